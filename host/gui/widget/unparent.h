/* What the dispose function of a widget with children of its own does. */
#ifndef TINKER_GUI_UNPARENT_H
#define TINKER_GUI_UNPARENT_H

#include <gtk/gtk.h>

/* Takes all children out of a widget. */
void tinker_unparent_children(GtkWidget *widget);

#endif
