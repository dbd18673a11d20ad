/* The plot's state, which painting and input share. */
#ifndef TINKER_GUI_GRAPH_PLOT_PRIVATE_H
#define TINKER_GUI_GRAPH_PLOT_PRIVATE_H

#include "gui/curve/graph-reading.h"
#include "gui/curve/graph-zoom.h"
#include "gui/graph/graph-plot.h"

#define TINKER_GRAPH_REACH 24.0 /* widget units: how near to the curve the pointer reads it */

/* What a picture depends on. */
typedef struct {
    int width, height, factor;
    const TinkerTheme *theme;
    gboolean quick;
    double enlargement; /* of its texts, by the font of the widget */
    guint64 revision;   /* of the data */
} TinkerGraphPicture;

typedef enum { TINKER_GRAPH_NO_DRAG, TINKER_GRAPH_BOX, TINKER_GRAPH_PAN } TinkerGraphDrag;

struct _TinkerGraphPlot {
    GtkWidget parent_instance;
    TinkerPlayer *player;
    TinkerGraphData *data;
    TinkerPaintMemory *memory;
    TinkerGraphPicture picture;
    GdkTexture *texture;
    gboolean show_values, pointer_inside, is_stale;
    double pointer[2];
    guint timer; /* or 0 */

    TinkerGraphZoom zoom;
    TinkerPlotGeometry geometry; /* of the last picture */
    TinkerGraphDrag drag;
    double drag_start[2], drag_now[2];

    TinkerCurve *curves; /* of the picture, where some are faded */
    TinkerBlockId lit;   /* what is pointed at, where it has a curve; else TINKER_NO_BLOCK */
    int chosen;          /* the curve that keys have come to; -1: none */

    TinkerGraphReading cursors[2];
    int cursor_count;
};

/* Draws anew at the next frame. */
void tinker_graph_plot_renew(TinkerGraphPlot *plot);
/* Where the axes are by what is shown now, drawn yet or not: what follows within the same frame goes on from there.
 * Borrowed. */
const TinkerPlotGeometry *tinker_graph_plot_geometry(TinkerGraphPlot *plot);
/* The block that a curve is of; TINKER_NO_BLOCK of an expression and of a table. */
TinkerBlockId tinker_graph_plot_block(TinkerGraphPlot *plot, guint curve);
/* What is drawn, but for theme and reading: where curves of what is pointed at are among others, those are faded. */
void tinker_graph_plot_fill(TinkerGraphPlot *plot, TinkerPlot *picture);
/* What the pointer reads: the nearest curve's maximum, minimum or zero, or its point. */
gboolean tinker_graph_plot_read(TinkerGraphPlot *plot, const TinkerPlot *picture, double x, double y,
                                TinkerGraphReading *reading);
/* What a cursor is put on that is set there: the nearest extremum or zero of any curve if it is near, else the curve
 * that passes nearest above or below, at the pointer's place across. FALSE where no curve is. */
gboolean tinker_graph_plot_read_place(TinkerGraphPlot *plot, double x, double y, TinkerGraphReading *reading);

/* The whole names of the curves, a line each, at a place of the legend where that shortens them; NULL elsewhere.
 * (transfer full) */
char *tinker_graph_plot_legend_text(TinkerGraphPlot *plot, double x, double y);

/* The axes that the box which is dragged is of; 0: it is none yet. */
TinkerGraphAxes tinker_graph_box_axes(const TinkerGraphPlot *plot);

void tinker_graph_plot_add_input(TinkerGraphPlot *plot);

/* graph-point.c: follows what is pointed at; points in the document at the block of the curve, or of the legend's
 * entry, at a place, or at nothing.
 */
void tinker_graph_plot_follow_pointing(TinkerGraphPlot *plot);
void tinker_graph_plot_point_at(TinkerGraphPlot *plot, double x, double y);
void tinker_graph_plot_point_away(TinkerGraphPlot *plot);

/* The box that is being dragged, and the cursors with what lies between them. */
void tinker_graph_plot_draw_marks(TinkerGraphPlot *plot, cairo_t *cairo);

#endif
