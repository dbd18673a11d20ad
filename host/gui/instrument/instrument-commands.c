/* Commands on one instrument, by menu and by key. They are installed for its class alone, so the widget is one. */
#include <glib/gi18n.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-range.h"
#include "gui/instrument/instrument-view-private.h"
#include "gui/widget/popup-menu.h"

static void delete_instrument(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = (gpointer)widget;
    tinker_instrument_remove(view->document, view->number);
}

static void set_kind(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = (gpointer)widget;
    tinker_instrument_set_kind(view->document, view->number, (TinkerInstrumentKind)g_variant_get_int32(parameter));
}

static void set_range(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = (gpointer)widget;
    tinker_instrument_range_popup(widget, view->document, view->number);
}

static GMenu *menu_of(TinkerInstrumentView *view)
{
    const gboolean controls = tinker_instrument_controls(view->shown);
    GMenu *menu = g_menu_new();
    g_autoptr(GMenu) kinds = g_menu_new(), others = g_menu_new();
    for (int i = 0; i < 3; i++) {
        const TinkerInstrumentKind kind =
            (TinkerInstrumentKind)(i + (controls ? TINKER_INSTRUMENT_SLIDER : TINKER_INSTRUMENT_NUMBER));
        g_autoptr(GMenuItem) item = g_menu_item_new(tinker_instrument_kind_title(kind), NULL);
        g_menu_item_set_action_and_target_value(item, "instrument.kind", g_variant_new_int32((gint32)kind));
        g_menu_append_item(kinds, item);
    }
    g_menu_append_section(menu, NULL, G_MENU_MODEL(kinds));
    if (controls) g_menu_append(others, _("Set _Range…"), "instrument.range");
    g_menu_append(others, controls ? _("_Delete Control") : _("_Delete Meter"), "instrument.delete");
    g_menu_append_section(menu, NULL, G_MENU_MODEL(others));
    return menu;
}

static void popup(GtkWidget *widget, double x, double y)
{
    g_autoptr(GMenu) menu = menu_of((gpointer)widget);
    tinker_popup_menu(widget, G_MENU_MODEL(menu), x, y);
}

static void show_menu(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = (gpointer)widget;
    popup(widget, 12, gtk_widget_get_height(view->bar));
}

static void on_menu(GtkGestureClick *gesture, int presses, double x, double y, GtkWidget *view)
{
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    gtk_widget_grab_focus(view);
    popup(view, x, y);
}

void instrument_view_add_menu(TinkerInstrumentView *view)
{
    GtkGesture *click = gtk_gesture_click_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), GDK_BUTTON_SECONDARY);
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE); /* before a scale */
    g_signal_connect(click, "pressed", G_CALLBACK(on_menu), view);
    gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(click));
}

void instrument_view_install_commands(GtkWidgetClass *widget_class)
{
    gtk_widget_class_install_action(widget_class, "instrument.delete", NULL, delete_instrument);
    gtk_widget_class_install_action(widget_class, "instrument.kind", "i", set_kind);
    gtk_widget_class_install_action(widget_class, "instrument.range", NULL, set_range);
    gtk_widget_class_install_action(widget_class, "instrument.menu", NULL, show_menu);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Delete, 0, "instrument.delete", NULL);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Menu, 0, "instrument.menu", NULL);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_F10, GDK_SHIFT_MASK, "instrument.menu", NULL);
}
