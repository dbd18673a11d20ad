/* After every change of the scene the views are brought in line with its instruments. The layer itself is not there for
 * the pointer. */
#include "gui/instrument/instrument-layer.h"

#include <math.h>

#include "gui/curve/graph-edit.h"
#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-room.h"
#include "gui/instrument/instrument-view.h"
#include "gui/widget/unparent.h"
#include "render/picture/painter.h"

#define USUAL_WIDTH  210.0 /* widget units: what is looked for as room for a new one */
#define USUAL_HEIGHT 104.0
#define FULL_HEIGHT  150.0 /* of a knob, which any control can become, about that of a dial, which any meter can */
#define BAR_HEIGHT   64.0  /* likewise at the bottom, where a bar may float */
#define NUDGE        10.0
#define EDGE         4.0
#define ROOMY_WIDTH  560.0 /* widget units of a canvas on which they have their full size, */
#define ROOMY_HEIGHT 320.0
#define LEAST_SIZE   0.7 /* and how small they may become: readable */

struct _TinkerInstrumentLayer {
    GtkWidget parent_instance;
    TinkerCanvas *canvas;
    TinkerGraphLayer *graphs;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerHand *hand;
    GPtrArray *views;        /* of TinkerInstrumentView, which are children: borrowed */
    GArray *boxes;           /* of TinkerGraphBox: where these are */
    InstrumentRoom room;     /* what they keep clear of: of blocks on a small canvas alone */
    gboolean has_looked;     /* that is up to date */
    TinkerPlayerState state; /* of the player when it was heard of last */
    gboolean awaits_run;     /* which began since, and whose way is not known yet */

    TinkerInstrumentView *dragged; /* borrowed; NULL: none */
    double press[2], from[2], way[2];
};

G_DEFINE_FINAL_TYPE(TinkerInstrumentLayer, tinker_instrument_layer, GTK_TYPE_WIDGET)

static const TinkerSceneInstrument *instrument_of(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    return g_ptr_array_index(tinker_scene_instruments(tinker_document_scene(layer->document)),
                             (guint)tinker_instrument_view_number(view));
}

/* Places ----------------------------------------------------------------------------------------------------------- */

/* On a small canvas they are smaller, so that they leave something of it to be seen. */
static double shrinkage(TinkerInstrumentLayer *layer)
{
    const double width = gtk_widget_get_width(GTK_WIDGET(layer)), height = gtk_widget_get_height(GTK_WIDGET(layer));
    return CLAMP(fmin(width / ROOMY_WIDTH, height / ROOMY_HEIGHT), LEAST_SIZE, 1);
}

static double below_fields(TinkerInstrumentLayer *layer)
{
    TinkerFrame *frame = tinker_player_frame(layer->player);
    double reach[2] = {0};
    if (frame != NULL) tinker_painter_fields_reach(frame, tinker_canvas_view(layer->canvas), reach);
    return reach[1] + EDGE;
}

/* Where it is wanted: always within the layer, however the canvas is looked at. One without a place stands at the left,
 * below the fields. */
static TinkerGraphBox wanted_box(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    const TinkerSceneInstrument *instrument = instrument_of(layer, view);
    GtkRequisition natural;
    gtk_widget_get_preferred_size(GTK_WIDGET(view), NULL, &natural);
    TinkerGraphBox box = {EDGE, 0, shrinkage(layer) * natural.width, shrinkage(layer) * natural.height};
    if (view == layer->dragged) {
        box.x = layer->from[0] + layer->way[0];
        box.y = layer->from[1] + layer->way[1];
    } else if (instrument->has_place) {
        tinker_view_to_canvas(tinker_canvas_view(layer->canvas), instrument->place[0], instrument->place[1], &box.x,
                              &box.y);
    } else {
        box.y = below_fields(layer) + tinker_instrument_view_number(view) * (USUAL_HEIGHT + EDGE);
    }
    box.x = fmax(fmin(round(box.x), gtk_widget_get_width(GTK_WIDGET(layer)) - box.width - EDGE), EDGE);
    box.y = fmax(fmin(round(box.y), gtk_widget_get_height(GTK_WIDGET(layer)) - box.height - EDGE), EDGE);
    return box;
}

/* What is in the way is asked for when everything that shows the scene has caught up with it. */
static void look_again(TinkerInstrumentLayer *layer)
{
    layer->has_looked = FALSE;
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

/* Whether there is a view of each instrument that the scene has by now: an edit is told to others before. */
static gboolean has_caught_up(TinkerInstrumentLayer *layer)
{
    return layer->views->len == tinker_scene_instruments(tinker_document_scene(layer->document))->len;
}

/* Whether one keeps clear of blocks and their ways. */
static gboolean keeps_clear(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    return shrinkage(layer) < 1 || instrument_of(layer, view)->makes_way;
}

static void look_for_blocks(TinkerInstrumentLayer *layer)
{
    gboolean any = FALSE;
    for (guint i = 0; i < layer->views->len; i++)
        any |= keeps_clear(layer, g_ptr_array_index(layer->views, i));
    instrument_room_look_for_blocks(&layer->room, layer->graphs, tinker_player_frame(layer->player), any);
}

/* Graphs stand in the way. Where instruments are smaller than they were put there, since the canvas is small, blocks do
 * as well: where they are when one begins to look, and where they come in the run, as soon as that is known. So they do
 * for one whose place was chosen before a run: nobody wanted it in the way. Instruments do not run away from what
 * moves. */
static void look_about(TinkerInstrumentLayer *layer)
{
    if (layer->has_looked || layer->views->len == 0) return;
    layer->has_looked = TRUE;
    instrument_room_look_for_graphs(&layer->room, layer->graphs);
    if (layer->state != TINKER_PLAYER_PLAYING) look_for_blocks(layer);
}

/* The way of a run is known when it is recorded, ahead of what is shown; of a long one, where it is halted. */
static void on_moved(TinkerInstrumentLayer *layer)
{
    TinkerRunStatus status;
    if (!layer->awaits_run || !has_caught_up(layer) || !tinker_player_status(layer->player, &status)) return;
    if (layer->state == TINKER_PLAYER_PLAYING && !status.finished) return;
    layer->awaits_run = FALSE;
    look_for_blocks(layer);
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

static void on_state_changed(TinkerInstrumentLayer *layer)
{
    const TinkerPlayerState before = layer->state;
    layer->state = tinker_player_state(layer->player);
    if (before == TINKER_PLAYER_SETUP) layer->awaits_run = layer->state == TINKER_PLAYER_PLAYING;
    on_moved(layer);
}

/* Out of the way of those before it, but for one that is dragged, of notices and of what is about; and no lower than
 * where a bar may float, unless it was put there. */
static void make_way(TinkerInstrumentLayer *layer, TinkerInstrumentView *view, TinkerGraphBox *box)
{
    const double width = gtk_widget_get_width(GTK_WIDGET(layer)), height = gtk_widget_get_height(GTK_WIDGET(layer));
    const double bottom = box->y + box->height <= height - BAR_HEIGHT ? height - BAR_HEIGHT : height;
    g_autoptr(GArray) others = g_array_new(FALSE, FALSE, sizeof(TinkerGraphBox));
    for (guint i = 0; i < layer->boxes->len; i++)
        if (g_ptr_array_index(layer->views, i) != layer->dragged)
            g_array_append_val(others, g_array_index(layer->boxes, TinkerGraphBox, i));
    instrument_room_make_way(&layer->room, keeps_clear(layer, view), others, width, bottom,
                             tinker_canvas_covered(layer->canvas), box);
}

/* The boxes of all, in order. One that is dragged goes where the pointer takes it, and the others stay until it is
 * there. */
static void arrange(TinkerInstrumentLayer *layer)
{
    look_about(layer);
    g_array_set_size(layer->boxes, 0);
    for (guint i = 0; i < layer->views->len; i++) {
        TinkerInstrumentView *view = g_ptr_array_index(layer->views, i);
        TinkerGraphBox box = wanted_box(layer, view);
        if (view != layer->dragged) make_way(layer, view, &box);
        g_array_append_val(layer->boxes, box);
    }
}

static TinkerGraphBox box_of(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    return g_array_index(layer->boxes, TinkerGraphBox, tinker_instrument_view_number(view));
}

static void tinker_instrument_layer_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerInstrumentLayer *layer = TINKER_INSTRUMENT_LAYER(widget);
    arrange(layer);
    gtk_widget_queue_draw(GTK_WIDGET(layer->canvas)); /* names make way */
    for (guint i = 0; i < layer->views->len; i++) {
        GtkWidget *view = g_ptr_array_index(layer->views, i);
        const float factor = (float)shrinkage(layer);
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        GskTransform *there = gsk_transform_translate(NULL, &GRAPHENE_POINT_INIT((float)box.x, (float)box.y));
        gtk_widget_allocate(view, (int)round(box.width / factor), (int)round(box.height / factor), -1,
                            gsk_transform_scale(there, factor, factor));
    }
}

static gboolean tinker_instrument_layer_contains(GtkWidget *widget, double x, double y)
{
    return FALSE;
}

void tinker_instrument_layer_find_room(TinkerInstrumentLayer *layer, TinkerInstrumentPlace *place)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    const double full = shrinkage(layer) * FULL_HEIGHT;
    TinkerGraphBox box = {.width = shrinkage(layer) * USUAL_WIDTH, .height = full};
    g_autoptr(GArray) taken = tinker_graph_layer_taken(layer->graphs, tinker_player_frame(layer->player));
    tinker_graph_layer_add_swept(layer->graphs, taken);
    place->makes_way = !(tinker_player_reached(layer->player) > 0);
    arrange(layer);
    for (guint i = 0; i < layer->boxes->len; i++) {
        TinkerGraphBox other = g_array_index(layer->boxes, TinkerGraphBox, i);
        other.height = fmax(other.height, full);
        g_array_append_val(taken, other);
    }
    tinker_graph_find_room(&box, view->width, view->height - BAR_HEIGHT, (const TinkerGraphBox *)(gpointer)taken->data,
                           (int)taken->len);
    tinker_view_to_world(view, box.x, box.y, &place->at[0], &place->at[1]);
}

void tinker_instrument_layer_draw(TinkerInstrumentLayer *layer, cairo_t *cairo)
{
    arrange(layer);
    for (guint i = 0; i < layer->views->len; i++) {
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        g_autoptr(GdkPaintable) seen = gtk_widget_paintable_new(g_ptr_array_index(layer->views, i));
        GtkSnapshot *snapshot = gtk_snapshot_new();
        gdk_paintable_snapshot(seen, snapshot, box.width / shrinkage(layer), box.height / shrinkage(layer));
        GskRenderNode *node = gtk_snapshot_free_to_node(snapshot);
        if (node == NULL) continue;
        cairo_save(cairo);
        cairo_translate(cairo, box.x, box.y);
        cairo_scale(cairo, shrinkage(layer), shrinkage(layer));
        gsk_render_node_draw(node, cairo);
        cairo_restore(cairo);
        gsk_render_node_unref(node);
    }
}

static void add_panels(TinkerInstrumentLayer *layer, GArray *boxes)
{
    for (guint i = 0; layer->boxes != NULL && i < layer->boxes->len; i++) {
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        g_array_append_vals(boxes, ((double[]){box.x, box.y, box.x + box.width, box.y + box.height}), 1);
    }
}

/* Moving ----------------------------------------------------------------------------------------------------------- */

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
    const TinkerGraphBox box = box_of(layer, view_of(gesture));
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
    const TinkerGraphBox box = wanted_box(layer, view);
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
    const TinkerGraphBox box = wanted_box(layer, view_of(controller)); /* also where it is not, to pass others */
    commit(layer, view_of(controller), box.x + NUDGE * right, box.y + NUDGE * down, "nudge instrument");
    return GDK_EVENT_STOP;
}

/* Keeping up ------------------------------------------------------------------------------------------------------- */

static TinkerInstrumentView *view_new(TinkerInstrumentLayer *layer, int number)
{
    TinkerInstrumentView *view = tinker_instrument_view_new(layer->document, layer->player, layer->hand, number);
    gtk_widget_set_parent(GTK_WIDGET(view), GTK_WIDGET(layer));
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), layer);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), layer);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_drag_end), layer);
    gtk_widget_add_controller(tinker_instrument_view_bar(view), GTK_EVENT_CONTROLLER(drag));
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), layer);
    gtk_widget_add_controller(GTK_WIDGET(view), keys);
    return view;
}

/* The first of the old ones that fits, or a new one. */
static TinkerInstrumentView *view_for(TinkerInstrumentLayer *layer, GPtrArray *old, int number)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(layer->document));
    for (guint i = 0; i < old->len; i++)
        if (tinker_instrument_view_fits(g_ptr_array_index(old, i), g_ptr_array_index(all, (guint)number)))
            return g_ptr_array_steal_index(old, i);
    return view_new(layer, number);
}

static void on_changed(TinkerInstrumentLayer *layer)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(layer->document));
    g_autoptr(GPtrArray) old = g_steal_pointer(&layer->views);
    layer->views = g_ptr_array_new();
    for (guint i = 0; i < all->len; i++) {
        TinkerInstrumentView *view = view_for(layer, old, (int)i);
        tinker_instrument_view_set_number(view, (int)i);
        g_ptr_array_add(layer->views, view);
    }
    for (guint i = 0; i < old->len; i++) {
        if (g_ptr_array_index(old, i) == layer->dragged) layer->dragged = NULL;
        gtk_widget_unparent(g_ptr_array_index(old, i));
    }
    gtk_widget_set_visible(GTK_WIDGET(layer), layer->views->len > 0);
    look_again(layer);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_instrument_layer_dispose(GObject *object)
{
    TinkerInstrumentLayer *layer = TINKER_INSTRUMENT_LAYER(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_pointer(&layer->views, g_ptr_array_unref);
    g_clear_pointer(&layer->boxes, g_array_unref);
    instrument_room_clear(&layer->room);
    g_clear_pointer(&layer->hand, tinker_hand_free);
    g_clear_object(&layer->canvas);
    g_clear_object(&layer->graphs);
    g_clear_object(&layer->player);
    g_clear_object(&layer->document);
    G_OBJECT_CLASS(tinker_instrument_layer_parent_class)->dispose(object);
}

static void tinker_instrument_layer_class_init(TinkerInstrumentLayerClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_instrument_layer_dispose;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_instrument_layer_size_allocate;
    GTK_WIDGET_CLASS(class)->contains = tinker_instrument_layer_contains;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "instrument-layer");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_instrument_layer_init(TinkerInstrumentLayer *layer)
{
    layer->views = g_ptr_array_new();
    layer->boxes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphBox));
    instrument_room_init(&layer->room);
    gtk_widget_set_overflow(GTK_WIDGET(layer), GTK_OVERFLOW_HIDDEN);
}

GtkWidget *tinker_instrument_layer_new(TinkerCanvas *canvas, TinkerGraphLayer *graphs, TinkerDocument *document,
                                       TinkerPlayer *player)
{
    TinkerInstrumentLayer *layer = g_object_new(TINKER_TYPE_INSTRUMENT_LAYER, NULL);
    layer->canvas = g_object_ref(canvas);
    layer->graphs = g_object_ref(graphs);
    layer->document = g_object_ref(document);
    layer->player = g_object_ref(player);
    layer->hand = tinker_hand_new(document, player);
    g_signal_connect_object(canvas, "view-changed", G_CALLBACK(look_again), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(canvas, "panels", G_CALLBACK(add_panels), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_state_changed), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), layer, G_CONNECT_SWAPPED);
    on_changed(layer);
    return GTK_WIDGET(layer);
}
