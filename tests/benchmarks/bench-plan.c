/* What a plan says that each bundled scene, and chains of rods and of bars, will take, beside what its run takes:
 * evaluations, which a test holds to a factor of 3, and processor time, which depends on the machine. */
#include <math.h>
#include <string.h>

#include "build-catalogue.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/plan-trial.h"
#include "physics/run/simulation.h"
#include "report.h"
#include "scene-text.h"
#include "scene/read/scene-json.h"
#include "subject.h"

#define TRIES 5

typedef struct {
    double evaluations, seconds;
} Cost;

static Cost planned(TinkerScene *scene, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_autoptr(GPtrArray) islands = model == NULL ? NULL : tinker_islands_for(model, options->impulses, &error);
    g_autoptr(TinkerPlan) plan = islands == NULL ? NULL : tinker_plan_new_counted(model, islands, options, &error);
    if (plan == NULL) g_error("%s", error->message);
    Cost cost = {0};
    for (guint i = 0; i < plan->islands->len; i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->islands, i);
        cost.evaluations += island->evaluations;
        cost.seconds += island->expected_s;
    }
    return cost;
}

static Cost seen(TinkerScene *scene, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_autoptr(TinkerSimulation) simulation = model == NULL ? NULL : tinker_simulation_new(model, options, &error);
    if (simulation == NULL) g_error("%s", error->message);
    g_autoptr(GArray) columns = tinker_columns_default(scene);
    const double started = benchmark_processor_time();
    if (!tinker_simulation_run(simulation, columns, NULL, NULL, &error)) g_error("%s", error->message);
    return (Cost){(double)tinker_simulation_summary(simulation)->evaluations, benchmark_processor_time() - started};
}

static void measure(BenchmarkReport *report, TinkerScene *scene, const char *name, const TinkerRunOptions *options)
{
    const Cost expected = planned(scene, options);
    Cost least = {0, INFINITY};
    for (int i = 0; i < TRIES; i++) {
        const Cost cost = seen(scene, options);
        least = (Cost){cost.evaluations, fmin(least.seconds, cost.seconds)};
    }
    benchmark_report_figure(report, name, "evaluations, expected", expected.evaluations, "", NAN);
    benchmark_report_figure(report, name, "evaluations, seen", least.evaluations, "", NAN);
    benchmark_report_figure(report, name, "time, expected", 1e6 * expected.seconds, "µs", NAN);
    benchmark_report_figure(report, name, "time, seen", 1e6 * least.seconds, "µs", NAN);
    benchmark_report_figure(report, name, "time, seen over expected", least.seconds / expected.seconds, "", NAN);
}

static void measure_file(BenchmarkReport *report, TinkerCatalogue *catalogue, const char *name)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(catalogue, path, NULL, &error);
    if (scene == NULL) g_error("%s", error->message);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.estimate = FALSE;
    measure(report, scene, name, &options);
}

/* Chains of 10 m that hang in a slight curve: each step has the same rows to solve, so that the time is theirs. */
static void measure_chains(BenchmarkReport *report, TinkerCatalogue *catalogue, gboolean bars)
{
    static const char *const methods[] = {"verlet", "rk4", "dopri5"};
    static const int sizes[] = {50, 200, 1000};
    for (gsize k = 0; k < G_N_ELEMENTS(sizes) * G_N_ELEMENTS(methods); k++) {
        const int n = sizes[k / G_N_ELEMENTS(methods)];
        const char *method = methods[k % G_N_ELEMENTS(methods)];
        g_autofree char *name = g_strdup_printf("chain of %d %s, %s", n, bars ? "bars" : "rods", method);
        if (!benchmark_report_wants(report, name)) continue;
        g_autoptr(GError) error = NULL;
        g_autofree double *angles = benchmark_hanging_angles(n);
        g_autofree char *text = bars ? benchmark_bars(n, angles, 10.0 / n) : benchmark_chain(n, angles, 10.0 / n);
        g_autoptr(TinkerScene) scene = tinker_scene_read_text(catalogue, text, strlen(text), NULL, NULL, &error);
        if (scene == NULL) g_error("%s", error->message);
        TinkerRunOptions options = tinker_run_options_of(scene);
        options.estimate = FALSE;
        options.method = method;
        options.step = n < 1000 ? 1e-3 : 1e-4;
        options.duration = 500 * options.step;
        measure(report, scene, name, &options);
    }
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    TinkerCatalogue *catalogue = test_build_catalogue();
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, NULL);
    for (const char *name = folder == NULL ? NULL : g_dir_read_name(folder); name != NULL;
         name = g_dir_read_name(folder))
        if (g_str_has_suffix(name, ".tinker.json") && benchmark_report_wants(report, name))
            measure_file(report, catalogue, name);
    measure_chains(report, catalogue, FALSE);
    measure_chains(report, catalogue, TRUE);
    tinker_catalogue_free(catalogue);
    return benchmark_report_end(report);
}
