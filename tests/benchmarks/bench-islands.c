/* What many islands cost: independent oscillators loaded, planned and run for ten steps, and masses that bounce on one
 * support. Each is run with twice as many beside it, as what is wanted is that time and memory go with their number. */
#include <glib/gstdio.h>
#include <math.h>
#include <stdio.h>

#include "report.h"
#include "subject.h"

#define LEAST    25000
#define DOUBLED  2
#define BOUNCING 2000
#define TRIES    3
#define MEGABYTE 1e6

/* Each a mass on a spring, 1 m above the one before: from an anchor of its own, or all from one support. */
static void write_oscillators(FILE *file, int count, gboolean common)
{
    fputs("{\"tinker\": 1, \"blocks\": [\n", file);
    if (common) fputs("{\"type\": \"support\", \"name\": \"S\", \"position\": [-3, 0]},\n", file);
    for (int i = 0; i < count; i++) {
        if (!common)
            fprintf(file, "{\"type\": \"support\", \"name\": \"S%d\", \"position\": [0, %d], \"solid\": false},\n", i,
                    i);
        fprintf(file, "{\"type\": \"mass\", \"name\": \"M%d\", \"position\": [1.5, %d], \"mass\": %g},\n", i, i,
                1 + 0.1 * (i % 7));
        fputs("{\"type\": \"spring\", \"ends\": [", file);
        if (common)
            fprintf(file, "{\"block\": \"S\", \"at\": [3, %d]}", i);
        else
            fprintf(file, "\"S%d\"", i);
        fprintf(file, ", \"M%d\"], \"rest_length\": 1, \"stiffness\": %d}%s\n", i, 10 + i % 100,
                i == count - 1 ? "" : ",");
    }
    fputs("]}\n", file);
}

/* Boxes 1.5 m apart, that fall on one support from ten heights and bounce. */
static void write_bouncing(FILE *file, int count)
{
    fprintf(
        file,
        "{\"tinker\": 1, \"run\": {\"duration\": 2}, \"blocks\": [\n{\"type\": \"gravity\"},\n{\"type\": \"support\", "
        "\"width\": %d, \"height\": 0.4, \"static_friction\": 0.5, \"dynamic_friction\": 0.4, \"restitution\": 0.5}",
        2 * count);
    for (int i = 0; i < count; i++)
        fprintf(file, ",\n{\"type\": \"mass\", \"mass\": %g, \"width\": 0.2, \"height\": 0.2, \"position\": [%g, %g]}",
                1 + 0.1 * (i % 7), 1.5 * i - 0.75 * count, 0.8 + 0.07 * (i % 10));
    fputs("]}\n", file);
}

typedef enum {
    OWN_ANCHORS,
    ONE_SUPPORT,
    BOUNCES,
} Kind;

static char *write_scene(Kind kind, int count)
{
    g_autoptr(GError) error = NULL;
    char *path;
    int descriptor = g_file_open_tmp("islands-XXXXXX.tinker.json", &path, &error);
    if (descriptor < 0) g_error("%s", error->message);
    FILE *file = fdopen(descriptor, "w");
    if (kind == BOUNCES)
        write_bouncing(file, count);
    else
        write_oscillators(file, count, kind == ONE_SUPPORT);
    if (fclose(file) != 0) g_error("%s could not be written", path);
    return path;
}

/* Of several tries, the least time and its memory. */
static BenchmarkChild least(const char *verb, const char *path, const char *const *options)
{
    BenchmarkChild best = {.processor = INFINITY};
    g_autofree char *tinker = benchmark_program();
    g_autoptr(GPtrArray) arguments = g_ptr_array_new();
    const char *const first[] = {tinker, verb, path};
    for (gsize i = 0; i < G_N_ELEMENTS(first); i++)
        g_ptr_array_add(arguments, (gpointer)first[i]);
    for (; *options != NULL; options++)
        g_ptr_array_add(arguments, (gpointer)*options);
    g_ptr_array_add(arguments, NULL);
    for (int i = 0; i < TRIES; i++) {
        BenchmarkChild run = benchmark_run((const char *const *)arguments->pdata);
        if (!run.fine) g_error("%s of %s failed", verb, path);
        if (run.processor < best.processor) best = run;
    }
    return best;
}

/* Of `count` and of twice as many. The goal (s) is for the latter, that of the ratio for time and memory. */
static void measure(BenchmarkReport *report, const char *scene, Kind kind, int count, const char *verb,
                    const char *const *options, double goal, double ratio)
{
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *few = write_scene(kind, count), *many = write_scene(kind, DOUBLED * count);
    const BenchmarkChild one = least(verb, few, options), other = least(verb, many, options);
    benchmark_report_figure(report, scene, "processor time", other.processor, "s", goal);
    benchmark_report_figure(report, scene, "processor time over that of half as many", other.processor / one.processor,
                            "", ratio);
    benchmark_report_figure(report, scene, "peak memory", other.peak_rss / MEGABYTE, "MB", NAN);
    benchmark_report_figure(report, scene, "memory over that of half as many", other.peak_rss / one.peak_rss, "",
                            ratio);
    g_unlink(few);
    g_unlink(many);
}

int main(int argc, char **argv)
{
    static const char *const ten_steps[] = {"--method", "rk4",        "--step", "0.001",         "--duration",
                                            "0.01",     "--interval", "0.01",   "--no-estimate", NULL};
    static const char *const with_estimate[] = {"--method", "rk4",        "--step", "0.001", "--duration",
                                                "0.01",     "--interval", "0.01",   NULL};
    static const char *const nothing[] = {NULL};
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    const double linear = 1.2 * DOUBLED;
    measure(report, "100000 oscillators, 10 steps", OWN_ANCHORS, 2 * LEAST, "run", ten_steps, 3, linear);
    measure(report, "50000 oscillators, 10 steps", OWN_ANCHORS, LEAST, "run", ten_steps, NAN, linear);
    measure(report, "100000 oscillators, 10 steps and estimate", OWN_ANCHORS, 2 * LEAST, "run", with_estimate, 3,
            linear);
    measure(report, "100000 oscillators on one support, 10 steps", ONE_SUPPORT, 2 * LEAST, "run", ten_steps, 3, linear);
    measure(report, "100000 oscillators, check", OWN_ANCHORS, 2 * LEAST, "check", nothing, NAN, linear);
    measure(report, "100000 oscillators, plan", OWN_ANCHORS, 2 * LEAST, "plan", nothing, 3, linear);
    measure(report, "4000 bouncing masses", BOUNCES, BOUNCING, "run", nothing, NAN, 2.5);
    return benchmark_report_end(report);
}
