/* Messages that have to be read, and questions that have to be answered. */
#ifndef TINKER_GUI_MESSAGE_H
#define TINKER_GUI_MESSAGE_H

#include <gtk/gtk.h>

/* Shows one over a window (may be NULL), until it is closed. */
void tinker_message(GtkWindow *window, const char *heading, const char *body);

/* A text of any length, to be read and copied: it scrolls within what a window has room for. `name` is said of it by a
 * screen reader. (transfer floating) */
GtkWidget *tinker_message_text(GtkWindow *window, const char *text, const char *name);

/* Has a dialog's "response" call `on_answer` with `data`, which goes with the dialog, answered or not. */
void tinker_connect_answer(gpointer dialog, GCallback on_answer, gpointer data, GDestroyNotify free_data);

#endif
