/* tinker graph: quantities over time, or against one another, as a plot or as CSV. */
#include "cli/verb/verbs.h"

#include <math.h>
#include <string.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/report/chart-table.h"
#include "cli/report/chart.h"
#include "cli/report/statistics-report.h"
#include "common/program/exit-status.h"
#include "measure/changes.h"

static const TinkerVerbHelp help = {
    .verb = "graph",
    .operands = "SCENE [\"BLOCK.QUANTITY\"|\"EXPRESSION\"...]",
    .summary =
        "Runs a scene and draws quantities over time in one graph, or writes them as CSV, in the units that the\n"
        "scene displays. Without a curve the scene's own graphs are drawn. The ending of the output, .png, .svg,\n"
        ".pdf or .csv, says what is written; - is CSV to standard output. `tinker plugins show TYPE` lists the\n"
        "quantities of a block. In an expression quantities and properties stand in braces; values are in SI.",
    .examples =
        "  tinker graph spring-mass.tinker.json \"Mass 0.y\" -o y.svg\n"
        "  tinker graph spring-mass.tinker.json \"Mass 0.y\" --decimals 5 -o y.csv\n"
        "  tinker graph spring-mass.tinker.json \"0.5*{Mass 0.mass}*{Mass 0.vy}^2\" Scene.energy -o energy.svg\n"
        "  tinker graph spring-mass.tinker.json \"Mass 0.y\" --statistics --from 2\n"
        "  tinker graph spring-mass.tinker.json \"Mass 0.vy\" --against y -o phase.png",
    .least_operands = 1,
    .most_operands = -1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *output, *decimals, *against, *log;
    gboolean statistics;
    char **with;
    char **plugin_folders; /* of the command line; borrowed */
    char *from, *to, *json, *spectrum;
} GraphOptions;

static void graph_options_clear(GraphOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->output);
    g_free(options->decimals);
    g_free(options->against);
    g_free(options->log);
    g_free(options->from);
    g_free(options->to);
    g_free(options->json);
    g_free(options->spectrum);
    g_strfreev(options->with);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(GraphOptions, graph_options_clear)

/* How the graph is written. */
typedef struct {
    gboolean csv;
    int decimals;
    int width, height;
    const TinkerTheme *theme;
} GraphForm;

static gboolean read_form(const GraphOptions *options, GraphForm *form, GError **error)
{
    static const char *const endings[] = {".csv", ".png", ".svg", ".pdf", NULL};
    *form = (GraphForm){.decimals = -1, .width = 800, .height = 500};
    if (options->decimals != NULL &&
        !tinker_option_integer("decimals", options->decimals, 0, 17, &form->decimals, error))
        return FALSE;
    if (!tinker_picture_arguments_read(&options->picture, &form->width, &form->height, &form->theme, error))
        return FALSE;
    int place = tinker_is_standard_stream(options->output) ? 0 : tinker_picture_ending(options->output, endings, error);
    form->csv = place == 0;
    return place >= 0;
}

static void report_left_out(const TinkerSceneGraph *graph)
{
    const TinkerSceneCurve *curve = tinker_scene_graph_curve(graph);
    if (graph->curves->len > 1 || curve == NULL) {
        tinker_report_warning("a graph of several curves left out: other axes than the first");
        return;
    }
    g_autofree char *against = g_str_equal(graph->against, "time") ? g_strdup("")
                               : g_str_equal(graph->against, "frequency")
                                   ? g_strdup(" --spectrum hann")
                                   : g_strdup_printf(" --against \"%s\"", graph->against);
    tinker_report_warning("graph of %s.%s left out: other axes than the first (to draw it: tinker graph SCENE "
                          "\"%s.%s\"%s -o ...)",
                          curve->block, curve->quantity, curve->block, curve->quantity, against);
}

static gboolean read_window(const GraphOptions *options, TinkerWindow *window, GError **error)
{
    *window = g_strcmp0(options->spectrum, "none") == 0 ? TINKER_WINDOW_RECTANGULAR : TINKER_WINDOW_HANN;
    const char *wrong = NULL;
    if (options->spectrum == NULL) return TRUE;
    if (!g_str_equal(options->spectrum, "hann") && !g_str_equal(options->spectrum, "none"))
        wrong = "it must be hann or none";
    else if (options->against != NULL || options->with != NULL)
        wrong = "a spectrum is of curves over time, and of one run: leave out --against and --with";
    if (wrong == NULL) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--spectrum %s: %s", options->spectrum, wrong);
    return FALSE;
}

static gboolean read_log(TinkerChart *chart, const char *axes, GError **error)
{
    for (const char *axis = axes; axis != NULL && *axis != '\0'; axis++) {
        if (*axis != 'x' && *axis != 'y') {
            g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--log is \"%s\" (it must be x, y or xy)",
                        axes);
            return FALSE;
        }
        chart->logarithmic[*axis == 'y'] = TRUE;
    }
    return TRUE;
}

static gboolean add_curves(TinkerChart *chart, const GraphOptions *options, const char *path, char **names,
                           GError **error)
{
    g_autoptr(GPtrArray) left_out = g_ptr_array_new();
    for (char **name = names; *name != NULL; name++)
        if (!tinker_chart_add(chart, *name, options->against, error)) {
            tinker_blame_option(NULL, error);
            return FALSE;
        }
    if (names[0] == NULL && !tinker_chart_add_graphs_of_scene(chart, path, left_out, error)) return FALSE;
    for (guint i = 0; i < left_out->len; i++)
        report_left_out(g_ptr_array_index(left_out, i));
    if (names[0] != NULL) tinker_chart_part_axes(chart);
    if (chart->curves->len > 0) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "the scene holds no graphs; name a curve (as in \"Mass 0.y\")");
    return FALSE;
}

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    return tinker_chart_sample(data, time, values, tinker_simulation_bands(simulation), error);
}

static gboolean take_event(TinkerSimulation *simulation, double time, const double *before, const double *behind,
                           void *data, GError **error)
{
    return tinker_chart_at_event(data, time, before, behind, error);
}

static void begin_again(void *chart)
{
    tinker_chart_cut(chart, -INFINITY);
}

/* What is drawn or measured has its jumps where they are. */
static TinkerSampleTaker taker_of(TinkerChart *chart, gboolean at_events)
{
    return (TinkerSampleTaker){take_sample, begin_again, at_events ? take_event : NULL, chart};
}

#define MOST_OTHERS 8

/* "stiff" of "some/stiff.tinker.json". (transfer full) */
static char *short_name(const char *path)
{
    char *name = g_path_get_basename(path);
    static const char *const endings[] = {".tinker.json", ".json", ".csv"};
    for (gsize i = 0; i < G_N_ELEMENTS(endings); i++)
        if (g_str_has_suffix(name, endings[i]) && strlen(name) > strlen(endings[i])) {
            name[strlen(name) - strlen(endings[i])] = '\0';
            break;
        }
    return name;
}

static void free_open_scene(gpointer open)
{
    tinker_open_scene_clear(open);
    g_free(open);
}

/* The chart of another scene, with curves and options as those of the first; of samples alone where it is written as
 * CSV. */
static TinkerChart *chart_of_scene(const GraphOptions *options, gboolean csv, TinkerOpenScene *other,
                                   TinkerScene *scene, char **names, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    g_autoptr(TinkerChart) chart = tinker_chart_new(other->scene);
    if (!add_curves(chart, options, other->name, names, error)) return NULL;
    if (!tinker_run_arguments_apply(&options->run, other->scene, &run_options, error)) return NULL;
    if (!tinker_scene_run_until(&run, other->scene, &options->run, NULL, &run_options, error)) return NULL;
    if (!tinker_scene_run_prepare(&run, other->scene, &options->run, &run_options, error)) return NULL;
    const TinkerSampleTaker taker = taker_of(chart, !csv);
    if (!tinker_scene_run_go(&run, chart->columns, &taker, error)) return NULL;
    tinker_scene_run_report_end(&run, other->name);
    chart->run = tinker_scene_changes(scene, other->scene);
    return g_steal_pointer(&chart);
}

/* The runs of --with, in the chart of this one. `scenes` keeps theirs. */
static gboolean add_others(TinkerChart *chart, const GraphOptions *options, gboolean csv, const TinkerOpenScene *open,
                           char **names, GPtrArray *scenes, GError **error)
{
    if (options->with == NULL) return TRUE;
    if (names[0] == NULL || g_strv_length(options->with) > MOST_OTHERS) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--with %s",
                    names[0] == NULL ? "needs a curve that is named (as in \"Mass 0.y\")"
                                     : "may be given eight times at most");
        return FALSE;
    }
    chart->run = short_name(open->name);
    for (char **path = options->with; *path != NULL; path++) {
        TinkerChart *other = NULL;
        if (g_str_has_suffix(*path, ".csv")) {
            other = tinker_chart_of_table(chart, names, options->against, *path, error);
        } else {
            TinkerOpenScene *scene = g_new0(TinkerOpenScene, 1);
            g_ptr_array_add(scenes, scene);
            if (tinker_open_scene(scene, options->plugin_folders, *path) != TINKER_EXIT_DONE) {
                g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--with: %s cannot be opened", *path);
                return FALSE;
            }
            other = chart_of_scene(options, csv, scene, open->scene, names, error);
            if (other == NULL) g_prefix_error(error, "--with: %s: ", *path);
        }
        if (other == NULL) return FALSE;
        if (other->run == NULL) other->run = short_name(*path);
        g_ptr_array_add(chart->others, other);
    }
    return TRUE;
}

/* Between two samples curves are made of cubics: so many samples an interval make them as good as the run. */
#define STATISTIC_SAMPLES 16

/* The interval of the statistics: all of the run where nothing is said. */
static gboolean read_interval(const GraphOptions *options, double *from, double *to, GError **error)
{
    static const TinkerDimension time = {.time = 1};
    if (options->from != NULL && !tinker_option_value("from", options->from, time, 0, FALSE, from, error)) return FALSE;
    if (options->to != NULL && !tinker_option_value("to", options->to, time, 0, TRUE, to, error)) return FALSE;
    if (*from < *to) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--from and --to leave nothing (from %g s to %g s)",
                *from, *to);
    return FALSE;
}

/* In the place of curves over time. */
static gboolean write_spectrum(TinkerChart *chart, const TinkerSpectrumOptions *spectrum, const GraphForm *form,
                               const GraphOptions *options, GError **error)
{
    if (form->csv) return tinker_chart_write_spectrum_csv(chart, spectrum, form->decimals, options->output, error);
    return tinker_chart_draw_spectrum(chart, spectrum, form->theme, form->width, form->height, options->output, error);
}

static gboolean statistics(const GraphOptions *options, const TinkerOpenScene *open, char **names, GError **failure,
                           GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    g_auto(TinkerOutput) json = {0};
    const TinkerAskedOutput outputs[] = {{"--json", options->json}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autoptr(TinkerChart) chart = tinker_chart_new(open->scene);
    if (options->output != NULL || options->against != NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--statistics draws nothing, and measures curves over time (leave out --output and --against)");
        return FALSE;
    }
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (!add_curves(chart, options, open->name, names, error)) return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return FALSE;
    run_options.interval /= STATISTIC_SAMPLES;
    if (!tinker_scene_run_until(&run, open->scene, &options->run, NULL, &run_options, error)) return FALSE;
    double from = 0, to = tinker_options_duration(&run_options);
    if (!read_interval(options, &from, &to, error)) return FALSE;
    run_options.bands = TRUE;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return FALSE;
    const TinkerSampleTaker taker = taker_of(chart, TRUE);
    if (!tinker_scene_run_go(&run, chart->columns, &taker, failure))
        tinker_chart_cut(chart, tinker_simulation_summary(run.simulation)->valid_until);
    tinker_scene_run_report_warnings(&run, open, &options->run);
    if (*failure == NULL) tinker_scene_run_report_end(&run, open->name);
    if (options->json != NULL && !tinker_output_open(&json, options->json, error)) return FALSE;
    if (!tinker_statistics_report(chart, from, to, tinker_is_standard_stream(options->json) ? NULL : stdout, json.file,
                                  error))
        return FALSE;
    return tinker_output_close(&json, error);
}

/* What was recorded is written even when the run fails; its error is in `failure` then. */
static gboolean graph(const GraphOptions *options, const TinkerOpenScene *open, char **names, GError **failure,
                      GError **error)
{
    GraphForm form;
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autoptr(GPtrArray) scenes = g_ptr_array_new_with_free_func(free_open_scene);
    g_autoptr(TinkerChart) chart = tinker_chart_new(open->scene);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    TinkerSpectrumOptions spectrum = {0};
    if (!read_log(chart, options->log, error) || !read_window(options, &spectrum.window, error)) return FALSE;
    if (!read_form(options, &form, error) || !add_curves(chart, options, open->name, names, error)) return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return FALSE;
    if (!tinker_scene_run_until(&run, open->scene, &options->run, NULL, &run_options, error)) return FALSE;
    spectrum.to = tinker_options_duration(&run_options);
    if (!read_interval(options, &spectrum.from, &spectrum.to, error)) return FALSE;
    const gboolean is_spectrum = options->spectrum != NULL || chart->is_spectrum;
    if (!is_spectrum && (options->from != NULL || options->to != NULL))
        tinker_report_warning("--from and --to have no effect without --spectrum or --statistics");
    run_options.bands = !form.csv && !is_spectrum && options->with == NULL;
    if (!add_others(chart, options, form.csv, open, names, scenes, error)) return FALSE;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return FALSE;
    const TinkerSampleTaker taker = taker_of(chart, !form.csv && !is_spectrum);
    (void)tinker_scene_run_go(&run, chart->columns, &taker, failure);
    if (*failure != NULL) tinker_chart_cut(chart, tinker_simulation_summary(run.simulation)->valid_until);
    tinker_scene_run_report_warnings(&run, open, &options->run);
    if (*failure == NULL) tinker_scene_run_report_end(&run, open->name);
    if (is_spectrum) return write_spectrum(chart, &spectrum, &form, options, error);
    if (form.csv) return tinker_chart_write_csv(chart, form.decimals, options->output, error);
    return tinker_chart_draw(chart, form.theme, form.width, form.height, options->output, error);
}

int tinker_verb_graph(int argc, char **argv)
{
    g_auto(GraphOptions) options = {0};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Write to FILE (.png, .svg, .pdf, .csv, or -)",
         "FILE"},
        {"against", 0, 0, G_OPTION_ARG_FILENAME, &options.against,
         "Draw against this quantity instead of time: a phase plot", "QUANTITY"},
        {"with", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options.with,
         "The same curves of another scene, or of a record (.csv), in one graph (up to eight times)", "FILE"},
        {"log", 0, 0, G_OPTION_ARG_FILENAME, &options.log, "Logarithmic axes: x, y or xy", "AXES"},
        {"statistics", 0, 0, G_OPTION_ARG_NONE, &options.statistics,
         "Tell mean, rms, extrema, period and damping of each curve, with their errors, in the place of drawing", NULL},
        {"spectrum", 0, 0, G_OPTION_ARG_FILENAME, &options.spectrum,
         "Amplitudes over frequency, with this window: hann or none", "WINDOW"},
        {"from", 0, 0, G_OPTION_ARG_FILENAME, &options.from, "Spectrum or statistics from this time on", "T"},
        {"to", 0, 0, G_OPTION_ARG_FILENAME, &options.to, "Spectrum or statistics up to this time", "T"},
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &options.json, "Write the statistics to FILE as JSON", "FILE"},
        {"decimals", 0, 0, G_OPTION_ARG_FILENAME, &options.decimals,
         "Digits behind the point in CSV, trailing zeros dropped (default: 9 significant digits)", "N"},
        TINKER_PICTURE_ENTRIES(options.picture, "800x500"),
        TINKER_RUN_ENTRIES(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;

    options.plugin_folders = line.plugin_folders;
    g_auto(TinkerOpenScene) open = {0};
    status = tinker_open_scene(&open, line.plugin_folders, line.operands[0]);
    if (status != TINKER_EXIT_DONE) return status;
    g_autoptr(GError) error = NULL, failure = NULL;
    gboolean (*work)(const GraphOptions *, const TinkerOpenScene *, char **, GError **, GError **) =
        options.statistics ? statistics : graph;
    if (!work(&options, &open, line.operands + 1, &failure, &error))
        return tinker_open_scene_report_error(&open, error);
    return failure != NULL ? tinker_report_error(open.name, failure) : TINKER_EXIT_DONE;
}
