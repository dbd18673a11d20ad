/* The view follows the scene's graph by its number, which its board keeps up to date. */
#include "gui/graph/graph-view.h"

#include <glib/gi18n.h>

#include "gui/graph/graph-looks.h"
#include "gui/graph/graph-view-private.h"
#include "gui/widget/unparent.h"

#define TELL_US 1000000 /* at most so often is the present value told while it plays */

G_DEFINE_FINAL_TYPE(TinkerGraphView, tinker_graph_view, GTK_TYPE_WIDGET)

enum { PROP_0, PROP_SHOW_VALUES, PROPERTIES };
static GParamSpec *properties[PROPERTIES];

GtkWidget *tinker_graph_view_title_bar(TinkerGraphView *view)
{
    return view->bar;
}

GtkWidget *tinker_graph_view_corner(TinkerGraphView *view)
{
    return view->corner;
}

int tinker_graph_view_number(TinkerGraphView *view)
{
    return view->number;
}

TinkerGraphData *tinker_graph_view_data(TinkerGraphView *view)
{
    return tinker_graph_plot_data(TINKER_GRAPH_PLOT(view->plot));
}

/* The graph -------------------------------------------------------------------------------------------------------- */

static char *identity_of(const TinkerSceneGraph *graph)
{
    GString *identity = g_string_new(graph->against);
    for (guint i = 0; i < graph->curves->len; i++) {
        const TinkerSceneCurve *curve = g_ptr_array_index(graph->curves, i);
        const char *const of[] = {curve->block, curve->quantity, curve->expression, curve->table};
        for (gsize k = 0; k < G_N_ELEMENTS(of); k++)
            g_string_append_printf(identity, "\n%s", of[k] != NULL ? of[k] : "");
    }
    return g_string_free(identity, FALSE);
}

gboolean tinker_graph_view_fits(TinkerGraphView *view, const TinkerSceneGraph *graph)
{
    g_autofree char *identity = identity_of(graph);
    return g_strcmp0(identity, view->identity) == 0;
}

/* Tells assistive technologies what the graph shows now. */
static void tell_value(TinkerGraphView *view)
{
    TinkerGraphData *data = tinker_graph_view_data(view);
    tinker_graph_data_update(data);
    g_autofree char *text = tinker_graph_data_present_text(data);
    g_autofree char *zoom = tinker_graph_plot_zoom_text(TINKER_GRAPH_PLOT(view->plot));
    g_autofree char *cursors = tinker_graph_plot_cursor_text(TINKER_GRAPH_PLOT(view->plot));
    g_autofree char *chosen = tinker_graph_plot_chosen_text(TINKER_GRAPH_PLOT(view->plot));
    const char *const more[] = {zoom, cursors, chosen};
    for (gsize i = 0; text != NULL && i < G_N_ELEMENTS(more); i++) {
        g_autofree char *before = text;
        text = more[i] != NULL ? g_strdup_printf("%s; %s", before, more[i]) : g_steal_pointer(&before);
    }
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   text != NULL ? text : _("Press Play to see the curve"), -1);
    view->told = g_get_monotonic_time();
}

static void on_moved(TinkerGraphView *view)
{
    gboolean playing = tinker_player_state(view->player) == TINKER_PLAYER_PLAYING;
    if (!gtk_widget_get_mapped(GTK_WIDGET(view)) || (playing && g_get_monotonic_time() < view->told + TELL_US)) return;
    tell_value(view);
}

/* By keys it is the block that all curves are of, if there is one. */
static TinkerPointed block_of_all(TinkerGraphView *view)
{
    TinkerGraphData *data = tinker_graph_view_data(view);
    const guint count = tinker_graph_data_own_curves(data);
    const char *name = count > 0 ? tinker_graph_series_block(tinker_graph_data_curve(data, 0)) : "";
    for (guint i = 1; i < count; i++)
        if (!g_str_equal(tinker_graph_series_block(tinker_graph_data_curve(data, i)), name)) name = "";
    TinkerScene *scene = tinker_document_scene(view->document);
    return tinker_pointed_block(name[0] != '\0' ? tinker_scene_find_block(scene, name) : TINKER_NO_BLOCK);
}

static void on_focus(GtkEventControllerFocus *focus, TinkerGraphView *view)
{
    const TinkerPointed what = block_of_all(view);
    if (gtk_event_controller_focus_is_focus(focus) && what.block != TINKER_NO_BLOCK)
        tinker_document_point(view->document, what);
}

static void on_focus_leave(GtkEventControllerFocus *focus, TinkerGraphView *view)
{
    tinker_document_point_away(view->document, block_of_all(view));
    if (view->plot != NULL) tinker_graph_plot_choose_no_curve(TINKER_GRAPH_PLOT(view->plot));
}

/* Lights up where a curve is of the block that is pointed at. */
static void on_pointed(TinkerGraphView *view)
{
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId pointed = tinker_document_pointed(view->document)->block;
    const GPtrArray *graphs = tinker_scene_graphs(scene);
    const char *name = pointed != TINKER_NO_BLOCK ? tinker_scene_block_name(scene, pointed) : NULL;
    gboolean lit = FALSE;
    if (name != NULL && view->number < (int)graphs->len) {
        const TinkerSceneGraph *graph = g_ptr_array_index(graphs, view->number);
        for (guint i = 0; i < graph->curves->len; i++)
            lit = lit || g_strcmp0(((const TinkerSceneCurve *)g_ptr_array_index(graph->curves, i))->block, name) == 0;
    }
    if (lit)
        gtk_widget_add_css_class(GTK_WIDGET(view), "lit");
    else
        gtk_widget_remove_css_class(GTK_WIDGET(view), "lit");
}

void tinker_graph_view_set_number(TinkerGraphView *view, int number)
{
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(view->document));
    const TinkerSceneGraph *graph = g_ptr_array_index(graphs, number);
    view->number = number;
    g_free(view->identity);
    view->identity = identity_of(graph);
    tinker_graph_plot_set_graph(TINKER_GRAPH_PLOT(view->plot), graph);
    const char *title = tinker_graph_data_title(tinker_graph_view_data(view));
    g_autofree char *label = g_strdup_printf(_("Graph of %s"), title);
    gtk_label_set_text(GTK_LABEL(view->title), title);
    g_autofree char *hint = g_strdup_printf(
        _("%s\nThe wheel zooms; on a page that scrolls it does so with Ctrl. A double click shows all."), title);
    gtk_widget_set_tooltip_text(view->title, hint);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    tell_value(view);

    const char *place = graph->has_place ? _("Dock Below the Canvas") : _("Float on the Canvas");
    gtk_button_set_icon_name(GTK_BUTTON(view->place_button),
                             graph->has_place ? "go-bottom-symbolic" : "view-restore-symbolic");
    gtk_actionable_set_action_name(GTK_ACTIONABLE(view->place_button), graph->has_place ? "graph.dock" : "graph.float");
    gtk_widget_set_tooltip_text(view->place_button, place);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view->place_button), GTK_ACCESSIBLE_PROPERTY_LABEL, place, -1);
    gtk_widget_action_set_enabled(GTK_WIDGET(view), "graph.statistics",
                                  !tinker_graph_data_is_spectrum(tinker_graph_view_data(view)));
    gtk_widget_action_set_enabled(GTK_WIDGET(view), "graph.dock", graph->has_place);
    gtk_widget_action_set_enabled(GTK_WIDGET(view), "graph.float", !graph->has_place);
}

/* Presses on a graph are not the canvas's. */
static void on_press(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphView *view)
{
    gtk_widget_grab_focus(GTK_WIDGET(view));
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_button(GtkWidget *bar, const char *icon, const char *label, const char *action)
{
    GtkWidget *button = gtk_button_new();
    if (icon != NULL) gtk_button_set_icon_name(GTK_BUTTON(button), icon);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_add_css_class(button, "circular");
    gtk_widget_set_valign(button, GTK_ALIGN_CENTER);
    gtk_widget_set_tooltip_text(button, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), action);
    gtk_box_append(GTK_BOX(bar), button);
    return button;
}

static void add_title_bar(TinkerGraphView *view)
{
    view->bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 2);
    view->title = gtk_label_new(NULL);
    gtk_widget_add_css_class(view->bar, "graph-title");
    gtk_label_set_ellipsize(GTK_LABEL(view->title), PANGO_ELLIPSIZE_END);
    gtk_label_set_xalign(GTK_LABEL(view->title), 0);
    gtk_widget_set_hexpand(view->title, TRUE);
    gtk_box_append(GTK_BOX(view->bar), view->title);
    view->place_button = add_button(view->bar, NULL, "", NULL);
    add_button(view->bar, "window-close-symbolic", _("Delete Graph"), "graph.delete");
    if (view->floats) gtk_widget_set_cursor_from_name(view->title, "move");
    gtk_widget_set_parent(view->bar, GTK_WIDGET(view));
}

static void add_plot(TinkerGraphView *view)
{
    GtkWidget *overlay = gtk_overlay_new();
    view->plot = tinker_graph_plot_new(view->document, view->player);
    tinker_graph_plot_set_show_values(TINKER_GRAPH_PLOT(view->plot), view->show_values);
    tinker_graph_looks_add(GTK_WIDGET(view), TINKER_GRAPH_PLOT(view->plot));
    g_signal_connect_swapped(view->plot, "looks-changed", G_CALLBACK(tell_value), view);
    gtk_widget_set_vexpand(view->plot, TRUE);
    gtk_overlay_set_child(GTK_OVERLAY(overlay), view->plot);
    view->corner = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 0);
    gtk_widget_add_css_class(view->corner, "graph-corner");
    gtk_widget_set_halign(view->corner, GTK_ALIGN_END);
    gtk_widget_set_valign(view->corner, GTK_ALIGN_END);
    gtk_widget_set_cursor_from_name(view->corner, "se-resize");
    gtk_widget_set_visible(view->corner, view->floats);
    gtk_overlay_add_overlay(GTK_OVERLAY(overlay), view->corner);
    gtk_widget_set_parent(overlay, GTK_WIDGET(view));
}

static void add_input(TinkerGraphView *view)
{
    GtkEventController *focus = gtk_event_controller_focus_new();
    g_signal_connect(focus, "enter", G_CALLBACK(on_focus), view);
    g_signal_connect(focus, "leave", G_CALLBACK(on_focus_leave), view);
    gtk_widget_add_controller(GTK_WIDGET(view), focus);
    const struct {
        guint button;
        GCallback pressed;
    } presses[] = {{GDK_BUTTON_PRIMARY, G_CALLBACK(on_press)},
                   {GDK_BUTTON_SECONDARY, G_CALLBACK(graph_view_on_right_press)}};
    for (gsize i = 0; i < G_N_ELEMENTS(presses); i++) {
        GtkGesture *click = gtk_gesture_click_new();
        gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), presses[i].button);
        g_signal_connect(click, "pressed", presses[i].pressed, view);
        gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(click));
    }
}

static void tinker_graph_view_get_property(GObject *object, guint property, GValue *value, GParamSpec *spec)
{
    g_value_set_boolean(value, TINKER_GRAPH_VIEW(object)->show_values);
}

static void tinker_graph_view_set_property(GObject *object, guint property, const GValue *value, GParamSpec *spec)
{
    TinkerGraphView *view = TINKER_GRAPH_VIEW(object);
    view->show_values = g_value_get_boolean(value);
    if (view->plot != NULL) tinker_graph_plot_set_show_values(TINKER_GRAPH_PLOT(view->plot), view->show_values);
}

static void tinker_graph_view_dispose(GObject *object)
{
    TinkerGraphView *view = TINKER_GRAPH_VIEW(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&view->player);
    g_clear_object(&view->document);
    g_clear_pointer(&view->identity, g_free);
    G_OBJECT_CLASS(tinker_graph_view_parent_class)->dispose(object);
}

static void tinker_graph_view_class_init(TinkerGraphViewClass *class)
{
    GObjectClass *object_class = G_OBJECT_CLASS(class);
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    object_class->get_property = tinker_graph_view_get_property;
    object_class->set_property = tinker_graph_view_set_property;
    object_class->dispose = tinker_graph_view_dispose;
    properties[PROP_SHOW_VALUES] =
        g_param_spec_boolean("show-values", NULL, NULL, TRUE, G_PARAM_READWRITE | G_PARAM_STATIC_STRINGS);
    g_object_class_install_properties(object_class, PROPERTIES, properties);
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "graph");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
    graph_view_install_commands(widget_class);
}

static void tinker_graph_view_init(TinkerGraphView *view)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(view));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    view->show_values = TRUE;
    gtk_widget_set_focusable(GTK_WIDGET(view), TRUE);
    gtk_widget_set_overflow(GTK_WIDGET(view), GTK_OVERFLOW_HIDDEN);
    add_input(view);
}

TinkerGraphView *tinker_graph_view_new(TinkerDocument *document, TinkerPlayer *player, gboolean floats)
{
    TinkerGraphView *view = g_object_new(TINKER_TYPE_GRAPH_VIEW, NULL);
    view->document = g_object_ref(document);
    view->player = g_object_ref(player);
    view->floats = floats;
    if (floats) gtk_widget_add_css_class(GTK_WIDGET(view), "floating");
    add_title_bar(view);
    add_plot(view);
    g_signal_connect_object(document, "pointed-changed", G_CALLBACK(on_pointed), view, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), view, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_moved), view, G_CONNECT_SWAPPED);
    return view;
}
