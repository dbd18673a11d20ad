/* A place is taken by a press, and the next by letting go after a drag, or by another press. By keys: Tab goes from
 * point to point of the bodies, arrows move by the grid, Return takes the place. */
#include "gui/instrument/measure-layer.h"

#include <math.h>
#include <string.h>

#include "gui/instrument/measure-drawing.h"

#define REACH     12.0 /* widget units: how near to a point of a body is on it */
#define THRESHOLD 4.0  /* widget units: what is less is no drag */

struct _TinkerMeasureLayer {
    GtkWidget parent_instance;
    TinkerCanvas *canvas;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerMeasuring measuring; /* what is taken */
    TinkerSceneEnd next;       /* what is pointed at */
    gboolean has_next;
    double press[2];
    gboolean by_key; /* places are chosen by keys, until the pointer is moved */
    double rest[2];  /* widget units of the window: where the pointer lies meanwhile; NAN: not known */
    int point;       /* of a body, that Tab has come to */
};

G_DEFINE_FINAL_TYPE(TinkerMeasureLayer, tinker_measure_layer, GTK_TYPE_WIDGET)

enum { MEASURED, PUT_AWAY, SIGNALS };
static guint signals[SIGNALS];

static gboolean is_whole(const TinkerMeasureLayer *layer)
{
    return layer->measuring.count == tinker_measuring_whole(layer->measuring.kind);
}

TinkerMeasuring tinker_measure_layer_measuring(TinkerMeasureLayer *layer)
{
    TinkerMeasuring measuring = layer->measuring;
    if (!is_whole(layer) && layer->has_next && measuring.count > 0) measuring.ends[measuring.count++] = layer->next;
    return measuring;
}

static void tell(TinkerMeasureLayer *layer)
{
    gtk_widget_queue_draw(GTK_WIDGET(layer));
    g_signal_emit(layer, signals[MEASURED], 0);
}

void tinker_measure_layer_begin(TinkerMeasureLayer *layer, TinkerMeasuringKind kind)
{
    layer->measuring = (TinkerMeasuring){.kind = kind};
    layer->by_key = FALSE;
    layer->has_next = FALSE;
    layer->point = -1;
    tell(layer);
}

/* Places ----------------------------------------------------------------------------------------------------------- */

static double grid_of(TinkerMeasureLayer *layer)
{
    const TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(layer->document));
    return head->canvas_snap ? head->canvas_grid : 0;
}

static void point_at(TinkerMeasureLayer *layer, double x, double y, GdkModifierType modifiers)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    TinkerFrame *frame = tinker_player_frame(layer->player);
    double world[2];
    if (frame == NULL) return;
    tinker_view_to_world(view, x, y, &world[0], &world[1]);
    const gboolean free = (modifiers & GDK_ALT_MASK) != 0;
    layer->next =
        tinker_measuring_snap(frame, world[0], world[1], free ? 0 : REACH / view->scale, free ? 0 : grid_of(layer));
    layer->has_next = TRUE;
}

static void take(TinkerMeasureLayer *layer)
{
    if (!layer->has_next) return;
    if (is_whole(layer)) layer->measuring.count = 0;
    layer->measuring.ends[layer->measuring.count++] = layer->next;
    layer->has_next = FALSE;
}

static void on_press(GtkGestureDrag *gesture, double x, double y, TinkerMeasureLayer *layer)
{
    layer->by_key = FALSE;
    gtk_widget_grab_focus(GTK_WIDGET(layer));
    layer->press[0] = x;
    layer->press[1] = y;
    point_at(layer, x, y, gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture)));
    take(layer);
    tell(layer);
}

static void on_drag(GtkGestureDrag *gesture, double dx, double dy, TinkerMeasureLayer *layer)
{
    if (is_whole(layer) || hypot(dx, dy) < THRESHOLD) return;
    point_at(layer, layer->press[0] + dx, layer->press[1] + dy,
             gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(gesture)));
    tell(layer);
}

static void on_release(GtkGestureDrag *gesture, double dx, double dy, TinkerMeasureLayer *layer)
{
    on_drag(gesture, dx, dy, layer);
    if (!is_whole(layer) && hypot(dx, dy) >= THRESHOLD) take(layer);
    tell(layer);
}

/* A pointer that lies still is told of anew where what is below it has moved, as when the bar of the tool grows: it
 * would take away what a key has chosen. */
static gboolean rests(GtkEventController *controller, TinkerMeasureLayer *layer)
{
    double at[2] = {0, 0};
    GdkEvent *event = gtk_event_controller_get_current_event(controller);
    if (!layer->by_key || event == NULL || !gdk_event_get_position(event, &at[0], &at[1])) return FALSE;
    if (isnan(layer->rest[0])) memcpy(layer->rest, at, sizeof at);
    layer->by_key = hypot(at[0] - layer->rest[0], at[1] - layer->rest[1]) < THRESHOLD;
    return layer->by_key;
}

static void on_motion(GtkEventControllerMotion *controller, double x, double y, TinkerMeasureLayer *layer)
{
    if (is_whole(layer) || rests(GTK_EVENT_CONTROLLER(controller), layer)) return;
    point_at(layer, x, y, gtk_event_controller_get_current_event_state(GTK_EVENT_CONTROLLER(controller)));
    tell(layer);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

static gboolean go_to_point(TinkerMeasureLayer *layer, int way)
{
    g_autoptr(GArray) points = tinker_measuring_points(tinker_document_scene(layer->document));
    const int count = (int)points->len;
    if (count == 0) return GDK_EVENT_PROPAGATE;
    layer->point = ((MAX(layer->point, way > 0 ? -1 : 0) + way) % count + count) % count;
    layer->next = g_array_index(points, TinkerSceneEnd, layer->point);
    layer->has_next = TRUE;
    tell(layer);
    return GDK_EVENT_STOP;
}

static gboolean nudge(TinkerMeasureLayer *layer, int right, int up)
{
    TinkerFrame *frame = tinker_player_frame(layer->player);
    const double step = fmax(grid_of(layer), 1e-9 + 4 / tinker_canvas_view(layer->canvas)->scale);
    double place[2] = {0, 0};
    if (frame == NULL) return GDK_EVENT_PROPAGATE;
    if (layer->has_next) tinker_frame_end(frame, layer->next, place);
    layer->next = (TinkerSceneEnd){TINKER_NO_BLOCK, place[0] + right * step, place[1] + up * step};
    layer->has_next = TRUE;
    tell(layer);
    return GDK_EVENT_STOP;
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerMeasureLayer *layer)
{
    if (modifiers & GDK_CONTROL_MASK) return GDK_EVENT_PROPAGATE;
    if (!layer->by_key) layer->rest[0] = NAN;
    layer->by_key = TRUE;
    switch (key) {
    case GDK_KEY_Tab:
        return go_to_point(layer, 1);
    case GDK_KEY_ISO_Left_Tab:
        return go_to_point(layer, -1);
    case GDK_KEY_Left:
        return nudge(layer, -1, 0);
    case GDK_KEY_Right:
        return nudge(layer, 1, 0);
    case GDK_KEY_Up:
        return nudge(layer, 0, 1);
    case GDK_KEY_Down:
        return nudge(layer, 0, -1);
    case GDK_KEY_Return:
        take(layer);
        tell(layer);
        return GDK_EVENT_STOP;
    case GDK_KEY_Escape:
        g_signal_emit(layer, signals[PUT_AWAY], 0);
        return GDK_EVENT_STOP;
    default:
        return GDK_EVENT_PROPAGATE;
    }
}

static void tinker_measure_layer_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    TinkerMeasureLayer *layer = TINKER_MEASURE_LAYER(widget);
    TinkerFrame *frame = tinker_player_frame(layer->player);
    const TinkerMeasuring measuring = tinker_measure_layer_measuring(layer);
    const int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    cairo_t *cairo = gtk_snapshot_append_cairo(snapshot, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    if (frame != NULL) tinker_measuring_draw(&measuring, frame, tinker_canvas_view(layer->canvas), widget, cairo);
    cairo_destroy(cairo);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void on_edited(TinkerMeasureLayer *layer)
{
    TinkerScene *scene = tinker_document_scene(layer->document);
    for (int i = 0; i < layer->measuring.count; i++) {
        const TinkerBlockId block = layer->measuring.ends[i].block;
        if (block != TINKER_NO_BLOCK && !tinker_scene_has_block(scene, block)) layer->measuring.count = 0;
    }
    layer->has_next = FALSE;
    tell(layer);
}

static void on_replaced(TinkerMeasureLayer *layer)
{
    tinker_measure_layer_begin(layer, layer->measuring.kind);
}

static void tinker_measure_layer_dispose(GObject *object)
{
    TinkerMeasureLayer *layer = TINKER_MEASURE_LAYER(object);
    g_clear_object(&layer->canvas);
    g_clear_object(&layer->document);
    g_clear_object(&layer->player);
    G_OBJECT_CLASS(tinker_measure_layer_parent_class)->dispose(object);
}

static void tinker_measure_layer_class_init(TinkerMeasureLayerClass *class)
{
    static const char *const names[SIGNALS] = {"measured", "put-away"};
    G_OBJECT_CLASS(class)->dispose = tinker_measure_layer_dispose;
    GTK_WIDGET_CLASS(class)->snapshot = tinker_measure_layer_snapshot;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "measurelayer");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
    for (int i = 0; i < SIGNALS; i++)
        signals[i] =
            g_signal_new(names[i], TINKER_TYPE_MEASURE_LAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_measure_layer_init(TinkerMeasureLayer *layer)
{
    GtkWidget *widget = GTK_WIDGET(layer);
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_press), layer);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag), layer);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_release), layer);
    gtk_widget_add_controller(widget, GTK_EVENT_CONTROLLER(drag));
    GtkEventController *motion = gtk_event_controller_motion_new(), *keys = gtk_event_controller_key_new();
    g_signal_connect(motion, "motion", G_CALLBACK(on_motion), layer);
    gtk_widget_add_controller(widget, motion);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), layer);
    gtk_widget_add_controller(widget, keys);
    gtk_widget_set_focusable(widget, TRUE);
    gtk_widget_set_cursor_from_name(widget, "crosshair");
    gtk_widget_set_visible(widget, FALSE);
}

TinkerMeasureLayer *tinker_measure_layer_new(TinkerCanvas *canvas, TinkerDocument *document, TinkerPlayer *player)
{
    TinkerMeasureLayer *layer = g_object_new(TINKER_TYPE_MEASURE_LAYER, NULL);
    layer->canvas = g_object_ref(canvas);
    layer->document = g_object_ref(document);
    layer->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_edited), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(tell), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(canvas, "view-changed", G_CALLBACK(gtk_widget_queue_draw), layer, G_CONNECT_SWAPPED);
    return layer;
}
