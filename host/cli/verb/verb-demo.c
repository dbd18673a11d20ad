/* tinker demo: the bundled spring-mass scene, run once, as record, graph and picture. */
#include "cli/verb/verbs.h"

#include <errno.h>
#include <stdio.h>

#include <glib/gstdio.h>

#include "cli/command/options.h"
#include "cli/command/run-arguments.h"
#include "cli/report/chart.h"
#include "cli/report/csv-record.h"
#include "common/program/exit-status.h"
#include "common/program/installation.h"
#include "common/program/print.h"
#include "render/picture/painter.h"

#define DEMO "spring-mass"

static const TinkerVerbHelp help = {
    .verb = "demo",
    .operands = "",
    .summary = "Runs the bundled scene of a mass on a spring and writes its record, its graph and its picture.",
    .examples = "  tinker demo\n"
                "  tinker demo --output-folder results",
};

/* The two takers of the one run's samples; the chart's values follow the record's. */
typedef struct {
    TinkerCsvRecord csv;
    TinkerChart *chart;
    GArray *record_columns, *all_columns; /* the latter borrows its elements */
} Demo;

static void demo_clear(Demo *demo)
{
    tinker_csv_record_clear(&demo->csv);
    g_clear_pointer(&demo->chart, tinker_chart_free);
    g_clear_pointer(&demo->record_columns, g_array_unref);
    g_clear_pointer(&demo->all_columns, g_array_unref);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Demo, demo_clear)

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Demo *demo = data;
    return tinker_csv_record_add(&demo->csv, time, values, error) &&
           tinker_chart_sample(demo->chart, time, values + demo->record_columns->len, NULL, error);
}

static gboolean demo_init(Demo *demo, TinkerScene *scene, const char *csv, GError **error)
{
    g_autoptr(GPtrArray) left_out = g_ptr_array_new();
    demo->chart = tinker_chart_new(scene);
    if (!tinker_chart_add_graphs_of_scene(demo->chart, "", left_out, error)) return FALSE;
    demo->record_columns = tinker_columns_default(scene);
    demo->all_columns = g_array_new(FALSE, FALSE, sizeof(TinkerColumn));
    g_array_append_vals(demo->all_columns, demo->record_columns->data, demo->record_columns->len);
    g_array_append_vals(demo->all_columns, demo->chart->columns->data, demo->chart->columns->len);
    return tinker_csv_record_open(&demo->csv, csv, demo->record_columns, error);
}

static gboolean draw(Demo *demo, TinkerScene *scene, const char *svg, const char *png, const char *picture,
                     GError **error)
{
    const TinkerTheme *light = tinker_theme_find("light");
    TinkerPaintOptions paint = tinker_paint_options_default();
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    return frame != NULL && tinker_chart_draw(demo->chart, light, 800, 500, svg, error) &&
           tinker_chart_draw(demo->chart, light, 800, 500, png, error) &&
           tinker_paint_to_file(frame, NULL, 800, 600, &paint, picture, error);
}

static gboolean show(const TinkerOpenScene *open, const char *folder, GError **error)
{
    g_autofree char *csv = g_build_filename(folder, DEMO ".csv", NULL);
    g_autofree char *svg = g_build_filename(folder, DEMO "-graph.svg", NULL);
    g_autofree char *png = g_build_filename(folder, DEMO "-graph.png", NULL);
    g_autofree char *picture = g_build_filename(folder, DEMO ".png", NULL);
    TinkerRunArguments arguments = {0};
    TinkerRunOptions options;
    g_auto(TinkerSceneRun) run = {0};
    g_auto(Demo) demo = {0};
    const TinkerAskedOutput outputs[] = {
        {"record", csv}, {"graph", svg}, {"graph", png}, {"picture", picture}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (!tinker_run_arguments_apply(&arguments, open->scene, &options, error)) return FALSE;
    if (!tinker_scene_run_prepare(&run, open->scene, &arguments, &options, error)) return FALSE;
    if (!demo_init(&demo, open->scene, csv, error)) return FALSE;
    const TinkerSampleTaker taker = {.sample = take_sample, .data = &demo}; /* the scene asks for no accuracy */
    if (!tinker_scene_run_go(&run, demo.all_columns, &taker, error)) return FALSE;
    tinker_scene_run_report_warnings(&run, open, &arguments);
    if (!tinker_csv_record_close(&demo.csv, tinker_simulation_summary(run.simulation)->valid_until, error))
        return FALSE;
    if (!draw(&demo, open->scene, svg, png, picture, error)) return FALSE;

    tinker_print_line(stdout, "%s: the record, a row every %g s (spreadsheets open it)", csv, options.interval);
    tinker_print_line(stdout, "%s: the graph of the mass's height over time, for documents and browsers", svg);
    tinker_print_line(stdout, "%s: the same graph as an image", png);
    tinker_print_line(stdout, "%s: the scene as it is drawn", picture);
    return TRUE;
}

int tinker_verb_demo(int argc, char **argv)
{
    g_autofree char *given = NULL;
    const GOptionEntry entries[] = {
        {"output-folder", 0, 0, G_OPTION_ARG_FILENAME, &given, "Write the files to DIR (the current folder)", "DIR"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;
    const char *folder = given != NULL ? given : ".";
    if (g_mkdir_with_parents(folder, 0777) != 0) {
        tinker_report_note("%s: cannot be made: %s", folder, g_strerror(errno));
        return TINKER_EXIT_FILE;
    }
    g_autofree char *scene = tinker_installation_scene(DEMO ".tinker.json");
    g_auto(TinkerOpenScene) open = {0};
    status = tinker_open_scene(&open, line.plugin_folders, scene);
    if (status != TINKER_EXIT_DONE) return status;
    g_autoptr(GError) error = NULL;
    return show(&open, folder, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
