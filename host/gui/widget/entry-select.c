/* GTK's own gestures take the sequence for themselves, which is why the events are looked at as they come. */
#include "gui/widget/entry-select.h"

#define BROUGHT_FOCUS "tinker-press-brought-focus" /* data of the controller: the press that is under way */

static gboolean on_event(GtkEventController *controller, GdkEvent *event)
{
    const GdkEventType type = gdk_event_get_event_type(event);
    if (type != GDK_BUTTON_PRESS && type != GDK_BUTTON_RELEASE) return GDK_EVENT_PROPAGATE;
    if (gdk_button_event_get_button(event) != GDK_BUTTON_PRIMARY) return GDK_EVENT_PROPAGATE;
    GtkWidget *entry = gtk_event_controller_get_widget(controller);
    if (type == GDK_BUTTON_PRESS) {
        gboolean had_focus = (gtk_widget_get_state_flags(entry) & GTK_STATE_FLAG_FOCUS_WITHIN) != 0;
        g_object_set_data(G_OBJECT(controller), BROUGHT_FOCUS, GINT_TO_POINTER(!had_focus));
    } else if (g_object_get_data(G_OBJECT(controller), BROUGHT_FOCUS) != NULL &&
               !gtk_editable_get_selection_bounds(GTK_EDITABLE(entry), NULL, NULL)) {
        gtk_editable_select_region(GTK_EDITABLE(entry), 0, -1);
    }
    return GDK_EVENT_PROPAGATE;
}

void tinker_entry_select_by_click(GtkWidget *entry)
{
    GtkEventController *controller = gtk_event_controller_legacy_new();
    gtk_event_controller_set_propagation_phase(controller, GTK_PHASE_CAPTURE);
    g_signal_connect(controller, "event", G_CALLBACK(on_event), NULL);
    gtk_widget_add_controller(entry, controller);
}

void tinker_entry_listen(GtkWidget *entry, GCallback typed, GCallback taken, GCallback left, GCallback key, void *data)
{
    GtkEventController *focus = gtk_event_controller_focus_new(), *keys = gtk_event_controller_key_new();
    g_signal_connect_swapped(entry, "changed", typed, data);
    g_signal_connect_swapped(entry, "activate", taken, data);
    g_signal_connect_swapped(focus, "leave", left, data);
    gtk_widget_add_controller(entry, focus);
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", key, data);
    gtk_widget_add_controller(entry, keys);
}
