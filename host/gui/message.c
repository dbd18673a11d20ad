/* One button, because there is nothing to decide. */
#include "message.h"

#include <adwaita.h>
#include <glib/gi18n.h>

void tinker_message(GtkWindow *window, const char *heading, const char *body)
{
    GtkWidget *dialog = adw_message_dialog_new(window, heading, body);
    adw_message_dialog_add_response(ADW_MESSAGE_DIALOG(dialog), "close", _("_Close"));
    gtk_window_present(GTK_WINDOW(dialog));
}
