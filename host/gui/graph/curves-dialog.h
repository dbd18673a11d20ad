/* The curves of one graph: which there are, on which axis; more of quantities, expressions and tables; the scales. */
#ifndef TINKER_GUI_CURVES_DIALOG_H
#define TINKER_GUI_CURVES_DIALOG_H

#include <gtk/gtk.h>

#include "gui/document/document.h"

/* Opens it over the window that the widget is in, for a graph by its number. Each change is a step at once. */
void tinker_curves_dialog_open(GtkWidget *over, TinkerDocument *document, int number);

#endif
