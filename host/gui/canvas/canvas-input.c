/* Looking around, the menu, and keys. */
#include <math.h>

#include "gui/canvas/canvas-private.h"

#define WHEEL_ZOOM 1.15 /* by one notch */
#define WHEEL_PAN  60.0 /* widget units by one notch */
#define FINE_NUDGE 1.0  /* widget units: an arrow key with Alt */

/* Looking around --------------------------------------------------------------------------------------------------- */

static void on_pan_press(GtkGestureDrag *gesture, double x, double y, TinkerCanvas *canvas)
{
    canvas->panned[0] = canvas->panned[1] = 0;
}

static void on_pan(GtkGestureDrag *gesture, double dx, double dy, TinkerCanvas *canvas)
{
    tinker_view_pan(&canvas->view, dx - canvas->panned[0], dy - canvas->panned[1]);
    canvas->panned[0] = dx;
    canvas->panned[1] = dy;
    canvas_view_changed(canvas);
}

static gboolean on_scroll(GtkEventControllerScroll *controller, double dx, double dy, TinkerCanvas *canvas)
{
    GdkModifierType modifiers = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(controller));
    if (modifiers & GDK_CONTROL_MASK)
        tinker_view_zoom(&canvas->view, pow(WHEEL_ZOOM, -dy), canvas->pointer[0], canvas->pointer[1]);
    else if (modifiers & GDK_SHIFT_MASK)
        tinker_view_pan(&canvas->view, -WHEEL_PAN * dy, -WHEEL_PAN * dx);
    else
        tinker_view_pan(&canvas->view, -WHEEL_PAN * dx, -WHEEL_PAN * dy);
    canvas_view_changed(canvas);
    return GDK_EVENT_STOP;
}

static void on_motion(GtkEventControllerMotion *controller, double x, double y, TinkerCanvas *canvas)
{
    if (canvas->gesture != CANVAS_IDLE) return;
    /* one that has not moved, as GTK tells of where widgets move, leaves what keys point at */
    if (canvas->points && x == canvas->pointer[0] && y == canvas->pointer[1]) return;
    canvas->pointer[0] = x;
    canvas->pointer[1] = y;
    canvas->points = TRUE;
    if (tinker_player_state(canvas->player) != TINKER_PLAYER_PLAYING)
        canvas_point_at(canvas, x, y, canvas_hit_at(canvas, x, y, FALSE).block);
}

static void on_pinch(GtkGestureZoom *gesture, double scale, TinkerCanvas *canvas)
{
    double x, y, *last = g_object_get_data(G_OBJECT(gesture), "last");
    if (last == NULL || !gtk_gesture_get_bounding_box_center(GTK_GESTURE(gesture), &x, &y)) return;
    tinker_view_zoom(&canvas->view, scale / *last, x, y);
    *last = scale;
    canvas_view_changed(canvas);
}

static void on_pinch_begin(GtkGesture *gesture, GdkEventSequence *sequence, TinkerCanvas *canvas)
{
    double *last = g_new(double, 1);
    *last = 1;
    g_object_set_data_full(G_OBJECT(gesture), "last", last, g_free);
}

/* The menu --------------------------------------------------------------------------------------------------------- */

static void on_menu(GtkGestureClick *gesture, int presses, double x, double y, TinkerCanvas *canvas)
{
    gtk_widget_grab_focus(GTK_WIDGET(canvas));
    TinkerHit hit = canvas_hit_at(canvas, x, y, FALSE);
    if (!tinker_document_is_selected(canvas->document, hit.block)) tinker_document_select(canvas->document, hit.block);
    canvas->pointer[0] = x;
    canvas->pointer[1] = y;
    g_signal_emit_by_name(canvas, "menu", x, y);
}

/* That of what is selected, over the first of it; of the empty canvas in its middle. */
static gboolean show_menu(TinkerCanvas *canvas)
{
    int count;
    const TinkerBlockId *selected = tinker_document_selection(canvas->document, &count);
    const TinkerFrame *frame = tinker_player_frame(canvas->player);
    double x = NAN, y = NAN, orientation;
    if (count > 0 && frame != NULL) {
        tinker_frame_centre(frame, selected[0], &x, &y, &orientation);
        tinker_view_to_canvas(&canvas->view, x, y, &x, &y);
    }
    canvas->pointer[0] = isfinite(x) ? CLAMP(x, 0, canvas->view.width) : canvas->view.width / 2;
    canvas->pointer[1] = isfinite(y) ? CLAMP(y, 0, canvas->view.height) : canvas->view.height / 2;
    g_signal_emit_by_name(canvas, "menu", canvas->pointer[0], canvas->pointer[1]);
    return GDK_EVENT_STOP;
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

static gboolean nudge(TinkerCanvas *canvas, int right, int up, GdkModifierType modifiers)
{
    int count;
    tinker_document_selection(canvas->document, &count);
    double step = canvas_grid(canvas, modifiers);
    if (step == 0) step = FINE_NUDGE / canvas->view.scale;
    if (count == 0) {
        tinker_view_pan(&canvas->view, -WHEEL_PAN * right, WHEEL_PAN * up);
        canvas_view_changed(canvas);
    } else if (tinker_player_time(canvas->player) > 0) {
        tinker_player_rewind(canvas->player);
    } else {
        tinker_document_move_selected(canvas->document, step * right, step * up, "nudge");
    }
    return GDK_EVENT_STOP;
}

/* Selects the block before or behind the one that is selected, in drawing order. */
static gboolean select_next(TinkerCanvas *canvas, int way)
{
    TinkerScene *scene = tinker_document_scene(canvas->document);
    int32_t count = tinker_scene_block_count(scene), place = way > 0 ? -1 : count;
    for (int32_t i = 0; i < count; i++)
        if (tinker_document_is_selected(canvas->document, tinker_scene_block_at(scene, i))) place = i;
    place += way;
    if (place < 0 || place >= count) {
        tinker_document_select(canvas->document, TINKER_NO_BLOCK);
        canvas_reach_away(canvas);
        return GDK_EVENT_PROPAGATE; /* on to the next widget */
    }
    tinker_document_select(canvas->document, tinker_scene_block_at(scene, place));
    canvas_reach_block(canvas, tinker_scene_block_at(scene, place));
    return GDK_EVENT_STOP;
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerCanvas *canvas)
{
    if (modifiers & GDK_CONTROL_MASK) return GDK_EVENT_PROPAGATE;
    switch (key) {
    case GDK_KEY_Left:
        return nudge(canvas, -1, 0, modifiers);
    case GDK_KEY_Right:
        return nudge(canvas, 1, 0, modifiers);
    case GDK_KEY_Up:
        return nudge(canvas, 0, 1, modifiers);
    case GDK_KEY_Down:
        return nudge(canvas, 0, -1, modifiers);
    case GDK_KEY_Tab:
        return select_next(canvas, 1);
    case GDK_KEY_ISO_Left_Tab:
        return select_next(canvas, -1);
    case GDK_KEY_Page_Down:
    case GDK_KEY_Page_Up:
        return modifiers & GDK_SHIFT_MASK ? GDK_EVENT_PROPAGATE
                                          : canvas_reach_arrow(canvas, key == GDK_KEY_Page_Down ? 1 : -1);
    case GDK_KEY_Menu:
        return show_menu(canvas);
    case GDK_KEY_F10:
        return modifiers & GDK_SHIFT_MASK ? show_menu(canvas) : GDK_EVENT_PROPAGATE;
    case GDK_KEY_Escape:
        if (canvas->gesture != CANVAS_IDLE)
            canvas_cancel_gesture(canvas);
        else
            tinker_document_select(canvas->document, TINKER_NO_BLOCK);
        canvas_reach_away(canvas);
        return GDK_EVENT_STOP;
    default:
        return GDK_EVENT_PROPAGATE;
    }
}

static GtkGesture *add_gesture(TinkerCanvas *canvas, GtkGesture *gesture, guint button)
{
    if (button > 0) gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(gesture), button);
    gtk_widget_add_controller(GTK_WIDGET(canvas), GTK_EVENT_CONTROLLER(gesture));
    return gesture;
}

void canvas_add_input(TinkerCanvas *canvas)
{
    canvas_add_drag(canvas);
    GtkGesture *pan = add_gesture(canvas, gtk_gesture_drag_new(), GDK_BUTTON_MIDDLE);
    g_signal_connect(pan, "drag-begin", G_CALLBACK(on_pan_press), canvas);
    g_signal_connect(pan, "drag-update", G_CALLBACK(on_pan), canvas);
    GtkGesture *menu = add_gesture(canvas, gtk_gesture_click_new(), GDK_BUTTON_SECONDARY);
    g_signal_connect(menu, "pressed", G_CALLBACK(on_menu), canvas);
    GtkGesture *pinch = add_gesture(canvas, gtk_gesture_zoom_new(), 0);
    g_signal_connect(pinch, "begin", G_CALLBACK(on_pinch_begin), canvas);
    g_signal_connect(pinch, "scale-changed", G_CALLBACK(on_pinch), canvas);
    GtkEventController *scroll = gtk_event_controller_scroll_new(GTK_EVENT_CONTROLLER_SCROLL_BOTH_AXES);
    g_signal_connect(scroll, "scroll", G_CALLBACK(on_scroll), canvas);
    gtk_widget_add_controller(GTK_WIDGET(canvas), scroll);
    GtkEventController *motion = gtk_event_controller_motion_new();
    g_signal_connect(motion, "motion", G_CALLBACK(on_motion), canvas);
    g_signal_connect_swapped(motion, "leave", G_CALLBACK(canvas_point_away), canvas);
    gtk_widget_add_controller(GTK_WIDGET(canvas), motion);
    GtkEventController *keys = gtk_event_controller_key_new();
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), canvas);
    gtk_widget_add_controller(GTK_WIDGET(canvas), keys);
    GtkEventController *focus = gtk_event_controller_focus_new();
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(canvas_reach_away), canvas);
    gtk_widget_add_controller(GTK_WIDGET(canvas), focus);
}
