/* A click into an entry selects what is in it; what is typed there is listened to in one way. */
#ifndef TINKER_GUI_ENTRY_SELECT_H
#define TINKER_GUI_ENTRY_SELECT_H

#include <gtk/gtk.h>

/* From now on, a click that brings the focus to this entry selects all of its text, so that the next key replaces it.
 * Another click sets the cursor, and a drag selects a part, as ever. */
void tinker_entry_select_by_click(GtkWidget *entry);

/* Calls `typed` as its text changes, `taken` for Return and `left` as the focus goes, each with `data` alone; and `key`
 * as handler of "key-pressed", with `data` at its end, before the entry itself has the key. */
void tinker_entry_listen(GtkWidget *entry, GCallback typed, GCallback taken, GCallback left, GCallback key, void *data);

#endif
