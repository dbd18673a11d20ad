/* A table as a curve of a graph: asks for the file, and which of its columns hold the times and the values. */
#ifndef TINKER_GUI_TABLE_DIALOG_H
#define TINKER_GUI_TABLE_DIALOG_H

#include <gtk/gtk.h>

#include "gui/document/document.h"

/* What came of it: NULL, or what is wrong with a file (borrowed). */
typedef void (*TinkerTableTold)(GtkWindow *over, GError *error);

/* Over a window, which is told. The curve is one step for undo; a file from elsewhere is copied beside the scene. */
void tinker_table_dialog_open(GtkWindow *over, TinkerDocument *document, int graph, TinkerTableTold told);

#endif
