/* The window's autosave, and where it fails a notice. */
#include <glib/gi18n.h>

#include "gui/window/window-parts.h"

/* NULL: there is nothing to tell any more. (transfer full) */
static void set_notice(TinkerWindow *window, TinkerNotice *notice)
{
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    if (notice != NULL) g_ptr_array_add(notices, notice);
    tinker_notice_bar_set(window->notices, "autosave", notices);
}

static void save(void *window)
{
    window_save(window, FALSE);
}

static void on_failed(TinkerAutosave *autosave, const char *message, TinkerWindow *window)
{
    g_autofree char *text = g_strdup_printf(
        _("Changes cannot be saved automatically at present. Save the scene to keep them. (%s)"), message);
    set_notice(window, tinker_notice_new(TINKER_NOTICE_ERROR, text, _("Save"), save, window, NULL));
}

static void on_working(TinkerAutosave *autosave, TinkerWindow *window)
{
    set_notice(window, NULL);
}

void window_add_autosave(TinkerWindow *window)
{
    window->autosave = tinker_autosave_new(window->document);
    g_signal_connect_object(window->autosave, "failed", G_CALLBACK(on_failed), window, 0);
    g_signal_connect_object(window->autosave, "working", G_CALLBACK(on_working), window, 0);
}
