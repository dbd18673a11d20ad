/* Mean, extrema, period and damping of a graph's curves, told in a message. */
#ifndef TINKER_GUI_GRAPH_STATISTICS_H
#define TINKER_GUI_GRAPH_STATISTICS_H

#include <gtk/gtk.h>

#include "gui/curve/graph-data.h"

/* Of the time that is seen (s); NULL: of all. */
void tinker_graph_show_statistics(GtkWidget *widget, TinkerGraphData *data, const double *range);

#endif
