/* Commands on one graph, by menu and by key. They are installed for its class alone, so the widget is one. */
#include <glib/gi18n.h>

#include "gui/curve/graph-edit.h"
#include "gui/graph/curves-dialog.h"
#include "gui/graph/graph-export.h"
#include "gui/graph/graph-looks.h"
#include "gui/graph/graph-menu.h"
#include "gui/graph/graph-view-private.h"
#include "gui/text/message.h"
#include "gui/widget/popup-menu.h"

static TinkerGraphData *data_of(const TinkerGraphView *view)
{
    return tinker_graph_plot_data(TINKER_GRAPH_PLOT(view->plot));
}

/* Passes it on to the window, which may take the view away meanwhile. */
static void edit(GtkWidget *widget, const char *name, GVariant *parameter)
{
    static const char *const of_window[][2] = {
        {"graph.dock", "win.dock-graph"}, {"graph.float", "win.float-graph"}, {"graph.delete", "win.delete-graph"}};
    g_autoptr(TinkerGraphView) view = g_object_ref((TinkerGraphView *)(gpointer)widget);
    for (gsize i = 0; i < G_N_ELEMENTS(of_window); i++)
        if (g_str_equal(of_window[i][0], name)) gtk_widget_activate_action(widget, of_window[i][1], "i", view->number);
}

static void copy(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerGraphView *view = (gpointer)widget;
    tinker_graph_copy(widget, data_of(view), gtk_widget_get_width(view->plot), gtk_widget_get_height(view->plot));
}

static void save_image(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerGraphView *view = (gpointer)widget;
    tinker_graph_save_image(widget, data_of(view), gtk_widget_get_width(view->plot), gtk_widget_get_height(view->plot));
}

static void export_values(GtkWidget *widget, const char *name, GVariant *parameter)
{
    tinker_graph_export_values(widget, data_of((gpointer)widget));
}

static void edit_curves(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerGraphView *view = (gpointer)widget;
    tinker_curves_dialog_open(widget, view->document, view->number);
}

static void show_statistics(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerGraphView *view = (gpointer)widget;
    TinkerGraphPart part = {0};
    double seen[2];
    gboolean is_part = tinker_graph_plot_between_cursors(TINKER_GRAPH_PLOT(view->plot), &part);
    if (!is_part && tinker_graph_data_is_over_time(data_of(view)) &&
        tinker_time_span_get(tinker_player_span(view->player), seen)) {
        part = (TinkerGraphPart){seen[0], seen[1], FALSE};
        is_part = TRUE;
    }
    g_autofree char *text = tinker_graph_statistics_text(data_of(view), is_part ? &part : NULL);
    GtkRoot *root = gtk_widget_get_root(widget);
    tinker_message(GTK_IS_WINDOW(root) ? GTK_WINDOW(root) : NULL, _("Statistics"), text);
}

static void set_against(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerGraphView *view = (gpointer)widget;
    if (!tinker_graph_set_against(view->document, view->number, g_variant_get_string(parameter, NULL), NULL))
        gtk_widget_error_bell(widget);
}

static void show_menu_at(TinkerGraphView *view, double x, double y)
{
    g_autoptr(GtkBuilder) builder = gtk_builder_new_from_resource("/org/tinker/Tinker/menus.ui");
    GMenuModel *model = G_MENU_MODEL(gtk_builder_get_object(builder, "graph_menu"));
    TinkerScene *scene = tinker_document_scene(view->document);
    g_autoptr(GMenuModel) over =
        tinker_graph_over_menu_new(scene, g_ptr_array_index(tinker_scene_graphs(scene), view->number));
    g_menu_append_submenu(G_MENU(gtk_builder_get_object(builder, "graph_over_section")), _("_Over"), over);
    tinker_popup_menu(GTK_WIDGET(view), model, x, y);
}

static void show_menu(GtkWidget *widget, const char *name, GVariant *parameter)
{
    show_menu_at((gpointer)widget, gtk_widget_get_width(widget) / 2.0, gtk_widget_get_height(widget) / 2.0);
}

void graph_view_on_right_press(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphView *view)
{
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    gtk_widget_grab_focus(GTK_WIDGET(view));
    show_menu_at(view, x, y);
}

void graph_view_install_commands(GtkWidgetClass *widget_class)
{
    static const struct {
        const char *name;
        GtkWidgetActionActivateFunc activate;
        guint key;
        GdkModifierType modifiers;
    } commands[] = {
        {"graph.copy", copy, GDK_KEY_c, GDK_CONTROL_MASK},
        {"graph.save-image", save_image, GDK_KEY_s, GDK_CONTROL_MASK | GDK_ALT_MASK},
        {"graph.export-values", export_values, GDK_KEY_e, GDK_CONTROL_MASK},
        {"graph.curves", edit_curves, GDK_KEY_l, GDK_CONTROL_MASK},
        {"graph.statistics", show_statistics, GDK_KEY_s, 0},
        {"graph.dock", edit, 0, 0},
        {"graph.float", edit, 0, 0},
        {"graph.delete", edit, GDK_KEY_Delete, 0},
        {"graph.menu", show_menu, GDK_KEY_Menu, 0},
        {"graph.menu", NULL, GDK_KEY_F10, GDK_SHIFT_MASK},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        if (commands[i].activate != NULL)
            gtk_widget_class_install_action(widget_class, commands[i].name, NULL, commands[i].activate);
        if (commands[i].key != 0)
            gtk_widget_class_add_binding_action(widget_class, commands[i].key, commands[i].modifiers, commands[i].name,
                                                NULL);
    }
    gtk_widget_class_install_action(widget_class, "graph.against", "s", set_against);
    tinker_graph_looks_bind(widget_class);
    gtk_widget_class_install_property_action(widget_class, "graph.show-values", "show-values");
}
