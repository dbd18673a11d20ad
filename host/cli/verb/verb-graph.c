/* tinker graph: quantities over time, or against one another, as a plot or as CSV. */
#include "cli/verb/verbs.h"

#include "cli/command/output.h"
#include "cli/report/statistics-report.h"
#include "cli/verb/graph-options.h"
#include "common/program/exit-status.h"

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

/* Between two samples curves are made of cubics: so many samples an interval make them as good as the run. */
#define STATISTIC_SAMPLES 16

/* In the place of curves over time. */
static gboolean write_spectrum(TinkerChart *chart, const TinkerSpectrumOptions *spectrum, const TinkerGraphForm *form,
                               const TinkerGraphOptions *options, GError **error)
{
    if (form->csv) return tinker_chart_write_spectrum_csv(chart, spectrum, form->decimals, options->output, error);
    return tinker_chart_draw_spectrum(chart, spectrum, form->theme, form->width, form->height, options->output, error);
}

static gboolean statistics(const TinkerGraphOptions *options, const TinkerOpenScene *open, char **names,
                           GError **failure, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    g_auto(TinkerOutput) json = {0};
    const TinkerAskedOutput outputs[] = {{"--json", options->json}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autoptr(TinkerChart) chart = tinker_chart_new(open->scene);
    if (options->output != NULL || options->against != NULL || options->with != NULL) {
        g_set_error(
            error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
            "--statistics draws nothing, and measures curves of one run over time (leave out --output, --against "
            "and --with)");
        return FALSE;
    }
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (!tinker_graph_add_curves(chart, options, open->name, names, error)) return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return FALSE;
    run_options.interval /= STATISTIC_SAMPLES;
    if (!tinker_scene_run_until(&run, open->scene, &options->run, NULL, &run_options, error)) return FALSE;
    double from = 0, to = tinker_options_duration(&run_options);
    if (!tinker_graph_read_interval(options, &from, &to, error)) return FALSE;
    run_options.bands = TRUE;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return FALSE;
    const TinkerSampleTaker taker = tinker_graph_taker(chart, TRUE);
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
static gboolean graph(const TinkerGraphOptions *options, const TinkerOpenScene *open, char **names, GError **failure,
                      GError **error)
{
    TinkerGraphForm form;
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autoptr(GPtrArray) scenes = tinker_graph_scenes_new();
    g_autoptr(TinkerChart) chart = tinker_chart_new(open->scene);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    TinkerSpectrumOptions spectrum = {0};
    if (!tinker_graph_read_log(chart, options->log, error) ||
        !tinker_graph_read_window(options, &spectrum.window, error))
        return FALSE;
    if (!tinker_graph_read_form(options, &form, error) ||
        !tinker_graph_add_curves(chart, options, open->name, names, error))
        return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return FALSE;
    if (!tinker_scene_run_until(&run, open->scene, &options->run, NULL, &run_options, error)) return FALSE;
    spectrum.to = tinker_options_duration(&run_options);
    if (!tinker_graph_read_interval(options, &spectrum.from, &spectrum.to, error)) return FALSE;
    const gboolean is_spectrum = options->spectrum != NULL || chart->is_spectrum;
    if (!is_spectrum && (options->from != NULL || options->to != NULL))
        tinker_report_warning("--from and --to have no effect without --spectrum or --statistics");
    run_options.bands = !form.csv && !is_spectrum && options->with == NULL;
    if (!tinker_graph_add_others(chart, options, form.csv, open, names, scenes, error)) return FALSE;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return FALSE;
    const TinkerSampleTaker taker = tinker_graph_taker(chart, !form.csv && !is_spectrum);
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
    g_auto(TinkerGraphOptions) options = {0};
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
    gboolean (*work)(const TinkerGraphOptions *, const TinkerOpenScene *, char **, GError **, GError **) =
        options.statistics ? statistics : graph;
    if (!work(&options, &open, line.operands + 1, &failure, &error))
        return tinker_open_scene_report_error(&open, error);
    return failure != NULL ? tinker_report_error(open.name, failure) : TINKER_EXIT_DONE;
}
