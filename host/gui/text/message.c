/* One button, because there is nothing to decide. */
#include "gui/text/message.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#define FEW_LINES    6   /* that need not be scrolled */
#define LINE         44  /* characters */
#define WIDTH        460 /* what scrolls: the width, and ... */
#define HEIGHT       320 /* ... the most of its height, ... */
#define LEAST_HEIGHT 120
#define MARGIN       12
#define SHARE        0.5 /* ... which is no more than this of the window's, either */

/* As lines wrap. */
static gboolean is_long(const char *text)
{
    glong lines = 0;
    g_auto(GStrv) parts = g_strsplit(text, "\n", -1);
    for (char **part = parts; *part != NULL; part++)
        lines += 1 + g_utf8_strlen(*part, -1) / LINE;
    return lines > FEW_LINES;
}

GtkWidget *tinker_message_text(GtkWindow *window, const char *text, const char *name)
{
    GtkWidget *label = gtk_label_new(text), *scroller = gtk_scrolled_window_new();
    const int available = window != NULL ? (int)(SHARE * gtk_widget_get_height(GTK_WIDGET(window))) : HEIGHT;
    const int most = CLAMP(available, LEAST_HEIGHT, HEIGHT);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_selectable(GTK_LABEL(label), TRUE);
    gtk_widget_set_margin_start(label, MARGIN);
    gtk_widget_set_margin_end(label, MARGIN);
    gtk_widget_set_margin_top(label, MARGIN);
    gtk_widget_set_margin_bottom(label, MARGIN);
    gtk_accessible_update_property(GTK_ACCESSIBLE(scroller), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scroller), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scroller), TRUE);
    /* What a text that wraps needs is underestimated. */
    gtk_scrolled_window_set_min_content_height(GTK_SCROLLED_WINDOW(scroller), is_long(text) ? 3 * most / 4 : -1);
    gtk_scrolled_window_set_max_content_height(GTK_SCROLLED_WINDOW(scroller), most);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scroller), label);
    gtk_widget_set_focusable(scroller, TRUE); /* arrow keys and Page Down scroll it */
    gtk_widget_set_size_request(scroller, WIDTH, -1);
    gtk_widget_add_css_class(scroller, "card");
    return scroller;
}

/* The dialog does not scroll what it is given as its body, and would be higher than the screen. */
void tinker_message(GtkWindow *window, const char *heading, const char *body)
{
    const gboolean scrolls = is_long(body);
    GtkWidget *dialog = adw_message_dialog_new(window, heading, scrolls ? NULL : body);
    if (scrolls)
        adw_message_dialog_set_extra_child(ADW_MESSAGE_DIALOG(dialog), tinker_message_text(window, body, heading));
    adw_message_dialog_add_response(ADW_MESSAGE_DIALOG(dialog), "close", _("_Close"));
    gtk_window_present(GTK_WINDOW(dialog));
}

void tinker_connect_answer(gpointer dialog, GCallback on_answer, gpointer data, GDestroyNotify free_data)
{
    /* a GClosureNotify is called with one argument more, as all of GLib's are */
    g_signal_connect_data(dialog, "response", on_answer, data, (GClosureNotify)(void (*)(void))free_data, 0);
}
