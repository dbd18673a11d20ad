/* Places of the canvas are mapped back onto the axes, so that logarithmic ones need no case of their own. */
#include "gui/curve/graph-zoom.h"

#include <math.h>
#include <string.h>

#define LEAST_SHARE 1e-6 /* of the numbers themselves: finer, an axis is shown as constant */

static const TinkerPlotScale *scale_of(const TinkerPlotGeometry *geometry, int axis)
{
    return axis == 0 ? &geometry->x : axis == 1 ? &geometry->y : &geometry->second;
}

static gboolean is_meant(const TinkerPlotGeometry *geometry, TinkerGraphAxes axes, int axis)
{
    return (axes & (1u << axis)) != 0 && (axis < 2 || geometry->has_second);
}

/* Shows what is between two places along an axis. */
static void show(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, int axis, double from, double to)
{
    const TinkerPlotScale *scale = scale_of(geometry, axis);
    const double a = tinker_plot_scale_value(scale, from), b = tinker_plot_scale_value(scale, to);
    const double low = fmin(a, b), high = fmax(a, b);
    if (!isfinite(low) || !isfinite(high) || !(high - low > LEAST_SHARE * fmax(fabs(low), fabs(high)))) return;
    if (scale->logarithmic && !(low > 0)) return;
    zoom->is_set[axis] = TRUE;
    zoom->range[axis][0] = low;
    zoom->range[axis][1] = high;
}

void tinker_graph_zoom_apply(const TinkerGraphZoom *zoom, TinkerPlot *plot)
{
    if (zoom->is_set[0]) plot->x_range = zoom->range[0];
    if (zoom->is_set[1]) plot->y_range = zoom->range[1];
    if (zoom->is_set[2]) plot->right_range = zoom->range[2];
}

void tinker_graph_zoom_by(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes, double x,
                          double y, double factor)
{
    for (int axis = 0; axis < 3; axis++) {
        const TinkerPlotScale *scale = scale_of(geometry, axis);
        const double at = axis == 0 ? x : y, end = scale->start + scale->length;
        if (is_meant(geometry, axes, axis))
            show(zoom, geometry, axis, at + (scale->start - at) / factor, at + (end - at) / factor);
    }
}

void tinker_graph_zoom_pan(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes, double dx,
                           double dy)
{
    for (int axis = 0; axis < 3; axis++) {
        const TinkerPlotScale *scale = scale_of(geometry, axis);
        const double by = axis == 0 ? dx : dy;
        if (is_meant(geometry, axes, axis))
            show(zoom, geometry, axis, scale->start - by, scale->start + scale->length - by);
    }
}

void tinker_graph_zoom_box(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes,
                           const double a[2], const double b[2])
{
    for (int axis = 0; axis < 3; axis++)
        if (is_meant(geometry, axes, axis)) show(zoom, geometry, axis, a[MIN(axis, 1)], b[MIN(axis, 1)]);
}

void tinker_graph_zoom_reset(TinkerGraphZoom *zoom)
{
    memset(zoom->is_set, 0, sizeof zoom->is_set);
}

TinkerGraphAxes tinker_graph_axes_at(const TinkerPlotGeometry *geometry, double x, double y)
{
    if (y > geometry->bottom) return TINKER_GRAPH_X;
    if (x < geometry->left) return TINKER_GRAPH_Y;
    if (x > geometry->right && geometry->has_second) return TINKER_GRAPH_SECOND;
    return TINKER_GRAPH_ALL;
}
