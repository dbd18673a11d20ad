/* What a plan says that a run will take, beside what the run is then seen to take. */
#include "physics-fixture.h"

#include <math.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/plan-trial.h"
#include "physics/run/simulation.h"

#define WITHIN 3.0
/* Longer than any trial goes on: the rest is told from it. */
#define LONG 20.0

static double planned(TinkerScene *scene, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(GPtrArray) islands = tinker_islands_for(model, options->impulses, &error);
    g_assert_no_error(error);
    g_autoptr(TinkerPlan) plan = tinker_plan_new_counted(model, islands, options, &error);
    g_assert_no_error(error);
    double evaluations = 0;
    for (guint i = 0; i < plan->islands->len; i++)
        evaluations += ((const TinkerIslandPlan *)g_ptr_array_index(plan->islands, i))->evaluations;
    return evaluations;
}

static double counted(TinkerScene *scene, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, options, &error);
    g_assert_no_error(error);
    g_autoptr(GArray) columns = tinker_columns_default(scene);
    tinker_simulation_run(simulation, columns, NULL, NULL, &error);
    g_assert_no_error(error);
    return (double)tinker_simulation_summary(simulation)->evaluations;
}

static void compare(const char *name, const char *method, double longer)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    if (method != NULL) options.method = method;
    options.estimate = FALSE;
    options.duration *= longer;
    options.interval *= longer;
    const double expected = planned(scene, &options), seen = counted(scene, &options);
    g_test_message("%s, %g s: %g evaluations are expected, %g are seen", name, options.duration, expected, seen);
    g_assert_cmpfloat(expected, <=, WITHIN * seen);
    g_assert_cmpfloat(expected, >=, seen / WITHIN);
}

static void test_bundled(void)
{
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, NULL);
    int scenes = 0;
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder)) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        compare(name, NULL, 1);
        scenes++;
    }
    g_assert_cmpint(scenes, >=, 25);
}

static void test_named_methods(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dopri5", "dop853", "newmark"};
    static const char *const names[] = {"base-excitation", "el-centro-block", "friction-oscillator", "double-pendulum"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        for (gsize k = 0; k < G_N_ELEMENTS(methods); k++) {
            g_autofree char *name = g_strconcat(names[i], ".tinker.json", NULL);
            compare(name, methods[k], 1);
        }
}

static void test_long_runs(void)
{
    static const char *const names[] = {"kapitza-pendulum", "double-pendulum", "spring-pendulum", "stick-slip-belt"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autofree char *name = g_strconcat(names[i], ".tinker.json", NULL);
        compare(name, NULL, LONG);
    }
}

/* Operations that are expected of 20 bars on pins, which hang straight down and are left to themselves or spun round
 * as one at `rate`. */
static double operations_of_bars(double rate)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < 20; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'bar', 'width': 0, 'orientation': '-90 deg', 'position': [0, %g],"
                               " 'velocity': [%g, 0], 'angular_velocity': %g}",
                               -0.5 - i, rate * (0.5 + i), rate);
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    for (int i = 1; i < 20; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'pin', 'ends': [{'block': 'Bar %d', 'at': [0.5, 0]},"
                               " {'block': 'Bar %d', 'at': [-0.5, 0]}]}",
                               i - 1, i);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks->str);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.method = "verlet";
    options.step = 1e-2;
    options.duration = 1;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(GPtrArray) islands = tinker_islands_for(model, FALSE, &error);
    g_autoptr(TinkerPlan) plan = tinker_plan_new_counted(model, islands, &options, &error);
    g_assert_no_error(error);
    return ((const TinkerIslandPlan *)g_ptr_array_index(plan->islands, 0))->operations;
}

/* What stands meets its rows after each step; what turns fast takes several Newton steps to come back to them, with as
 * many evaluations of the accelerations, and these are counted too. */
static void test_corrections(void)
{
    g_assert_cmpfloat(operations_of_bars(3), >, 1.5 * operations_of_bars(0));
}

static void add_tests(void)
{
    g_test_add_func("/physics/plan-trial/corrections", test_corrections);
    g_test_add_func("/physics/plan-trial/bundled", test_bundled);
    g_test_add_func("/physics/plan-trial/named-methods", test_named_methods);
    g_test_add_func("/physics/plan-trial/long-runs", test_long_runs);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
