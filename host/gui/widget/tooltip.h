/* Tooltips of widgets that are made by the hundred. */
#ifndef TINKER_GUI_TOOLTIP_H
#define TINKER_GUI_TOOLTIP_H

#include <gtk/gtk.h>

/* As gtk_widget_set_tooltip_text, for a widget that no window has yet. GTK's own asks the window system where the
 * pointer is, for each widget again, which takes longer than to make the widget. */
void tinker_widget_begin_tooltip(GtkWidget *widget, const char *text);

#endif
