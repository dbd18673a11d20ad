/* While a graph is dragged, only its box on the screen changes; the scene takes it over at the end, as one step. The
 * layer itself is not there for the pointer: what does not hit a graph goes to the canvas. */
#include "gui/graph/graph-layer.h"

#include <math.h>

#include "gui/canvas/canvas-swept.h"
#include "gui/curve/graph-edit.h"
#include "gui/graph/graph-export.h"
#include "render/picture/painter.h"

#define LEAST_WIDTH  200.0 /* widget units: readable */
#define LEAST_HEIGHT 140.0
#define USUAL_WIDTH  340.0
#define USUAL_HEIGHT 230.0
#define NUDGE        10.0
#define BLOCK_GAP    4.0  /* widget units: what a new graph leaves free about the drawing of a block */
#define BAR_HEIGHT   64.0 /* widget units: likewise at the bottom, where the bar floats */

struct _TinkerGraphLayer {
    TinkerGraphBoard parent_instance;
    TinkerCanvas *canvas;
    TinkerSwept swept;

    TinkerGraphView *dragged; /* borrowed; NULL: none */
    gboolean sizes;           /* else it moves */
    double press[2];
    TinkerGraphBox start, box; /* of the one that is dragged: at the press, now */
};

G_DEFINE_FINAL_TYPE(TinkerGraphLayer, tinker_graph_layer, TINKER_TYPE_GRAPH_BOARD)

static gboolean floats(const TinkerSceneGraph *graph)
{
    return graph->has_place;
}

/* Places ----------------------------------------------------------------------------------------------------------- */

static double held(double length, double least, double most)
{
    return fmax(fmin(length, most), least);
}

/* A size in m on the screen: readable, and not larger than the canvas. */
static void size_on_screen(TinkerGraphLayer *layer, const double *size, TinkerGraphBox *box)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    box->width = round(held(size != NULL ? size[0] * view->scale : USUAL_WIDTH, LEAST_WIDTH, view->width));
    box->height = round(held(size != NULL ? size[1] * view->scale : USUAL_HEIGHT, LEAST_HEIGHT, view->height));
}

/* While the canvas shows all there is to see, of a graph, too, whose size has a least one, and rounding. */
static void keep_inside(TinkerGraphLayer *layer, TinkerGraphBox *box)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    const gboolean in_sight =
        box->x < view->width && box->y < view->height && box->x + box->width > 0 && box->y + box->height > 0;
    if (!in_sight || !tinker_canvas_is_fitted(layer->canvas)) return;
    box->x = held(box->x, 0, view->width - box->width);
    box->y = held(box->y, 0, view->height - box->height);
}

static TinkerGraphBox box_of(TinkerGraphLayer *layer, TinkerGraphView *graph_view)
{
    if (graph_view == layer->dragged) return layer->box;
    const TinkerSceneGraph *graph = tinker_graph_board_graph(TINKER_GRAPH_BOARD(layer), graph_view);
    TinkerGraphBox box;
    tinker_view_to_canvas(tinker_canvas_view(layer->canvas), graph->place[0], graph->place[1], &box.x, &box.y);
    box.x = round(box.x);
    box.y = round(box.y);
    size_on_screen(layer, graph->has_size ? graph->size : NULL, &box);
    keep_inside(layer, &box);
    return box;
}

static void tinker_graph_layer_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerGraphLayer *layer = TINKER_GRAPH_LAYER(widget);
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(widget);
    gtk_widget_queue_draw(GTK_WIDGET(layer->canvas)); /* names make way */
    for (int i = 0; i < tinker_graph_board_count(board); i++) {
        TinkerGraphView *view = tinker_graph_board_view(board, i);
        TinkerGraphBox box = box_of(layer, view);
        gboolean in_sight = box.x < width && box.y < height && box.x + box.width > 0 && box.y + box.height > 0;
        gtk_widget_set_child_visible(GTK_WIDGET(view), in_sight);
        if (!in_sight) continue;
        gtk_widget_measure(GTK_WIDGET(view), GTK_ORIENTATION_HORIZONTAL, -1, NULL, NULL, NULL, NULL);
        const GtkAllocation allocation = {(int)box.x, (int)box.y, (int)box.width, (int)box.height};
        gtk_widget_size_allocate(GTK_WIDGET(view), &allocation, -1);
    }
}

static gboolean tinker_graph_layer_contains(GtkWidget *widget, double x, double y)
{
    return FALSE;
}

/* Adds boxes of drawings in the world. */
static void add_drawings(const GArray *boxes, const TinkerView *view, GArray *taken)
{
    for (guint i = 0; i < boxes->len; i++) {
        const double *world = (const double *)(gpointer)boxes->data + 4 * (gsize)i;
        double left, top, right, bottom;
        tinker_view_to_canvas(view, world[0], world[3], &left, &top);
        tinker_view_to_canvas(view, world[2], world[1], &right, &bottom);
        TinkerGraphBox box = {left - BLOCK_GAP, top - BLOCK_GAP, right - left + 2 * BLOCK_GAP,
                              bottom - top + 2 * BLOCK_GAP};
        g_array_append_val(taken, box);
    }
}

/* And that of the fields in the corner. */
static void add_fields(TinkerFrame *frame, const TinkerView *view, GArray *taken)
{
    double reach[2];
    tinker_painter_fields_reach(frame, view, reach);
    const TinkerGraphBox box = {0, 0, reach[0] + BLOCK_GAP, reach[1] + BLOCK_GAP};
    if (reach[0] > 0) g_array_append_val(taken, box);
}

GArray *tinker_graph_layer_taken(TinkerGraphLayer *layer, TinkerFrame *frame)
{
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(layer);
    GArray *taken = g_array_new(FALSE, FALSE, sizeof(TinkerGraphBox));
    for (int i = 0; i < tinker_graph_board_count(board); i++) {
        TinkerGraphBox box = box_of(layer, tinker_graph_board_view(board, i));
        g_array_append_val(taken, box);
    }
    if (frame != NULL) {
        g_autoptr(GArray) boxes = tinker_painter_boxes(frame, tinker_canvas_view(layer->canvas));
        add_drawings(boxes, tinker_canvas_view(layer->canvas), taken);
        add_fields(frame, tinker_canvas_view(layer->canvas), taken);
    }
    return taken;
}

void tinker_graph_layer_add_swept(TinkerGraphLayer *layer, GArray *taken)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(layer);
    const GArray *boxes =
        tinker_swept_boxes(&layer->swept, tinker_graph_board_document(board), tinker_graph_board_player(board), view);
    add_drawings(boxes, view, taken);
}

void tinker_graph_layer_find_room(TinkerGraphLayer *layer, TinkerFrame *frame, const double *size, double place[2],
                                  double room[2])
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    g_autoptr(GArray) taken = tinker_graph_layer_taken(layer, frame);
    TinkerGraphBox box = {0};
    tinker_graph_layer_add_swept(layer, taken);
    size_on_screen(layer, size, &box);
    tinker_graph_find_room(&box, view->width, view->height - BAR_HEIGHT, (const TinkerGraphBox *)(gpointer)taken->data,
                           (int)taken->len);
    tinker_view_to_world(view, box.x, box.y, &place[0], &place[1]);
    room[0] = box.width / view->scale;
    room[1] = box.height / view->scale;
}

void tinker_graph_layer_draw_for_paper(TinkerGraphLayer *layer, cairo_t *cairo)
{
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(layer);
    for (int i = 0; i < tinker_graph_board_count(board); i++) {
        TinkerGraphView *view = tinker_graph_board_view(board, i);
        const TinkerGraphBox box = box_of(layer, view);
        cairo_save(cairo);
        cairo_translate(cairo, box.x, box.y);
        cairo_rectangle(cairo, 0, 0, box.width, box.height);
        cairo_clip(cairo);
        tinker_graph_draw_for_paper(tinker_graph_view_data(view), cairo, box.width, box.height);
        cairo_rectangle(cairo, 0, 0, box.width, box.height);
        cairo_set_source_rgb(cairo, 0.6, 0.6, 0.6);
        cairo_set_line_width(cairo, 2); /* the outer half is cut off */
        cairo_stroke(cairo);
        cairo_restore(cairo);
    }
}

/* Dragging --------------------------------------------------------------------------------------------------------- */

static void commit(TinkerGraphLayer *layer, TinkerGraphView *graph_view, const TinkerGraphBox *box, gboolean moved,
                   gboolean sized, const char *merge)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    double place[2], size[2] = {box->width / view->scale, box->height / view->scale};
    tinker_view_to_world(view, box->x, box->y, &place[0], &place[1]);
    tinker_graph_move(tinker_graph_board_document(TINKER_GRAPH_BOARD(layer)), tinker_graph_view_number(graph_view),
                      moved ? place : NULL, sized ? size : NULL, TRUE, merge);
}

/* The graph that a controller belongs to, whatever part of it that is. */
static TinkerGraphView *view_of(gpointer controller)
{
    GtkWidget *widget = gtk_event_controller_get_widget(controller);
    return TINKER_GRAPH_VIEW(TINKER_IS_GRAPH_VIEW(widget) ? widget
                                                          : gtk_widget_get_ancestor(widget, TINKER_TYPE_GRAPH_VIEW));
}

/* Where the pointer is on the layer: what it drags moves along with it. */
static void pointer_of(TinkerGraphLayer *layer, GtkGestureDrag *gesture, double dx, double dy, double place[2])
{
    double x, y;
    gtk_gesture_drag_get_start_point(gesture, &x, &y);
    GtkWidget *part = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture));
    gtk_widget_translate_coordinates(part, GTK_WIDGET(layer), x + dx, y + dy, &place[0], &place[1]);
}

static void on_drag_begin(GtkGestureDrag *gesture, double x, double y, TinkerGraphLayer *layer)
{
    TinkerGraphView *view = view_of(gesture);
    layer->start = layer->box = box_of(layer, view);
    layer->dragged = view;
    layer->sizes = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture)) == tinker_graph_view_corner(view);
    pointer_of(layer, gesture, 0, 0, layer->press);
}

static void on_drag_update(GtkGestureDrag *gesture, double dx, double dy, TinkerGraphLayer *layer)
{
    double pointer[2];
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    if (layer->dragged != view_of(gesture)) return;
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    pointer_of(layer, gesture, dx, dy, pointer);
    double way[2] = {round(pointer[0] - layer->press[0]), round(pointer[1] - layer->press[1])};
    if (layer->sizes) {
        layer->box.width = held(layer->start.width + way[0], LEAST_WIDTH, view->width);
        layer->box.height = held(layer->start.height + way[1], LEAST_HEIGHT, view->height);
    } else {
        layer->box.x =
            held(layer->start.x + way[0], LEAST_WIDTH / 2 - layer->start.width, view->width - LEAST_WIDTH / 2);
        layer->box.y = held(layer->start.y + way[1], 0, view->height - LEAST_HEIGHT / 4);
    }
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

static void on_drag_end(GtkGestureDrag *gesture, double dx, double dy, TinkerGraphLayer *layer)
{
    TinkerGraphView *view = view_of(gesture);
    if (layer->dragged != view) return;
    TinkerGraphBox start = layer->start, box = layer->box;
    layer->dragged = NULL;
    gboolean moved = box.x != start.x || box.y != start.y;
    gboolean sized = box.width != start.width || box.height != start.height;
    commit(layer, view, &box, moved, sized, NULL);
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

static void on_drag_cancel(GtkGesture *gesture, GdkEventSequence *sequence, TinkerGraphLayer *layer)
{
    layer->dragged = NULL;
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

/* In front at once; the scene learns of it when the button is let go, so that it is one step with a drag. */
static void on_pressed(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphLayer *layer)
{
    GtkWidget *view = gtk_event_controller_get_widget(GTK_EVENT_CONTROLLER(gesture));
    if (gtk_widget_get_next_sibling(view) != NULL) gtk_widget_insert_before(view, GTK_WIDGET(layer), NULL);
}

static void on_released(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphLayer *layer)
{
    commit(layer, view_of(gesture), &(TinkerGraphBox){0}, FALSE, FALSE, NULL);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerGraphLayer *layer)
{
    static const struct {
        guint key;
        int right, down;
    } ways[] = {{GDK_KEY_Left, -1, 0}, {GDK_KEY_Right, 1, 0}, {GDK_KEY_Up, 0, -1}, {GDK_KEY_Down, 0, 1}};
    for (gsize i = 0; i < G_N_ELEMENTS(ways); i++) {
        if (ways[i].key != key || (modifiers & GDK_CONTROL_MASK)) continue;
        gboolean sizes = (modifiers & GDK_SHIFT_MASK) != 0;
        TinkerGraphBox box = box_of(layer, view_of(controller));
        if (sizes) {
            box.width = fmax(box.width + NUDGE * ways[i].right, LEAST_WIDTH);
            box.height = fmax(box.height + NUDGE * ways[i].down, LEAST_HEIGHT);
        } else {
            box.x += NUDGE * ways[i].right;
            box.y += NUDGE * ways[i].down;
        }
        commit(layer, view_of(controller), &box, !sizes, sizes, "nudge graph");
        return GDK_EVENT_STOP;
    }
    return GDK_EVENT_PROPAGATE;
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void add_drag(TinkerGraphLayer *layer, GtkWidget *part)
{
    GtkGesture *drag = gtk_gesture_drag_new();
    g_signal_connect(drag, "drag-begin", G_CALLBACK(on_drag_begin), layer);
    g_signal_connect(drag, "drag-update", G_CALLBACK(on_drag_update), layer);
    g_signal_connect(drag, "drag-end", G_CALLBACK(on_drag_end), layer);
    g_signal_connect(drag, "cancel", G_CALLBACK(on_drag_cancel), layer);
    gtk_widget_add_controller(part, GTK_EVENT_CONTROLLER(drag));
}

static void added(TinkerGraphBoard *board, TinkerGraphView *view)
{
    add_drag(TINKER_GRAPH_LAYER(board), tinker_graph_view_title_bar(view));
    add_drag(TINKER_GRAPH_LAYER(board), tinker_graph_view_corner(view));
    GtkGesture *click = gtk_gesture_click_new();
    g_signal_connect(click, "pressed", G_CALLBACK(on_pressed), board);
    g_signal_connect(click, "released", G_CALLBACK(on_released), board);
    gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(click));
    GtkEventController *keys = gtk_event_controller_key_new();
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), board);
    gtk_widget_add_controller(GTK_WIDGET(view), keys);
}

static void add_panels(TinkerGraphLayer *layer, GArray *boxes)
{
    TinkerGraphBoard *board = TINKER_GRAPH_BOARD(layer);
    for (int i = 0; layer->canvas != NULL && i < tinker_graph_board_count(board); i++) {
        const TinkerGraphBox box = box_of(layer, tinker_graph_board_view(board, i));
        g_array_append_vals(boxes, ((double[]){box.x, box.y, box.x + box.width, box.y + box.height}), 1);
    }
}

void tinker_graph_layer_set_canvas(TinkerGraphLayer *layer, TinkerCanvas *canvas)
{
    layer->canvas = g_object_ref(canvas);
    g_signal_connect_object(canvas, "view-changed", G_CALLBACK(gtk_widget_queue_allocate), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(canvas, "panels", G_CALLBACK(add_panels), layer, G_CONNECT_SWAPPED);
}

static void tinker_graph_layer_dispose(GObject *object)
{
    g_clear_object(&TINKER_GRAPH_LAYER(object)->canvas);
    tinker_swept_clear(&TINKER_GRAPH_LAYER(object)->swept);
    G_OBJECT_CLASS(tinker_graph_layer_parent_class)->dispose(object);
}

static void tinker_graph_layer_class_init(TinkerGraphLayerClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_graph_layer_dispose;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_graph_layer_size_allocate;
    GTK_WIDGET_CLASS(class)->contains = tinker_graph_layer_contains;
    TINKER_GRAPH_BOARD_CLASS(class)->shows = floats;
    TINKER_GRAPH_BOARD_CLASS(class)->floats = TRUE;
    TINKER_GRAPH_BOARD_CLASS(class)->added = added;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "graph-layer");
}

static void tinker_graph_layer_init(TinkerGraphLayer *layer)
{
    gtk_widget_set_overflow(GTK_WIDGET(layer), GTK_OVERFLOW_HIDDEN);
}
