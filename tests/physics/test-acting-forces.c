/* Forces told apart: they add up to mass times acceleration in every scene there is. */
#include "acting-watch.h"

#include <math.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"

static double mass_of(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_MASS);
    return tinker_scene_get(scene, block, column);
}

/* A connector takes nothing from anywhere, nor does a contact: what it does to all its ends adds up to nothing. */
static void assert_opposite(const GArray *out)
{
    for (guint i = 0; i < out->len; i++) {
        const TinkerActingForce *one = &g_array_index(out, TinkerActingForce, i);
        double fx = one->fx, fy = one->fy, scale = hypot(fx, fy);
        gboolean touch = one->kind >= TINKER_ACTING_NORMAL;
        if (one->kind != TINKER_ACTING_LINE && one->kind != TINKER_ACTING_CONSTRAINT && !touch) continue;
        for (guint k = 0; k < out->len; k++) {
            const TinkerActingForce *other = &g_array_index(out, TinkerActingForce, k);
            if (k == i || other->kind != one->kind) continue;
            if (touch ? other->by != one->on || other->on != one->by : other->by != one->by) continue;
            fx += other->fx;
            fy += other->fy;
        }
        physics_assert_near("the sum of opposite forces", hypot(fx, fy), 0, 1e-13 * scale);
    }
}

static void assert_newton(const ActingWatch *watch, double time, const double *values)
{
    TinkerScene *scene = watch->scene;
    for (guint i = 0; i < watch->bodies->len; i++) {
        TinkerBlockId body = g_array_index(watch->bodies, TinkerBlockId, i);
        double mass = mass_of(scene, body), fx = 0, fy = 0, scale = 0;
        for (guint k = 0; k < watch->out->len; k++) {
            const TinkerActingForce *force = &g_array_index(watch->out, TinkerActingForce, k);
            g_assert_true(force->by != force->on);
            if (force->on != body) continue;
            fx += force->fx;
            fy += force->fy;
            scale += hypot(force->fx, force->fy);
        }
        double off = hypot(fx - mass * values[2 * i], fy - mass * values[2 * i + 1]);
        if (!(off <= 1e-9 * scale) && !g_test_failed())
            g_test_fail_printf("%s at t = %g s: forces (%.12g, %.12g) N are not mass times acceleration "
                               "(%.12g, %.12g) N",
                               tinker_scene_block_name(scene, body), time, fx, fy, mass * values[2 * i],
                               mass * values[2 * i + 1]);
    }
}

static gboolean look_and_add_up(TinkerSimulation *simulation, double time, const double *values, void *data,
                                GError **error)
{
    ActingWatch *watch = data;
    if (!acting_watch_look(simulation, time, values, data, error)) return FALSE;
    assert_newton(watch, time, values);
    assert_opposite(watch->out);
    return TRUE;
}

/* Runs a scene with its own settings, but for samples at these times. */
static void check_sums(TinkerScene *scene, double duration, gboolean impulses)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.duration = duration;
    options.interval = duration / 97;
    options.impulses = impulses;
    options.estimate = FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_assert_no_error(error);
    ActingWatch watch;
    acting_watch_open(&watch, scene, model);
    tinker_simulation_run(simulation, watch.columns, look_and_add_up, &watch, &error);
    g_assert_no_error(error);
    g_assert_cmpint(watch.looked, ==, 98);
    g_assert_cmpint(watch.allotted, ==, 0);
    g_assert_cmpfloat(watch.most, >, 0);
    acting_watch_close(&watch);
}

typedef struct {
    const char *name, *path; /* from the root of the sources */
    double duration;
    gboolean impulses;
} SceneCase;

static const SceneCase scene_cases[] = {
    {"spring-mass", "host/scenes/spring-mass.tinker.json", 3, FALSE},
    {"double-pendulum", "host/scenes/double-pendulum.tinker.json", 4, FALSE},
    {"four-bar-linkage", "host/scenes/four-bar-linkage.tinker.json", 4, FALSE},
    {"friction-incline", "host/scenes/friction-incline.tinker.json", 4, FALSE},
    {"friction-incline/impulses", "host/scenes/friction-incline.tinker.json", 4, TRUE},
    {"bouncing-balls", "host/scenes/bouncing-balls.tinker.json", 5, FALSE},
    {"bouncing-balls/impulses", "host/scenes/bouncing-balls.tinker.json", 3, TRUE},
    {"stick-slip-belt", "host/scenes/stick-slip-belt.tinker.json", 6, FALSE},
    {"sliding-ladder", "host/scenes/sliding-ladder.tinker.json", 2, FALSE},
    {"hanging-cable", "host/scenes/hanging-cable.tinker.json", 2, FALSE},
    {"kapitza-pendulum", "host/scenes/kapitza-pendulum.tinker.json", 2, FALSE},
    {"terminal-velocity", "host/scenes/terminal-velocity.tinker.json", 3, FALSE},
    {"tuned-mass-damper", "host/scenes/tuned-mass-damper.tinker.json", 5, FALSE},
    {"el-centro-block", "host/scenes/el-centro-block.tinker.json", 5, FALSE},
    {"one-sided-support", "host/scenes/one-sided-support.tinker.json", 1.5, FALSE},
    {"lift-off", "host/scenes/lift-off.tinker.json", 4, FALSE},
    {"support-motion", "host/scenes/support-motion.tinker.json", 5, FALSE},
    {"stiff-chain", "host/scenes/stiff-chain.tinker.json", 2, FALSE},
    {"A26", "tests/reference/A26_parallel_springs.tinker.json", 2, FALSE},
    {"A32", "tests/reference/A32_incline_stick.tinker.json", 5, FALSE},
    {"A38", "tests/reference/A38_shake_stickslip.tinker.json", 3, FALSE},
    {"B07", "tests/reference/B07_chain10.tinker.json", 1, FALSE},
    {"C02", "tests/reference/C02_car_axis_panhard.tinker.json", 1, FALSE},
    {"C09", "tests/reference/C09_slider_crank.tinker.json", 1, FALSE},
    {"D08", "tests/reference/D08_rod_mass_ratio_1e6.tinker.json", 1, FALSE},
    {"D12", "tests/reference/D12_redundant_parallelogram.tinker.json", 1, FALSE},
    {"D13", "tests/reference/D13_duplicate_rod.tinker.json", 1, FALSE},
};

static void test_scene(gconstpointer data)
{
    const SceneCase *scene_case = data;
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), scene_case->path, NULL);
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
    g_assert_no_error(error);
    check_sums(scene, scene_case->duration, scene_case->impulses);
}

/* Roles that no bundled block fills. */
static void test_other_roles(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'support', 'solid': false, 'position': [100, -50]}, {'type': 'gravity'},"
              "{'type': 'mass', 'position': [102, -50]}, {'type': 'mass', 'position': [102, -49], 'mass': 3},"
              "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3, 'length': 1},"
              "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1', 'Support 0'], 'stiffness': 2},"
              "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2},"
              "{'type': 'attraction', 'strength': 1}, {'type': 'attraction', 'strength': 2},"
              "{'type': 'torsion', 'ends': ['Mass 0', 'Support 0', 'Mass 1'], 'stiffness': 1},"
              "{'type': 'orbit', 'ends': ['Support 0'], 'radius': 0.1, 'rate': 2},"
              "{'type': 'actuator', 'ends': ['Mass 0', 'Mass 1'], 'waveform': {'expression': '1 + 0.1*sin(t)^2'}},"
              "{'type': 'rope', 'ends': ['Support 0', 'Mass 1'], 'length': 2.25},"
              "{'type': 'wind', 'drag_quadratic': 0.3, 'drag': 0.1}, {'type': 'wind', 'velocity': [3, 0], 'drag': 1}");
    check_sums(scene, 3, FALSE);
}

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(scene_cases); i++) {
        g_autofree char *name = g_strdup_printf("/physics/acting-forces/sums/%s", scene_cases[i].name);
        g_test_add_data_func(name, &scene_cases[i], test_scene);
    }
    g_test_add_func("/physics/acting-forces/sums/other-roles", test_other_roles);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
