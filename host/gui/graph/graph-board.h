/* What shows several of the scene's graphs and keeps up with it. How they are arranged is the subclasses':
 * graph-layer.h, graph-dock.h, graph-grid.h. */
#ifndef TINKER_GUI_GRAPH_BOARD_H
#define TINKER_GUI_GRAPH_BOARD_H

#include "gui/graph/graph-view.h"

#define TINKER_TYPE_GRAPH_BOARD (tinker_graph_board_get_type())
G_DECLARE_DERIVABLE_TYPE(TinkerGraphBoard, tinker_graph_board, TINKER, GRAPH_BOARD, GtkWidget)

struct _TinkerGraphBoardClass {
    GtkWidgetClass parent_class;
    gboolean floats;                                               /* its views do */
    gboolean (*shows)(const TinkerSceneGraph *graph);              /* which graphs belong here */
    void (*added)(TinkerGraphBoard *board, TinkerGraphView *view); /* a view is new; may be NULL */
};

/* Shows the graphs of this document. Takes references. */
void tinker_graph_board_set_player(TinkerGraphBoard *board, TinkerDocument *document, TinkerPlayer *player);

TinkerDocument *tinker_graph_board_document(TinkerGraphBoard *board);
TinkerPlayer *tinker_graph_board_player(TinkerGraphBoard *board);
/* The graph that a view shows. Borrowed, until the scene changes. */
const TinkerSceneGraph *tinker_graph_board_graph(TinkerGraphBoard *board, TinkerGraphView *view);

/* The views, in the order of the graphs. Borrowed. */
int tinker_graph_board_count(TinkerGraphBoard *board);
TinkerGraphView *tinker_graph_board_view(TinkerGraphBoard *board, int place);

#endif
