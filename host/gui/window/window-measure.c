/* Ruler and protractor: the commands, and the bar that tells what is measured and can keep it. */
#include <glib/gi18n.h>

#include "gui/instrument/measure-layer.h"
#include "gui/widget/beside.h"
#include "gui/window/window-parts.h"

#define TOOL "measure" /* data of the window */

typedef struct {
    TinkerWindow *window; /* borrowed: it owns this */
    TinkerMeasureLayer *layer;
    GtkWidget *bar, *read, *keep; /* NULL: no tool is held */
} Tool;

static Tool *tool_of(TinkerWindow *window)
{
    return g_object_get_data(G_OBJECT(window), TOOL);
}

static void set_held(Tool *tool, gboolean ruler, gboolean protractor)
{
    GActionMap *map = G_ACTION_MAP(tool->window);
    g_simple_action_set_state(G_SIMPLE_ACTION(g_action_map_lookup_action(map, "ruler")), g_variant_new_boolean(ruler));
    g_simple_action_set_state(G_SIMPLE_ACTION(g_action_map_lookup_action(map, "protractor")),
                              g_variant_new_boolean(protractor));
}

/* What is read is told to screen readers as the label of the bar changes. */
static void on_measured(Tool *tool)
{
    if (tool->bar == NULL) return;
    const TinkerMeasuring measuring = tinker_measure_layer_measuring(tool->layer);
    TinkerFrame *frame = tinker_player_frame(tool->window->player);
    const gboolean ruler = measuring.kind == TINKER_RULER;
    g_autofree char *text = frame != NULL ? tinker_measuring_text(&measuring, frame, TRUE) : NULL;
    const char *hint = ruler ? _("Drag from one place to another; they snap to bodies and their points")
                             : _("Drag from the corner along one leg, then click a place on the other");
    const char *shown = text != NULL ? text : hint;
    if (g_strcmp0(gtk_label_get_text(GTK_LABEL(tool->read)), shown) != 0) {
        gtk_label_set_text(GTK_LABEL(tool->read), shown);
        gtk_accessible_update_property(GTK_ACCESSIBLE(tool->layer), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, shown, -1);
    }
    const char *why_not = tinker_measuring_why_not_kept(&measuring, tinker_document_scene(tool->window->document));
    gtk_widget_set_sensitive(tool->keep, why_not == NULL);
    gtk_widget_set_tooltip_text(tool->keep, why_not != NULL ? why_not : _("As a block of the scene"));
}

static void put_away(Tool *tool)
{
    if (tool->bar == NULL) return;
    gtk_box_remove(tool->window->banners, tool->bar);
    tool->bar = tool->read = tool->keep = NULL;
    gtk_widget_set_visible(GTK_WIDGET(tool->layer), FALSE);
    set_held(tool, FALSE, FALSE);
    gtk_widget_grab_focus(GTK_WIDGET(tool->window->canvas));
}

static void on_keep(Tool *tool)
{
    const TinkerMeasuring measuring = tinker_measure_layer_measuring(tool->layer);
    g_autoptr(GError) error = NULL;
    if (tinker_player_time(tool->window->player) > 0) tinker_player_rewind(tool->window->player);
    if (tinker_measuring_keep(&measuring, tool->window->document, &error))
        put_away(tool);
    else if (error != NULL)
        window_toast(tool->window, error->message);
}

static void add_bar(Tool *tool, TinkerMeasuringKind kind)
{
    tool->read = g_object_new(GTK_TYPE_LABEL, "accessible-role", GTK_ACCESSIBLE_ROLE_STATUS, NULL);
    gtk_label_set_wrap(GTK_LABEL(tool->read), TRUE);
    gtk_label_set_xalign(GTK_LABEL(tool->read), 0);
    gtk_widget_add_css_class(tool->read, "numeric");
    tool->keep =
        gtk_button_new_with_mnemonic(kind == TINKER_RULER ? _("_Keep as Dimension") : _("_Keep as Angle Mark"));
    GtkWidget *done = gtk_button_new_with_mnemonic(_("_Put Away"));
    g_signal_connect_swapped(tool->keep, "clicked", G_CALLBACK(on_keep), tool);
    g_signal_connect_swapped(done, "clicked", G_CALLBACK(put_away), tool);
    GtkWidget *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *parts[] = {tool->keep, done};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        gtk_widget_set_valign(parts[i], GTK_ALIGN_CENTER);
        gtk_box_append(GTK_BOX(buttons), parts[i]);
    }
    tinker_beside_wrap(tool->keep);
    tool->bar = tinker_beside_new(tool->read, buttons);
    gtk_widget_add_css_class(tool->bar, "film-bar");
    gtk_box_append(tool->window->banners, tool->bar);
}

static void hold(Tool *tool, TinkerMeasuringKind kind)
{
    put_away(tool);
    add_bar(tool, kind);
    set_held(tool, kind == TINKER_RULER, kind == TINKER_PROTRACTOR);
    gtk_accessible_update_property(GTK_ACCESSIBLE(tool->layer), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   kind == TINKER_RULER ? _("Ruler") : _("Protractor"), -1);
    gtk_widget_set_visible(GTK_WIDGET(tool->layer), TRUE);
    tinker_measure_layer_begin(tool->layer, kind);
    gtk_widget_grab_focus(GTK_WIDGET(tool->layer));
}

static void on_tool(GSimpleAction *action, GVariant *parameter, gpointer window)
{
    Tool *tool = tool_of(window);
    g_autoptr(GVariant) held = g_action_get_state(G_ACTION(action));
    if (g_variant_get_boolean(held))
        put_away(tool);
    else
        hold(tool, g_str_equal(g_action_get_name(G_ACTION(action)), "ruler") ? TINKER_RULER : TINKER_PROTRACTOR);
}

void window_add_measuring(TinkerWindow *window)
{
    static const GActionEntry actions[] = {
        {.name = "ruler", .activate = on_tool, .state = "false"},
        {.name = "protractor", .activate = on_tool, .state = "false"},
    };
    Tool *tool = g_new0(Tool, 1);
    tool->window = window;
    tool->layer = tinker_measure_layer_new(window->canvas, window->document, window->player);
    g_object_set_data_full(G_OBJECT(window), TOOL, tool, g_free);
    g_action_map_add_action_entries(G_ACTION_MAP(window), actions, G_N_ELEMENTS(actions), window);
    gtk_overlay_add_overlay(window->canvas_overlay, GTK_WIDGET(tool->layer));
    /* below the bar that it has, whose buttons are to be pressed */
    gtk_widget_insert_before(GTK_WIDGET(tool->layer), GTK_WIDGET(window->canvas_overlay), GTK_WIDGET(window->banners));
    g_signal_connect_swapped(tool->layer, "measured", G_CALLBACK(on_measured), tool);
    g_signal_connect_swapped(tool->layer, "put-away", G_CALLBACK(put_away), tool);
}
