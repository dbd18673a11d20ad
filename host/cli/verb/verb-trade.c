/* tinker trade: measures speed against accuracy on one scene, and advises. */
#include "cli/verb/verbs.h"

#include <string.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/command/run-arguments.h"
#include "cli/report/trade-report.h"
#include "common/graph/trade-chart.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"

#define WIDTH   900
#define HEIGHT  600
#define ERROR   1e-6
#define SECONDS 25.0

static const TinkerVerbHelp help = {
    .verb = "trade",
    .operands = "SCENE",
    .summary =
        "Measures speed against accuracy on this scene: every suitable method over a range of steps or tolerances,\n"
        "error against wall time. Errors are relative to the extent of the motion and its largest speed, against a\n"
        "reference that two different methods confirm to each other; the wall time is the median of repeated runs.\n"
        "Ends with the cheapest choice for an error, or the most accurate within a budget of wall time. Ctrl-C\n"
        "keeps what was measured.",
    .examples = "  tinker trade double-pendulum.tinker.json\n"
                "  tinker trade pendulum.tinker.json --error 1e-9 -o trade.svg --csv trade.csv\n"
                "  tinker trade pendulum.tinker.json --methods rk4,verlet --budget \"2 ms\" --write",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *at, *methods, *error, *budget, *seconds, *csv, *output;
    gboolean write;
} TradeArguments;

static void trade_arguments_clear(TradeArguments *arguments)
{
    tinker_run_arguments_clear(&arguments->run);
    tinker_picture_arguments_clear(&arguments->picture);
    char *const texts[] = {arguments->at,      arguments->methods, arguments->error, arguments->budget,
                           arguments->seconds, arguments->csv,     arguments->output};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TradeArguments, trade_arguments_clear)

/* Everything that is needed while the scene is measured. */
typedef struct {
    TinkerTradeOptions options;
    GArray *times;
    char **methods;
    TinkerProgress progress;
    TinkerOutput csv;
    int width, height;
    const TinkerTheme *theme;
} TradeJob;

static void trade_job_clear(TradeJob *job)
{
    g_clear_pointer(&job->times, g_array_unref);
    g_clear_pointer(&job->methods, g_strfreev);
    tinker_output_clear(&job->csv);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TradeJob, trade_job_clear)

static void show_progress(double share, void *data)
{
    tinker_progress_update(data, share, 1);
}

/* What is not asked for is the accuracy that the scene asks for, if it does. */
static gboolean read_wishes(const TradeArguments *arguments, const TinkerOpenScene *open, TinkerTradeOptions *options,
                            GError **error)
{
    static const TinkerDimension none = TINKER_DIMENSION_NONE, time = TINKER_DIMENSION_TIME;
    double accuracy = tinker_scene_head(open->scene)->run.accuracy;
    options->error = accuracy > 0 ? accuracy : ERROR;
    options->seconds = SECONDS;
    if (arguments->error != NULL && arguments->budget != NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--error and --budget exclude each other (the advice is for one of them)");
        return FALSE;
    }
    if (arguments->error != NULL &&
        !tinker_option_value("error", arguments->error, none, 0, TRUE, &options->error, error))
        return FALSE;
    if (arguments->budget != NULL &&
        !tinker_option_value("budget", arguments->budget, time, 0, TRUE, &options->budget, error))
        return FALSE;
    return arguments->seconds == NULL ||
           tinker_option_value("seconds", arguments->seconds, time, 0, TRUE, &options->seconds, error);
}

static char **read_methods(const char *text)
{
    char **methods = g_strsplit(text, ",", -1);
    for (char **method = methods; *method != NULL; method++)
        g_strstrip(*method);
    return methods;
}

static gboolean read_outputs(TradeJob *job, const TradeArguments *arguments, const TinkerOpenScene *open,
                             GError **error)
{
    static const char *const endings[] = {".png", ".svg", ".pdf", NULL};
    const TinkerAskedOutput outputs[] = {{"--csv", arguments->csv}, {"--output", arguments->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    job->width = WIDTH;
    job->height = HEIGHT;
    if (arguments->write && tinker_is_standard_stream(open->path)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--write needs a scene that is a file (standard input cannot be written to)");
        return FALSE;
    }
    if (arguments->write && !tinker_output_is_writable(open->path, error)) return FALSE;
    if (!tinker_picture_arguments_read(&arguments->picture, &job->width, &job->height, &job->theme, error))
        return FALSE;
    if (arguments->output != NULL && tinker_picture_ending(arguments->output, endings, error) < 0) return FALSE;
    return arguments->csv == NULL || tinker_output_open(&job->csv, arguments->csv, error);
}

/* Everything that can go wrong before the first run does so here. */
static gboolean prepare(TradeJob *job, const TradeArguments *arguments, const TinkerOpenScene *open, GError **error)
{
    TinkerTradeOptions *options = &job->options;
    if (!read_wishes(arguments, open, options, error)) return FALSE;
    if (!tinker_run_arguments_apply(&arguments->run, open->scene, &options->run, error)) return FALSE;
    if (arguments->at != NULL) {
        job->times = tinker_run_arguments_times(arguments->at, error);
        if (job->times == NULL) return FALSE;
        options->run.at = (const double *)(gpointer)job->times->data;
        options->run.at_count = job->times->len;
    }
    if (arguments->methods != NULL) job->methods = read_methods(arguments->methods);
    if (job->methods != NULL && job->methods[0] == NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--methods \"\": no method is named (as in --methods rk4,verlet; `tinker plugins` lists "
                    "them)");
        return FALSE;
    }
    options->methods = (const char *const *)job->methods;
    options->cancelled = tinker_progress_interrupted;
    options->progress = show_progress;
    options->data = &job->progress;
    return read_outputs(job, arguments, open, error);
}

static gboolean draw_chart(const TradeJob *job, const TinkerTrade *trade, const char *title, const char *path,
                           GError **error)
{
    g_autoptr(TinkerTradeChart) chart = tinker_trade_chart_new(trade);
    TinkerPlot plot = tinker_trade_chart_plot(chart, job->theme);
    plot.title = title[0] != '\0' ? title : NULL;
    return tinker_plot_to_file(&plot, job->width, job->height, path, error);
}

static gboolean write_results(TradeJob *job, const TradeArguments *arguments, const TinkerOpenScene *open,
                              const TinkerTrade *trade, GError **error)
{
    FILE *text = tinker_is_standard_stream(arguments->csv) ? stderr : stdout;
    g_autofree char *reference = tinker_trade_reference_text(trade);
    g_autofree char *advice = tinker_trade_advice_text(trade, &job->options);
    tinker_trade_write_tables(trade, text);
    fputc('\n', text);
    tinker_print_text(text, reference);
    tinker_print_text(text, advice);
    if (job->csv.file != NULL) tinker_trade_write_csv(trade, job->csv.file);
    if (!tinker_output_close(&job->csv, error)) return FALSE;
    const char *title = tinker_scene_head(open->scene)->title;
    return arguments->output == NULL || draw_chart(job, trade, title, arguments->output, error);
}

/* Puts the advice into the scene's file, in the units that the scene displays. */
static gboolean write_scene(const TinkerOpenScene *open, const TinkerTrade *trade, GError **error)
{
    gboolean english = tinker_scene_head(open->scene)->units == TINKER_UNIT_SYSTEM_ENGLISH;
    tinker_trade_apply(trade, open->scene);
    if (!tinker_scene_write_file(open->scene, open->path, english ? TINKER_WRITE_ENGLISH : TINKER_WRITE_SI, error))
        return FALSE;
    tinker_report_note("%s: the advised method is now in its run settings", open->name);
    return TRUE;
}

static int trade(const TradeArguments *arguments, const TinkerOpenScene *open)
{
    g_auto(TradeJob) job = {0};
    g_autoptr(GError) error = NULL;
    if (!prepare(&job, arguments, open, &error)) return tinker_open_scene_report_error(open, error);
    tinker_progress_catch_interrupt();
    job.progress = tinker_progress_start("measuring");
    g_autoptr(TinkerTrade) result = tinker_trade_new(open->scene, &job.options, &error);
    tinker_progress_end(&job.progress);
    if (result == NULL) {
        if (g_error_matches(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD)) tinker_blame_option(NULL, &error);
        return tinker_open_scene_report_error(open, error);
    }
    tinker_open_scene_report_warnings(open);
    if (!write_results(&job, arguments, open, result, &error)) return tinker_report_error(open->name, error);
    gboolean advised = result->advice.kind == TINKER_TRADE_ADVICE_MET && !result->interrupted;
    if (result->interrupted) tinker_report_note("stopped: what was measured up to then is above");
    if (arguments->write && !advised)
        tinker_report_note("%s: not changed, as there is no advice that keeps to what was "
                           "wished for",
                           open->name);
    if (arguments->write && advised && !write_scene(open, result, &error))
        return tinker_report_error(open->name, error);
    return result->interrupted || (arguments->write && !advised) ? TINKER_EXIT_RUN_FAILED : TINKER_EXIT_DONE;
}

int tinker_verb_trade(int argc, char **argv)
{
    g_auto(TradeArguments) arguments = {0};
    const GOptionEntry entries[] = {
        {"error", 0, 0, G_OPTION_ARG_FILENAME, &arguments.error,
         "Advise the cheapest for this error (the scene's accuracy, or 1e-6)", "E"},
        {"budget", 0, 0, G_OPTION_ARG_FILENAME, &arguments.budget,
         "Advise the most accurate within this wall time of a run", "S"},
        {"write", 0, 0, G_OPTION_ARG_NONE, &arguments.write, "Put the advice into the scene's file", NULL},
        {"csv", 0, 0, G_OPTION_ARG_FILENAME, &arguments.csv, "Write the measurements to FILE as CSV", "FILE"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &arguments.output, "Draw the chart to FILE (.png, .svg, .pdf)",
         "FILE"},
        {"methods", 0, 0, G_OPTION_ARG_FILENAME, &arguments.methods, "Measure these methods alone", "A,B"},
        {"duration", 0, 0, G_OPTION_ARG_FILENAME, &arguments.run.duration, "How long a motion to run", "S"},
        {"at", 0, 0, G_OPTION_ARG_FILENAME, &arguments.at,
         "Measure errors at these times; runs last to the last of them", "T1,T2,..."},
        {"seconds", 0, 0, G_OPTION_ARG_FILENAME, &arguments.seconds, "How long measuring takes, about (25)", "S"},
        TINKER_PICTURE_ENTRIES(arguments.picture, "900x600"),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    return trade(&arguments, &open);
}
