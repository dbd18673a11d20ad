/* The curves of the graph, each of which reads the record by itself. */
#include "gui/curve/graph-data-private.h"

static void line_free(GraphLine *line)
{
    tinker_graph_series_free(line->series);
    tinker_thin_path_clear(&line->thin);
    g_free(line->name);
    g_free(line->label);
    g_free(line->run_name);
    g_free(line);
}

static void forget_points(TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++) {
        if (graph_line(data, i)->run != NULL) continue;
        tinker_graph_series_forget(graph_line(data, i)->series);
        tinker_thin_path_forget(&graph_line(data, i)->thin);
    }
    data->revision++;
}

/* The graph -------------------------------------------------------------------------------------------------------- */

static void add_line(TinkerGraphData *data, const TinkerSceneCurve *curve, TinkerKeptRun *run, GPtrArray *old)
{
    GraphLine *line = g_new0(GraphLine, 1);
    TinkerScene *now = tinker_document_scene(data->document), *scene = run != NULL ? run->scene : now;
    if (run != NULL) tinker_scene_head(scene)->units = tinker_scene_head(now)->units;
    line->series = tinker_graph_series_new(scene, tinker_document_base(data->document), data->graph, curve);
    line->run = run;
    tinker_thin_path_init(&line->thin);
    for (guint i = 0; i < old->len; i++) {
        GraphLine *other = g_ptr_array_index(old, i);
        if (other->run != run || !tinker_graph_series_take_over(line->series, other->series)) continue;
        line->generation = other->generation;
        g_ptr_array_remove_index(old, i);
        break;
    }
    g_ptr_array_add(data->lines, line);
}

static void add_lines_of(TinkerGraphData *data, TinkerKeptRun *run, GPtrArray *old)
{
    for (guint i = 0; i < data->graph->curves->len; i++) {
        const TinkerSceneCurve *curve = g_ptr_array_index(data->graph->curves, i);
        if (run == NULL || curve->table == NULL) add_line(data, curve, run, old);
    }
}

static void add_lines(TinkerGraphData *data, GPtrArray *old)
{
    TinkerKeptRuns *kept = tinker_player_kept(data->player);
    data->lines = g_ptr_array_new_with_free_func((GDestroyNotify)line_free);
    add_lines_of(data, NULL, old);
    data->own = data->lines->len;
    for (guint i = 0; i < tinker_kept_runs_count(kept); i++)
        if (tinker_kept_runs_at(kept, i)->shown) add_lines_of(data, tinker_kept_runs_at(kept, i), old);
}

static void on_kept_changed(TinkerKeptRuns *runs, TinkerGraphData *data)
{
    if (data->graph == NULL) return;
    g_autoptr(GPtrArray) old = g_steal_pointer(&data->lines);
    add_lines(data, old);
    data->revision++;
    graph_data_renew_texts(data);
}

void tinker_graph_data_set_graph(TinkerGraphData *data, const TinkerSceneGraph *graph)
{
    g_autoptr(GPtrArray) old = g_steal_pointer(&data->lines);
    g_clear_pointer(&data->graph, tinker_scene_graph_free);
    data->graph = tinker_scene_graph_copy(graph);
    data->over_time = g_str_equal(graph->against, "time");
    data->is_spectrum = g_str_equal(graph->against, "frequency");
    add_lines(data, old);
    data->is_path = !data->over_time;
    for (guint i = 0; i < data->lines->len && data->is_path; i++)
        data->is_path = tinker_graph_axes_of_path(tinker_graph_series_x_axis(graph_line(data, i)->series),
                                                  tinker_graph_series_y_axis(graph_line(data, i)->series));
    data->revision++;
    graph_data_renew_texts(data);
}

TinkerDocument *tinker_graph_data_document(const TinkerGraphData *data)
{
    return data->document;
}

const char *tinker_graph_data_title(const TinkerGraphData *data)
{
    return data->title;
}

const char *tinker_graph_data_against(const TinkerGraphData *data)
{
    return data->graph != NULL ? data->graph->against : NULL;
}

gboolean tinker_graph_data_is_over_time(const TinkerGraphData *data)
{
    return data->over_time;
}

gboolean tinker_graph_data_is_spectrum(const TinkerGraphData *data)
{
    return data->is_spectrum;
}

/* The record ------------------------------------------------------------------------------------------------------- */

static gboolean read_player(gpointer source, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                            GArray *values)
{
    return tinker_player_series(source, quantity, cursor, times, values);
}

static gboolean read_band(gpointer source, TinkerQuantity quantity, double until, double *band)
{
    return tinker_player_band(source, quantity, until, band);
}

static gboolean read_kept_band(gpointer source, TinkerQuantity quantity, double until, double *band)
{
    return tinker_recording_band(source, quantity, until, band);
}

static gboolean read_kept(gpointer source, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                          GArray *values)
{
    return tinker_recording_series(source, quantity, cursor, times, values);
}

static gboolean update_line(TinkerGraphData *data, GraphLine *line)
{
    if (line->run == NULL) return tinker_graph_series_update(line->series, read_player, data->player);
    const guint generation = tinker_recording_generation(&line->run->recording);
    if (generation != line->generation) {
        tinker_graph_series_forget(line->series);
        tinker_thin_path_forget(&line->thin);
    }
    line->generation = generation;
    return tinker_graph_series_update(line->series, read_kept, &line->run->recording);
}

guint64 tinker_graph_data_update(TinkerGraphData *data)
{
    const guint generation = tinker_player_generation(data->player);
    const double before = data->time;
    if (generation != data->generation) forget_points(data);
    data->generation = generation;
    for (guint i = 0; i < data->lines->len; i++)
        if (update_line(data, graph_line(data, i))) data->revision++;
    data->time = tinker_player_time(data->player);
    if (data->time != before) data->revision++;
    return data->revision;
}

gboolean tinker_graph_data_is_behind(const TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++)
        if (tinker_graph_series_is_behind(graph_line(data, i)->series)) return TRUE;
    return FALSE;
}

void tinker_graph_data_catch_up(TinkerGraphData *data)
{
    do
        tinker_graph_data_update(data);
    while (tinker_graph_data_is_behind(data));
}

guint tinker_graph_data_own_curves(const TinkerGraphData *data)
{
    return data->own;
}

guint tinker_graph_data_curves(const TinkerGraphData *data)
{
    return data->lines->len;
}

const TinkerGraphSeries *tinker_graph_data_curve(const TinkerGraphData *data, guint curve)
{
    return graph_line(data, curve)->series;
}

const char *tinker_graph_data_name(const TinkerGraphData *data, guint curve)
{
    return graph_line(data, curve)->name;
}

const char *tinker_graph_data_run(const TinkerGraphData *data, guint curve)
{
    return graph_line(data, curve)->run_name;
}

gboolean tinker_graph_data_begins_run(const TinkerGraphData *data, guint curve)
{
    return curve >= data->own &&
           (curve == data->own || graph_line(data, curve)->run != graph_line(data, curve - 1)->run);
}

gsize tinker_graph_data_count(const TinkerGraphData *data)
{
    return data->lines->len > 0 ? tinker_graph_series_count(graph_line(data, 0)->series) : 0;
}

const double *tinker_graph_data_x(const TinkerGraphData *data)
{
    return tinker_graph_series_x(graph_line(data, 0)->series);
}

const double *tinker_graph_data_y(const TinkerGraphData *data)
{
    return tinker_graph_series_y(graph_line(data, 0)->series);
}

gboolean tinker_graph_data_is_empty(const TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++)
        if (tinker_graph_series_count(graph_line(data, i)->series) > 0) return FALSE;
    return TRUE;
}

gboolean tinker_graph_data_run_error(const TinkerGraphData *data, guint curve, double from, double to, double *error)
{
    const GraphLine *line = graph_line(data, curve);
    if (line->run != NULL)
        return tinker_graph_series_run_error(line->series, read_kept, read_kept_band, &line->run->recording, from, to,
                                             error);
    return tinker_graph_series_run_error(line->series, read_player, read_band, data->player, from, to, error);
}

static gboolean find_peak(const TinkerGraphSeries *series, gsize *point)
{
    const double *y = tinker_graph_series_y(series);
    const gsize count = tinker_graph_series_count(series);
    *point = 0;
    for (gsize i = 1; i < count; i++)
        if (y[i] > y[*point]) *point = i;
    return count > 0;
}

gboolean tinker_graph_data_present(const TinkerGraphData *data, guint curve, gsize *point)
{
    if (data->is_spectrum) return curve < data->lines->len && find_peak(graph_line(data, curve)->series, point);
    return curve < data->lines->len && tinker_graph_series_find(graph_line(data, curve)->series, data->time, point);
}

gsize tinker_graph_data_point(const TinkerGraphData *data, guint curve, gsize drawn)
{
    return data->drawn_thin ? g_array_index(graph_line(data, curve)->thin.kept, guint, drawn) : drawn;
}

/* Life ------------------------------------------------------------------------------------------------------------- */

TinkerGraphData *tinker_graph_data_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerGraphData *data = g_new0(TinkerGraphData, 1);
    data->document = g_object_ref(document);
    data->player = g_object_ref(player);
    data->generation = tinker_player_generation(player);
    data->lines = g_ptr_array_new_with_free_func((GDestroyNotify)line_free);
    g_signal_connect(tinker_player_kept(player), "changed", G_CALLBACK(on_kept_changed), data);
    data->curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurve));
    data->now = g_array_new(FALSE, FALSE, sizeof(double));
    return data;
}

void tinker_graph_data_free(TinkerGraphData *data)
{
    if (data == NULL) return;
    g_signal_handlers_disconnect_by_data(tinker_player_kept(data->player), data);
    g_object_unref(data->document);
    g_object_unref(data->player);
    g_clear_pointer(&data->graph, tinker_scene_graph_free);
    char *texts[] = {data->title, data->x_label, data->y_label, data->right_label};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_ptr_array_unref(data->lines);
    g_array_unref(data->curves);
    g_array_unref(data->now);
    g_free(data);
}
