/* A label that may be cut off asks for no width; how much of a choice the open list shows is a number of characters. */
#include "gui/widget/choices.h"

#define LONGEST 48 /* characters */
#define SHOWN   24 /* of a choice in the open list, however narrow its button is */

static void on_setup(GtkSignalListItemFactory *factory, GtkListItem *item, gpointer longest)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_label_set_max_width_chars(GTK_LABEL(label), GPOINTER_TO_INT(longest));
    gtk_list_item_set_child(item, label);
}

static void on_bind(GtkSignalListItemFactory *factory, GtkListItem *item, gpointer shown)
{
    const char *text = gtk_string_object_get_string(gtk_list_item_get_item(item));
    GtkLabel *label = GTK_LABEL(gtk_list_item_get_child(item));
    gtk_label_set_text(label, text);
    gtk_label_set_width_chars(label, (int)MIN(g_utf8_strlen(text, -1), GPOINTER_TO_INT(shown)));
}

static GtkListItemFactory *new_factory(int longest, int shown)
{
    GtkListItemFactory *factory = gtk_signal_list_item_factory_new();
    g_signal_connect(factory, "setup", G_CALLBACK(on_setup), GINT_TO_POINTER(longest));
    g_signal_connect(factory, "bind", G_CALLBACK(on_bind), GINT_TO_POINTER(shown));
    return factory;
}

void tinker_choices_cut_off(GtkDropDown *list)
{
    g_autoptr(GtkListItemFactory) button = new_factory(LONGEST / 2, 0), open = new_factory(LONGEST, SHOWN);
    gtk_drop_down_set_factory(list, button);
    gtk_drop_down_set_list_factory(list, open);
}
