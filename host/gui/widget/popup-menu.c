/* A popover is a child of the widget it is shown over; this one is taken out again when it has closed. */
#include "gui/widget/popup-menu.h"

static gboolean unparent_later(gpointer menu)
{
    if (gtk_widget_get_parent(menu) != NULL) gtk_widget_unparent(menu);
    return G_SOURCE_REMOVE;
}

/* The item that was chosen is activated after the menu has closed. */
static void on_closed(GtkWidget *menu, gpointer had_tooltip)
{
    gtk_widget_set_has_tooltip(gtk_widget_get_parent(menu), GPOINTER_TO_INT(had_tooltip));
    g_idle_add_full(G_PRIORITY_DEFAULT_IDLE, unparent_later, g_object_ref(menu), g_object_unref);
}

void tinker_popup_menu(GtkWidget *parent, GMenuModel *model, double x, double y)
{
    GtkWidget *menu = gtk_popover_menu_new_from_model_full(model, GTK_POPOVER_MENU_NESTED);
    const GdkRectangle at = {(int)x, (int)y, 1, 1};
    gtk_widget_set_parent(menu, parent);
    gtk_popover_set_has_arrow(GTK_POPOVER(menu), FALSE);
    gtk_popover_set_pointing_to(GTK_POPOVER(menu), &at);
    gtk_widget_set_halign(menu, GTK_ALIGN_START);
    g_signal_connect(menu, "closed", G_CALLBACK(on_closed), GINT_TO_POINTER(gtk_widget_get_has_tooltip(parent)));
    gtk_widget_set_has_tooltip(parent, FALSE); /* it would come up over the menu */
    gtk_popover_popup(GTK_POPOVER(menu));
}
