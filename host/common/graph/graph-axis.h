/* The axes of graphs, in the units that the scene displays: what both programs draw beside a curve and write over its
 * column. */
#ifndef TINKER_COMMON_GRAPH_AXIS_H
#define TINKER_COMMON_GRAPH_AXIS_H

#include "common/program/csv-writer.h"
#include "scene/store/quantities.h"

/* What stands on one axis of one curve. Texts are borrowed from the block's class. */
typedef struct {
    const char *title; /* "Time", "Y Position" */
    const char *unit;  /* displayed, "ft" */
    double per_si;     /* displayed value = SI value * per_si */
    TinkerDimension dimension;
    TinkerBlockId block; /* TINKER_NO_BLOCK: time */
} TinkerGraphAxis;

TinkerGraphAxis tinker_graph_axis_time(void);
/* Of a spectrum, in Hz. */
TinkerGraphAxis tinker_graph_axis_frequency(void);

/* The axis of a quantity of this block, or of the scene (quantities.h). */
TinkerGraphAxis tinker_graph_axis(TinkerScene *scene, TinkerBlockId block, int32_t quantity);

/* The axis of a value in SI, in the unit that is displayed or asked for (`wanted`; NULL). A unit of another dimension
 * is shown as it is written, and the number in SI; so is any where the dimension is not known (NULL). */
TinkerGraphAxis tinker_graph_axis_of_value(TinkerScene *scene, const char *title, const TinkerDimension *dimension,
                                           const char *wanted);

/* The label that several curves share on one axis: up to two titles, or what is measured, and the unit. NULL where
 * there are none. (transfer full) */
char *tinker_graph_axes_label(const TinkerGraphAxis *axes, guint count);

/* "Y Position [m]", or the title alone where there is no unit. (transfer full) */
char *tinker_axis_label(const char *title, const char *unit);

/* Whether the two belong to a path in the plane, whose scales are to be equal: one length against another. */
gboolean tinker_graph_axes_of_path(const TinkerGraphAxis *x, const TinkerGraphAxis *y);

/* The heading of a graph's CSV column: the axis's title, with the block's name before it where several curves are
 * written. Time has no block. */
void tinker_csv_axis(TinkerCsvWriter *writer, const TinkerScene *scene, const TinkerGraphAxis *axis, gboolean several);

#endif
