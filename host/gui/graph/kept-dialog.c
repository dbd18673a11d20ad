/* A row a run. Nothing else changes the runs while the dialog is open, so rows are made anew only where one was taken
 * away. */
#include "gui/graph/kept-dialog.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#define WIDTH  420
#define HEIGHT 320

static GtkWidget *list_of(GtkWidget *window)
{
    return g_object_get_data(G_OBJECT(window), "list");
}

static TinkerKeptRuns *runs_of(GtkWidget *part)
{
    return g_object_get_data(G_OBJECT(gtk_widget_get_root(part)), "runs");
}

static guint place_of(GtkWidget *part)
{
    return GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(part), "place"));
}

static void on_shown(GtkWidget *check)
{
    tinker_kept_runs_show(runs_of(check), place_of(check), gtk_check_button_get_active(GTK_CHECK_BUTTON(check)));
}

static void on_renamed(GtkWidget *entry)
{
    tinker_kept_runs_rename(runs_of(entry), place_of(entry), gtk_editable_get_text(GTK_EDITABLE(entry)));
}

static void fill(GtkWidget *window);

static gboolean fill_later(gpointer window)
{
    fill(window);
    return G_SOURCE_REMOVE;
}

static void on_remove(GtkWidget *button)
{
    GtkWidget *window = GTK_WIDGET(gtk_widget_get_root(button));
    tinker_kept_runs_remove(runs_of(button), place_of(button));
    g_idle_add_full(G_PRIORITY_HIGH_IDLE, fill_later, g_object_ref(window), g_object_unref);
}

static void add_row(GtkWidget *list, TinkerKeptRuns *runs, guint place, TinkerScene *scene)
{
    const TinkerKeptRun *run = tinker_kept_runs_at(runs, place);
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *check = gtk_check_button_new(),
              *entry = gtk_entry_new(), *button = gtk_button_new_from_icon_name("list-remove-symbolic");
    g_autofree char *called = tinker_kept_runs_name_beside(runs, run, scene),
                    *show = g_strdup_printf(_("Show %s"), called), *name = g_strdup_printf(_("Name of %s"), called),
                    *remove = g_strdup_printf(_("Remove %s"), called);
    const struct {
        GtkWidget *part;
        const char *label, *signal;
        GCallback act;
    } parts[] = {{check, show, "toggled", G_CALLBACK(on_shown)},
                 {entry, name, "changed", G_CALLBACK(on_renamed)},
                 {button, remove, "clicked", G_CALLBACK(on_remove)}};
    gtk_check_button_set_active(GTK_CHECK_BUTTON(check), run->shown);
    gtk_editable_set_text(GTK_EDITABLE(entry), called);
    gtk_widget_set_hexpand(entry, TRUE);
    gtk_widget_add_css_class(button, "flat");
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        g_object_set_data(G_OBJECT(parts[i].part), "place", GUINT_TO_POINTER(place));
        gtk_widget_set_tooltip_text(parts[i].part, parts[i].label);
        gtk_accessible_update_property(GTK_ACCESSIBLE(parts[i].part), GTK_ACCESSIBLE_PROPERTY_LABEL, parts[i].label,
                                       -1);
        gtk_box_append(GTK_BOX(row), parts[i].part);
        g_signal_connect(parts[i].part, parts[i].signal, parts[i].act, NULL);
    }
    gtk_box_append(GTK_BOX(list), row);
}

static void fill(GtkWidget *window)
{
    TinkerKeptRuns *runs = g_object_get_data(G_OBJECT(window), "runs");
    GtkWidget *list = list_of(window), *child;
    while ((child = gtk_widget_get_first_child(list)) != NULL)
        gtk_box_remove(GTK_BOX(list), child);
    for (guint i = 0; i < tinker_kept_runs_count(runs); i++)
        add_row(list, runs, i, tinker_document_scene(g_object_get_data(G_OBJECT(window), "document")));
    if (tinker_kept_runs_count(runs) > 0) return;
    GtkWidget *none =
        gtk_label_new(_("No run is kept. “Keep Run” keeps the present one to be compared with the next."));
    gtk_label_set_wrap(GTK_LABEL(none), TRUE);
    gtk_box_append(GTK_BOX(list), none);
}

static gboolean on_escape(GtkWidget *widget, GVariant *arguments, gpointer data)
{
    gtk_window_close(GTK_WINDOW(widget));
    return TRUE;
}

void tinker_kept_dialog_open(GtkWindow *over, TinkerDocument *document, TinkerKeptRuns *runs)
{
    GtkWidget *content = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0), *list = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *scroller = gtk_scrolled_window_new();
    GtkWidget *window =
        g_object_new(ADW_TYPE_WINDOW, "title", _("Kept Runs"), "modal", TRUE, "transient-for", over, "default-width",
                     WIDTH, "default-height", HEIGHT, "destroy-with-parent", TRUE, NULL);
    g_object_set_data_full(G_OBJECT(window), "runs", g_object_ref(runs), g_object_unref);
    g_object_set_data_full(G_OBJECT(window), "document", g_object_ref(document), g_object_unref);
    g_object_set_data(G_OBJECT(window), "list", list);
    g_object_set(list, "margin-top", 12, "margin-bottom", 18, "margin-start", 18, "margin-end", 18, NULL);
    g_object_set(scroller, "hscrollbar-policy", GTK_POLICY_NEVER, "vexpand", TRUE, "child", list, NULL);
    gtk_box_append(GTK_BOX(content), adw_header_bar_new());
    gtk_box_append(GTK_BOX(content), scroller);
    adw_window_set_content(ADW_WINDOW(window), content);
    GtkEventController *keys = gtk_shortcut_controller_new();
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(keys),
        gtk_shortcut_new(gtk_keyval_trigger_new(GDK_KEY_Escape, 0), gtk_callback_action_new(on_escape, NULL, NULL)));
    gtk_widget_add_controller(window, keys);
    fill(window);
    gtk_window_present(GTK_WINDOW(window));
}
