/* What every part of the window may tell, and may ask of it. */
#include "gui/text/message.h"
#include "gui/text/settings.h"
#include "gui/window/window-parts.h"

void window_toast(TinkerWindow *window, const char *text)
{
    AdwToast *toast = adw_toast_new(text);
    adw_toast_set_timeout(toast, (guint)MAX(tinker_settings_integer("window", "message-seconds", 4), 0));
    adw_toast_overlay_add_toast(window->toasts, toast);
}

void window_message(TinkerWindow *window, const char *heading, const char *body)
{
    tinker_message(GTK_WINDOW(window), heading, body);
}

gboolean tinker_window_is_untouched(TinkerWindow *window)
{
    return tinker_document_path(window->document) == NULL && tinker_document_is_empty(window->document) &&
           !tinker_document_is_modified(window->document);
}
