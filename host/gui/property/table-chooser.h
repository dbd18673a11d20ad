/* Asks which file a table is read from. */
#ifndef TINKER_GUI_TABLE_CHOOSER_H
#define TINKER_GUI_TABLE_CHOOSER_H

#include <gtk/gtk.h>

#include "gui/property/property-list.h"

/* Asks over the window of the widget for a file, and before it is copied; then sets the row, which has a `file_choice`.
 * Of a scene that has no file yet it says that it has to be saved first. Takes references. */
void tinker_choose_table(GtkWidget *widget, TinkerDocument *document, TinkerPropertyRow *row);

#endif
