/* The curves of `tinker graph`, of its own scene and of others beside it. */
#include <math.h>
#include <string.h>

#include "cli/report/chart-table.h"
#include "cli/verb/graph-options.h"
#include "common/program/exit-status.h"
#include "measure/changes.h"

#define MOST_OTHERS 8

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

gboolean tinker_graph_add_curves(TinkerChart *chart, const TinkerGraphOptions *options, const char *path, char **names,
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

TinkerSampleTaker tinker_graph_taker(TinkerChart *chart, gboolean at_events)
{
    return (TinkerSampleTaker){take_sample, begin_again, at_events ? take_event : NULL, chart};
}

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

GPtrArray *tinker_graph_scenes_new(void)
{
    return g_ptr_array_new_with_free_func(free_open_scene);
}

/* The chart of another scene, with curves and options as those of the first; of samples alone where it is written as
 * CSV. */
static TinkerChart *chart_of_scene(const TinkerGraphOptions *options, gboolean csv, TinkerOpenScene *other,
                                   TinkerScene *scene, char **names, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    tinker_scene_head(other->scene)->units = tinker_scene_head(scene)->units; /* one axis has one unit */
    g_autoptr(TinkerChart) chart = tinker_chart_new(other->scene);
    if (!tinker_graph_add_curves(chart, options, other->name, names, error)) return NULL;
    if (!tinker_run_arguments_apply(&options->run, other->scene, &run_options, error)) return NULL;
    if (!tinker_scene_run_until(&run, other->scene, &options->run, NULL, &run_options, error)) return NULL;
    if (!tinker_scene_run_prepare(&run, other->scene, &options->run, &run_options, error)) return NULL;
    const TinkerSampleTaker taker = tinker_graph_taker(chart, !csv);
    if (!tinker_scene_run_go(&run, chart->columns, &taker, error)) return NULL;
    tinker_scene_run_report_end(&run, other->name);
    chart->run = tinker_scene_changes(scene, other->scene);
    return g_steal_pointer(&chart);
}

gboolean tinker_graph_add_others(TinkerChart *chart, const TinkerGraphOptions *options, gboolean csv,
                                 const TinkerOpenScene *open, char **names, GPtrArray *scenes, GError **error)
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
