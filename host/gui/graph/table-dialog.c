/* First the file, then, where it has more than two, its columns by name: Return adds, Escape cancels. */
#include "gui/graph/table-dialog.h"

#include <adwaita.h>
#include <glib/gi18n-lib.h>

#include "gui/curve/graph-edit.h"
#include "gui/document/carry-tables.h"
#include "gui/widget/choices.h"
#include "units/waveform/table-columns.h"

typedef struct {
    GtkWindow *over;          /* owned */
    TinkerDocument *document; /* owned */
    int graph;
    TinkerTableTold told;
    char *path;
    GPtrArray *names;  /* of the columns: of char * */
    GtkWidget *window; /* that asks for columns; borrowed, as what is in it */
    GtkDropDown *times, *values;
} Dialog;

static void dialog_free(gpointer data)
{
    Dialog *dialog = data;
    g_object_unref(dialog->over);
    g_object_unref(dialog->document);
    g_clear_pointer(&dialog->names, g_ptr_array_unref);
    g_free(dialog->path);
    g_free(dialog);
}

/* Named by its file and the heading of its column. */
static void add_table(const Dialog *dialog, int time_column, int column)
{
    const char *scene = tinker_document_path(dialog->document);
    const char *heading = column < (int)dialog->names->len ? g_ptr_array_index(dialog->names, column) : "";
    g_autoptr(GError) error = NULL;
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(double));
    gboolean made;
    g_autofree char *name = table_name_in_scene(scene, dialog->path);
    if (name == NULL) name = table_name_of_copy(scene, dialog->path);
    g_autofree char *title = heading[0] != '\0' ? g_strdup_printf("%s: %s", name, heading) : NULL;
    const TinkerSceneCurve curve = {
        .table = name, .time_column = time_column, .column = column, .title = title, .axis = 1};
    if (tinker_table_read_column(dialog->path, time_column, column, rows, &error) &&
        table_copy_beside(scene, dialog->path, name, &made, &error))
        tinker_graph_add_curve(dialog->document, dialog->graph, &curve, &error);
    dialog->told(dialog->over, error);
}

/* The columns ------------------------------------------------------------------------------------------------------ */

/* What is in one column cannot be over itself. */
static void on_selected(Dialog *dialog)
{
    const gboolean differ = gtk_drop_down_get_selected(dialog->times) != gtk_drop_down_get_selected(dialog->values);
    adw_message_dialog_set_response_enabled(ADW_MESSAGE_DIALOG(dialog->window), "add", differ);
}

static void on_response(GtkWidget *window, const char *response, Dialog *dialog)
{
    if (g_str_equal(response, "add"))
        add_table(dialog, (int)gtk_drop_down_get_selected(dialog->times),
                  (int)gtk_drop_down_get_selected(dialog->values));
}

/* Columns without a name are counted from 1, as a table is read; a scene's file counts from 0, the time. */
static GtkDropDown *add_list(GtkGrid *grid, int row, const char *label, GPtrArray *names, guint selected)
{
    GtkStringList *model = gtk_string_list_new(NULL);
    for (guint i = 0; i < names->len; i++) {
        const char *name = g_ptr_array_index(names, i);
        g_autofree char *text = name[0] != '\0' ? g_strdup(name) : g_strdup_printf(_("Column %u"), i + 1);
        gtk_string_list_append(model, text);
    }
    GtkWidget *list = gtk_drop_down_new(G_LIST_MODEL(model), NULL), *title = gtk_label_new_with_mnemonic(label);
    tinker_choices_cut_off(GTK_DROP_DOWN(list));
    gtk_drop_down_set_selected(GTK_DROP_DOWN(list), selected);
    gtk_widget_set_hexpand(list, TRUE);
    gtk_widget_set_halign(title, GTK_ALIGN_START);
    gtk_label_set_mnemonic_widget(GTK_LABEL(title), list);
    gtk_accessible_update_relation(GTK_ACCESSIBLE(list), GTK_ACCESSIBLE_RELATION_LABELLED_BY, title, NULL, -1);
    gtk_grid_attach(grid, title, 0, row, 1, 1);
    gtk_grid_attach(grid, list, 1, row, 1, 1);
    return GTK_DROP_DOWN(list);
}

/* The window owns the dialog. */
static void ask_for_columns(Dialog *dialog)
{
    GtkWidget *grid = gtk_grid_new(), *window = adw_message_dialog_new(dialog->over, _("Columns of the Table"), NULL);
    AdwMessageDialog *message = ADW_MESSAGE_DIALOG(window);
    dialog->window = window;
    g_object_set_data_full(G_OBJECT(window), "dialog", dialog, dialog_free);
    g_object_set(grid, "row-spacing", 12, "column-spacing", 12, NULL);
    dialog->times = add_list(GTK_GRID(grid), 0, _("_Time"), dialog->names, 0);
    dialog->values = add_list(GTK_GRID(grid), 1, _("_Values"), dialog->names, 1);
    adw_message_dialog_set_extra_child(message, grid);
    adw_message_dialog_add_responses(message, "cancel", _("_Cancel"), "add", _("_Add"), NULL);
    adw_message_dialog_set_response_appearance(message, "add", ADW_RESPONSE_SUGGESTED);
    adw_message_dialog_set_default_response(message, "add");
    adw_message_dialog_set_close_response(message, "cancel");
    g_signal_connect_swapped(dialog->times, "notify::selected", G_CALLBACK(on_selected), dialog);
    g_signal_connect_swapped(dialog->values, "notify::selected", G_CALLBACK(on_selected), dialog);
    g_signal_connect(window, "response", G_CALLBACK(on_response), dialog);
    gtk_window_present(GTK_WINDOW(window));
    gtk_widget_grab_focus(GTK_WIDGET(dialog->values));
}

/* The file --------------------------------------------------------------------------------------------------------- */

/* Of two columns it is plain which is which. */
static void on_file(GtkNativeDialog *chooser, int response, Dialog *dialog)
{
    g_autoptr(GFile) file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(chooser));
    g_autoptr(GError) error = NULL;
    if (response == GTK_RESPONSE_ACCEPT && file != NULL) dialog->path = g_file_get_path(file);
    if (dialog->path != NULL) dialog->names = tinker_table_column_names(dialog->path, &error);
    if (error != NULL) dialog->told(dialog->over, error);
    if (dialog->names != NULL && dialog->names->len > 2) {
        ask_for_columns(g_steal_pointer(&dialog));
    } else if (dialog->names != NULL) {
        add_table(dialog, 0, 1);
    }
    g_clear_pointer(&dialog, dialog_free);
    g_object_unref(chooser);
}

void tinker_table_dialog_open(GtkWindow *over, TinkerDocument *document, int graph, TinkerTableTold told)
{
    if (tinker_document_path(document) == NULL) {
        g_autoptr(GError) error = g_error_new_literal(TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE,
                                                      _("Save the scene first: tables lie beside it."));
        told(over, error);
        return;
    }
    Dialog *dialog = g_new0(Dialog, 1);
    dialog->over = g_object_ref(over);
    dialog->document = g_object_ref(document);
    dialog->graph = graph;
    dialog->told = told;
    GtkFileChooserNative *chooser =
        gtk_file_chooser_native_new(_("Choose a Table"), over, GTK_FILE_CHOOSER_ACTION_OPEN, _("_Open"), _("_Cancel"));
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(chooser), TRUE);
    g_signal_connect(chooser, "response", G_CALLBACK(on_file), dialog);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(chooser));
}
