/* Up to two questions one after the other: which file, and whether it may be copied beside the scene. */
#include "gui/property/table-chooser.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#include "gui/text/message.h"

/* What is asked about. */
typedef struct {
    GtkWindow *window;
    TinkerDocument *document;
    TinkerPropertyRow *row;
    char *path; /* of the file; NULL: none yet */
} Request;

static Request *request_new(GtkWindow *window, TinkerDocument *document, TinkerPropertyRow *row, const char *path)
{
    Request *request = g_new(Request, 1);
    *request = (Request){g_object_ref(window), g_object_ref(document), tinker_property_row_ref(row), g_strdup(path)};
    return request;
}

static void request_free(gpointer data)
{
    Request *request = data;
    g_object_unref(request->window);
    g_object_unref(request->document);
    tinker_property_row_unref(request->row);
    g_free(request->path);
    g_free(request);
}

static void refuse(const Request *request, const char *reason)
{
    tinker_message(request->window, _("The Table Was Not Taken"), reason);
}

static void take(const Request *request, const char *path)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_property_row_choose_file(request->document, request->row, path, &error))
        refuse(request, error->message);
}

/* Copying ---------------------------------------------------------------------------------------------------------- */

static void on_copy(AdwMessageDialog *dialog, const char *answer, const Request *request)
{
    if (g_strcmp0(answer, "copy") == 0) take(request, request->path);
}

static void ask_to_copy(const Request *request, const char *path, const char *name)
{
    g_autofree char *own = g_filename_display_basename(path);
    g_autofree char *folder = g_path_get_dirname(tinker_document_path(request->document));
    g_autofree char *shown = g_filename_display_name(folder), *as = g_filename_display_name(name);
    g_autofree char *body =
        g_str_equal(own, as)
            ? g_strdup_printf(_("A scene reads tables from its own folder, and “%s” lies elsewhere. Copy it to %s?"),
                              own, shown)
            : g_strdup_printf(_("A scene reads tables from its own folder, and “%s” lies elsewhere. Copy it to %s as "
                                "“%s”? Another file has its name there, and stays as it is."),
                              own, shown, as);
    GtkWidget *dialog = adw_message_dialog_new(request->window, _("Copy the Table?"), body);
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "copy", _("_Copy"), NULL);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "copy");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    tinker_connect_answer(dialog, G_CALLBACK(on_copy),
                          request_new(request->window, request->document, request->row, path), request_free);
    gtk_window_present(GTK_WINDOW(dialog));
}

/* The file --------------------------------------------------------------------------------------------------------- */

static void on_path(const Request *request, const char *path)
{
    g_autofree char *copy = NULL;
    g_autoptr(GError) error = NULL;
    if (!tinker_property_row_check_file(request->document, request->row, path, &copy, &error))
        refuse(request, error->message);
    else if (copy != NULL)
        ask_to_copy(request, path, copy);
    else
        take(request, path);
}

static void on_file(GtkNativeDialog *dialog, int response, const Request *request)
{
    g_autoptr(GFile) file =
        response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    g_autofree char *path = file != NULL ? g_file_get_path(file) : NULL;
    if (path != NULL)
        on_path(request, path);
    else if (file != NULL)
        refuse(request, _("Choose a local file."));
    g_object_unref(dialog);
}

static void add_filters(GtkFileChooser *chooser)
{
    g_autoptr(GtkFileFilter) tables = gtk_file_filter_new(), all = gtk_file_filter_new();
    gtk_file_filter_set_name(tables, _("CSV tables"));
    gtk_file_filter_add_suffix(tables, "csv");
    gtk_file_filter_set_name(all, _("All files"));
    gtk_file_filter_add_pattern(all, "*");
    gtk_file_chooser_add_filter(chooser, tables);
    gtk_file_chooser_add_filter(chooser, all);
}

static void ask_file(GtkWindow *window, TinkerDocument *document, TinkerPropertyRow *row)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(
        _("Choose a Table"), window, GTK_FILE_CHOOSER_ACTION_OPEN, _("_Choose"), _("_Cancel"));
    g_autoptr(GFile) scene = g_file_new_for_path(tinker_document_path(document)), folder = g_file_get_parent(scene);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    add_filters(GTK_FILE_CHOOSER(dialog));
    gtk_file_chooser_set_current_folder(GTK_FILE_CHOOSER(dialog), folder, NULL);
    tinker_connect_answer(dialog, G_CALLBACK(on_file), request_new(window, document, row, NULL), request_free);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

/* Scenes without a folder ------------------------------------------------------------------------------------------ */

static void on_save(AdwMessageDialog *dialog, const char *answer, GtkWidget *window)
{
    if (g_strcmp0(answer, "save") == 0) gtk_widget_activate_action(window, "win.save", NULL);
}

static void ask_to_save(GtkWindow *window)
{
    GtkWidget *dialog = adw_message_dialog_new(window, _("Save the Scene First"),
                                               _("A scene reads tables from its own folder, and this one has not been "
                                                 "saved yet. Choose the table afterwards."));
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "save", _("_Save"), NULL);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "save");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    g_signal_connect_object(dialog, "response", G_CALLBACK(on_save), window, 0);
    gtk_window_present(GTK_WINDOW(dialog));
}

void tinker_choose_table(GtkWidget *widget, TinkerDocument *document, TinkerPropertyRow *row)
{
    GtkWindow *window = GTK_WINDOW(gtk_widget_get_root(widget));
    if (tinker_document_path(document) == NULL)
        ask_to_save(window);
    else
        ask_file(window, document, row);
}
