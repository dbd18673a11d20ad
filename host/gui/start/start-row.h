/* A row of the section "Start": what it asks for, an entry, the button that applies it, and what is wrong with what was
 * typed.
 */
#ifndef TINKER_GUI_START_ROW_H
#define TINKER_GUI_START_ROW_H

#include <gtk/gtk.h>

#define TINKER_TYPE_START_ROW (tinker_start_row_get_type())
G_DECLARE_FINAL_TYPE(TinkerStartRow, tinker_start_row, TINKER, START_ROW, GtkListBoxRow)

/* The signal "apply" (char *text) asks for what was typed. */
TinkerStartRow *tinker_start_row_new(const char *label);

/* Shows a value, unless something else is being typed or was refused. Escape brings it back. */
void tinker_start_row_show(TinkerStartRow *row, const char *value, const char *description);

/* Says beneath the entry what is wrong, until something else is typed; the entry keeps its text. */
void tinker_start_row_refuse(TinkerStartRow *row, const char *message);

gboolean tinker_start_row_has_focus(TinkerStartRow *row);
void tinker_start_row_focus(TinkerStartRow *row);

/* A label with lines as short as its container makes them. (transfer full, floating) */
GtkWidget *tinker_start_wrapping_label(const char *text);

#endif
