/* Pages are files below the folder of the documentation. Links from one to the other are followed here, others by
 * whatever the desktop has for them. */
#include "gui/window/help-window.h"

#include <glib/gi18n.h>
#include <string.h>

#include "common/program/installation.h"
#include "gui/widget/markdown-view.h"

#define CONTENTS "README.md"
#define DATA     "tinker-help-window"

struct _TinkerHelpWindow {
    AdwWindow parent_instance;
    GtkWidget *back, *scrolled, *title;
    GtkWidget *view; /* of the page that is shown */
    char *folder;
    GPtrArray *visited; /* of char *: pages, the one that is shown last */
};

G_DEFINE_FINAL_TYPE(TinkerHelpWindow, tinker_help_window, ADW_TYPE_WINDOW)

/* Pages ------------------------------------------------------------------------------------------------------------ */

static GtkWidget *find_named(GtkWidget *in, const char *name)
{
    for (GtkWidget *child = gtk_widget_get_first_child(in); child != NULL; child = gtk_widget_get_next_sibling(child))
        if (g_str_equal(gtk_widget_get_name(child), name)) return child;
    return NULL;
}

/* Once it has a place. */
static gboolean scroll_to_anchor(gpointer data)
{
    TinkerHelpWindow *help = data;
    const char *page = g_ptr_array_index(help->visited, help->visited->len - 1), *anchor = strchr(page, '#');
    GtkWidget *heading = anchor != NULL ? find_named(help->view, anchor + 1) : NULL;
    double x, y = 0;
    if (heading != NULL) gtk_widget_translate_coordinates(heading, help->view, 0, 0, &x, &y);
    gtk_adjustment_set_value(gtk_scrolled_window_get_vadjustment(GTK_SCROLLED_WINDOW(help->scrolled)), y);
    return G_SOURCE_REMOVE;
}

static gboolean on_link(GtkWidget *label, const char *to, TinkerHelpWindow *help);

static void show_last(TinkerHelpWindow *help)
{
    const char *page = g_ptr_array_index(help->visited, help->visited->len - 1);
    g_autofree char *file = g_strndup(page, strcspn(page, "#")), *path = g_build_filename(help->folder, file, NULL);
    g_autofree char *beside = g_path_get_dirname(path), *text = NULL, *shown = NULL;
    g_autoptr(GError) error = NULL;
    if (!g_file_get_contents(path, &text, NULL, &error))
        text = g_strdup_printf(
            _("# This page is not there\n\n%s\n\nThe documentation comes with the program: install it again."),
            error->message);
    shown = g_str_has_suffix(file, ".md") || error != NULL ? g_strdup(text)
                                                           : g_strdup_printf("# %s\n\n```\n%s```\n", file, text);
    help->view = tinker_markdown_view_new(shown, beside, G_CALLBACK(on_link), help);
    gtk_widget_add_css_class(help->view, "help-page");
    gtk_window_set_focus(GTK_WINDOW(help), NULL); /* or the next page's first words are selected */
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(help->scrolled), help->view);
    gtk_widget_set_sensitive(help->back, help->visited->len > 1);
    adw_window_title_set_subtitle(ADW_WINDOW_TITLE(help->title), file);
    g_idle_add_full(G_PRIORITY_LOW, scroll_to_anchor, g_object_ref(help), g_object_unref);
}

static void go_to(TinkerHelpWindow *help, const char *page)
{
    const char *shown = help->visited->len > 0 ? g_ptr_array_index(help->visited, help->visited->len - 1) : "";
    if (!g_str_equal(shown, page)) g_ptr_array_add(help->visited, g_strdup(page));
    show_last(help);
}

/* Whether it is a page, to which it goes then. */
static gboolean on_link(GtkWidget *label, const char *to, TinkerHelpWindow *help)
{
    const char *page = g_ptr_array_index(help->visited, help->visited->len - 1);
    g_autofree char *file = g_strndup(page, strcspn(page, "#")), *beside = g_path_get_dirname(file);
    if (strstr(to, "://") != NULL) return FALSE;
    if (to[0] == '#') {
        g_autofree char *same = g_strconcat(file, to, NULL);
        go_to(help, same);
        return TRUE;
    }
    g_autofree char *target = g_strndup(to, strcspn(to, "#"));
    g_autofree char *path = g_build_filename(help->folder, beside, target, NULL);
    if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
        g_autofree char *plain = g_canonicalize_filename(path, "/"), *uri = g_filename_to_uri(plain, NULL, NULL);
        gtk_show_uri(GTK_WINDOW(help), uri, GDK_CURRENT_TIME);
        return TRUE;
    }
    g_autofree char *next = g_strconcat(beside, "/", to, NULL);
    go_to(help, g_str_has_prefix(next, "./") ? next + 2 : next);
    return TRUE;
}

static void on_back(TinkerHelpWindow *help)
{
    if (help->visited->len < 2) return;
    g_ptr_array_set_size(help->visited, (int)help->visited->len - 1);
    show_last(help);
}

static void on_contents(TinkerHelpWindow *help)
{
    go_to(help, CONTENTS);
}

static void on_shortcuts(TinkerHelpWindow *help)
{
    GtkWindow *window = gtk_window_get_transient_for(GTK_WINDOW(help));
    if (window != NULL) gtk_widget_activate_action(GTK_WIDGET(window), "win.show-help-overlay", NULL);
}

/* The window ------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_button(TinkerHelpWindow *help, GtkWidget *bar, const char *icon, const char *label,
                             void (*clicked)(TinkerHelpWindow *help))
{
    GtkWidget *button = gtk_button_new_from_icon_name(icon);
    gtk_widget_set_tooltip_text(button, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(clicked), help);
    adw_header_bar_pack_start(ADW_HEADER_BAR(bar), button);
    return button;
}

static void tinker_help_window_finalize(GObject *object)
{
    TinkerHelpWindow *help = TINKER_HELP_WINDOW(object);
    g_ptr_array_unref(help->visited);
    g_free(help->folder);
    G_OBJECT_CLASS(tinker_help_window_parent_class)->finalize(object);
}

static void tinker_help_window_class_init(TinkerHelpWindowClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_help_window_finalize;
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_Escape, 0, "window.close", NULL);
}

static void tinker_help_window_init(TinkerHelpWindow *help)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0), *bar = adw_header_bar_new();
    GtkWidget *clamp = adw_clamp_new();
    help->folder = tinker_installation_document_folder();
    help->visited = g_ptr_array_new_with_free_func(g_free);
    help->title = adw_window_title_new(_("Help"), "");
    adw_header_bar_set_title_widget(ADW_HEADER_BAR(bar), help->title);
    help->back = add_button(help, bar, "go-previous-symbolic", _("Back"), on_back);
    add_button(help, bar, "view-list-symbolic", _("Contents"), on_contents);
    add_button(help, bar, "preferences-desktop-keyboard-shortcuts-symbolic", _("Keyboard Shortcuts"), on_shortcuts);
    help->scrolled = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(help->scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_widget_set_vexpand(help->scrolled, TRUE);
    adw_clamp_set_maximum_size(ADW_CLAMP(clamp), 900);
    adw_clamp_set_child(ADW_CLAMP(clamp), help->scrolled);
    gtk_box_append(GTK_BOX(box), bar);
    gtk_box_append(GTK_BOX(box), clamp);
    adw_window_set_content(ADW_WINDOW(help), box);
    gtk_window_set_title(GTK_WINDOW(help), _("Help"));
    gtk_window_set_default_size(GTK_WINDOW(help), 860, 720);
}

void tinker_help_show(GtkWindow *window)
{
    TinkerHelpWindow *help = g_object_get_data(G_OBJECT(window), DATA);
    if (help == NULL) {
        help = g_object_new(TINKER_TYPE_HELP_WINDOW, "transient-for", window, "destroy-with-parent", TRUE, NULL);
        g_object_set_data(G_OBJECT(window), DATA, help);
        gtk_window_set_hide_on_close(GTK_WINDOW(help), TRUE);
    }
    go_to(help, "README.md");
    gtk_window_present(GTK_WINDOW(help));
}
