/* Dragging with the primary button. A press decides by what lies under it; nothing is changed before the pointer has
 * moved. */
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/canvas/canvas-private.h"

#define THRESHOLD 4.0 /* widget units: a press that moves less is a click */

static void set_highlighted(TinkerCanvas *canvas, TinkerBlockId block)
{
    if (canvas->highlighted == block) return;
    canvas->highlighted = block;
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

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
    canvas->pressed = canvas_hit_at(canvas, x, y, !several);
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
        if (edits && tinker_player_time(canvas->player) > 0 && !canvas_acts_at_once(canvas, canvas->pressed)) {
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

void canvas_add_drag(TinkerCanvas *canvas)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(drag), GDK_BUTTON_PRIMARY);
    gtk_widget_add_controller(GTK_WIDGET(canvas), GTK_EVENT_CONTROLLER(drag));
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_press), canvas);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag), canvas);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_release), canvas);
}
