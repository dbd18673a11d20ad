/* What one graph shows: the points of its curves recorded so far in the units that the scene displays, ready to be
 * plotted. No widget. */
#ifndef TINKER_GUI_GRAPH_DATA_H
#define TINKER_GUI_GRAPH_DATA_H

#include "gui/curve/graph-series.h"
#include "measure/statistics.h"
#include "render/plot/plot.h"

typedef struct _TinkerGraphData TinkerGraphData;

/* Of a graph in this document as the player has recorded it. Takes references. Nothing is known before
 * tinker_graph_data_set_graph. (transfer full) */
TinkerGraphData *tinker_graph_data_new(TinkerDocument *document, TinkerPlayer *player);
void tinker_graph_data_free(TinkerGraphData *data);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerGraphData, tinker_graph_data_free)

/* Which graph it is of, one of the document's scene; copied. To be called again whenever the scene has changed, for
 * then units and names may be others. */
void tinker_graph_data_set_graph(TinkerGraphData *data, const TinkerSceneGraph *graph);

TinkerDocument *tinker_graph_data_document(const TinkerGraphData *data);

/* The graph's own title, else "Mass 0: Y Position", or "Mass 0: Y Velocity over Y Position", or those of all curves.
 * Borrowed. */
const char *tinker_graph_data_title(const TinkerGraphData *data);
/* What it is over, as the scene's graph has it; NULL before there is one. Borrowed. */
const char *tinker_graph_data_against(const TinkerGraphData *data);
/* Whether it is over time. */
gboolean tinker_graph_data_is_over_time(const TinkerGraphData *data);
/* Whether it is of spectra: amplitudes over frequency. */
gboolean tinker_graph_data_is_spectrum(const TinkerGraphData *data);

/* Takes over what has been recorded since the last time, of a long record as much as a frame has time for, and the
 * present time. A number that is another whenever the picture is. */
guint64 tinker_graph_data_update(TinkerGraphData *data);
/* Whether the last update has left something for the next. */
gboolean tinker_graph_data_is_behind(const TinkerGraphData *data);
/* Updates until nothing is left, however long that takes. */
void tinker_graph_data_catch_up(TinkerGraphData *data);

/* Its curves, in order: how many, one of them (borrowed), and its name in a legend. */
guint tinker_graph_data_curves(const TinkerGraphData *data);
/* The first so many are of the present run, the others of runs that are kept. */
guint tinker_graph_data_own_curves(const TinkerGraphData *data);
const TinkerGraphSeries *tinker_graph_data_curve(const TinkerGraphData *data, guint curve);
const char *tinker_graph_data_name(const TinkerGraphData *data, guint curve);
/* The name of the kept run that it is of, as the legend has it; NULL: of the present one. And whether it is the first
 * curve of a run that is kept. */
const char *tinker_graph_data_run(const TinkerGraphData *data, guint curve);
gboolean tinker_graph_data_begins_run(const TinkerGraphData *data, guint curve);

/* Points of the first curve; 0 before a run. They themselves, in displayed units: of x (the time, or the other
 * quantity) and of y. Borrowed until the next update. */
gsize tinker_graph_data_count(const TinkerGraphData *data);
const double *tinker_graph_data_x(const TinkerGraphData *data);
const double *tinker_graph_data_y(const TinkerGraphData *data);
/* Whether no curve has a point. */
gboolean tinker_graph_data_is_empty(const TinkerGraphData *data);

/* Fills in curves, labels, scales, ranges and the present time; the theme, the title and all else are the caller's.
 * Borrowed from `data` until the next update. The first curves are those of the graph, further ones point something
 * out. Before a run: bare axes. Where the plot has to be quick, a path that is not over time is drawn with as few
 * points as show it. */
void tinker_graph_data_fill_plot(TinkerGraphData *data, TinkerPlot *plot);

/* Which point of its curve a point of the curve filled in last is. */
gsize tinker_graph_data_point(const TinkerGraphData *data, guint curve, gsize drawn);

/* How far its run may have a curve off between two times (s), in the unit shown. FALSE where that is not
 * known, or not yet. */
gboolean tinker_graph_data_run_error(const TinkerGraphData *data, guint curve, double from, double to, double *error);

/* A part of the time (s), and whether it is that between the two cursors of a graph. */
typedef struct {
    double from, to;
    gboolean between_cursors;
} TinkerGraphPart;

/* Mean, extrema, period and damping of its curves in a part of the time (NULL: all), of the present run and then of
 * each that is kept and shown, under their names; each with its error, that of the run included where it is known; and
 * how far they are from the tables of measured values beside them. (transfer full) */
char *tinker_graph_statistics_text(TinkerGraphData *data, const TinkerGraphPart *part);

/* Adds a statistic's value with the digits that its error leaves; of one that is less than its error those up to the
 * error's own decade. */
void tinker_statistic_append(GString *text, const TinkerStatistic *statistic);

/* A point for people: "t = 1.25 s" (and the other quantity's value, if it is not over time), of a spectrum
 * "f = 0.8 Hz". (transfer full) */
char *tinker_graph_data_x_text(const TinkerGraphData *data, guint curve, gsize point);
/* A place across, of what is over time or a spectrum: "t = 1.25 s", "f = 0.8 Hz"; with what stands before the letter.
 * (transfer full) */
char *tinker_graph_data_place_text(const TinkerGraphData *data, const char *before, double place);
/* "y = −0.12 m". (transfer full) */
char *tinker_graph_value_text(const char *name, double value, const char *unit);

/* The point of a curve at the present time, or before it; of a spectrum that of the greatest amplitude. FALSE where
 * there is none. */
gboolean tinker_graph_data_present(const TinkerGraphData *data, guint curve, gsize *point);

/* The place of a curve at the present time, in displayed units: straight between two points, as the canvas has the
 * bodies between two samples. FALSE where there is none, and of a spectrum. */
gboolean tinker_graph_data_now(const TinkerGraphData *data, guint curve, double now[2]);

/* What its own curves are at the present time, of a spectrum at their peaks, in one line: "t = 1.25 s, y = −0.12 m";
 * NULL before a run. (transfer full) */
char *tinker_graph_data_present_text(const TinkerGraphData *data);

/* Whether a file is free for what is exported: not the scene's own, nor one that it reads. */
gboolean tinker_graph_data_check_output(const TinkerGraphData *data, const char *path, GError **error);

/* Writes all points as CSV, with the headings that the command line writes: "Time,Y Position"; the time and then a
 * column a curve, or two where it is not over time; `decimals` as in csv-writer.h. Atomic. Errors: G_FILE_ERROR, and
 * those of tinker_graph_data_check_output. */
gboolean tinker_graph_data_write_csv(TinkerGraphData *data, const char *path, int decimals, GError **error);

#endif
