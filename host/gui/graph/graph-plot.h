/* The plot of one graph as a widget: paints when there is something new to see, and reads values off the curve. */
#ifndef TINKER_GUI_GRAPH_PLOT_H
#define TINKER_GUI_GRAPH_PLOT_H

#include <gtk/gtk.h>

#include "gui/curve/graph-data.h"
#include "gui/curve/graph-zoom.h"

#define TINKER_TYPE_GRAPH_PLOT (tinker_graph_plot_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphPlot, tinker_graph_plot, TINKER, GRAPH_PLOT, GtkWidget)

/* (transfer floating) */
GtkWidget *tinker_graph_plot_new(TinkerDocument *document, TinkerPlayer *player);

/* What it plots. Borrowed. */
TinkerGraphData *tinker_graph_plot_data(TinkerGraphPlot *plot);

/* Shows another graph, or the same after the scene has changed. */
void tinker_graph_plot_set_graph(TinkerGraphPlot *plot, const TinkerSceneGraph *graph);

/* Whether the values of the point under the pointer are shown. */
void tinker_graph_plot_set_show_values(TinkerGraphPlot *plot, gboolean show);

/* Signal: "looks-changed" when what is zoomed or measured has.
 *
 * Zooms about the middle; moves on by shares of what is seen; shows all again, also of the time in other graphs. */
void tinker_graph_plot_zoom(TinkerGraphPlot *plot, TinkerGraphAxes axes, double factor);
void tinker_graph_plot_pan(TinkerGraphPlot *plot, double right, double up);
void tinker_graph_plot_show_all(TinkerGraphPlot *plot);
/* Goes to the time of the first curve's next maximum, minimum or zero, or the one before. */
void tinker_graph_plot_go_to_next(TinkerGraphPlot *plot, gboolean forward);

/* One of two cursors, at the present time; none; and what they read: "Δt = 0.5 s, Δy = 0.2 m, 1/Δt = 2 Hz" (transfer
 * full; NULL: there is none). */
void tinker_graph_plot_put_cursor(TinkerGraphPlot *plot);
void tinker_graph_plot_clear_cursors(TinkerGraphPlot *plot);
/* Keys go from curve to curve: what it is of is pointed at until none is chosen any more. */
void tinker_graph_plot_choose_curve(TinkerGraphPlot *plot, int step);
void tinker_graph_plot_choose_no_curve(TinkerGraphPlot *plot);
/* The part of the time between both cursors. FALSE where there are not two, at two times. */
gboolean tinker_graph_plot_between_cursors(TinkerGraphPlot *plot, TinkerGraphPart *part);
/* "shows 0.5 to 1.2 s" where the time that is seen is not all (transfer full; NULL). */
char *tinker_graph_plot_zoom_text(TinkerGraphPlot *plot);
char *tinker_graph_plot_cursor_text(TinkerGraphPlot *plot);
/* The name of the curve that keys have come to; NULL: none. (transfer full) */
char *tinker_graph_plot_chosen_text(TinkerGraphPlot *plot);

/* Whether a plot that is to be seen, this widget or one below it, has more of the record to read. */
gboolean tinker_graph_plot_any_behind(GtkWidget *root);

#endif
