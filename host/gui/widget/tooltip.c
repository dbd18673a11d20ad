#include "gui/widget/tooltip.h"

void tinker_widget_begin_tooltip(GtkWidget *widget, const char *text)
{
    const gboolean visible = gtk_widget_get_visible(widget);
    gtk_widget_set_visible(widget, FALSE); /* the pointer is on nothing that is not seen */
    gtk_widget_set_tooltip_text(widget, text);
    gtk_widget_set_visible(widget, visible);
}
