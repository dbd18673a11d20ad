/* A click into an entry selects what is in it. */
#ifndef TINKER_GUI_ENTRY_SELECT_H
#define TINKER_GUI_ENTRY_SELECT_H

#include <gtk/gtk.h>

/* From now on, a click that brings the focus to this entry selects all of its text, so that the next key replaces it.
 * Another click sets the cursor, and a drag selects a part, as ever. */
void tinker_entry_select_by_click(GtkWidget *entry);

#endif
