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

/* That nearest to a place of the canvas, within `reach` (canvas units), of the plot's axes. */
gboolean tinker_graph_reading_snap(const TinkerGraphSeries *series, const TinkerPlotGeometry *geometry, double x,
                                   double y, double reach, TinkerGraphReading *reading);

/* The maximum or minimum at this very time (s), if it is one, such as one that was gone to. */
gboolean tinker_graph_reading_extremum_at(const TinkerGraphSeries *series, double time, TinkerGraphReading *reading);

/* The next one after a time (s), or the one before it. */
gboolean tinker_graph_reading_next(const TinkerGraphSeries *series, double time, gboolean forward,
                                   TinkerGraphReading *reading);

/* The value of the curve at x, straight between two points. FALSE where there is none. */
gboolean tinker_graph_reading_at(const TinkerGraphSeries *series, double x, TinkerGraphReading *reading);

/* All maxima and minima in order of x, at most so many; of TinkerGraphReading. None where x turns back. (transfer
 * full) */
GArray *tinker_graph_reading_extrema(const TinkerGraphSeries *series, guint most);

/* "y = 1.2 m (maximum)"; of a point alone its value. (transfer full) */
char *tinker_graph_reading_text(const TinkerGraphSeries *series, const TinkerGraphReading *reading);

#endif
