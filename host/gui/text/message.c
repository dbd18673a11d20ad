/* One button, because there is nothing to decide. */
#include "gui/text/message.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#define FEW_LINES      10
#define LINE           44  /* characters */
#define SCROLLED       0.5 /* of the window's height: what a long text takes of it at most */
#define LEAST_SCROLLED 120

static gboolean is_long(const char *body)
{
    int lines = 1;
    for (const char *c = body; *c != '\0'; c++)
        lines += *c == '\n';
    return lines > FEW_LINES;
}

/* The dialog does not scroll what it is given as its body, and would be higher than the screen. */
static GtkWidget *scrolled(GtkWindow *window, const char *body)
{
    GtkWidget *label = gtk_label_new(body), *scroller = gtk_scrolled_window_new();
    const int height = window != NULL ? gtk_widget_get_height(GTK_WIDGET(window)) : 0;
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_width_chars(GTK_LABEL(label), LINE);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scroller), label);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scroller), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scroller), TRUE);
    gtk_scrolled_window_set_max_content_height(GTK_SCROLLED_WINDOW(scroller),
                                               MAX((int)(SCROLLED * height), LEAST_SCROLLED));
    gtk_widget_set_focusable(scroller, TRUE); /* arrow keys and Page Down scroll it */
    return scroller;
}

void tinker_message(GtkWindow *window, const char *heading, const char *body)
{
    const gboolean scrolls = is_long(body);
    GtkWidget *dialog = adw_message_dialog_new(window, heading, scrolls ? NULL : body);
    if (scrolls) adw_message_dialog_set_extra_child(ADW_MESSAGE_DIALOG(dialog), scrolled(window, body));
    adw_message_dialog_add_response(ADW_MESSAGE_DIALOG(dialog), "close", _("_Close"));
    gtk_window_present(GTK_WINDOW(dialog));
}

void tinker_connect_answer(gpointer dialog, GCallback on_answer, gpointer data, GDestroyNotify free_data)
{
    /* a GClosureNotify is called with one argument more, as all of GLib's are */
    g_signal_connect_data(dialog, "response", on_answer, data, (GClosureNotify)(void (*)(void))free_data, 0);
}
