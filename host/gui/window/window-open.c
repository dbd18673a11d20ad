/* New scenes, files, recent ones and examples; and what a file that is opened has to say. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/document/examples.h"
#include "gui/document/new-scene.h"
#include "gui/text/message.h"
#include "gui/text/translate.h"
#include "gui/window/new-dialog.h"
#include "gui/window/window-files.h"

#define MOST_RECENT 8

/* Findings --------------------------------------------------------------------------------------------------------- */

static char *text_of_findings(const GPtrArray *findings)
{
    GString *text = g_string_new(NULL);
    for (guint i = 0; i < findings->len; i++) {
        const TinkerFinding *finding = g_ptr_array_index(findings, i);
        if (i > 0) g_string_append_c(text, '\n');
        if (finding->line > 0) g_string_append_printf(text, "%d:%d: ", finding->line, finding->column);
        if (finding->kind == TINKER_FINDING_WARNING) g_string_append(text, _("warning: "));
        g_string_append(text, finding->message);
    }
    return g_string_free(text, FALSE);
}

static void show_findings(TinkerWindow *window, const char *heading, const char *body, const char *text)
{
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(window), heading, body);
    adw_message_dialog_set_extra_child(ADW_MESSAGE_DIALOG(dialog),
                                       tinker_message_text(GTK_WINDOW(window), text, _("Findings")));
    adw_message_dialog_add_response(ADW_MESSAGE_DIALOG(dialog), "close", _("_Close"));
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "close");
    gtk_window_present(GTK_WINDOW(dialog));
}

static void on_details(AdwToast *toast, TinkerWindow *window)
{
    show_findings(window, _("Opened with Warnings"), NULL, g_object_get_data(G_OBJECT(toast), "findings"));
}

static void tell_warnings(TinkerWindow *window, const GPtrArray *findings)
{
    g_autofree char *title =
        g_strdup_printf(ngettext("Opened with %u warning", "Opened with %u warnings", findings->len), findings->len);
    AdwToast *toast = adw_toast_new(title);
    adw_toast_set_button_label(toast, _("_Details"));
    g_object_set_data_full(G_OBJECT(toast), "findings", text_of_findings(findings), g_free);
    g_signal_connect_object(toast, "button-clicked", G_CALLBACK(on_details), window, 0);
    adw_toast_overlay_add_toast(window->toasts, toast);
}

/* Files ------------------------------------------------------------------------------------------------------------ */

/* Opens a file; says what is wrong with it. */
static void open_path(TinkerWindow *window, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    if (!tinker_document_open(window->document, path, findings, &error)) {
        g_autofree char *text = text_of_findings(findings), *name = g_path_get_basename(path);
        g_autofree char *body =
            findings->len == 0 ? g_strdup(error->message)
                               : g_strdup_printf(ngettext("“%s” has a mistake. The number before it says the line and "
                                                          "the column.",
                                                          "“%s” has mistakes. The numbers before each say the line and "
                                                          "the column.",
                                                          findings->len),
                                                 name);
        if (findings->len == 0 || error->code == TINKER_SCENE_ERROR_FILE)
            window_message(window, _("The File Was Not Opened"), error->message);
        else
            show_findings(window, _("The File Was Not Opened"), body, text);
        return;
    }
    window_note_recent(path);
    if (findings->len > 0) tell_warnings(window, findings);
}

void tinker_window_open_file(TinkerWindow *window, GFile *file)
{
    g_autofree char *path = g_file_get_path(file);
    if (path != NULL) {
        open_path(window, path);
        return;
    }
    g_autofree char *name = g_file_get_parse_name(file);
    g_autofree char *body =
        g_strdup_printf(_("“%s” is not in a folder of this computer. Copy it into one, and open the copy."), name);
    window_message(window, _("The File Was Not Opened"), body);
}

static void on_open_name(GtkNativeDialog *dialog, int response, TinkerWindow *window)
{
    g_autoptr(GFile) file =
        response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    if (file != NULL) tinker_window_open_file(window, file);
    g_object_unref(window);
    g_object_unref(dialog);
}

static void choose_file(TinkerWindow *window, const char *subject)
{
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(_("Open Scene"), GTK_WINDOW(window),
                                                               GTK_FILE_CHOOSER_ACTION_OPEN, _("_Open"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    window_add_filters(dialog);
    g_signal_connect(dialog, "response", G_CALLBACK(on_open_name), g_object_ref(window));
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

void window_choose_file(TinkerWindow *window)
{
    window_ask_first(window, choose_file, NULL);
}

static void open_recent(TinkerWindow *window, const char *path)
{
    open_path(window, path);
}

/* A copy without a name: saving asks for one. */
static void open_example(TinkerWindow *window, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = NULL;
    gsize length;
    if (!g_file_get_contents(path, &text, &length, &error) ||
        !tinker_document_start(window->document, text, length, path, &error))
        window_message(window, _("The Example Was Not Opened"), error->message);
}

static void on_open_recent(GSimpleAction *action, GVariant *path, gpointer window)
{
    window_ask_first(window, open_recent, g_variant_get_string(path, NULL));
}

static void on_open_example(GSimpleAction *action, GVariant *path, gpointer window)
{
    window_ask_first(window, open_example, g_variant_get_string(path, NULL));
}

/* New -------------------------------------------------------------------------------------------------------------- */

static void start_new(TinkerWindow *window, const TinkerNewScene *settings)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_new_scene_start(window->document, settings, &error))
        window_message(window, _("The New Scene Was Not Made"), error->message);
}

void window_start_first(TinkerWindow *window)
{
    TinkerNewScene settings = {TINKER_UNIT_SYSTEM_SI, 0};
    const char *width = tinker_new_scene_default_width(settings.units);
    if (tinker_new_scene_parse_width(width, settings.units, &settings.width, NULL)) start_new(window, &settings);
}

static void ask_settings(TinkerWindow *window, const char *subject)
{
    GtkWidget *dialog = tinker_new_dialog_new(GTK_WINDOW(window));
    g_signal_connect_object(dialog, "create", G_CALLBACK(start_new), window, G_CONNECT_SWAPPED);
    gtk_window_present(GTK_WINDOW(dialog));
}

void tinker_window_new_scene(TinkerWindow *window)
{
    window_ask_first(window, ask_settings, NULL);
}

/* The menu --------------------------------------------------------------------------------------------------------- */

/* An underline would be read as a mark of a key. */
static GMenuItem *item_of(const char *title, const char *action, const char *path)
{
    g_auto(GStrv) parts = g_strsplit(title, "_", -1);
    g_autofree char *label = g_strjoinv("__", parts);
    GMenuItem *item = g_menu_item_new(label, NULL);
    g_menu_item_set_action_and_target(item, action, "s", path);
    return item;
}

static void add_recent(GMenu *menu, GtkRecentInfo *info)
{
    g_autofree char *path = g_filename_from_uri(gtk_recent_info_get_uri(info), NULL, NULL);
    g_autofree char *name = path != NULL ? g_path_get_basename(path) : NULL;
    if (name == NULL || !g_str_has_suffix(name, WINDOW_SCENE_ENDING) || !g_file_test(path, G_FILE_TEST_EXISTS)) return;
    name[strlen(name) - strlen(WINDOW_SCENE_ENDING)] = '\0';
    g_autoptr(GMenuItem) item = item_of(name, "win.open-recent", path);
    g_menu_append_item(menu, item);
}

static gint latest_first(gconstpointer a, gconstpointer b)
{
    return g_date_time_compare(gtk_recent_info_get_modified((GtkRecentInfo *)b),
                               gtk_recent_info_get_modified((GtkRecentInfo *)a));
}

static void update_recent(TinkerWindow *window)
{
    g_menu_remove_all(window->recent_menu);
    GList *items = g_list_sort(gtk_recent_manager_get_items(gtk_recent_manager_get_default()), latest_first);
    for (GList *item = items; item != NULL; item = item->next)
        if (g_menu_model_get_n_items(G_MENU_MODEL(window->recent_menu)) < MOST_RECENT)
            add_recent(window->recent_menu, item->data);
    g_list_free_full(items, (GDestroyNotify)gtk_recent_info_unref);
}

static void fill_examples(TinkerWindow *window)
{
    const GPtrArray *topics = tinker_examples(tinker_document_catalogue(window->document));
    for (guint t = 0; t < topics->len; t++) {
        const TinkerTopic *topic = g_ptr_array_index(topics, t);
        g_autoptr(GMenu) menu = g_menu_new();
        for (guint i = 0; i < topic->examples->len; i++) {
            const TinkerExample *example = g_ptr_array_index(topic->examples, i);
            const char *title = tinker_translate_title(example->title, example->description);
            g_autoptr(GMenuItem) item = item_of(title, "win.open-example", example->path);
            g_menu_append_item(menu, item);
        }
        g_menu_append_submenu(window->examples_menu, topic->title, G_MENU_MODEL(menu));
    }
}

/* Not before the window is there: some dozens of files are read for it. */
static gboolean fill_menus(gpointer data)
{
    TinkerWindow *window = data;
    fill_examples(window);
    update_recent(window);
    g_signal_connect_object(gtk_recent_manager_get_default(), "changed", G_CALLBACK(update_recent), window,
                            G_CONNECT_SWAPPED);
    return G_SOURCE_REMOVE;
}

/* A split button names its arrow by a tip alone, which screen readers do not take for a name. */
static void name_arrow(AdwSplitButton *button)
{
    const char *name = adw_split_button_get_dropdown_tooltip(button);
    GtkWidget *arrow = gtk_widget_get_first_child(GTK_WIDGET(button));
    while (arrow != NULL && !GTK_IS_MENU_BUTTON(arrow))
        arrow = gtk_widget_get_next_sibling(arrow);
    if (arrow == NULL) return;
    gtk_accessible_update_property(GTK_ACCESSIBLE(arrow), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    GtkWidget *inner = gtk_widget_get_first_child(arrow); /* what has the focus */
    if (inner != NULL) gtk_accessible_update_property(GTK_ACCESSIBLE(inner), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
}

void window_add_open_menu(TinkerWindow *window)
{
    static const GActionEntry entries[] = {
        {.name = "open-recent", .activate = on_open_recent, .parameter_type = "s"},
        {.name = "open-example", .activate = on_open_example, .parameter_type = "s"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), entries, G_N_ELEMENTS(entries), window);
    name_arrow(window->open_button);
    g_idle_add_full(G_PRIORITY_LOW, fill_menus, g_object_ref(window), g_object_unref);
}
