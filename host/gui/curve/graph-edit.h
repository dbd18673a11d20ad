/* Adding, moving and removing graphs: each one step for undo. And where a new one has room. No widget.
 *
 * A graph is known by its number in tinker_scene_graphs, whose order is that of stacking: the last is in front. A graph
 * with a place floats over the canvas; one without is docked. */
#ifndef TINKER_GUI_GRAPH_EDIT_H
#define TINKER_GUI_GRAPH_EDIT_H

#include "gui/document/document.h"

/* Adds a graph in front of all others: of a quantity of the block against another one, or over time where `against` is
 * NULL. `place` is its upper left corner, `size` its width and height (m); both NULL: docked. Answers its number, or
 * -1. Errors: TINKER_SCENE_ERROR. */
int tinker_graph_add(TinkerDocument *document, TinkerBlockId block, const char *quantity, const char *against,
                     const double place[2], const double size[2], GError **error);

void tinker_graph_remove(TinkerDocument *document, int number);

/* Puts a graph to another place with another size (either NULL: as it was), in front of the others where `in_front`.
 * Answers its number from now on. No step where nothing changes. `merge` as in history.h. */
int tinker_graph_move(TinkerDocument *document, int number, const double place[2], const double size[2],
                      gboolean in_front, const char *merge);

/* Takes its place away: it is docked. */
void tinker_graph_dock(TinkerDocument *document, int number);

/* Adds a curve behind the others (copied), takes one away (not the last one that there is), puts one to the axis at the
 * left (1) or right (2), and makes the axis across (0) or upwards (1) logarithmic. Errors: TINKER_SCENE_ERROR. */
gboolean tinker_graph_add_curve(TinkerDocument *document, int number, const TinkerSceneCurve *curve, GError **error);
gboolean tinker_graph_remove_curve(TinkerDocument *document, int number, guint curve, GError **error);
gboolean tinker_graph_set_curve_axis(TinkerDocument *document, int number, guint curve, int axis, GError **error);
gboolean tinker_graph_set_logarithmic(TinkerDocument *document, int number, int axis, gboolean logarithmic,
                                      GError **error);

/* Draws it over "time" or "frequency", or against a quantity of each curve's own block; axes and ranges are found anew.
 * Errors: TINKER_SCENE_ERROR. */
gboolean tinker_graph_set_against(TinkerDocument *document, int number, const char *against, GError **error);

/* A rectangle on the canvas (widget units). */
typedef struct {
    double x, y, width, height;
} TinkerGraphBox;

/* Finds a place for `box`, whose size is given, in an area of this size: one that covers none of `taken` if there is
 * any, else as little as can be. Places to the right and at the top come first. */
void tinker_graph_find_room(TinkerGraphBox *box, double width, double height, const TinkerGraphBox *taken, int count);

/* Moves `box`, which covers some of `taken`, to the nearest place that covers none; FALSE, and it stays, where there is
 * none. */
gboolean tinker_graph_move_to_room(TinkerGraphBox *box, double width, double height, const TinkerGraphBox *taken,
                                   int count);

#endif
