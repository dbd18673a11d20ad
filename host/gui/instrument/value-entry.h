/* The value of a control as a number that can be typed. */
#ifndef TINKER_GUI_VALUE_ENTRY_H
#define TINKER_GUI_VALUE_ENTRY_H

#include <gtk/gtk.h>

/* What was typed and ended with Return. FALSE where it is refused: it stays, and is marked. */
typedef gboolean (*TinkerValueTaken)(const char *text, gpointer data);

/* An entry whose text is handed to `take`; Escape, and leaving it, bring back what was shown. (transfer floating) */
GtkWidget *tinker_value_entry_new(TinkerValueTaken take, gpointer data);

/* Shows a value, unless another one is being typed. */
void tinker_value_entry_show(GtkWidget *entry, const char *text);

#endif
