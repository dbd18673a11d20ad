/* Moving an instrument: by its title, or with Shift and the arrow keys. */
#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-layer-private.h"

#define NUDGE 10.0

static void commit(TinkerInstrumentLayer *layer, TinkerInstrumentView *view, double x, double y, const char *merge)
{
    double place[2];
    tinker_view_to_world(tinker_canvas_view(layer->canvas), x, y, &place[0], &place[1]);
    tinker_instrument_move(layer->document, tinker_instrument_view_number(view), place, merge);
}

static TinkerInstrumentView *view_of(gpointer controller)
{
    GtkWidget *widget = gtk_event_controller_get_widget(controller);
    return TINKER_INSTRUMENT_VIEW(
        TINKER_IS_INSTRUMENT_VIEW(widget) ? widget : gtk_widget_get_ancestor(widget, TINKER_TYPE_INSTRUMENT_VIEW));
}

static void pointer_of(TinkerInstrumentLayer *layer, GtkGestureDrag *gesture, double dx, double dy, double place[2])
{
    double x, y;
    gtk_gesture_drag_get_start_point(gesture, &x, &y);
    GtkWidget *part = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture));
    gtk_widget_translate_coordinates(part, GTK_WIDGET(layer), x + dx, y + dy, &place[0], &place[1]);
}

static void on_drag_begin(GtkGestureDrag *gesture, double x, double y, TinkerInstrumentLayer *layer)
{
    gtk_widget_grab_focus(GTK_WIDGET(view_of(gesture)));
    const TinkerGraphBox box =
        g_array_index(layer->boxes, TinkerGraphBox, tinker_instrument_view_number(view_of(gesture)));
    layer->from[0] = box.x;
    layer->from[1] = box.y;
    layer->dragged = view_of(gesture);
    layer->way[0] = layer->way[1] = 0;
    pointer_of(layer, gesture, 0, 0, layer->press);
}

static void on_drag_update(GtkGestureDrag *gesture, double dx, double dy, TinkerInstrumentLayer *layer)
{
    double pointer[2];
    if (layer->dragged != view_of(gesture)) return;
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    pointer_of(layer, gesture, dx, dy, pointer);
    layer->way[0] = pointer[0] - layer->press[0];
    layer->way[1] = pointer[1] - layer->press[1];
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

static void on_drag_end(GtkGestureDrag *gesture, double dx, double dy, TinkerInstrumentLayer *layer)
{
    TinkerInstrumentView *view = view_of(gesture);
    if (layer->dragged != view) return;
    const TinkerGraphBox box = instrument_layer_wanted_box(layer, view);
    layer->dragged = NULL;
    if (layer->way[0] != 0 || layer->way[1] != 0) commit(layer, view, box.x, box.y, NULL);
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerInstrumentLayer *layer)
{
    const int right = (key == GDK_KEY_Right) - (key == GDK_KEY_Left),
              down = (key == GDK_KEY_Down) - (key == GDK_KEY_Up);
    if ((right == 0 && down == 0) || !(modifiers & GDK_SHIFT_MASK)) return GDK_EVENT_PROPAGATE;
    if (GTK_IS_TEXT(gtk_root_get_focus(gtk_widget_get_root(GTK_WIDGET(layer))))) return GDK_EVENT_PROPAGATE;
    const TinkerGraphBox box =
        instrument_layer_wanted_box(layer, view_of(controller)); /* also where it is not, to pass others */
    commit(layer, view_of(controller), box.x + NUDGE * right, box.y + NUDGE * down, "nudge instrument");
    return GDK_EVENT_STOP;
}

void instrument_layer_let_move(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), layer);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), layer);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_drag_end), layer);
    gtk_widget_add_controller(tinker_instrument_view_bar(view), GTK_EVENT_CONTROLLER(drag));
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), layer);
    gtk_widget_add_controller(GTK_WIDGET(view), keys);
}
