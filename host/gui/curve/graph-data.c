/* The curves of the graph, each of which reads the record by itself. */
#include "gui/curve/graph-data.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/curve/thin-path.h"
#include "gui/text/translate.h"

/* One curve. */
typedef struct {
    TinkerGraphSeries *series;
    TinkerKeptRun *run;  /* borrowed; NULL: the present one */
    guint generation;    /* of what is kept */
    char *name, *label;  /* in a legend */
    TinkerThinPath thin; /* of a path */
} Line;

struct _TinkerGraphData {
    TinkerDocument *document;
    TinkerPlayer *player;

    /* The graph. */
    TinkerSceneGraph *graph; /* NULL at first */
    GPtrArray *lines;        /* of Line: the present run's, then those of each run that is kept */
    guint own;               /* lines of the present run */
    char *title;
    char *x_label, *y_label, *right_label;
    gboolean over_time, is_path;

    /* The record. */
    guint generation;
    double time;      /* s: the present */
    guint64 revision; /* of the picture */
    gboolean drawn_thin;

    /* What a plot borrows. */
    GArray *curves; /* of TinkerCurve */
    GArray *now;    /* of double: x and y of each curve at present, in turn */
    double axes_x[2], axes_y[2], floor_y[2], ranges[2][2];
};

static Line *line_of(const TinkerGraphData *data, guint number)
{
    return g_ptr_array_index(data->lines, number);
}

static void line_free(Line *line)
{
    tinker_graph_series_free(line->series);
    tinker_thin_path_clear(&line->thin);
    g_free(line->name);
    g_free(line->label);
    g_free(line);
}

static void forget_points(TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++) {
        if (line_of(data, i)->run != NULL) continue;
        tinker_graph_series_forget(line_of(data, i)->series);
        tinker_thin_path_forget(&line_of(data, i)->thin);
    }
    data->revision++;
}

/* The graph -----------------------------------------------------------------------------------------------------------
 */

static const char *y_title(const TinkerGraphData *data, guint number)
{
    return tinker_translate(tinker_graph_series_y_axis(line_of(data, number)->series)->title);
}

/* "Mass 0: Y Position"; "Y Position" where all curves are of one block. (transfer full) */
static char *name_of(const TinkerGraphData *data, guint number, gboolean with_block)
{
    const char *block = tinker_graph_series_block(line_of(data, number)->series);
    if (!with_block || block[0] == '\0') return g_strdup(y_title(data, number));
    return g_strdup_printf("%s: %s", block, y_title(data, number));
}

static gboolean has_one_block(const TinkerGraphData *data)
{
    const char *first = tinker_graph_series_block(line_of(data, 0)->series);
    for (guint i = 1; i < data->own; i++)
        if (!g_str_equal(tinker_graph_series_block(line_of(data, i)->series), first)) return FALSE;
    return TRUE;
}

typedef enum { AXIS_X, AXIS_LEFT, AXIS_RIGHT } AxisPlace;

/* (transfer full) */
static GArray *axes_of(const TinkerGraphData *data, AxisPlace place)
{
    GArray *axes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphAxis));
    for (guint i = 0; i < data->lines->len; i++) {
        const TinkerGraphSeries *series = line_of(data, i)->series;
        if (place != AXIS_X && tinker_graph_series_is_right(series) != (place == AXIS_RIGHT)) continue;
        TinkerGraphAxis axis =
            *(place == AXIS_X ? tinker_graph_series_x_axis(series) : tinker_graph_series_y_axis(series));
        axis.title = tinker_translate(axis.title);
        g_array_append_val(axes, axis);
    }
    return axes;
}

static char *label_of(const TinkerGraphData *data, AxisPlace place)
{
    g_autoptr(GArray) axes = axes_of(data, place);
    return tinker_graph_axes_label((const TinkerGraphAxis *)(gpointer)axes->data, axes->len);
}

static char *title_of(const TinkerGraphData *data)
{
    if (data->graph->title != NULL && data->graph->title[0] != '\0') return g_strdup(data->graph->title);
    const gboolean one_block = has_one_block(data);
    g_autofree char *first = name_of(data, 0, TRUE);
    if (data->own == 1 && !data->over_time)
        return g_strdup_printf(_("%s over %s"), first,
                               tinker_translate(tinker_graph_series_x_axis(line_of(data, 0)->series)->title));
    GString *title = g_string_new(first);
    for (guint i = 1; i < data->own; i++) {
        g_autofree char *name = name_of(data, i, !one_block);
        g_string_append_printf(title, ", %s", name);
    }
    return g_string_free(title, FALSE);
}

static gboolean has_several_units(const TinkerGraphData *data, gboolean right)
{
    g_autoptr(GArray) axes = axes_of(data, right ? AXIS_RIGHT : AXIS_LEFT);
    for (guint i = 1; i < axes->len; i++)
        if (!g_str_equal(g_array_index(axes, TinkerGraphAxis, i).unit, g_array_index(axes, TinkerGraphAxis, 0).unit))
            return TRUE;
    return FALSE;
}

static void renew_texts(TinkerGraphData *data)
{
    char **texts[] = {&data->title, &data->x_label, &data->y_label, &data->right_label};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_clear_pointer(texts[i], g_free);
    const gboolean one_block = has_one_block(data);
    g_autofree char *now =
        tinker_kept_runs_name_of(tinker_player_kept(data->player), tinker_document_scene(data->document));
    data->title = title_of(data);
    data->x_label = label_of(data, AXIS_X);
    data->y_label = label_of(data, AXIS_LEFT);
    data->right_label = label_of(data, AXIS_RIGHT);
    for (guint i = 0; i < data->lines->len; i++) {
        Line *line = line_of(data, i);
        const char *unit = tinker_graph_series_y_axis(line->series)->unit;
        line->name = name_of(data, i, !one_block);
        if (data->lines->len > data->own && !tinker_graph_series_is_table(line->series)) {
            /* several runs of one curve are told apart by the run alone */
            g_autofree char *plain = line->name;
            const char *run = line->run != NULL ? line->run->name : now;
            line->name = data->own == 1 ? g_strdup(run) : g_strdup_printf("%s (%s)", plain, run);
        }
        line->label = has_several_units(data, tinker_graph_series_is_right(line->series))
                          ? tinker_axis_label(line->name, unit)
                          : g_strdup(line->name);
    }
}

static void add_line(TinkerGraphData *data, const TinkerSceneCurve *curve, TinkerKeptRun *run, GPtrArray *old)
{
    Line *line = g_new0(Line, 1);
    TinkerScene *now = tinker_document_scene(data->document), *scene = run != NULL ? run->scene : now;
    if (run != NULL) tinker_scene_head(scene)->units = tinker_scene_head(now)->units;
    line->series = tinker_graph_series_new(scene, tinker_document_base(data->document), data->graph, curve);
    line->run = run;
    tinker_thin_path_init(&line->thin);
    for (guint i = 0; i < old->len; i++) {
        Line *other = g_ptr_array_index(old, i);
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
    renew_texts(data);
}

void tinker_graph_data_set_graph(TinkerGraphData *data, const TinkerSceneGraph *graph)
{
    g_autoptr(GPtrArray) old = g_steal_pointer(&data->lines);
    g_clear_pointer(&data->graph, tinker_scene_graph_free);
    data->graph = tinker_scene_graph_copy(graph);
    data->over_time = g_str_equal(graph->against, "time");
    add_lines(data, old);
    data->is_path = !data->over_time;
    for (guint i = 0; i < data->lines->len && data->is_path; i++)
        data->is_path = tinker_graph_axes_of_path(tinker_graph_series_x_axis(line_of(data, i)->series),
                                                  tinker_graph_series_y_axis(line_of(data, i)->series));
    data->revision++;
    renew_texts(data);
}

TinkerDocument *tinker_graph_data_document(const TinkerGraphData *data)
{
    return data->document;
}

const char *tinker_graph_data_title(const TinkerGraphData *data)
{
    return data->title;
}

gboolean tinker_graph_data_is_over_time(const TinkerGraphData *data)
{
    return data->over_time;
}

/* The record ----------------------------------------------------------------------------------------------------------
 */

static gboolean read_player(gpointer source, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                            GArray *values)
{
    return tinker_player_series(source, quantity, cursor, times, values);
}

static gboolean read_kept(gpointer source, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                          GArray *values)
{
    return tinker_recording_series(source, quantity, cursor, times, values);
}

static gboolean update_line(TinkerGraphData *data, Line *line)
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
        if (update_line(data, line_of(data, i))) data->revision++;
    data->time = tinker_player_time(data->player);
    if (data->time != before) data->revision++;
    return data->revision;
}

gboolean tinker_graph_data_is_behind(const TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++)
        if (tinker_graph_series_is_behind(line_of(data, i)->series)) return TRUE;
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
    return line_of(data, curve)->series;
}

const char *tinker_graph_data_name(const TinkerGraphData *data, guint curve)
{
    return line_of(data, curve)->name;
}

const char *tinker_graph_data_run(const TinkerGraphData *data, guint curve)
{
    return line_of(data, curve)->run != NULL ? line_of(data, curve)->run->name : NULL;
}

gsize tinker_graph_data_count(const TinkerGraphData *data)
{
    return data->lines->len > 0 ? tinker_graph_series_count(line_of(data, 0)->series) : 0;
}

const double *tinker_graph_data_x(const TinkerGraphData *data)
{
    return tinker_graph_series_x(line_of(data, 0)->series);
}

const double *tinker_graph_data_y(const TinkerGraphData *data)
{
    return tinker_graph_series_y(line_of(data, 0)->series);
}

gboolean tinker_graph_data_is_empty(const TinkerGraphData *data)
{
    for (guint i = 0; i < data->lines->len; i++)
        if (tinker_graph_series_count(line_of(data, i)->series) > 0) return FALSE;
    return TRUE;
}

gboolean tinker_graph_data_present(const TinkerGraphData *data, guint curve, gsize *point)
{
    return curve < data->lines->len && tinker_graph_series_find(line_of(data, curve)->series, data->time, point);
}

gsize tinker_graph_data_point(const TinkerGraphData *data, guint curve, gsize drawn)
{
    return data->drawn_thin ? g_array_index(line_of(data, curve)->thin.kept, guint, drawn) : drawn;
}

/* The plot ------------------------------------------------------------------------------------------------------------
 */

/* A plot without a point has no axes: this curve lies on the frame, where nobody sees it. */
static void fill_bare_axes(TinkerGraphData *data, TinkerPlot *plot)
{
    double duration = tinker_player_duration(data->player);
    data->axes_x[0] = data->axes_y[0] = data->floor_y[0] = data->floor_y[1] = 0;
    data->axes_x[1] = data->over_time && duration > 0 ? duration : 1;
    data->axes_y[1] = 1;
    const TinkerCurve floor = {.x = data->axes_x, .y = data->floor_y, .count = 2, .role = TINKER_CURVE_GUIDE};
    g_array_append_val(data->curves, floor);
    plot->x_range = data->axes_x;
    plot->y_range = data->axes_y;
}

/* A run that is kept has the same colours whichever others are shown. */
static int colour_of(const TinkerGraphData *data, guint number)
{
    guint tables = 0;
    for (guint i = 0; i < data->own; i++)
        tables += tinker_graph_series_is_table(line_of(data, i)->series);
    const guint of_run = MAX(data->own - tables, 1);
    const guint in_run = (number - data->own) % of_run;
    return (int)(data->own + of_run * (guint)line_of(data, number)->run->number + in_run);
}

static void add_curve(TinkerGraphData *data, guint number, gboolean thin)
{
    Line *line = line_of(data, number);
    const TinkerGraphSeries *series = line->series;
    TinkerCurve curve = {.label = data->lines->len > 1 ? line->label : NULL,
                         .x = tinker_graph_series_x(series),
                         .y = tinker_graph_series_y(series),
                         .count = tinker_graph_series_count(series),
                         .index = tinker_graph_series_index(series),
                         .colour = line->run == NULL ? (int)number : colour_of(data, number),
                         .right = tinker_graph_series_is_right(series),
                         .markers = tinker_graph_series_is_table(series),
                         .no_line = tinker_graph_series_is_table(series)};
    if (thin && curve.count > 0) {
        tinker_thin_path_update(&line->thin, curve.x, curve.y, curve.count);
        curve.x = (const double *)(gpointer)line->thin.x->data;
        curve.y = (const double *)(gpointer)line->thin.y->data;
        curve.count = line->thin.kept->len;
    }
    g_array_append_val(data->curves, curve);
}

/* The present point of a phase plot, straight between two samples; over time the cursor marks it. */
static void find_present(const TinkerGraphData *data, guint number, double now[2])
{
    const TinkerGraphSeries *series = line_of(data, number)->series;
    gsize point;
    now[0] = now[1] = NAN;
    if (!tinker_graph_series_find(series, data->time, &point)) return;
    const double *times = tinker_graph_series_times(series), *x = tinker_graph_series_x(series),
                 *y = tinker_graph_series_y(series);
    const gsize next = MIN(point + 1, tinker_graph_series_count(series) - 1);
    const double span = times[next] - times[point], share = span > 0 ? fmin((data->time - times[point]) / span, 1) : 0;
    now[0] = x[point] + share * (x[next] - x[point]);
    now[1] = y[point] + share * (y[next] - y[point]);
}

static void add_present(TinkerGraphData *data, TinkerPlot *plot)
{
    if (data->over_time) {
        plot->cursor = &data->time;
        return;
    }
    g_array_set_size(data->now, 2 * data->lines->len);
    for (guint i = 0; i < data->lines->len; i++) {
        double *now = &g_array_index(data->now, double, 2 * i);
        find_present(data, i, now);
        const TinkerCurve ring = {.x = now,
                                  .y = now + 1,
                                  .count = 1,
                                  .role = TINKER_CURVE_RING,
                                  .no_line = TRUE,
                                  .right = tinker_graph_series_is_right(line_of(data, i)->series)};
        if (!isnan(now[0])) g_array_append_val(data->curves, ring);
    }
}

/* What the scene's graph asks of its axes, in displayed units. */
static void set_axes(TinkerGraphData *data, TinkerPlot *plot)
{
    const TinkerSceneGraph *graph = data->graph;
    const TinkerGraphSeries *first = line_of(data, 0)->series;
    const double factors[2] = {tinker_graph_series_x_axis(first)->per_si, tinker_graph_series_y_axis(first)->per_si};
    plot->x_logarithmic = graph->logarithmic[0];
    plot->y_logarithmic = plot->right_logarithmic = graph->logarithmic[1];
    for (int axis = 0; axis < 2; axis++)
        for (int end = 0; end < 2; end++)
            data->ranges[axis][end] = factors[axis] * graph->range[axis][end];
    if (graph->has_range[0]) plot->x_range = data->ranges[0];
    if (graph->has_range[1]) plot->y_range = data->ranges[1];
}

void tinker_graph_data_fill_plot(TinkerGraphData *data, TinkerPlot *plot)
{
    plot->x_label = data->x_label;
    plot->y_label = data->y_label;
    plot->right_label = data->right_label;
    plot->equal_scales = data->is_path;
    data->drawn_thin = !data->over_time && plot->quick;
    g_array_set_size(data->curves, 0);
    if (tinker_graph_data_is_empty(data)) {
        fill_bare_axes(data, plot);
    } else {
        for (guint i = 0; i < data->lines->len; i++)
            add_curve(data, i, data->drawn_thin);
        set_axes(data, plot);
        add_present(data, plot);
    }
    plot->curves = (const TinkerCurve *)(gpointer)data->curves->data;
    plot->curve_count = (int)data->curves->len;
}

/* Texts ---------------------------------------------------------------------------------------------------------------
 */

char *tinker_graph_value_text(const char *name, double value, const char *unit)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(number, sizeof number, "%.5g", value + 0.0);
    const char *gap = unit[0] != '\0' ? " " : "";
    return number[0] == '-' ? g_strdup_printf("%s = −%s%s%s", name, number + 1, gap, unit)
                            : g_strdup_printf("%s = %s%s%s", name, number, gap, unit);
}

char *tinker_graph_data_x_text(const TinkerGraphData *data, guint curve, gsize point)
{
    const TinkerGraphSeries *series = line_of(data, curve)->series;
    g_autofree char *time = tinker_graph_value_text("t", tinker_graph_series_times(series)[point], "s");
    if (data->over_time) return g_steal_pointer(&time);
    g_autofree char *x = tinker_graph_value_text(data->graph->against, tinker_graph_series_x(series)[point],
                                                 tinker_graph_series_x_axis(series)->unit);
    return g_strdup_printf("%s, %s", time, x);
}

char *tinker_graph_data_y_text(const TinkerGraphData *data, guint curve, gsize point)
{
    const TinkerGraphSeries *series = line_of(data, curve)->series;
    return tinker_graph_value_text(tinker_graph_series_symbol(series), tinker_graph_series_y(series)[point],
                                   tinker_graph_series_y_axis(series)->unit);
}

/* Life ----------------------------------------------------------------------------------------------------------------
 */

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
