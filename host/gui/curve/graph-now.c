/* What a graph tells of the time that is shown. */
#include <math.h>

#include "gui/curve/graph-data-private.h"
#include "gui/curve/graph-reading.h"

/* Straight between two samples, as bodies on the canvas are; but at a maximum or minimum that was gone to, what is read
 * there, which the straight line would cut off. */
gboolean tinker_graph_data_now(const TinkerGraphData *data, guint curve, double now[2])
{
    gsize point;
    if (data->is_spectrum || !tinker_graph_data_present(data, curve, &point)) return FALSE;
    const TinkerGraphSeries *series = graph_line(data, curve)->series;
    const double *times = tinker_graph_series_times(series), *x = tinker_graph_series_x(series),
                 *y = tinker_graph_series_y(series);
    const gsize next = MIN(point + 1, tinker_graph_series_count(series) - 1);
    const double span = times[next] - times[point], share = span > 0 ? fmin((data->time - times[point]) / span, 1) : 0;
    now[0] = x[point] + share * (x[next] - x[point]);
    now[1] = y[point] + share * (y[next] - y[point]);
    TinkerGraphReading turn;
    if (data->over_time && tinker_graph_reading_extremum_at(series, data->time, &turn)) now[1] = turn.at[1];
    return TRUE;
}

static char *x_text_now(const TinkerGraphData *data, guint curve, gsize point, const double now[2])
{
    const TinkerGraphSeries *series = graph_line(data, curve)->series;
    if (data->is_spectrum) return tinker_graph_data_x_text(data, curve, point);
    const double last = tinker_graph_series_times(series)[tinker_graph_series_count(series) - 1];
    g_autofree char *time = tinker_graph_value_text("t", MIN(data->time, last), "s");
    if (data->over_time) return g_steal_pointer(&time);
    g_autofree char *x =
        tinker_graph_value_text(data->graph->against, now[0], tinker_graph_series_x_axis(series)->unit);
    return g_strdup_printf("%s, %s", time, x);
}

char *tinker_graph_data_present_text(const TinkerGraphData *data)
{
    g_autofree char *text = NULL;
    for (guint i = 0; i < data->own; i++) {
        const TinkerGraphSeries *series = graph_line(data, i)->series;
        double now[2] = {0};
        gsize point;
        if (!tinker_graph_data_present(data, i, &point)) continue;
        if (data->is_spectrum)
            now[1] = tinker_graph_series_y(series)[point];
        else
            tinker_graph_data_now(data, i, now);
        g_autofree char *before = text != NULL ? g_steal_pointer(&text) : x_text_now(data, i, point, now);
        g_autofree char *y = tinker_graph_value_text(tinker_graph_series_symbol(series), now[1],
                                                     tinker_graph_series_y_axis(series)->unit);
        text = g_strdup_printf("%s, %s", before, y);
    }
    return g_steal_pointer(&text);
}
