/* The graphs that float over the canvas: each keeps its place in the world. Dragging the title bar moves one, dragging
 * the lower right corner sizes it, a click brings it to the front; the arrow keys move it, and size it with Shift. */
#ifndef TINKER_GUI_GRAPH_LAYER_H
#define TINKER_GUI_GRAPH_LAYER_H

#include "gui/canvas/canvas.h"
#include "gui/graph/graph-board.h"

#define TINKER_TYPE_GRAPH_LAYER (tinker_graph_layer_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphLayer, tinker_graph_layer, TINKER, GRAPH_LAYER, TinkerGraphBoard)

/* Lies over this canvas. Takes a reference. To be called before tinker_graph_board_set_player. */
void tinker_graph_layer_set_canvas(TinkerGraphLayer *layer, TinkerCanvas *canvas);

/* Where a graph has room in what is seen now: covers other graphs, the blocks and their way in the run that is recorded
 * as little as can be. `size` (m) is the wanted one, or NULL. `place` and `room` are the answers, in m. */
void tinker_graph_layer_find_room(TinkerGraphLayer *layer, TinkerFrame *frame, const double *size, double place[2],
                                  double room[2]);

/* What of the layer is taken by graphs and by blocks, of TinkerGraphBox. The frame may be NULL. (transfer full) */
GArray *tinker_graph_layer_taken(TinkerGraphLayer *layer, TinkerFrame *frame);
/* Adds what blocks take of it on the way of the run that is recorded. */
void tinker_graph_layer_add_swept(TinkerGraphLayer *layer, GArray *taken);

/* Draws the graphs where they are on the canvas, for white paper. */
void tinker_graph_layer_draw_for_paper(TinkerGraphLayer *layer, cairo_t *cairo);

#endif
