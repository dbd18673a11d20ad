/* The plot of one graph as a widget: paints when there is something new to see, and reads values off the curve. */
#ifndef TINKER_GUI_GRAPH_PLOT_H
#define TINKER_GUI_GRAPH_PLOT_H

#include <gtk/gtk.h>

#include "gui/document/graph-data.h"

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

/* Whether a plot that is to be seen, this widget or one below it, has more of the record to read. */
gboolean tinker_graph_plot_any_behind(GtkWidget *root);

#endif
