/* All graphs of the scene, large, in one to three columns. */
#ifndef TINKER_GUI_GRAPH_GRID_H
#define TINKER_GUI_GRAPH_GRID_H

#include "gui/graph/graph-board.h"

#define TINKER_TYPE_GRAPH_GRID (tinker_graph_grid_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphGrid, tinker_graph_grid, TINKER, GRAPH_GRID, TinkerGraphBoard)

/* Before tinker_graph_board_set_player it shows nothing. (transfer floating) */
GtkWidget *tinker_graph_grid_new(void);

#endif
