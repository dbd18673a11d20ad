/* What the files of a curve's points share. */
#ifndef TINKER_GUI_GRAPH_SERIES_PRIVATE_H
#define TINKER_GUI_GRAPH_SERIES_PRIVATE_H

#include "gui/curve/graph-series.h"

#include "measure/formula.h"

/* One quantity of the record. */
typedef struct {
    TinkerQuantity of;
    TinkerSeriesCursor cursor;
    GArray *times, *values; /* of double: read, and not yet part of a point */
} GraphSource;

struct _TinkerGraphSeries {
    char *block, *symbol, *fault, *key; /* `key`: what tells whose points they are */
    TinkerGraphAxis x_axis, y_axis;
    gboolean right, is_table;
    gboolean over_time;     /* samples are: x is empty */
    gboolean is_spectrum;   /* points are not the samples */
    TinkerFormula *formula; /* NULL: y is the first source; x is the last, where it is not over time */
    GArray *sources;        /* of GraphSource */
    gboolean behind;
    GArray *times, *x, *y;            /* of double; x is empty over time */
    GArray *frequencies, *amplitudes; /* of double: of the first `transformed` samples */
    gsize transformed;
    TinkerCurveIndex *index; /* of the points over time or over frequency */
};

static inline GraphSource *graph_source(const TinkerGraphSeries *series, guint number)
{
    return &g_array_index(series->sources, GraphSource, number);
}

#endif
