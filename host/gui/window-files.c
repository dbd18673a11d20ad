/* New, open, save, and the question about what is not saved, which comes before whatever would lose it. */
#include <glib/gi18n.h>

#include "window-private.h"

#define ENDING ".tinker.json"

/* What is to be done once nothing can be lost. */
typedef void (*Then)(TinkerWindow *window);

typedef struct {
    TinkerWindow *window; /* owned */
    Then then;
} Question;

static void question_free(Question *question)
{
    g_object_unref(question->window);
    g_free(question);
}

/* Saving -------------------------------------------------------------------------------------------------------------- */

static gboolean save_to(TinkerWindow *window, const char *path)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_document_save(window->document, path, &error)) {
        window_message(window, _("The Scene Was Not Saved"), error->message);
        return FALSE;
    }
    g_autofree char *name = g_path_get_basename(path);
    g_autofree char *uri = g_filename_to_uri(path, NULL, NULL);
    gtk_recent_manager_add_item(gtk_recent_manager_get_default(), uri);
    g_autofree char *text = g_strdup_printf(_("Saved as %s"), name);
    window_toast(window, text);
    return TRUE;
}

static void on_save_name(GtkNativeDialog *dialog, int response, Question *question)
{
    if (response == GTK_RESPONSE_ACCEPT) {
        g_autoptr(GFile) file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
        g_autofree char *chosen = g_file_get_path(file);
        g_autofree char *path =
            g_str_has_suffix(chosen, ".json") ? g_strdup(chosen) : g_strconcat(chosen, ENDING, NULL);
        if (save_to(question->window, path) && question->then != NULL) question->then(question->window);
    }
    question_free(question);
    g_object_unref(dialog);
}

static void add_filters(GtkFileChooserNative *dialog)
{
    g_autoptr(GtkFileFilter) scenes = gtk_file_filter_new(), all = gtk_file_filter_new();
    gtk_file_filter_set_name(scenes, _("Tinker scenes"));
    gtk_file_filter_add_pattern(scenes, "*" ENDING);
    gtk_file_filter_set_name(all, _("All files"));
    gtk_file_filter_add_pattern(all, "*");
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), scenes);
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), all);
}

static void ask_name(TinkerWindow *window, Then then)
{
    Question *question = g_new(Question, 1);
    *question = (Question){g_object_ref(window), then};
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(_("Save Scene"), GTK_WINDOW(window),
                                                               GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    add_filters(dialog);
    g_autofree char *name = tinker_document_name(window->document);
    g_autofree char *file_name = g_strconcat(name, ENDING, NULL);
    gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), g_strdelimit(file_name, "/", '-'));
    g_signal_connect(dialog, "response", G_CALLBACK(on_save_name), question);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

static void save_then(TinkerWindow *window, gboolean under_another_name, Then then)
{
    const char *path = tinker_document_path(window->document);
    if (path == NULL || under_another_name) {
        ask_name(window, then);
        return;
    }
    g_autofree char *same = g_strdup(path);
    if (save_to(window, same) && then != NULL) then(window);
}

void window_save(TinkerWindow *window, gboolean under_another_name)
{
    save_then(window, under_another_name, NULL);
}

/* The question -------------------------------------------------------------------------------------------------------- */

static void on_answer(AdwMessageDialog *dialog, const char *answer, Question *question)
{
    if (g_strcmp0(answer, "discard") == 0) question->then(question->window);
    if (g_strcmp0(answer, "save") == 0) save_then(question->window, FALSE, question->then);
    question_free(question);
}

/* Does it at once where there is nothing to save. */
static void ask_first(TinkerWindow *window, Then then)
{
    if (!tinker_document_is_modified(window->document)) {
        then(window);
        return;
    }
    Question *question = g_new(Question, 1);
    *question = (Question){g_object_ref(window), then};
    g_autofree char *name = tinker_document_name(window->document);
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(window), _("Save Changes?"), NULL);
    adw_message_dialog_format_body(ADW_MESSAGE_DIALOG(dialog),
                                   _("“%s” has changes that are not saved. They are lost if you discard them."), name);
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "discard", _("_Discard"),
                                     "save", _("_Save"), NULL);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "discard", ADW_RESPONSE_DESTRUCTIVE);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "save", ADW_RESPONSE_SUGGESTED);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "save");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    g_signal_connect(dialog, "response", G_CALLBACK(on_answer), question);
    gtk_window_present(GTK_WINDOW(dialog));
}

static void close_now(TinkerWindow *window)
{
    window->may_close = TRUE;
    gtk_window_close(GTK_WINDOW(window));
}

void window_ask_to_close(TinkerWindow *window)
{
    ask_first(window, close_now);
}

/* New and open -------------------------------------------------------------------------------------------------------- */

static void start_new(TinkerWindow *window)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GBytes) text = g_resources_lookup_data("/org/tinker/Tinker/new-scene.tinker.json", 0, NULL);
    gsize length;
    const char *data = g_bytes_get_data(text, &length);
    if (!tinker_document_start(window->document, data, length, NULL, &error))
        window_message(window, _("No New Scene"), error->message);
}

void window_new_scene(TinkerWindow *window)
{
    ask_first(window, start_new);
}

void tinker_window_open(TinkerWindow *window, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    if (!tinker_document_open(window->document, path, findings, &error)) {
        window_message(window, _("The File Was Not Opened"), error->message);
        return;
    }
    g_autofree char *uri = g_filename_to_uri(path, NULL, NULL);
    if (uri != NULL) gtk_recent_manager_add_item(gtk_recent_manager_get_default(), uri);
    if (findings->len == 0) return;
    const TinkerFinding *first = g_ptr_array_index(findings, 0);
    window_toast(window, first->message);
}

static void on_open_name(GtkNativeDialog *dialog, int response, TinkerWindow *window)
{
    if (response == GTK_RESPONSE_ACCEPT) {
        g_autoptr(GFile) file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
        g_autofree char *path = g_file_get_path(file);
        tinker_window_open(window, path);
    }
    g_object_unref(dialog);
}

static void choose_file(TinkerWindow *window)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(_("Open Scene"), GTK_WINDOW(window),
                                                               GTK_FILE_CHOOSER_ACTION_OPEN, _("_Open"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    add_filters(dialog);
    g_signal_connect(dialog, "response", G_CALLBACK(on_open_name), window);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

void window_choose_file(TinkerWindow *window)
{
    ask_first(window, choose_file);
}
