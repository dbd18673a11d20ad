/* Gestures and keys. A press decides by what lies under it; nothing is changed before the pointer has moved. */
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/canvas/canvas-private.h"

#define THRESHOLD  4.0  /* widget units: a press that moves less is a click */
#define WHEEL_ZOOM 1.15 /* by one notch */
#define WHEEL_PAN  60.0 /* widget units by one notch */
#define FINE_NUDGE 1.0  /* widget units: an arrow key with Alt */

static void set_highlighted(TinkerCanvas *canvas, TinkerBlockId block)
{
    if (canvas->highlighted == block) return;
    canvas->highlighted = block;
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

/* An end that is attached lies over the body it is on: that is meant, unless the connector is selected. What has its
 * ends at one place, as a pin, is meant itself, for nothing else of it could be clicked. */
static TinkerHit body_rather_than_end(TinkerCanvas *canvas, TinkerFrame *frame, TinkerHit hit, const double world[2])
{
    TinkerScene *scene = tinker_frame_scene(frame);
    gboolean is_end = hit.part >= 0 && hit.part < tinker_scene_end_count(scene, hit.block);
    if (!is_end || tinker_document_is_selected(canvas->document, hit.block)) return hit;
    if (tinker_is_at_one_place(frame, hit.block)) return (TinkerHit){hit.block, TINKER_PART_WHOLE};
    TinkerBlockId body = tinker_scene_end(scene, hit.block, hit.part).block;
    if (body == TINKER_NO_BLOCK) return hit;
    TinkerBlockId under = tinker_hit_connectable(frame, hit.block, world[0], world[1], 0);
    return under == body ? (TinkerHit){body, TINKER_PART_WHOLE} : hit;
}

/* A force may be taken by its handle while the scene plays: what it becomes acts from then on. */
static gboolean acts_at_once(TinkerCanvas *canvas, TinkerHit hit)
{
    const TinkerScene *scene = tinker_document_scene(canvas->document);
    if (tinker_player_state(canvas->player) != TINKER_PLAYER_PLAYING || hit.block == TINKER_NO_BLOCK) return FALSE;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, hit.block);
    return hit.part >= TINKER_PART_HANDLE && block_class != NULL && block_class->physics != NULL &&
           block_class->physics->force_element != NULL;
}

/* What lies under a point, fields in their corner too. `handles`: those of what is selected come first, for only they
 * are drawn, and only of the scene as placed; that of a force can be taken while it plays. */
static TinkerHit hit_at(TinkerCanvas *canvas, double x, double y, gboolean handles)
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    TinkerHit hit = {TINKER_NO_BLOCK, TINKER_PART_NONE};
    if (frame == NULL) return hit;
    double world[2];
    canvas_to_world(canvas, x, y, world);
    tinker_frame_set_symbol_size(frame,
                                 tinker_painter_symbol_size(frame, canvas->view.scale / canvas_magnification(canvas)));
    TinkerBlockId selected = tinker_document_selected(canvas->document);
    if (handles && selected != TINKER_NO_BLOCK)
        hit = tinker_hit_handle(frame, selected, world[0], world[1], canvas_reach(canvas));
    if (tinker_frame_time(frame) != 0 && !acts_at_once(canvas, hit)) hit.block = TINKER_NO_BLOCK;
    if (hit.block == TINKER_NO_BLOCK)
        hit = tinker_hit(frame, world[0], world[1], canvas_reach(canvas), TINKER_NO_BLOCK);
    if (hit.block != TINKER_NO_BLOCK) return body_rather_than_end(canvas, frame, hit, world);
    return (TinkerHit){tinker_painter_field_at(frame, &canvas->view, x, y), TINKER_PART_NONE};
}

TinkerHit tinker_canvas_handle(TinkerCanvas *canvas, double place[2])
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    const TinkerBlockId selected = tinker_document_selected(canvas->document);
    canvas_to_world(canvas, canvas->pointer[0], canvas->pointer[1], place);
    if (frame == NULL || selected == TINKER_NO_BLOCK) return (TinkerHit){TINKER_NO_BLOCK, TINKER_PART_NONE};
    return tinker_hit_handle(frame, selected, place[0], place[1], canvas_reach(canvas));
}

/* Dragging --------------------------------------------------------------------------------------------------------- */

/* What the press has hold of from now on, and where on it. */
static void take_hold(TinkerCanvas *canvas, const double world[2])
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    if (frame == NULL || canvas->pressed.block == TINKER_NO_BLOCK) return;
    const TinkerHit hit = tinker_hit_to_drag(frame, canvas->pressed, world[0], world[1], canvas_reach(canvas));
    if (hit.block != canvas->pressed.block) tinker_document_select(canvas->document, hit.block);
    canvas->pressed = hit;
    tinker_frame_to_own(frame, hit.block, world, canvas->grip);
}

static void begin_drag(TinkerCanvas *canvas)
{
    double world[2];
    int count;
    tinker_document_selection(canvas->document, &count);
    canvas_to_world(canvas, canvas->press[0], canvas->press[1], world);
    if (count <= 1) take_hold(canvas, world);
    if (canvas->pressed.block == TINKER_NO_BLOCK) {
        canvas->gesture = CANVAS_BAND;
    } else if (count > 1 && canvas->pressed.part == TINKER_PART_WHOLE) {
        tinker_document_begin(canvas->document, "Move", NULL);
        canvas->gesture = CANVAS_GROUP;
        canvas->group_moved[0] = canvas->group_moved[1] = 0;
    } else {
        canvas->drag = tinker_drag_begin(tinker_document_history(canvas->document),
                                         tinker_document_scene(canvas->document), canvas->pressed, world[0], world[1]);
        canvas->gesture = canvas->drag != NULL ? CANVAS_DRAG : CANVAS_IDLE;
    }
}

static void drag_part(TinkerCanvas *canvas, GdkModifierType modifiers)
{
    double world[2];
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    canvas_to_world(canvas, canvas->pointer[0], canvas->pointer[1], world);
    if (frame != NULL)
        tinker_drag_set_symbol_size(
            canvas->drag, tinker_painter_symbol_size(frame, canvas->view.scale / canvas_magnification(canvas)));
    TinkerScene *scene = tinker_document_scene(canvas->document);
    const TinkerPlacement before = tinker_placement_of(scene, canvas->pressed.block);
    TinkerBlockId target =
        tinker_drag_to(canvas->drag, world[0], world[1], canvas_grid(canvas, modifiers), canvas_reach(canvas));
    if (canvas->pressed.part == TINKER_PART_WHOLE)
        tinker_joined_follow_hand(tinker_document_history(canvas->document), scene, &before, canvas->grip, world, NULL);
    else
        tinker_joined_follow(tinker_document_history(canvas->document), scene, &before, NULL);
    tinker_document_touch(canvas->document);
    set_highlighted(canvas, target);
}

/* Moves the selection by what the snapped way of the pointer has become more. */
static void drag_group(TinkerCanvas *canvas, GdkModifierType modifiers)
{
    double way[2] = {(canvas->pointer[0] - canvas->press[0]) / canvas->view.scale,
                     (canvas->press[1] - canvas->pointer[1]) / canvas->view.scale};
    tinker_snap(canvas_grid(canvas, modifiers), &way[0], &way[1]);
    double dx = way[0] - canvas->group_moved[0], dy = way[1] - canvas->group_moved[1];
    if (dx == 0 && dy == 0) return;
    tinker_document_shift_selected(canvas->document, dx, dy);
    tinker_document_touch(canvas->document);
    canvas->group_moved[0] = way[0];
    canvas->group_moved[1] = way[1];
}

static void select_in_band(TinkerCanvas *canvas)
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    if (frame == NULL) return;
    double a[2], b[2];
    canvas_to_world(canvas, canvas->press[0], canvas->press[1], a);
    canvas_to_world(canvas, canvas->pointer[0], canvas->pointer[1], b);
    TinkerScene *scene = tinker_frame_scene(frame);
    g_autoptr(GArray) inside = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        double x, y, orientation;
        tinker_frame_centre(frame, block, &x, &y, &orientation);
        if (x >= fmin(a[0], b[0]) && x <= fmax(a[0], b[0]) && y >= fmin(a[1], b[1]) && y <= fmax(a[1], b[1]))
            g_array_append_val(inside, block);
    }
    tinker_document_select_all_of(canvas->document, (const TinkerBlockId *)(gpointer)inside->data, (int)inside->len);
}

static void on_press(GtkGestureDrag *gesture, double x, double y, TinkerCanvas *canvas)
{
    GdkModifierType modifiers = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    gtk_widget_grab_focus(GTK_WIDGET(canvas));
    canvas_cancel_gesture(canvas);
    canvas->press[0] = canvas->pointer[0] = x;
    canvas->press[1] = canvas->pointer[1] = y;
    canvas->moved = FALSE;
    gboolean several = (modifiers & (GDK_CONTROL_MASK | GDK_SHIFT_MASK)) != 0;
    canvas->pressed = hit_at(canvas, x, y, !several);
    TinkerBlockId block = canvas->pressed.block;
    if (several && block != TINKER_NO_BLOCK)
        tinker_document_toggle(canvas->document, block);
    else if (!several && !(block != TINKER_NO_BLOCK && tinker_document_is_selected(canvas->document, block)))
        tinker_document_select(canvas->document, block);
}

static void on_drag(GtkGestureDrag *gesture, double dx, double dy, TinkerCanvas *canvas)
{
    GdkModifierType modifiers = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    canvas->pointer[0] = canvas->press[0] + dx;
    canvas->pointer[1] = canvas->press[1] + dy;
    if (!canvas->moved && hypot(dx, dy) < THRESHOLD) return;
    if (!canvas->moved) {
        canvas->moved = TRUE;
        gboolean edits = canvas->pressed.block != TINKER_NO_BLOCK;
        if (edits && tinker_player_time(canvas->player) > 0 && !acts_at_once(canvas, canvas->pressed)) {
            tinker_player_rewind(canvas->player);
            return;
        }
        begin_drag(canvas);
    }
    if (canvas->gesture == CANVAS_DRAG) drag_part(canvas, modifiers);
    if (canvas->gesture == CANVAS_GROUP) drag_group(canvas, modifiers);
    if (canvas->gesture == CANVAS_BAND) gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

static void on_release(GtkGestureDrag *gesture, double dx, double dy, TinkerCanvas *canvas)
{
    GdkModifierType modifiers = gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture));
    CanvasGesture ended = canvas->gesture;
    canvas->gesture = CANVAS_IDLE;
    if (ended == CANVAS_DRAG) {
        tinker_drag_end(g_steal_pointer(&canvas->drag), (modifiers & GDK_SHIFT_MASK) != 0,
                        (modifiers & GDK_ALT_MASK) != 0 ? 0 : canvas_top_reach(canvas));
        tinker_document_touch(canvas->document);
        g_signal_emit_by_name(canvas, "dropped", canvas->pressed.block, canvas_reach(canvas));
    }
    if (ended == CANVAS_GROUP) tinker_document_end(canvas->document);
    if (ended == CANVAS_BAND) select_in_band(canvas);
    set_highlighted(canvas, TINKER_NO_BLOCK);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

void canvas_cancel_gesture(TinkerCanvas *canvas)
{
    CanvasGesture cancelled = canvas->gesture;
    canvas->gesture = CANVAS_IDLE;
    if (cancelled == CANVAS_DRAG) {
        tinker_drag_cancel(g_steal_pointer(&canvas->drag));
        tinker_document_touch(canvas->document);
    }
    if (cancelled == CANVAS_GROUP) tinker_document_abort(canvas->document);
    set_highlighted(canvas, TINKER_NO_BLOCK);
}

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
        canvas_point_at(canvas, x, y, hit_at(canvas, x, y, FALSE).block);
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
    TinkerHit hit = hit_at(canvas, x, y, FALSE);
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
    GtkGesture *drag = add_gesture(canvas, gtk_gesture_drag_new(), GDK_BUTTON_PRIMARY);
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_press), canvas);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag), canvas);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_release), canvas);
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
