/* Boxes in one list, those that matter most first: where not all leave room, the last ones are left out. */
#include "gui/instrument/instrument-room.h"

static GArray *boxes_new(void)
{
    return g_array_new(FALSE, FALSE, sizeof(TinkerGraphBox));
}

void instrument_room_init(InstrumentRoom *room)
{
    room->graphs = boxes_new();
    room->blocks = boxes_new();
    room->swept = boxes_new();
}

void instrument_room_clear(InstrumentRoom *room)
{
    g_clear_pointer(&room->graphs, g_array_unref);
    g_clear_pointer(&room->blocks, g_array_unref);
    g_clear_pointer(&room->swept, g_array_unref);
}

void instrument_room_look_for_graphs(InstrumentRoom *room, TinkerGraphLayer *graphs)
{
    g_array_unref(room->graphs);
    room->graphs = tinker_graph_layer_taken(graphs, NULL);
}

void instrument_room_look_for_blocks(InstrumentRoom *room, TinkerGraphLayer *graphs, TinkerFrame *frame,
                                     gboolean they_count)
{
    g_array_set_size(room->blocks, 0);
    g_array_set_size(room->swept, 0);
    if (!they_count) return;
    g_array_unref(room->blocks);
    room->blocks = tinker_graph_layer_taken(graphs, frame);
    tinker_graph_layer_add_swept(graphs, room->swept);
}

void instrument_room_make_way(const InstrumentRoom *room, gboolean blocks_count, const GArray *others, double width,
                              double height, double covered, TinkerGraphBox *box)
{
    const TinkerGraphBox notices = {.width = width, .height = covered};
    g_autoptr(GArray) taken = g_array_copy(room->graphs);
    g_array_append_vals(taken, others->data, others->len);
    guint counts[4] = {[3] = taken->len};
    if (covered > 0) g_array_append_val(taken, notices);
    counts[2] = taken->len;
    if (blocks_count) g_array_append_vals(taken, room->blocks->data, room->blocks->len);
    counts[1] = taken->len;
    if (blocks_count) g_array_append_vals(taken, room->swept->data, room->swept->len);
    counts[0] = taken->len;
    const TinkerGraphBox *all = (const TinkerGraphBox *)(gpointer)taken->data;
    for (gsize i = 0; i < G_N_ELEMENTS(counts); i++)
        if (tinker_graph_move_to_room(box, width, height, all, (int)counts[i])) return;
}
