/* The dialogs are the desktop's own. */
#include "gui/widget/save-dialog.h"

#include <glib/gi18n.h>
#include <string.h>

static const struct {
    const char *name, *ending;
} formats[] = {{N_("PNG image"), ".png"}, {N_("SVG drawing"), ".svg"}, {N_("PDF document"), ".pdf"}};

GtkFileChooserNative *tinker_save_dialog_new(GtkWindow *window, const char *title, const char *suggestion,
                                             const char *ending)
{
    GtkFileChooserNative *dialog =
        gtk_file_chooser_native_new(title, window, GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    g_autofree char *bare = g_strdup(suggestion);
    g_strdelimit(bare, "/\\", '-');
    g_strdelimit(bare, ":", ',');
    g_autofree char *name = g_strconcat(bare, ending, NULL);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), name);
    return dialog;
}

void tinker_save_dialog_add_filter(GtkFileChooserNative *dialog, const char *name, const char *ending)
{
    g_autoptr(GtkFileFilter) filter = gtk_file_filter_new();
    g_autofree char *pattern = g_strconcat("*", ending, NULL);
    gtk_file_filter_set_name(filter, name);
    gtk_file_filter_add_pattern(filter, pattern);
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), filter);
}

char *tinker_save_dialog_path(GtkNativeDialog *dialog)
{
    g_autoptr(GFile) file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
    return file != NULL ? g_file_get_path(file) : NULL;
}

gboolean tinker_has_ending(const char *path, const char *ending)
{
    gsize length = strlen(path), tail = strlen(ending);
    return length > tail && g_ascii_strcasecmp(path + length - tail, ending) == 0;
}

GtkFileChooserNative *tinker_picture_dialog_new(GtkWindow *window, const char *title, const char *suggestion)
{
    GtkFileChooserNative *dialog = tinker_save_dialog_new(window, title, suggestion, formats[0].ending);
    for (gsize i = 0; i < G_N_ELEMENTS(formats); i++)
        tinker_save_dialog_add_filter(dialog, _(formats[i].name), formats[i].ending);
    return dialog;
}

char *tinker_picture_dialog_path(GtkNativeDialog *dialog)
{
    g_autofree char *path = tinker_save_dialog_path(dialog);
    GtkFileFilter *filter = gtk_file_chooser_get_filter(GTK_FILE_CHOOSER(dialog));
    gsize chosen = 0;
    if (path == NULL) return NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(formats); i++) {
        if (tinker_has_ending(path, formats[i].ending)) return g_strdup(path);
        if (filter != NULL && g_strcmp0(gtk_file_filter_get_name(filter), _(formats[i].name)) == 0) chosen = i;
    }
    return g_strconcat(path, formats[chosen].ending, NULL);
}
