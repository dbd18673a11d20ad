/* The menu of graphs that a block can have; its entries are the action win.add-graph. No widget. */
#ifndef TINKER_GUI_GRAPH_MENU_H
#define TINKER_GUI_GRAPH_MENU_H

#include <gio/gio.h>

#include "scene/store/scene.h"

/* What stands in a record comes first, the rest in a submenu, then the phase plots. Empty where the block has no
 * graphs. (transfer full) */
GMenuModel *tinker_graph_menu_new(const TinkerBlockClass *block_class);

/* What else a graph of this scene could be over: time, frequency, and where all its curves are quantities of blocks of
 * one class the recorded quantities of those; entries of graph.against. (transfer full) */
GMenuModel *tinker_graph_over_menu_new(const TinkerScene *scene, const TinkerSceneGraph *graph);

/* Whether blocks of this class, which may be NULL, have quantities to graph. */
gboolean tinker_block_class_has_graphs(const TinkerBlockClass *block_class);

#endif
