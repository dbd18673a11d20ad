/* Lines under the header bar that stay until their reason is gone or the user has seen enough of them. */
#include <glib/gi18n.h>

#include "window-private.h"

static GtkWidget *find(TinkerWindow *window, const char *key)
{
    GtkWidget *child = gtk_widget_get_first_child(GTK_WIDGET(window->banners));
    while (child != NULL && g_strcmp0(gtk_widget_get_name(child), key) != 0)
        child = gtk_widget_get_next_sibling(child);
    return child;
}

static void on_response(GtkInfoBar *bar, int response, gpointer data)
{
    gtk_info_bar_set_revealed(bar, FALSE);
}

void window_banner_hide(TinkerWindow *window, const char *key)
{
    GtkWidget *bar = find(window, key);
    if (bar != NULL) gtk_box_remove(window->banners, bar);
}

void window_banner_show(TinkerWindow *window, const char *key, const char *text, const char *label, const char *action)
{
    GtkWidget *last = find(window, key);
    if (last != NULL && g_strcmp0(g_object_get_data(G_OBJECT(last), "text"), text) == 0) return;
    window_banner_hide(window, key);
    GtkWidget *bar = gtk_info_bar_new(), *line = gtk_label_new(text);
    gtk_widget_set_name(bar, key);
    g_object_set_data_full(G_OBJECT(bar), "text", g_strdup(text), g_free);
    gtk_info_bar_set_message_type(GTK_INFO_BAR(bar), GTK_MESSAGE_WARNING);
    gtk_info_bar_set_show_close_button(GTK_INFO_BAR(bar), TRUE);
    gtk_label_set_wrap(GTK_LABEL(line), TRUE);
    gtk_label_set_xalign(GTK_LABEL(line), 0);
    gtk_widget_set_hexpand(line, TRUE);
    gtk_info_bar_add_child(GTK_INFO_BAR(bar), line);
    if (label != NULL) {
        GtkWidget *button = gtk_button_new_with_mnemonic(label);
        gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
        gtk_widget_set_valign(button, GTK_ALIGN_CENTER);
        gtk_info_bar_add_child(GTK_INFO_BAR(bar), button);
    }
    g_signal_connect(bar, "response", G_CALLBACK(on_response), NULL);
    gtk_box_append(window->banners, bar);
}
