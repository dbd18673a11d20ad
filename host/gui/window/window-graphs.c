/* Graphs in the window: on the canvas, in the dock below it, and on a page of their own; and the commands about them.
 */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/curve/graph-edit.h"
#include "gui/graph/graph-dock.h"
#include "gui/graph/graph-layer.h"
#include "gui/graph/graph-menu.h"
#include "gui/graph/graph-page.h"
#include "gui/graph/kept-dialog.h"
#include "gui/window/window-parts.h"

#define PAGE "graphs"

static gboolean has_graph(TinkerWindow *window, GVariant *number)
{
    int count = (int)tinker_scene_graphs(tinker_document_scene(window->document))->len;
    return g_variant_get_int32(number) >= 0 && g_variant_get_int32(number) < count;
}

/* Commands --------------------------------------------------------------------------------------------------------- */

/* Adds a graph of the selected block; the parameter is "QUANTITY" or "QUANTITY/AGAINST". */
static void add_graph(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    TinkerBlockId block = tinker_document_selected(window->document);
    if (block == TINKER_NO_BLOCK) {
        window_toast(window, _("Select the block that the graph is to be of"));
        return;
    }
    double place[2], size[2];
    g_autoptr(GError) error = NULL;
    g_auto(GStrv) quantities = g_strsplit(g_variant_get_string(parameter, NULL), "/", 2);
    tinker_graph_layer_find_room(window->graph_layer, tinker_player_frame(window->player), NULL, place, size);
    if (quantities[0] == NULL ||
        tinker_graph_add(window->document, block, quantities[0], quantities[1], place, size, &error) < 0)
        window_toast(window, error != NULL ? error->message : _("Name a quantity"));
}

static void float_graph(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    if (!has_graph(window, parameter)) return;
    int number = g_variant_get_int32(parameter);
    const TinkerSceneGraph *graph =
        g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(window->document)), number);
    double place[2], room[2], size[2] = {graph->size[0], graph->size[1]};
    gboolean has_size = graph->has_size;
    tinker_graph_layer_find_room(window->graph_layer, tinker_player_frame(window->player), has_size ? size : NULL,
                                 place, room);
    tinker_graph_move(window->document, number, place, has_size ? NULL : room, TRUE, NULL);
}

static void dock_graph(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    if (has_graph(window, parameter)) tinker_graph_dock(window->document, g_variant_get_int32(parameter));
}

static void delete_graph(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    if (has_graph(window, parameter)) tinker_graph_remove(window->document, g_variant_get_int32(parameter));
}

void window_new_graph(TinkerWindow *window)
{
    adw_view_stack_set_visible_child_name(window->pages, PAGE);
    gtk_widget_child_focus(adw_view_stack_get_visible_child(window->pages), GTK_DIR_TAB_FORWARD);
}

void window_keep_run(TinkerWindow *window)
{
    TinkerKeptRuns *kept = tinker_player_kept(window->player);
    if (tinker_player_keep(window->player)) {
        g_autofree char *text =
            g_strdup_printf(_("Kept as “%s”"), tinker_kept_runs_at(kept, tinker_kept_runs_count(kept) - 1)->name);
        window_toast(window, text);
    } else {
        window_toast(window, tinker_kept_runs_count(kept) == TINKER_MOST_KEPT
                                 ? _("Eight runs are kept: remove one first")
                                 : _("Press Play first: there is no run to keep"));
    }
}

void window_kept_runs(TinkerWindow *window)
{
    tinker_kept_dialog_open(GTK_WINDOW(window), window->document, tinker_player_kept(window->player));
}

/* The menu --------------------------------------------------------------------------------------------------------- */

void window_append_graph_menu(TinkerWindow *window, GMenu *menu)
{
    TinkerBlockId block = tinker_document_selected(window->document);
    if (block == TINKER_NO_BLOCK) return;
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(window->document), block);
    if (!tinker_block_class_has_graphs(block_class)) return;
    g_autoptr(GMenu) section = g_menu_new();
    g_autoptr(GMenuModel) graphs = tinker_graph_menu_new(block_class);
    g_menu_append_submenu(section, _("Add _Graph"), graphs);
    g_menu_append_section(menu, NULL, G_MENU_MODEL(section));
}

/* Parts ------------------------------------------------------------------------------------------------------------ */

/* A pane gives its lower part the least height until somebody has set the border: it stays where it was put at first.
 * From then on both parts share what a higher window gives, or a lower one takes. */
static gboolean keep_height(gpointer dock)
{
    GtkWidget *pane = gtk_widget_get_ancestor(dock, GTK_TYPE_PANED);
    if (pane == NULL || !gtk_widget_get_mapped(dock)) return G_SOURCE_REMOVE;
    gtk_paned_set_position(GTK_PANED(pane), gtk_paned_get_position(GTK_PANED(pane)));
    gtk_paned_set_resize_end_child(GTK_PANED(pane), TRUE);
    tinker_graph_dock_settle(TINKER_GRAPH_DOCK(dock));
    return G_SOURCE_REMOVE;
}

static void on_dock_shown(GtkWidget *dock)
{
    g_timeout_add_full(G_PRIORITY_LOW, 100, keep_height, g_object_ref(dock), g_object_unref);
}

static void add_dock(TinkerWindow *window)
{
    GtkWidget *dock = tinker_graph_dock_new(), *scroller = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scroller), GTK_POLICY_AUTOMATIC, GTK_POLICY_NEVER);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scroller), dock);
    gtk_widget_set_hexpand(scroller, TRUE);
    gtk_box_append(window->dock, scroller);
    g_signal_connect(dock, "map", G_CALLBACK(on_dock_shown), NULL);
    g_object_bind_property(dock, "visible", window->dock, "visible", G_BINDING_SYNC_CREATE);
    tinker_graph_board_set_player(TINKER_GRAPH_BOARD(dock), window->document, window->player);
}

static void add_page(TinkerWindow *window)
{
    GtkWidget *graphs = tinker_graph_page_new(window->document, window->player);
    AdwViewStackPage *page = adw_view_stack_add_titled(window->pages, graphs, PAGE, _("Graphs"));
    adw_view_stack_page_set_icon_name(page, "tinker-graph-symbolic");
}

void window_add_graphs(TinkerWindow *window)
{
    static const GActionEntry actions[] = {
        {.name = "add-graph", .activate = add_graph, .parameter_type = "s"},
        {.name = "float-graph", .activate = float_graph, .parameter_type = "i"},
        {.name = "dock-graph", .activate = dock_graph, .parameter_type = "i"},
        {.name = "delete-graph", .activate = delete_graph, .parameter_type = "i"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), actions, G_N_ELEMENTS(actions), window);
    tinker_graph_layer_set_canvas(window->graph_layer, window->canvas);
    tinker_graph_board_set_player(TINKER_GRAPH_BOARD(window->graph_layer), window->document, window->player);
    add_dock(window);
    add_page(window);
}
