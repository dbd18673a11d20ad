/* Messages that have to be read, and questions that have to be answered. */
#ifndef TINKER_GUI_MESSAGE_H
#define TINKER_GUI_MESSAGE_H

#include <gtk/gtk.h>

/* Shows one over a window (may be NULL), until it is closed. */
void tinker_message(GtkWindow *window, const char *heading, const char *body);

/* Has a dialog's "response" call `on_answer` with `data`, which goes with the dialog, answered or not. */
void tinker_connect_answer(gpointer dialog, GCallback on_answer, gpointer data, GDestroyNotify free_data);

#endif
