/* Ways to look at a graph, by key and menu: zoom, move on, go to extrema, put cursors. */
#ifndef TINKER_GUI_GRAPH_LOOKS_H
#define TINKER_GUI_GRAPH_LOOKS_H

#include "gui/graph/graph-plot.h"

/* The keys, for a class of widgets that has the focus. */
void tinker_graph_looks_bind(GtkWidgetClass *widget_class);
/* The actions "look.zoom-in", ..., on such a widget. */
void tinker_graph_looks_add(GtkWidget *widget, TinkerGraphPlot *plot);

#endif
