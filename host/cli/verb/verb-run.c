/* tinker run: runs a scene, streams its record as CSV and writes the summary. */
#include "cli/verb/verbs.h"

#include <stdio.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/run-arguments.h"
#include "cli/report/csv-record.h"
#include "cli/report/summary.h"
#include "common/program/exit-status.h"
#include "physics/compile/compile.h"
#include "physics/record/sample-times.h"

static const TinkerVerbHelp help = {
    .verb = "run",
    .operands = "SCENE",
    .summary =
        "Runs a scene. The summary goes to standard output, or to standard error where the record or the\n"
        "JSON goes to standard output. Times may carry a unit: \"2 min\", \"10 ms\"; plain numbers are seconds.\n"
        "What is not given is taken from the scene. Ctrl-C stops the run and keeps what was computed.",
    .examples = "  tinker run pendulum.tinker.json --csv pendulum.csv\n"
                "  tinker run pendulum.tinker.json --method rk4 --step \"5 ms\" --duration \"2 min\"\n"
                "  tinker run pendulum.tinker.json --accuracy 1e-6\n"
                "  tinker run pendulum.tinker.json --at 0,0.5,2 --columns \"Mass 0.x,Rod 0.tension\" --csv -\n"
                "  tinker run bounce.tinker.json --until \"event(impact)\" --until \"{Mass 0.y} = 1\" --json -\n"
                "  tinker run - --json summary.json < pendulum.tinker.json",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    char *csv, *at, *columns, *json;
    char **until;
} RunOptions;

static void run_options_clear(RunOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    g_free(options->csv);
    g_free(options->at);
    g_free(options->columns);
    g_free(options->json);
    g_strfreev(options->until);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(RunOptions, run_options_clear)

/* Everything that is open while the scene runs. */
typedef struct {
    GArray *times; /* of --at; NULL: every interval */
    GArray *columns;
    TinkerRunOptions options;
    TinkerSceneRun run;
    TinkerCsvRecord csv;
    TinkerOutput json;
} RunJob;

static void run_job_clear(RunJob *job)
{
    tinker_scene_run_clear(&job->run);
    g_clear_pointer(&job->times, g_array_unref);
    g_clear_pointer(&job->columns, g_array_unref);
    tinker_csv_record_clear(&job->csv);
    tinker_output_clear(&job->json);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(RunJob, run_job_clear)

static gboolean write_sample(TinkerSimulation *simulation, double time, const double *values, void *data,
                             GError **error)
{
    RunJob *job = data;
    return job->csv.output.file == NULL || tinker_csv_record_add(&job->csv, time, values, error);
}

static void begin_again(void *data)
{
    tinker_csv_record_begin_again(&((RunJob *)data)->csv);
}

static GArray *pick_columns(const RunOptions *options, TinkerScene *scene, GError **error)
{
    if (options->columns == NULL) return tinker_columns_default(scene);
    g_autoptr(GArray) columns = tinker_columns_new();
    if (tinker_columns_add_list(columns, scene, options->columns, error)) return g_steal_pointer(&columns);
    tinker_blame_option("columns", error);
    return NULL;
}

/* Everything that can go wrong before the first step does so here. */
static gboolean prepare(RunJob *job, const RunOptions *options, const TinkerOpenScene *open, GError **error)
{
    const TinkerAskedOutput outputs[] = {{"--csv", options->csv}, {"--json", options->json}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &job->options, error)) return FALSE;
    if (options->at != NULL) {
        job->times = tinker_run_arguments_times(options->at, error);
        if (job->times == NULL) return FALSE;
        job->options.at = (const double *)(gpointer)job->times->data;
        job->options.at_count = job->times->len;
    }
    job->columns = pick_columns(options, open->scene, error);
    if (job->columns == NULL ||
        !tinker_scene_run_until(&job->run, open->scene, &options->run, options->until, &job->options, error))
        return FALSE;
    if (!tinker_scene_run_prepare(&job->run, open->scene, &options->run, &job->options, error)) return FALSE;
    if (options->csv != NULL && !tinker_csv_record_open(&job->csv, options->csv, job->columns, error)) return FALSE;
    return options->json == NULL || tinker_output_open(&job->json, options->json, error);
}

static void add_failure(GPtrArray *warnings, const GError *failure)
{
    if (failure != NULL) g_ptr_array_insert(warnings, 0, g_strdup(failure->message));
}

static gboolean write_results(RunJob *job, const RunOptions *options, const TinkerOpenScene *open,
                              const GError *failure, GError **error)
{
    const TinkerSummary *summary = tinker_simulation_summary(job->run.simulation);
    g_autoptr(GPtrArray) warnings = tinker_scene_run_warnings(&job->run, open, &options->run);
    g_autoptr(GPtrArray) opened = tinker_catalogue_opened(open->catalogue);
    TinkerRunReport report = {
        .scene = open->scene,
        .scene_name = open->name,
        .run = summary,
        .libraries = opened,
        .warnings = warnings,
        .has_until = tinker_until_count(job->run.until) > 0,
        .stopped_by = job->run.stopped_by,
    };
    gboolean taken = tinker_is_standard_stream(options->csv) || tinker_is_standard_stream(options->json);
    gboolean fine = tinker_csv_record_close(&job->csv, summary->valid_until, error);
    tinker_summary_write_text(&report, taken ? stderr : stdout);
    if (job->json.file != NULL) {
        add_failure(warnings, failure);
        tinker_summary_write_json(&report, job->json.file);
    }
    return tinker_output_close(&job->json, fine ? error : NULL) && fine;
}

static void warn_without_record(const RunOptions *options)
{
    if (options->csv != NULL) return;
    if (options->columns != NULL) tinker_report_warning("--columns has no effect without --csv");
    if (options->at != NULL)
        tinker_report_warning("--at has no effect without --csv, but that the run lasts to the last of its times");
}

static int run(const RunOptions *options, const TinkerCommandLine *line)
{
    g_auto(TinkerOpenScene) open = {0};
    int status = tinker_open_scene(&open, line->plugin_folders, line->operands[0]);
    if (status != TINKER_EXIT_DONE) return status;

    g_auto(RunJob) job = {0};
    g_autoptr(GError) error = NULL, failure = NULL;
    if (!prepare(&job, options, &open, &error)) return tinker_open_scene_report_error(&open, error);
    warn_without_record(options);
    const GArray *columns = options->csv != NULL ? job.columns : NULL;
    const TinkerSampleTaker taker = {.sample = write_sample, .begin_again = begin_again, .data = &job};
    if (options->csv != NULL && job.options.accuracy > 0) tinker_csv_record_hold(&job.csv);
    (void)tinker_scene_run_go(&job.run, columns, &taker, &failure);
    if (!write_results(&job, options, &open, failure, &error) && failure == NULL)
        return tinker_report_error(open.name, error);
    return failure != NULL ? tinker_report_error(open.name, failure) : TINKER_EXIT_DONE;
}

int tinker_verb_run(int argc, char **argv)
{
    g_auto(RunOptions) options = {0};
    const GOptionEntry entries[] = {
        TINKER_RUN_ENTRIES(options.run),
        {"csv", 0, 0, G_OPTION_ARG_FILENAME, &options.csv, "Write the record to FILE as CSV, in SI", "FILE"},
        {"at", 0, 0, G_OPTION_ARG_FILENAME, &options.at,
         "Record at just these times; the run lasts to the last of them", "T1,T2,..."},
        {"columns", 0, 0, G_OPTION_ARG_FILENAME, &options.columns,
         "Record these quantities (default: motion of the masses, tension of the connectors)", "\"A.x,B.y\""},
        {"until", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options.until,
         "End where this first holds (may be repeated): \"A = B\", \"A < B\" or event(KIND[, BLOCK])", "COND"},
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &options.json, "Write the summary to FILE as JSON", "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;
    return run(&options, &line);
}
