/* What a graph shows of its axes, where that is not all: changed by the ways of wheel, box and hand. No widget. */
#ifndef TINKER_GUI_GRAPH_ZOOM_H
#define TINKER_GUI_GRAPH_ZOOM_H

#include "render/plot/plot.h"

/* Axes, to be combined. */
typedef enum {
    TINKER_GRAPH_X = 1 << 0,
    TINKER_GRAPH_Y = 1 << 1,
    TINKER_GRAPH_SECOND = 1 << 2, /* the axis at the right */
    TINKER_GRAPH_UP = TINKER_GRAPH_Y | TINKER_GRAPH_SECOND,
    TINKER_GRAPH_ALL = TINKER_GRAPH_X | TINKER_GRAPH_UP,
} TinkerGraphAxes;

typedef struct {
    gboolean is_set[3];
    double range[3][2]; /* x, y, second: from, to, in displayed units */
} TinkerGraphZoom;

/* The plot shows that; all is what it shows otherwise. The ranges are borrowed. */
void tinker_graph_zoom_apply(const TinkerGraphZoom *zoom, TinkerPlot *plot);

/* Shows 1/factor as much as before, about a place of the canvas, which stays. No more than can be told apart. */
void tinker_graph_zoom_by(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes, double x,
                          double y, double factor);
/* What is seen goes along with the hand by as many canvas units. */
void tinker_graph_zoom_pan(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes, double dx,
                           double dy);
/* Shows what lies between two corners on the canvas. */
void tinker_graph_zoom_box(TinkerGraphZoom *zoom, const TinkerPlotGeometry *geometry, TinkerGraphAxes axes,
                           const double a[2], const double b[2]);
void tinker_graph_zoom_reset(TinkerGraphZoom *zoom);

/* The axes that a place of the canvas is about: both where the curves are, one beside them. */
TinkerGraphAxes tinker_graph_axes_at(const TinkerPlotGeometry *geometry, double x, double y);

#endif
