/* One graph: a title bar with its buttons, the plot, and the menu. Its commands are actions graph.* of the widget;
 * those that edit the scene are the window's: win.float-graph, win.dock-graph, win.delete-graph, each with the graph's
 * number. */
#ifndef TINKER_GUI_GRAPH_VIEW_H
#define TINKER_GUI_GRAPH_VIEW_H

#include <gtk/gtk.h>

#include "gui/curve/graph-data.h"

#define TINKER_TYPE_GRAPH_VIEW (tinker_graph_view_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphView, tinker_graph_view, TINKER, GRAPH_VIEW, GtkWidget)

/* With no graph yet. `floats`: it stands on the canvas, with a corner to size it by. (transfer floating) */
TinkerGraphView *tinker_graph_view_new(TinkerDocument *document, TinkerPlayer *player, gboolean floats);

/* Shows the graph of this number in tinker_scene_graphs. To be called again whenever the scene has changed. */
void tinker_graph_view_set_number(TinkerGraphView *view, int number);
int tinker_graph_view_number(TinkerGraphView *view);

/* Whether it shows a graph of the same quantities, so that it can stay where the scene has changed. */
gboolean tinker_graph_view_fits(TinkerGraphView *view, const TinkerSceneGraph *graph);

/* What it shows. Borrowed. */
TinkerGraphData *tinker_graph_view_data(TinkerGraphView *view);

/* What it is moved by and sized by. Borrowed. */
GtkWidget *tinker_graph_view_title_bar(TinkerGraphView *view);
GtkWidget *tinker_graph_view_corner(TinkerGraphView *view);

#endif
