/* tinker bench: what a step of this scene costs. Stepping alone is timed: reading, compiling, recording and starting
 * over are outside the clock. */
#include "cli/verb/verbs.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

#include <cjson/cJSON.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/run-arguments.h"
#include "cli/report/text-table.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#define BATCHES 9

static const TinkerVerbHelp help = {
    .verb = "bench",
    .operands = "SCENE",
    .summary =
        "Times the steps of a scene: the median of several batches, per step, per evaluation of the accelerations\n"
        "and per block. Without --method all fixed-step methods are timed. The motion starts over whenever the\n"
        "scene's duration is reached.",
    .examples = "  tinker bench chain.tinker.json\n"
                "  tinker bench chain.tinker.json --method rk4 --step 0.001 --json bench.json",
    .least_operands = 1,
    .most_operands = 1,
};

/* What was measured of one method; `failure` where it could not be, and then the numbers are 0. */
typedef struct {
    char *method;
    double step; /* s; NAN: adaptive */
    double ns_per_step, evaluations_per_step;
    gint64 steps_timed;
    char *failure;
} Measurement;

static void measurement_clear(gpointer data)
{
    Measurement *measurement = data;
    g_free(measurement->method);
    g_free(measurement->failure);
}

/* A simulation that is stepped and started over. */
typedef struct {
    TinkerModel *model;
    TinkerRunOptions options;
    TinkerSimulation *simulation;
    gint64 steps, evaluations; /* of the laps before this one */
    double nanoseconds;        /* of this batch */
    gint64 batch_steps;
} Stepper;

static double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static gboolean start_lap(Stepper *stepper, GError **error)
{
    if (stepper->simulation != NULL) {
        const TinkerSummary *summary = tinker_simulation_summary(stepper->simulation);
        stepper->steps += summary->steps;
        stepper->evaluations += summary->evaluations;
        g_clear_pointer(&stepper->simulation, tinker_simulation_free);
    }
    stepper->simulation = tinker_simulation_new(stepper->model, &stepper->options, error);
    return stepper->simulation != NULL;
}

/* Steps within the clock until the batch has its steps or the motion its duration. */
static gboolean time_lap(Stepper *stepper, gint64 wanted, GError **error)
{
    double end = stepper->options.duration * (1 - 1e-12);
    double begun = now_ns();
    gboolean fine = TRUE;
    while (fine && stepper->batch_steps < wanted && tinker_simulation_time(stepper->simulation) < end) {
        fine = tinker_simulation_step(stepper->simulation, error);
        stepper->batch_steps++;
    }
    stepper->nanoseconds += now_ns() - begun;
    return fine;
}

/* One batch; answers ns per step, or NAN. */
static double time_batch(Stepper *stepper, gint64 wanted, GError **error)
{
    stepper->nanoseconds = 0;
    stepper->batch_steps = 0;
    while (stepper->batch_steps < wanted) {
        double end = stepper->options.duration * (1 - 1e-12);
        gboolean over = stepper->simulation == NULL || tinker_simulation_time(stepper->simulation) >= end;
        if (over && !start_lap(stepper, error)) return NAN;
        if (!time_lap(stepper, wanted, error)) return NAN;
    }
    return stepper->nanoseconds / (double)stepper->batch_steps;
}

static int by_value(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* Finds how many steps fill a batch, by doubling; that warms the caches as well. */
static gint64 batch_size(Stepper *stepper, double seconds, GError **error)
{
    for (gint64 steps = 16;; steps *= 2) {
        double ns = time_batch(stepper, steps, error);
        if (isnan(ns)) return 0;
        if (ns * (double)steps * 4 >= 1e9 * seconds || steps > G_MAXINT32)
            return MAX(1, (gint64)(1e9 * seconds / fmax(ns, 1)));
        if (tinker_progress_interrupted(NULL)) return steps;
    }
}

static gboolean measure(Stepper *stepper, double seconds, Measurement *measurement, GError **error)
{
    double batches[BATCHES];
    gint64 size = batch_size(stepper, seconds / BATCHES, error);
    if (size == 0) return FALSE;
    for (int i = 0; i < BATCHES; i++) {
        batches[i] = time_batch(stepper, size, error);
        if (isnan(batches[i])) return FALSE;
        measurement->steps_timed += stepper->batch_steps;
    }
    qsort(batches, BATCHES, sizeof batches[0], by_value);
    measurement->ns_per_step = batches[BATCHES / 2];
    const TinkerSummary *summary = tinker_simulation_summary(stepper->simulation);
    measurement->evaluations_per_step =
        (double)(stepper->evaluations + summary->evaluations) / (double)(stepper->steps + summary->steps);
    measurement->step = summary->adaptive ? NAN : summary->step;
    if (stepper->options.impulses) { /* whatever method is named */
        g_free(measurement->method);
        measurement->method = g_strdup(summary->method);
    }
    return TRUE;
}

static gboolean measure_method(TinkerModel *model, const TinkerRunOptions *options, const char *method, double seconds,
                               Measurement *measurement, GError **error)
{
    Stepper stepper = {.model = model, .options = *options};
    stepper.options.method = method;
    measurement->method = g_strdup(method);
    gboolean fine = measure(&stepper, seconds, measurement, error);
    g_clear_pointer(&stepper.simulation, tinker_simulation_free);
    return fine;
}

static cJSON *to_json(const Measurement *measurement, int32_t blocks)
{
    cJSON *object = cJSON_CreateObject();
    cJSON_AddStringToObject(object, "method", measurement->method);
    if (isnan(measurement->step))
        cJSON_AddNullToObject(object, "step");
    else
        cJSON_AddNumberToObject(object, "step", measurement->step);
    cJSON_AddNumberToObject(object, "ns_per_step", measurement->ns_per_step);
    cJSON_AddNumberToObject(object, "evaluations_per_step", measurement->evaluations_per_step);
    cJSON_AddNumberToObject(object, "ns_per_evaluation", measurement->ns_per_step / measurement->evaluations_per_step);
    cJSON_AddNumberToObject(object, "blocks", blocks);
    cJSON_AddNumberToObject(object, "steps_timed", (double)measurement->steps_timed);
    return object;
}

static void write_table(const GArray *measurements, int32_t blocks, FILE *file)
{
    static const char *const headings[] = {
        "METHOD", "STEP [s]", "NS/STEP", "EVALUATIONS/STEP", "NS/EVALUATION", "NS/EVALUATION/BLOCK", "STEPS TIMED"};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrrrrrr", 0);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (guint i = 0; i < measurements->len; i++) {
        const Measurement *measurement = &g_array_index(measurements, Measurement, i);
        if (measurement->failure != NULL) continue;
        double ns_per_evaluation = measurement->ns_per_step / measurement->evaluations_per_step;
        tinker_text_table_add(table, measurement->method);
        if (isnan(measurement->step))
            tinker_text_table_add(table, "adaptive");
        else
            tinker_text_table_add_format(table, "%g", measurement->step);
        tinker_text_table_add_format(table, "%.1f", measurement->ns_per_step);
        tinker_text_table_add_format(table, "%.3g", measurement->evaluations_per_step);
        tinker_text_table_add_format(table, "%.1f", ns_per_evaluation);
        tinker_text_table_add_format(table, "%.2f", ns_per_evaluation / MAX(blocks, 1));
        tinker_text_table_add_format(table, "%" G_GINT64_FORMAT, measurement->steps_timed);
    }
    tinker_print_line(file, "%d blocks", blocks);
    tinker_text_table_write(table, file);
    for (guint i = 0; i < measurements->len; i++) {
        const Measurement *measurement = &g_array_index(measurements, Measurement, i);
        if (measurement->failure != NULL)
            tinker_print_line(file, "%s: not timed: %s", measurement->method, measurement->failure);
    }
}

/* One object of a method that was asked for; else an array of those that could be timed. */
static void write_json(const GArray *measurements, int32_t blocks, gboolean single, FILE *file)
{
    cJSON *array = cJSON_CreateArray();
    for (guint i = 0; i < measurements->len; i++) {
        const Measurement *measurement = &g_array_index(measurements, Measurement, i);
        if (measurement->failure == NULL) cJSON_AddItemToArray(array, to_json(measurement, blocks));
    }
    char *text = cJSON_Print(single ? cJSON_GetArrayItem(array, 0) : array);
    tinker_print_text(file, text);
    cJSON_free(text);
    cJSON_Delete(array);
}

/* Every method is timed that can be; with one that was asked for, its failure is the program's. */
static gboolean measure_all(TinkerModel *model, const TinkerRunOptions *options, const TinkerRunArguments *arguments,
                            double seconds, GArray *measurements, GError **error)
{
    if (arguments->method != NULL || options->impulses) {
        g_array_set_size(measurements, 1);
        Measurement *only = &g_array_index(measurements, Measurement, 0);
        if (measure_method(model, options, options->method, seconds, only, error)) return TRUE;
        if (g_error_matches(*error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD)) tinker_blame_option(NULL, error);
        return FALSE;
    }
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_ADAPTIVE) continue;
        if (tinker_progress_interrupted(NULL)) break;
        g_autoptr(GError) failure = NULL;
        Measurement measurement = {0};
        if (!measure_method(model, options, (*method)->id, seconds, &measurement, &failure))
            measurement.failure = g_strdup(failure->message);
        g_array_append_val(measurements, measurement);
    }
    return TRUE;
}

static gboolean bench(const TinkerRunArguments *arguments, const TinkerOpenScene *open, const char *seconds_text,
                      const char *json, GError **error)
{
    static const TinkerDimension time_dimension = TINKER_DIMENSION_TIME;
    const TinkerAskedOutput outputs[] = {{"--json", json}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    double seconds = 1;
    TinkerRunOptions options;
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (seconds_text != NULL && !tinker_option_value("seconds", seconds_text, time_dimension, 0, TRUE, &seconds, error))
        return FALSE;
    if (!tinker_run_arguments_apply(arguments, open->scene, &options, error)) return FALSE;
    g_autoptr(TinkerModel) model = tinker_model_new(open->scene, error);
    if (model == NULL) return FALSE;
    g_auto(TinkerOutput) output = {0};
    if (json != NULL && !tinker_output_open(&output, json, error)) return FALSE;

    tinker_progress_catch_interrupt();
    g_autoptr(GArray) measurements = g_array_new(FALSE, TRUE, sizeof(Measurement));
    g_array_set_clear_func(measurements, measurement_clear);
    GError *reason = NULL;
    if (!measure_all(model, &options, arguments, seconds, measurements, &reason)) {
        g_propagate_error(error, reason);
        return FALSE;
    }
    int32_t blocks = tinker_scene_block_count(open->scene);
    tinker_open_scene_report_warnings(open);
    write_table(measurements, blocks, tinker_is_standard_stream(json) ? stderr : stdout);
    if (output.file != NULL) write_json(measurements, blocks, arguments->method != NULL, output.file);
    return tinker_output_close(&output, error);
}

int tinker_verb_bench(int argc, char **argv)
{
    g_auto(TinkerRunArguments) arguments = {0};
    g_autofree char *seconds = NULL, *json = NULL;
    const GOptionEntry entries[] = {
        TINKER_RUN_METHOD_ENTRIES(arguments),
        {"seconds", 0, 0, G_OPTION_ARG_FILENAME, &seconds, "How long each method is timed, about (1)", "S"},
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &json, "Write the result to FILE as JSON", "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    return bench(&arguments, &open, seconds, json, &error) ? TINKER_EXIT_DONE
                                                           : tinker_open_scene_report_error(&open, error);
}
