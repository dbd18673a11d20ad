/* Each way has an action, which menus name, and a key. */
#include "gui/graph/graph-looks.h"

#define ZOOM 1.5
#define STEP 0.2 /* of what is seen: how far a key moves it */

typedef enum {
    ZOOM_IN,
    ZOOM_OUT,
    ZOOM_IN_ACROSS,
    ZOOM_OUT_ACROSS,
    ZOOM_IN_UPWARDS,
    ZOOM_OUT_UPWARDS,
    SHOW_ALL,
    GO_LEFT,
    GO_RIGHT,
    GO_UP,
    GO_DOWN,
    NEXT_EXTREMUM,
    PREVIOUS_EXTREMUM,
    PUT_CURSOR,
    CLEAR_CURSORS,
    NEXT_CURVE,
    PREVIOUS_CURVE,
} Look;

static void look(TinkerGraphPlot *plot, Look how)
{
    switch (how) {
    case ZOOM_IN:
    case ZOOM_OUT:
        tinker_graph_plot_zoom(plot, TINKER_GRAPH_ALL, how == ZOOM_IN ? ZOOM : 1 / ZOOM);
        break;
    case ZOOM_IN_ACROSS:
    case ZOOM_OUT_ACROSS:
        tinker_graph_plot_zoom(plot, TINKER_GRAPH_X, how == ZOOM_IN_ACROSS ? ZOOM : 1 / ZOOM);
        break;
    case ZOOM_IN_UPWARDS:
    case ZOOM_OUT_UPWARDS:
        tinker_graph_plot_zoom(plot, TINKER_GRAPH_UP, how == ZOOM_IN_UPWARDS ? ZOOM : 1 / ZOOM);
        break;
    case SHOW_ALL:
        tinker_graph_plot_show_all(plot);
        break;
    case GO_LEFT:
    case GO_RIGHT:
        tinker_graph_plot_pan(plot, how == GO_RIGHT ? STEP : -STEP, 0);
        break;
    case GO_UP:
    case GO_DOWN:
        tinker_graph_plot_pan(plot, 0, how == GO_UP ? STEP : -STEP);
        break;
    case NEXT_EXTREMUM:
    case PREVIOUS_EXTREMUM:
        tinker_graph_plot_go_to_next(plot, how == NEXT_EXTREMUM);
        break;
    case PUT_CURSOR:
        tinker_graph_plot_put_cursor(plot);
        break;
    case CLEAR_CURSORS:
        tinker_graph_plot_clear_cursors(plot);
        break;
    case NEXT_CURVE:
    case PREVIOUS_CURVE:
        tinker_graph_plot_choose_curve(plot, how == NEXT_CURVE ? 1 : -1);
        break;
    }
}

static const struct {
    const char *action;
    Look look;
    guint key, other_key;
    GdkModifierType modifiers;
} looks[] = {
    {"zoom-in", ZOOM_IN, GDK_KEY_plus, GDK_KEY_KP_Add, 0},
    {"zoom-out", ZOOM_OUT, GDK_KEY_minus, GDK_KEY_KP_Subtract, 0},
    {"zoom-in-across", ZOOM_IN_ACROSS, GDK_KEY_x, 0, 0},
    {"zoom-out-across", ZOOM_OUT_ACROSS, GDK_KEY_X, 0, GDK_SHIFT_MASK},
    {"zoom-in-upwards", ZOOM_IN_UPWARDS, GDK_KEY_y, 0, 0},
    {"zoom-out-upwards", ZOOM_OUT_UPWARDS, GDK_KEY_Y, 0, GDK_SHIFT_MASK},
    {"show-all", SHOW_ALL, GDK_KEY_0, GDK_KEY_KP_0, 0},
    {"go-left", GO_LEFT, GDK_KEY_Left, 0, GDK_CONTROL_MASK},
    {"go-right", GO_RIGHT, GDK_KEY_Right, 0, GDK_CONTROL_MASK},
    {"go-up", GO_UP, GDK_KEY_Up, 0, GDK_CONTROL_MASK},
    {"go-down", GO_DOWN, GDK_KEY_Down, 0, GDK_CONTROL_MASK},
    {"next-extremum", NEXT_EXTREMUM, GDK_KEY_n, 0, 0},
    {"previous-extremum", PREVIOUS_EXTREMUM, GDK_KEY_p, 0, 0},
    {"put-cursor", PUT_CURSOR, GDK_KEY_c, 0, 0},
    {"clear-cursors", CLEAR_CURSORS, GDK_KEY_C, 0, GDK_SHIFT_MASK},
    {"next-curve", NEXT_CURVE, GDK_KEY_Page_Down, GDK_KEY_KP_Page_Down, 0},
    {"previous-curve", PREVIOUS_CURVE, GDK_KEY_Page_Up, GDK_KEY_KP_Page_Up, 0},
};

static void on_look(GSimpleAction *action, GVariant *parameter, gpointer plot)
{
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++)
        if (g_str_equal(looks[i].action, g_action_get_name(G_ACTION(action)))) look(plot, looks[i].look);
}

void tinker_graph_looks_bind(GtkWidgetClass *widget_class)
{
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++) {
        g_autofree char *name = g_strconcat("look.", looks[i].action, NULL);
        const guint keys[] = {looks[i].key, looks[i].other_key};
        for (gsize k = 0; k < G_N_ELEMENTS(keys); k++)
            if (keys[k] != 0)
                gtk_widget_class_add_binding_action(widget_class, keys[k], looks[i].modifiers, name, NULL);
    }
}

void tinker_graph_looks_add(GtkWidget *widget, TinkerGraphPlot *plot)
{
    g_autoptr(GSimpleActionGroup) group = g_simple_action_group_new();
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++) {
        g_autoptr(GSimpleAction) action = g_simple_action_new(looks[i].action, NULL);
        g_signal_connect_object(action, "activate", G_CALLBACK(on_look), plot, 0);
        g_action_map_add_action(G_ACTION_MAP(group), G_ACTION(action));
    }
    gtk_widget_insert_action_group(widget, "look", G_ACTION_GROUP(group));
}
