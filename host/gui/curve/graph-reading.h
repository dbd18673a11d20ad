/* Reading a curve: its maxima, minima and zeros, found between its points. No widget. */
#ifndef TINKER_GUI_GRAPH_READING_H
#define TINKER_GUI_GRAPH_READING_H

#include "gui/curve/graph-series.h"
#include "render/plot/plot.h"

typedef enum {
    TINKER_READING_POINT, /* nothing but a point of the record */
    TINKER_READING_MAXIMUM,
    TINKER_READING_MINIMUM,
    TINKER_READING_ZERO,
} TinkerReadingKind;

typedef struct {
    guint curve;
    gsize point; /* the one at it or before it */
    TinkerReadingKind kind;
    double at[2]; /* x and y, displayed */
} TinkerGraphReading;

/* The extremum or zero about a point, if there is one between its two neighbours: an extremum by the parabola through
 * the three points, a zero by the cubic through four. Not of a curve whose x turns back. */
gboolean tinker_graph_reading_about(const TinkerGraphSeries *series, gsize point, TinkerGraphReading *reading);

/* That nearest to a place of the canvas, within `reach` (canvas units), of the plot's axes. */
gboolean tinker_graph_reading_snap(const TinkerGraphSeries *series, const TinkerPlotGeometry *geometry, double x,
                                   double y, double reach, TinkerGraphReading *reading);

/* The next one after a time (s), or the one before it. */
gboolean tinker_graph_reading_next(const TinkerGraphSeries *series, double time, gboolean forward,
                                   TinkerGraphReading *reading);

/* The value of the curve at x, straight between two points. FALSE where there is none. */
gboolean tinker_graph_reading_at(const TinkerGraphSeries *series, double x, TinkerGraphReading *reading);

#endif
