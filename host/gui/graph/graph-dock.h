/* The docked graphs side by side, all equally wide. */
#ifndef TINKER_GUI_GRAPH_DOCK_H
#define TINKER_GUI_GRAPH_DOCK_H

#include "gui/graph/graph-board.h"

#define TINKER_TYPE_GRAPH_DOCK (tinker_graph_dock_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphDock, tinker_graph_dock, TINKER, GRAPH_DOCK, TinkerGraphBoard)

/* Before tinker_graph_board_set_player it shows nothing. (transfer floating) */
GtkWidget *tinker_graph_dock_new(void);

/* From now on it may be made lower than it was at first. */
void tinker_graph_dock_settle(TinkerGraphDock *dock);

#endif
