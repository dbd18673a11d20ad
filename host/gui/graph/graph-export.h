/* What leaves the program from a graph: its picture and its values. */
#ifndef TINKER_GUI_GRAPH_EXPORT_H
#define TINKER_GUI_GRAPH_EXPORT_H

#include <gtk/gtk.h>

#include "gui/curve/graph-data.h"

/* Puts a picture of the graph, as wide and high as given (widget units), onto the widget's clipboard: in the light
 * theme, at twice the resolution, for documents. */
void tinker_graph_copy(GtkWidget *widget, TinkerGraphData *data, int width, int height);

/* Draws it likewise, from (0, 0) on. */
void tinker_graph_draw_for_paper(TinkerGraphData *data, cairo_t *cairo, double width, double height);

/* Ask for a file; then write the picture (.png, .svg, .pdf) or the values (CSV). `view` is the widget whose window the
 * question belongs to; it keeps `data` alive, which is looked at again when the answer is there. Failures are told. */
void tinker_graph_save_image(GtkWidget *view, TinkerGraphData *data, int width, int height);
void tinker_graph_export_values(GtkWidget *view, TinkerGraphData *data);

#endif
