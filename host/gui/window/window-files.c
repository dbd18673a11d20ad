/* Saving, and the question about what is not saved, which comes before whatever would lose it. */
#include "gui/window/window-files.h"

#include <glib/gi18n.h>

#include "gui/text/message.h"

/* What is to be done once nothing can be lost, and what with. */
typedef struct {
    TinkerWindow *window; /* owned */
    WindowThen then;      /* may be NULL */
    char *subject;        /* of `then` */
    char *path;           /* where to save */
} Question;

static Question *question_new(TinkerWindow *window, const char *path, WindowThen then, const char *subject)
{
    Question *question = g_new(Question, 1);
    *question = (Question){g_object_ref(window), then, g_strdup(subject), g_strdup(path)};
    return question;
}

static void question_free(Question *question)
{
    g_object_unref(question->window);
    g_free(question->subject);
    g_free(question->path);
    g_free(question);
}

G_DEFINE_AUTOPTR_CLEANUP_FUNC(Question, question_free)

/* Has a dialog answer a copy of the question, which goes with the dialog, answered or not. */
static void connect_answer(gpointer dialog, GCallback on_answer, const Question *question)
{
    tinker_connect_answer(dialog, on_answer,
                          question_new(question->window, question->path, question->then, question->subject),
                          (GDestroyNotify)question_free);
}

static gboolean on_idle(gpointer data)
{
    const Question *question = data;
    question->then(question->window, question->subject);
    return G_SOURCE_REMOVE;
}

/* Not before the dialog that was answered has gone: the window may go, too. */
static void proceed_when_idle(const Question *question)
{
    if (question->then == NULL) return;
    g_idle_add_full(G_PRIORITY_DEFAULT, on_idle,
                    question_new(question->window, NULL, question->then, question->subject),
                    (GDestroyNotify)question_free);
}

void window_note_recent(const char *path)
{
    g_autofree char *uri = g_filename_to_uri(path, NULL, NULL);
    if (uri != NULL) gtk_recent_manager_add_item(gtk_recent_manager_get_default(), uri);
}

/* Saving ----------------------------------------------------------------------------------------------------------- */

static void ask_name(TinkerWindow *window, WindowThen then, const char *subject);

static void on_not_saved(AdwMessageDialog *dialog, const char *answer, const Question *question)
{
    if (g_strcmp0(answer, "save-as") == 0) ask_name(question->window, question->then, question->subject);
}

/* Nothing was lost: the window keeps everything, and so does the file. */
static void tell_not_saved(const Question *question, const char *message)
{
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(question->window), _("The Scene Was Not Saved"), message);
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "save-as", _("Save _As…"),
                                     NULL);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "save-as");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    connect_answer(dialog, G_CALLBACK(on_not_saved), question);
    gtk_window_present(GTK_WINDOW(dialog));
}

static void save_now(const Question *question)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_document_save(question->window->document, question->path, &error)) {
        tell_not_saved(question, error->message);
        return;
    }
    g_autofree char *name = g_path_get_basename(question->path);
    g_autofree char *text = g_strdup_printf(_("Saved as %s"), name);
    window_note_recent(question->path);
    window_toast(question->window, text);
    proceed_when_idle(question);
}

static void on_overwrite(AdwMessageDialog *dialog, const char *answer, const Question *question)
{
    if (g_strcmp0(answer, "overwrite") == 0) save_now(question);
    if (g_strcmp0(answer, "save-as") == 0) ask_name(question->window, question->then, question->subject);
}

static void ask_to_overwrite(const Question *question, const char *heading, const char *body)
{
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(question->window), heading, body);
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "cancel", _("_Cancel"), "overwrite", _("_Overwrite"),
                                     "save-as", _("Save _As…"), NULL);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "overwrite", ADW_RESPONSE_DESTRUCTIVE);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "save-as");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "cancel");
    connect_answer(dialog, G_CALLBACK(on_overwrite), question);
    gtk_window_present(GTK_WINDOW(dialog));
}

/* The dialog has asked about the name that was typed, not about the one with the ending. */
static void save_under_name(Question *question, const char *chosen)
{
    gboolean complete = g_str_has_suffix(chosen, ".json");
    question->path = complete ? g_strdup(chosen) : g_strconcat(chosen, WINDOW_SCENE_ENDING, NULL);
    if (complete || !g_file_test(question->path, G_FILE_TEST_EXISTS)) {
        save_now(question);
        return;
    }
    g_autofree char *name = g_path_get_basename(question->path);
    g_autofree char *body = g_strdup_printf(_("There is a file “%s” already. What it holds is lost if you overwrite "
                                              "it."),
                                            name);
    ask_to_overwrite(question, _("Overwrite File?"), body);
}

static void on_save_name(GtkNativeDialog *dialog, int response, Question *question)
{
    g_autoptr(GFile) file =
        response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    g_autofree char *chosen = file != NULL ? g_file_get_path(file) : NULL;
    if (chosen != NULL)
        save_under_name(question, chosen);
    else if (file != NULL)
        window_message(question->window, _("The Scene Was Not Saved"), _("Choose a local folder."));
    g_object_unref(dialog);
}

void window_add_filters(GtkFileChooserNative *dialog)
{
    g_autoptr(GtkFileFilter) scenes = gtk_file_filter_new(), all = gtk_file_filter_new();
    gtk_file_filter_set_name(scenes, _("Tinker scenes"));
    gtk_file_filter_add_pattern(scenes, "*" WINDOW_SCENE_ENDING);
    gtk_file_filter_set_name(all, _("All files"));
    gtk_file_filter_add_pattern(all, "*");
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), scenes);
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), all);
}

/* Begins beside the file, or among the documents with the scene's title. Without the ending, which is put on later: the
 * chooser would select "Untitled.tinker" alone to be typed over, and leave ".json". */
static void suggest_name(GtkFileChooser *chooser, TinkerDocument *document)
{
    const char *path = tinker_document_path(document);
    if (path != NULL) {
        g_autoptr(GFile) file = g_file_new_for_path(path), folder = g_file_get_parent(file);
        g_autofree char *name = g_path_get_basename(path);
        if (g_str_has_suffix(name, WINDOW_SCENE_ENDING)) name[strlen(name) - strlen(WINDOW_SCENE_ENDING)] = '\0';
        gtk_file_chooser_set_current_folder(chooser, folder, NULL);
        gtk_file_chooser_set_current_name(chooser, name);
        return;
    }
    g_autofree char *name = tinker_document_name(document);
    const char *documents = g_get_user_special_dir(G_USER_DIRECTORY_DOCUMENTS);
    g_autoptr(GFile) folder = g_file_new_for_path(documents != NULL ? documents : g_get_home_dir());
    gtk_file_chooser_set_current_folder(chooser, folder, NULL);
    gtk_file_chooser_set_current_name(chooser, g_strdelimit(name, "/", '-'));
}

static void ask_name(TinkerWindow *window, WindowThen then, const char *subject)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(_("Save Scene"), GTK_WINDOW(window),
                                                               GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    window_add_filters(dialog);
    suggest_name(GTK_FILE_CHOOSER(dialog), window->document);
    connect_answer(dialog, G_CALLBACK(on_save_name), &(Question){window, then, (char *)subject, NULL});
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

static void save_then(TinkerWindow *window, gboolean under_another_name, WindowThen then, const char *subject)
{
    const char *path = tinker_document_path(window->document);
    if (path == NULL || under_another_name) {
        ask_name(window, then, subject);
        return;
    }
    g_autoptr(Question) question = question_new(window, path, then, subject);
    if (!tinker_document_changed_on_disk(window->document)) {
        save_now(question);
        return;
    }
    g_autofree char *name = g_path_get_basename(path);
    g_autofree char *body = g_strdup_printf(_("Another program has changed “%s” since it was opened here. Its changes "
                                              "are lost if you overwrite the file."),
                                            name);
    ask_to_overwrite(question, _("The File Has Changed"), body);
}

void window_save(TinkerWindow *window, gboolean under_another_name)
{
    save_then(window, under_another_name, NULL, NULL);
}

/* The question ----------------------------------------------------------------------------------------------------- */

static void on_answer(AdwMessageDialog *dialog, const char *answer, const Question *question)
{
    if (g_strcmp0(answer, "discard") == 0) proceed_when_idle(question);
    if (g_strcmp0(answer, "save") == 0) save_then(question->window, FALSE, question->then, question->subject);
}

void window_ask_first(TinkerWindow *window, WindowThen then, const char *subject)
{
    if (!tinker_document_is_modified(window->document)) {
        then(window, subject);
        return;
    }
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
    connect_answer(dialog, G_CALLBACK(on_answer), &(Question){window, then, (char *)subject, NULL});
    gtk_window_present(GTK_WINDOW(dialog));
}

static void close_now(TinkerWindow *window, const char *subject)
{
    window->may_close = TRUE;
    tinker_autosave_forget(window->autosave);
    gtk_window_close(GTK_WINDOW(window));
}

void window_ask_to_close(TinkerWindow *window)
{
    window_ask_first(window, close_now, NULL);
}
