/* The points of one curve of a graph: of a quantity or of an expression, as they are recorded, or of a table in a file;
 * or of its spectrum. In displayed units. No widget. */
#ifndef TINKER_GUI_GRAPH_SERIES_H
#define TINKER_GUI_GRAPH_SERIES_H

#include "common/graph/graph-axis.h"
#include "gui/document/player.h"
#include "render/plot/curve-index.h"

typedef struct _TinkerGraphSeries TinkerGraphSeries;

/* Of a curve of this graph, of the scene that is recorded; `base` is a file beside which tables lie (may be NULL). What
 * cannot be found, such as a table that is gone, gives no points. The scene is borrowed for the call. (transfer full)
 */
TinkerGraphSeries *tinker_graph_series_new(TinkerScene *scene, const char *base, const TinkerSceneGraph *graph,
                                           const TinkerSceneCurve *curve);
void tinker_graph_series_free(TinkerGraphSeries *series);

/* Whether the points of `old` are those that this one is to have, which it then takes from it. */
gboolean tinker_graph_series_take_over(TinkerGraphSeries *series, TinkerGraphSeries *old);

/* "Mass 0", or "" of an expression or a table; "y", what is short for it in a reading. Borrowed. */
const char *tinker_graph_series_block(const TinkerGraphSeries *series);
const char *tinker_graph_series_symbol(const TinkerGraphSeries *series);
/* The axes. x is the time, but in a phase plot. */
const TinkerGraphAxis *tinker_graph_series_x_axis(const TinkerGraphSeries *series);
const TinkerGraphAxis *tinker_graph_series_y_axis(const TinkerGraphSeries *series);
gboolean tinker_graph_series_is_right(const TinkerGraphSeries *series);
gboolean tinker_graph_series_is_table(const TinkerGraphSeries *series);

/* Forgets what was recorded. */
void tinker_graph_series_forget(TinkerGraphSeries *series);
/* How the record is read: as tinker_recording_series. */
typedef gboolean (*TinkerSeriesReader)(gpointer source, TinkerQuantity quantity, TinkerSeriesCursor *cursor,
                                       GArray *times, GArray *values);
/* Takes over what has been recorded since, of a long record a portion. TRUE where there are new points. */
gboolean tinker_graph_series_update(TinkerGraphSeries *series, TinkerSeriesReader read, gpointer source);
gboolean tinker_graph_series_is_behind(const TinkerGraphSeries *series);

/* How far the run may have the values between two times (s) off, in the unit shown, by how far the quantities may be
 * off that it is made of. Reads the record once more. FALSE where that is not known, or not yet; of a table it is 0. */
typedef gboolean (*TinkerBandReader)(gpointer source, TinkerQuantity quantity, double until, double *band);
gboolean tinker_graph_series_run_error(const TinkerGraphSeries *series, TinkerSeriesReader read, TinkerBandReader band,
                                       gpointer source, double from, double to, double *error);

/* Points, and they themselves; the times are in s, and of a spectrum those of the samples. At an event there are two at
 * one time: just before it and just behind it. Borrowed until the next update. */
gsize tinker_graph_series_count(const TinkerGraphSeries *series);
const double *tinker_graph_series_times(const TinkerGraphSeries *series);
const double *tinker_graph_series_x(const TinkerGraphSeries *series);
const double *tinker_graph_series_y(const TinkerGraphSeries *series);
/* The first point from one on, which is the first of its time, that is a sample and not at an event; a point that is
 * not there where there is none. */
gsize tinker_graph_series_sample_from(const TinkerGraphSeries *series, gsize point);
/* Of the points where x is the time or the frequency; else NULL. */
const TinkerCurveIndex *tinker_graph_series_index(const TinkerGraphSeries *series);

/* The last point not later than a time (s). FALSE where there is none, and of a spectrum. */
gboolean tinker_graph_series_find(const TinkerGraphSeries *series, double time, gsize *point);

#endif
