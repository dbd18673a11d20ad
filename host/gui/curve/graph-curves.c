/* The curves of a graph as a plot draws them. */
#include <math.h>

#include "gui/curve/graph-data-private.h"

/* Of a spectrum only what holds lines is shown at first: up to twice the highest frequency that has more than this
 * share of the greatest amplitude. */
#define FAINT 0.01

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
        tables += tinker_graph_series_is_table(graph_line(data, i)->series);
    const guint of_run = MAX(data->own - tables, 1);
    const guint in_run = (number - data->own) % of_run;
    return (int)(data->own + of_run * (guint)graph_line(data, number)->run->number + in_run);
}

static void add_curve(TinkerGraphData *data, guint number, gboolean thin)
{
    GraphLine *line = graph_line(data, number);
    const TinkerGraphSeries *series = line->series;
    TinkerCurve curve = {.label = data->lines->len > 1 ? line->label : NULL,
                         .x = tinker_graph_series_x(series),
                         .y = tinker_graph_series_y(series),
                         .count = tinker_graph_series_count(series),
                         .index = tinker_graph_series_index(series),
                         .colour = line->run == NULL ? (int)number : colour_of(data, number),
                         .right = tinker_graph_series_is_right(series),
                         .behind = line->run != NULL,
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

static void add_present(TinkerGraphData *data, TinkerPlot *plot)
{
    if (data->over_time) {
        plot->cursor = &data->time;
        return;
    }
    if (data->is_spectrum) return;
    g_array_set_size(data->now, 2 * data->lines->len);
    for (guint i = 0; i < data->lines->len; i++) {
        double *now = &g_array_index(data->now, double, 2 * i);
        if (!tinker_graph_data_now(data, i, now)) now[0] = now[1] = NAN;
        const TinkerCurve ring = {.x = now,
                                  .y = now + 1,
                                  .count = 1,
                                  .role = TINKER_CURVE_RING,
                                  .no_line = TRUE,
                                  .right = tinker_graph_series_is_right(graph_line(data, i)->series)};
        if (!isnan(now[0])) g_array_append_val(data->curves, ring);
    }
}

static void find_lines(TinkerGraphData *data)
{
    double highest = 0, end = 0;
    for (guint i = 0; i < data->lines->len; i++) {
        const TinkerGraphSeries *series = graph_line(data, i)->series;
        const double *x = tinker_graph_series_x(series), *y = tinker_graph_series_y(series);
        gsize peak, last = tinker_graph_series_count(series);
        if (!tinker_graph_data_present(data, i, &peak)) continue;
        end = fmax(end, x[last - 1]);
        while (--last > peak && y[last] < FAINT * y[peak])
            ;
        highest = fmax(highest, x[last]);
    }
    data->ranges[0][0] = 0;
    data->ranges[0][1] = highest > 0 ? fmin(2 * highest, end) : end;
}

/* What the scene's graph asks of its axes, in displayed units. */
static void set_axes(TinkerGraphData *data, TinkerPlot *plot)
{
    const TinkerSceneGraph *graph = data->graph;
    const TinkerGraphSeries *first = graph_line(data, 0)->series;
    const double factors[2] = {tinker_graph_series_x_axis(first)->per_si, tinker_graph_series_y_axis(first)->per_si};
    plot->x_logarithmic = graph->logarithmic[0];
    plot->y_logarithmic = plot->right_logarithmic = graph->logarithmic[1];
    for (int axis = 0; axis < 2; axis++)
        for (int end = 0; end < 2; end++)
            data->ranges[axis][end] = factors[axis] * graph->range[axis][end];
    const gboolean finds_lines = data->is_spectrum && !graph->has_range[0] && !plot->x_logarithmic;
    if (finds_lines) find_lines(data);
    if (graph->has_range[0] || finds_lines) plot->x_range = data->ranges[0];
    if (graph->has_range[1]) plot->y_range = data->ranges[1];
}

void tinker_graph_data_fill_plot(TinkerGraphData *data, TinkerPlot *plot)
{
    plot->x_label = data->x_label;
    plot->y_label = data->y_label;
    plot->right_label = data->right_label;
    plot->equal_scales = data->is_path;
    data->drawn_thin = !data->over_time && !data->is_spectrum && plot->quick;
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
