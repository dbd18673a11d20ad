/* What is drawn, and what of it is read: for painting and for input. */
#include <math.h>

#include "gui/graph/graph-plot-private.h"

#define SNAP           16.0 /* widget units: how near to a maximum, minimum or zero it is that which is read */
#define COMPACT_WIDTH  700  /* widget units: below either, texts are smaller */
#define COMPACT_HEIGHT 420
#define A_CLICK        5.0  /* widget units: a press that moved no farther is one */
#define THIN_BOX       12.0 /* a box less high, or wide, is of the other axis alone */

void tinker_graph_plot_renew(TinkerGraphPlot *plot)
{
    plot->is_stale = TRUE;
    gtk_widget_queue_draw(GTK_WIDGET(plot));
}

TinkerBlockId tinker_graph_plot_block(TinkerGraphPlot *plot, guint curve)
{
    TinkerScene *scene = tinker_document_scene(tinker_graph_data_document(plot->data));
    const char *name = tinker_graph_series_block(tinker_graph_data_curve(plot->data, curve));
    return name[0] != '\0' ? tinker_scene_find_block(scene, name) : TINKER_NO_BLOCK;
}

/* Curves of other blocks than what is pointed at, where there is one of it. */
static void fade_others(TinkerGraphPlot *plot, TinkerPlot *picture)
{
    const int own = MIN((int)tinker_graph_data_curves(plot->data), picture->curve_count);
    if (plot->lit == TINKER_NO_BLOCK) return;
    g_free(plot->curves);
    plot->curves = g_memdup2(picture->curves, (gsize)picture->curve_count * sizeof *plot->curves);
    for (int i = 0; i < own; i++)
        plot->curves[i].faded = tinker_graph_plot_block(plot, (guint)i) != plot->lit;
    picture->curves = plot->curves;
}

void tinker_graph_plot_fill(TinkerGraphPlot *plot, TinkerPlot *picture)
{
    picture->enlargement = plot->picture.enlargement;
    picture->compact = plot->picture.width < COMPACT_WIDTH || plot->picture.height < COMPACT_HEIGHT;
    tinker_graph_data_fill_plot(plot->data, picture);
    fade_others(plot, picture);
    if (tinker_graph_data_is_empty(plot->data)) return;
    if (tinker_graph_data_is_over_time(plot->data))
        plot->zoom.is_set[0] = tinker_time_span_get(tinker_player_span(plot->player), plot->zoom.range[0]);
    tinker_graph_zoom_apply(&plot->zoom, picture);
}

const TinkerPlotGeometry *tinker_graph_plot_geometry(TinkerGraphPlot *plot)
{
    TinkerPlot picture = {.theme = plot->picture.theme, .quick = plot->picture.quick, .memory = plot->memory};
    if (!plot->is_stale || plot->picture.theme == NULL) return &plot->geometry;
    tinker_graph_plot_fill(plot, &picture);
    tinker_plot_measure(&picture, plot->picture.width, plot->picture.height, &plot->geometry);
    return &plot->geometry;
}

gboolean tinker_graph_plot_read(TinkerGraphPlot *plot, const TinkerPlot *picture, double x, double y,
                                TinkerGraphReading *reading)
{
    TinkerPlotPoint found;
    if (tinker_graph_data_is_empty(plot->data) ||
        !tinker_plot_pick(picture, plot->picture.width, plot->picture.height, x, y, TINKER_GRAPH_REACH, &found) ||
        found.curve >= (int)tinker_graph_data_curves(plot->data))
        return FALSE;
    const guint curve = (guint)found.curve;
    const TinkerGraphSeries *series = tinker_graph_data_curve(plot->data, curve);
    reading->curve = curve;
    if (tinker_graph_reading_snap(series, &plot->geometry, x, y, SNAP, reading)) return TRUE;
    reading->kind = TINKER_READING_POINT;
    reading->point = tinker_graph_data_point(plot->data, curve, found.point);
    reading->at[0] = tinker_graph_series_x(series)[reading->point];
    reading->at[1] = tinker_graph_series_y(series)[reading->point];
    return TRUE;
}

gboolean tinker_graph_plot_read_place(TinkerGraphPlot *plot, double x, double y, TinkerGraphReading *reading)
{
    const TinkerPlotGeometry *at = &plot->geometry;
    double nearest = SNAP, aside = INFINITY;
    gboolean snaps = FALSE;
    for (guint i = 0; i < tinker_graph_data_curves(plot->data); i++) {
        const TinkerGraphSeries *series = tinker_graph_data_curve(plot->data, i);
        const TinkerPlotScale *up = tinker_graph_series_is_right(series) ? &at->second : &at->y;
        TinkerGraphReading tried = {.curve = i};
        if (tinker_graph_reading_snap(series, at, x, y, nearest, &tried)) {
            nearest =
                hypot(tinker_plot_scale_place(&at->x, tried.at[0]) - x, tinker_plot_scale_place(up, tried.at[1]) - y);
            *reading = tried;
            snaps = TRUE;
        } else if (!snaps && tinker_graph_reading_at(series, tinker_plot_scale_value(&at->x, x), &tried) &&
                   fabs(tinker_plot_scale_place(up, tried.at[1]) - y) < aside) {
            aside = fabs(tinker_plot_scale_place(up, tried.at[1]) - y);
            *reading = tried;
        }
    }
    return snaps || isfinite(aside);
}

TinkerGraphAxes tinker_graph_box_axes(const TinkerGraphPlot *plot)
{
    const double width = fabs(plot->drag_now[0] - plot->drag_start[0]),
                 height = fabs(plot->drag_now[1] - plot->drag_start[1]);
    if (fmax(width, height) < A_CLICK) return 0;
    if (height < THIN_BOX) return TINKER_GRAPH_X;
    return width < THIN_BOX ? TINKER_GRAPH_UP : TINKER_GRAPH_ALL;
}

char *tinker_graph_plot_legend_text(TinkerGraphPlot *plot, double x, double y)
{
    const TinkerPlotGeometry *at = tinker_graph_plot_geometry(plot);
    if (!at->shortens_legend || tinker_graph_data_is_empty(plot->data) || x < at->legend[0] || x > at->legend[2] ||
        y < at->legend[1] || y > at->legend[3])
        return NULL;
    GString *names = g_string_new(NULL);
    for (guint i = 0; i < tinker_graph_data_curves(plot->data); i++)
        g_string_append_printf(names, "%s%s", i > 0 ? "\n" : "", tinker_graph_data_name(plot->data, i));
    return g_string_free(names, FALSE);
}
