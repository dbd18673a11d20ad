/* A child that is taken out is no longer the first. */
#include "gui/widget/unparent.h"

void tinker_unparent_children(GtkWidget *widget)
{
    GtkWidget *child;
    while ((child = gtk_widget_get_first_child(widget)) != NULL)
        gtk_widget_unparent(child);
}
