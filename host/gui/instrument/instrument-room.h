/* What instruments on the canvas keep clear of, and where one has room beside it. */
#ifndef TINKER_GUI_INSTRUMENT_ROOM_H
#define TINKER_GUI_INSTRUMENT_ROOM_H

#include "gui/curve/graph-edit.h"
#include "gui/graph/graph-layer.h"

/* Boxes of graphs, of blocks, and of what blocks take on the way of a run, as they were looked up last: of
 * TinkerGraphBox. */
typedef struct {
    GArray *graphs, *blocks, *swept;
} InstrumentRoom;

void instrument_room_init(InstrumentRoom *room);
void instrument_room_clear(InstrumentRoom *room);

void instrument_room_look_for_graphs(InstrumentRoom *room, TinkerGraphLayer *graphs);
/* Where blocks are in this frame (may be NULL), and on the way of the run that is recorded; or, where they do not
 * count, none. */
void instrument_room_look_for_blocks(InstrumentRoom *room, TinkerGraphLayer *graphs, TinkerFrame *frame,
                                     gboolean they_count);

/* Moves a box to the nearest place in an area of this size that is clear of graphs, of `others` (TinkerGraphBox), of
 * notices, which cover so much of the top, of blocks and their ways: of as many of these, in this order, as there is
 * room for. */
void instrument_room_make_way(const InstrumentRoom *room, gboolean blocks_count, const GArray *others, double width,
                              double height, double covered, TinkerGraphBox *box);

#endif
