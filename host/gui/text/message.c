/* One button, because there is nothing to decide. */
#include "gui/text/message.h"

#include <adwaita.h>
#include <glib/gi18n.h>

void tinker_message(GtkWindow *window, const char *heading, const char *body)
{
    GtkWidget *dialog = adw_message_dialog_new(window, heading, body);
    adw_message_dialog_add_response(ADW_MESSAGE_DIALOG(dialog), "close", _("_Close"));
    gtk_window_present(GTK_WINDOW(dialog));
}

void tinker_connect_answer(gpointer dialog, GCallback on_answer, gpointer data, GDestroyNotify free_data)
{
    /* a GClosureNotify is called with one argument more, as all of GLib's are */
    g_signal_connect_data(dialog, "response", on_answer, data, (GClosureNotify)(void (*)(void))free_data, 0);
}
