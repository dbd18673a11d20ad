/* Controls and meters in the window: the layer that shows them, the commands that add them, and their menus. */
#include <glib/gi18n.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-layer.h"
#include "gui/instrument/instrument-menu.h"
#include "gui/window/window-parts.h"

/* The parameter is the name of a number of the selected block. */
static void add_control(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    const TinkerBlockId block = tinker_document_selected(window->document);
    g_autoptr(GError) error = NULL;
    TinkerInstrumentPlace place;
    if (block == TINKER_NO_BLOCK) {
        window_toast(window, _("Select the block that the control is to be of"));
        return;
    }
    tinker_instrument_layer_find_room(window->instruments, &place);
    if (!tinker_control_add(window->document, block, g_variant_get_string(parameter, NULL), &place, &error))
        window_toast(window, error->message);
}

/* That of a quantity of the selected block; without one, of the scene. */
static void add_meter(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    const TinkerBlockId block = tinker_document_selected(window->document);
    g_autoptr(GError) error = NULL;
    TinkerInstrumentPlace place;
    tinker_instrument_layer_find_room(window->instruments, &place);
    if (!tinker_meter_add(window->document, block, g_variant_get_string(parameter, NULL), &place, &error))
        window_toast(window, error->message);
}

void window_append_instrument_menu(TinkerWindow *window, GMenu *menu)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    const TinkerBlockId block = tinker_document_selected(window->document);
    int selected;
    tinker_document_selection(window->document, &selected);
    if (selected > 1) return;
    g_autoptr(GMenu) section = g_menu_new();
    g_autoptr(GMenuModel) meters = tinker_meter_menu_new(scene, block);
    if (block != TINKER_NO_BLOCK) {
        g_autoptr(GMenuModel) controls = tinker_control_menu_new(tinker_scene_block_class(scene, block));
        if (g_menu_model_get_n_items(controls) > 0) g_menu_append_submenu(section, _("Add C_ontrol"), controls);
    }
    if (g_menu_model_get_n_items(meters) > 0) g_menu_append_submenu(section, _("Add _Meter"), meters);
    g_menu_append_section(menu, NULL, G_MENU_MODEL(section));
}

void window_add_instruments(TinkerWindow *window)
{
    static const GActionEntry actions[] = {
        {.name = "add-control", .activate = add_control, .parameter_type = "s"},
        {.name = "add-meter", .activate = add_meter, .parameter_type = "s"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), actions, G_N_ELEMENTS(actions), window);
    GtkWidget *layer =
        tinker_instrument_layer_new(window->canvas, window->graph_layer, window->document, window->player);
    window->instruments = TINKER_INSTRUMENT_LAYER(layer);
    gtk_overlay_add_overlay(window->canvas_overlay, layer);
    /* below notices, as graphs are */
    gtk_widget_insert_before(layer, GTK_WIDGET(window->canvas_overlay), GTK_WIDGET(window->banners));
}
