/* Pointing at a curve is pointing at the block that it is of, and the other way round. */
#include <math.h>

#include "gui/graph/graph-plot-private.h"

#define REACH 7.0 /* widget units: how near to a curve is at it */

/* Straight from point to point, how far above or below a place the curve passes. */
static double off(TinkerGraphPlot *plot, guint curve, double x, double y)
{
    const TinkerPlotGeometry *at = tinker_graph_plot_geometry(plot);
    const TinkerGraphSeries *series = tinker_graph_data_curve(plot->data, curve);
    const TinkerPlotScale *up = tinker_graph_series_is_right(series) ? &at->second : &at->y;
    TinkerGraphReading read = {0};
    if (x < at->left || x > at->right || y < at->top || y > at->bottom ||
        !tinker_graph_reading_at(series, tinker_plot_scale_value(&at->x, x), &read))
        return INFINITY;
    const double passes = tinker_plot_scale_place(up, read.at[1]);
    return isfinite(passes) ? fabs(passes - y) : INFINITY;
}

/* Of the legend first, which lies over the curves; -1: none. */
static int curve_at(TinkerGraphPlot *plot, double x, double y)
{
    const double width = plot->picture.width, height = plot->picture.height;
    TinkerPlot picture = {.theme = plot->picture.theme, .memory = plot->memory};
    TinkerPlotPoint point;
    double nearest = REACH;
    if (plot->picture.theme == NULL) return -1;
    tinker_graph_plot_fill(plot, &picture);
    int found = tinker_plot_pick_legend(&picture, width, height, x, y);
    if (found >= 0) return found;
    for (guint i = 0; i < tinker_graph_data_curves(plot->data); i++) {
        const double distance = off(plot, i, x, y);
        if (distance > nearest) continue;
        nearest = distance;
        found = (int)i;
    }
    if (found < 0 && tinker_plot_pick(&picture, width, height, x, y, REACH, &point)) found = point.curve;
    return found;
}

void tinker_graph_plot_point_at(TinkerGraphPlot *plot, double x, double y)
{
    const int curve = curve_at(plot, x, y);
    const gboolean is_curve = curve >= 0 && curve < (int)tinker_graph_data_curves(plot->data);
    const TinkerBlockId block = is_curve ? tinker_graph_plot_block(plot, (guint)curve) : TINKER_NO_BLOCK;
    tinker_document_point(tinker_graph_data_document(plot->data), tinker_pointed_block(block));
}

void tinker_graph_plot_point_away(TinkerGraphPlot *plot)
{
    tinker_document_point(tinker_graph_data_document(plot->data), tinker_pointed_block(TINKER_NO_BLOCK));
}

static TinkerPointed chosen_block(TinkerGraphPlot *plot)
{
    const gboolean is_curve = plot->chosen >= 0 && plot->chosen < (int)tinker_graph_data_curves(plot->data);
    return tinker_pointed_block(is_curve ? tinker_graph_plot_block(plot, (guint)plot->chosen) : TINKER_NO_BLOCK);
}

void tinker_graph_plot_choose_curve(TinkerGraphPlot *plot, int step)
{
    const int count = (int)tinker_graph_data_curves(plot->data);
    if (count == 0) return;
    plot->chosen = plot->chosen < 0 ? 0 : CLAMP(plot->chosen + step, 0, count - 1);
    tinker_document_point(tinker_graph_data_document(plot->data), chosen_block(plot));
    g_signal_emit_by_name(plot, "looks-changed");
}

void tinker_graph_plot_choose_no_curve(TinkerGraphPlot *plot)
{
    tinker_document_point_away(tinker_graph_data_document(plot->data), chosen_block(plot));
    plot->chosen = -1;
}

char *tinker_graph_plot_chosen_text(TinkerGraphPlot *plot)
{
    if (plot->chosen < 0 || plot->chosen >= (int)tinker_graph_data_curves(plot->data)) return NULL;
    return g_strdup(tinker_graph_data_name(plot->data, (guint)plot->chosen));
}

/* Drawn anew only where that changes something. */
static void on_pointed(TinkerGraphPlot *plot)
{
    const TinkerBlockId pointed = tinker_document_pointed(tinker_graph_data_document(plot->data))->block;
    TinkerBlockId lit = TINKER_NO_BLOCK;
    for (guint i = 0; i < tinker_graph_data_curves(plot->data) && pointed != TINKER_NO_BLOCK; i++)
        if (tinker_graph_plot_block(plot, i) == pointed) lit = pointed;
    if (lit == plot->lit) return;
    plot->lit = lit;
    tinker_graph_plot_renew(plot);
}

void tinker_graph_plot_follow_pointing(TinkerGraphPlot *plot)
{
    plot->lit = TINKER_NO_BLOCK;
    plot->chosen = -1;
    g_signal_connect_object(tinker_graph_data_document(plot->data), "pointed-changed", G_CALLBACK(on_pointed), plot,
                            G_CONNECT_SWAPPED);
}
