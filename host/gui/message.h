/* Messages that have to be read. */
#ifndef TINKER_GUI_MESSAGE_H
#define TINKER_GUI_MESSAGE_H

#include <gtk/gtk.h>

/* Shows one over a window (may be NULL), until it is closed. */
void tinker_message(GtkWindow *window, const char *heading, const char *body);

#endif
