/* The program as a whole: reading a large scene, starting up, and memory over long runs. Times are those of the wall,
 * since a user waits for them. Work that takes memory is done in children, so that each figure is of one thing alone.
 */
#include <glib/gstdio.h>
#include <math.h>
#include <stdio.h>

#include "build-catalogue.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "report.h"
#include "scene-text.h"
#include "scene/read/scene-json.h"
#include "subject.h"

#define LARGE_MASSES 100000
#define STARTS       20
#define MEGABYTE     1e6

static char *write_large_scene(void)
{
    g_autoptr(GError) error = NULL;
    char *path;
    int descriptor = g_file_open_tmp("large-XXXXXX.tinker.json", &path, &error);
    if (descriptor < 0) g_error("%s", error->message);
    FILE *file = fdopen(descriptor, "w");
    benchmark_write_large(file, LARGE_MASSES);
    if (fclose(file) != 0) g_error("%s could not be written", path);
    return path;
}

enum { READ_SECONDS, READ_PROCESSOR, READ_RSS, COMPILE_SECONDS, COMPILE_RSS, STEP_SECONDS, LOADED_COUNT };

static double step_seconds(TinkerModel *model)
{
    g_autoptr(GError) error = NULL;
    TinkerRunOptions options = {
        .duration = 1, .interval = 1, .method = "rk4", .step = 1e-3, .tolerance = 1e-9, .spectral_radius = 0.8};
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    double values[5];
    if (simulation == NULL) g_error("%s", error->message);
    for (gsize i = 0; i < G_N_ELEMENTS(values); i++) {
        double started = benchmark_now();
        if (!tinker_simulation_step(simulation, &error)) g_error("%s", error->message);
        values[i] = benchmark_now() - started;
    }
    return benchmark_summarize(values, G_N_ELEMENTS(values)).minimum;
}

static void load(void *data, double *values)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerCatalogue) catalogue = test_build_catalogue();
    double started = benchmark_now(), processor = benchmark_processor_time();
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(catalogue, data, NULL, &error);
    if (scene == NULL) g_error("%s", error->message);
    double read = benchmark_now();
    values[READ_SECONDS] = read - started;
    values[READ_PROCESSOR] = benchmark_processor_time() - processor;
    values[READ_RSS] = benchmark_peak_rss();
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    if (model == NULL) g_error("%s", error->message);
    values[COMPILE_SECONDS] = benchmark_now() - read;
    values[COMPILE_RSS] = benchmark_peak_rss();
    values[STEP_SECONDS] = step_seconds(model);
}

static void report_large_scene(BenchmarkReport *report)
{
    const char *scene = "100000 masses, 400000 springs";
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *path = write_large_scene(), *tinker = benchmark_program();
    double values[LOADED_COUNT];
    BenchmarkChild loaded = benchmark_in_child(load, path, values, LOADED_COUNT);
    if (!loaded.fine) g_error("%s could not be loaded", path);
    benchmark_report_figure(report, scene, "reading", values[READ_SECONDS], "s", 2);
    benchmark_report_figure(report, scene, "reading, processor time", values[READ_PROCESSOR], "s", NAN);
    benchmark_report_figure(report, scene, "peak memory after reading", values[READ_RSS] / MEGABYTE, "MB", 500);
    benchmark_report_figure(report, scene, "compiling", values[COMPILE_SECONDS], "s", NAN);
    benchmark_report_figure(report, scene, "peak memory after compiling", values[COMPILE_RSS] / MEGABYTE, "MB", NAN);
    benchmark_report_figure(report, scene, "one rk4 step, least of 5", 1e3 * values[STEP_SECONDS], "ms", NAN);
    const char *arguments[] = {tinker, "run", path, "--duration", "0.01", "--interval", "0.01", NULL};
    BenchmarkChild run = benchmark_run(arguments);
    if (!run.fine) g_error("%s could not be run", path);
    benchmark_report_figure(report, scene, "tinker run of 10 steps, start to end", run.wall, "s", NAN);
    benchmark_report_figure(report, scene, "its peak memory", run.peak_rss / MEGABYTE, "MB", NAN);
    g_unlink(path);
}

static void report_start(BenchmarkReport *report, const char *scene, const char *const *arguments, double goal)
{
    if (!benchmark_report_wants(report, scene)) return;
    double values[STARTS];
    benchmark_run(arguments);
    for (int i = 0; i < STARTS; i++) {
        BenchmarkChild run = benchmark_run(arguments);
        if (!run.fine) g_error("%s failed", scene);
        values[i] = 1e3 * run.wall;
    }
    BenchmarkTiming timing = benchmark_summarize(values, STARTS);
    benchmark_report_figure(report, scene, "start to end, median of 20", timing.median, "ms", goal);
    benchmark_report_figure(report, scene, "start to end, least of 20", timing.minimum, "ms", NAN);
}

/* Peak memory of a run with this many samples, MB; and its time for each sample in µs. */
static double long_run(const char *tinker, const char *path, const char *duration, double samples, double *per_sample)
{
    const char *arguments[] = {tinker,       "run",   path,    "--duration", duration,
                               "--interval", "0.001", "--csv", "/dev/null",  NULL};
    BenchmarkChild run = benchmark_run(arguments);
    if (!run.fine) g_error("the run of %s s failed", duration);
    *per_sample = 1e6 * run.wall / samples;
    return run.peak_rss / MEGABYTE;
}

static void report_long_runs(BenchmarkReport *report, const char *tinker, const char *path)
{
    const char *scene = "spring-mass to CSV";
    if (!benchmark_report_wants(report, scene)) return;
    double per_sample;
    double million = long_run(tinker, path, "1000", 1e6, &per_sample);
    benchmark_report_figure(report, scene, "1e6 samples, peak memory", million, "MB", NAN);
    benchmark_report_figure(report, scene, "1e6 samples, wall time of each", per_sample, "us", NAN);
    double ten_million = long_run(tinker, path, "10000", 1e7, &per_sample);
    benchmark_report_figure(report, scene, "1e7 samples, peak memory", ten_million, "MB", NAN);
    benchmark_report_figure(report, scene, "1e7 samples, wall time of each", per_sample, "us", NAN);
    benchmark_report_figure(report, scene, "growth of peak memory", ten_million - million, "MB", 1);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    g_autofree char *tinker = benchmark_program();
    g_autofree char *folder = g_path_get_dirname(tinker);
    g_autofree char *path = g_build_filename(folder, "..", "scenes", "spring-mass.tinker.json", NULL);
    const char *run[] = {tinker, "run", path, NULL}, *version[] = {tinker, "--version", NULL};
    report_large_scene(report);
    report_start(report, "tinker run spring-mass", run, 20);
    report_start(report, "tinker --version", version, NAN);
    report_long_runs(report, tinker, path);
    return benchmark_report_end(report);
}
