/* Where controls and meters are: at their places in the world as far as that can be seen, out of the way of what is
 * about. */
#include <math.h>

#include "gui/curve/graph-edit.h"
#include "gui/instrument/instrument-layer-private.h"
#include "render/picture/painter.h"

#define USUAL_WIDTH  210.0 /* widget units: what is looked for as room for a new one */
#define USUAL_HEIGHT 104.0
#define FULL_HEIGHT  150.0 /* of a knob, which any control can become, about that of a dial, which any meter can */
#define BAR_HEIGHT   64.0  /* likewise at the bottom, where a bar may float */
#define EDGE         4.0
#define ROOMY_WIDTH  560.0 /* widget units of a canvas on which they have their full size, */
#define ROOMY_HEIGHT 320.0
#define LEAST_SIZE   0.7 /* and how small they may become: readable */

static const TinkerSceneInstrument *instrument_of(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    return g_ptr_array_index(tinker_scene_instruments(tinker_document_scene(layer->document)),
                             (guint)tinker_instrument_view_number(view));
}

double instrument_layer_shrinkage(TinkerInstrumentLayer *layer)
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

TinkerGraphBox instrument_layer_wanted_box(TinkerInstrumentLayer *layer, TinkerInstrumentView *view)
{
    const TinkerSceneInstrument *instrument = instrument_of(layer, view);
    GtkRequisition natural;
    gtk_widget_get_preferred_size(GTK_WIDGET(view), NULL, &natural);
    TinkerGraphBox box = {EDGE, 0, instrument_layer_shrinkage(layer) * natural.width,
                          instrument_layer_shrinkage(layer) * natural.height};
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

void instrument_layer_look_again(TinkerInstrumentLayer *layer)
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
    return instrument_layer_shrinkage(layer) < 1 || instrument_of(layer, view)->makes_way;
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
void instrument_layer_on_moved(TinkerInstrumentLayer *layer)
{
    TinkerRunStatus status;
    if (!layer->awaits_run || !has_caught_up(layer) || !tinker_player_status(layer->player, &status)) return;
    if (layer->state == TINKER_PLAYER_PLAYING && !status.finished) return;
    layer->awaits_run = FALSE;
    look_for_blocks(layer);
    gtk_widget_queue_allocate(GTK_WIDGET(layer));
}

void instrument_layer_on_state_changed(TinkerInstrumentLayer *layer)
{
    const TinkerPlayerState before = layer->state;
    layer->state = tinker_player_state(layer->player);
    if (before == TINKER_PLAYER_SETUP) layer->awaits_run = layer->state == TINKER_PLAYER_PLAYING;
    instrument_layer_on_moved(layer);
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

void instrument_layer_arrange(TinkerInstrumentLayer *layer)
{
    look_about(layer);
    g_array_set_size(layer->boxes, 0);
    for (guint i = 0; i < layer->views->len; i++) {
        TinkerInstrumentView *view = g_ptr_array_index(layer->views, i);
        TinkerGraphBox box = instrument_layer_wanted_box(layer, view);
        if (view != layer->dragged) make_way(layer, view, &box);
        g_array_append_val(layer->boxes, box);
    }
}

void tinker_instrument_layer_find_room(TinkerInstrumentLayer *layer, TinkerInstrumentPlace *place)
{
    const TinkerView *view = tinker_canvas_view(layer->canvas);
    const double full = instrument_layer_shrinkage(layer) * FULL_HEIGHT;
    TinkerGraphBox box = {.width = instrument_layer_shrinkage(layer) * USUAL_WIDTH, .height = full};
    g_autoptr(GArray) taken = tinker_graph_layer_taken(layer->graphs, tinker_player_frame(layer->player));
    tinker_graph_layer_add_swept(layer->graphs, taken);
    place->makes_way = !(tinker_player_reached(layer->player) > 0);
    instrument_layer_arrange(layer);
    for (guint i = 0; i < layer->boxes->len; i++) {
        TinkerGraphBox other = g_array_index(layer->boxes, TinkerGraphBox, i);
        other.height = fmax(other.height, full);
        g_array_append_val(taken, other);
    }
    tinker_graph_find_room(&box, view->width, view->height - BAR_HEIGHT, (const TinkerGraphBox *)(gpointer)taken->data,
                           (int)taken->len);
    tinker_view_to_world(view, box.x, box.y, &place->at[0], &place->at[1]);
}
