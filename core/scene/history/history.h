/* Undo and redo: a history of changes to a scene.
 *
 * Changes go through the history instead of the scene itself; those between begin and end are one step for the user.
 * Whatever bypasses it (tinker_scene_head, tinker_scene_graphs) is not taken back, and must not be mixed with it.
 */
#ifndef TINKER_CORE_HISTORY_H
#define TINKER_CORE_HISTORY_H

#include "scene/store/scene.h"

typedef struct _TinkerHistory TinkerHistory;

/* The scene is borrowed and outlives the history. (transfer full) */
TinkerHistory *tinker_history_new(TinkerScene *scene);
void tinker_history_free(TinkerHistory *history);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerHistory, tinker_history_free)

/* Opens a step with a title for the menu ("Move Mass 0"); steps do not nest. Consecutive steps with the same non-NULL
 * `merge` key (a drag) become one. */
void tinker_history_begin(TinkerHistory *history, const char *title, const char *merge);
void tinker_history_end(TinkerHistory *history);
/* Ends the step and takes back what it did. */
void tinker_history_abort(TinkerHistory *history);
/* Whether there is one between begin and end. */
gboolean tinker_history_is_open(const TinkerHistory *history);

/* The setters of scene.h, recorded. Outside begin and end each is a step of its own. */
TinkerBlockId tinker_history_add_block(TinkerHistory *history, const TinkerBlockClass *block_class, const char *name,
                                       GError **error);
/* One of a type with a number of ends of choice, which the type must allow; its name is the first that is free. */
TinkerBlockId tinker_history_add_block_of(TinkerHistory *history, const TinkerBlockClass *block_class, int32_t ends);
void tinker_history_remove_block(TinkerHistory *history, TinkerBlockId block);
/* Several different ones at once, in a time that does not depend on how many they are but by what has to be kept of
 * each. */
void tinker_history_remove_blocks(TinkerHistory *history, const TinkerBlockId *blocks, gsize count);
gboolean tinker_history_rename_block(TinkerHistory *history, TinkerBlockId block, const char *name, GError **error);
gboolean tinker_history_set(TinkerHistory *history, TinkerBlockId block, int32_t property, const double *values,
                            GError **error);
gboolean tinker_history_lay_on(TinkerHistory *history, TinkerBlockId block, TinkerBlockId plate, double along,
                               GError **error);
void tinker_history_unset(TinkerHistory *history, TinkerBlockId block, int32_t property);
void tinker_history_set_waveform(TinkerHistory *history, TinkerBlockId block, int32_t property,
                                 TinkerWaveform *waveform);
void tinker_history_set_text(TinkerHistory *history, TinkerBlockId block, int32_t property, const char *text);
gboolean tinker_history_set_end(TinkerHistory *history, TinkerBlockId block, int32_t end, TinkerSceneEnd to,
                                GError **error);

/* Takes over all of the head: title, units, canvas, run settings; ranges are those of the format. Texts are copied. */
gboolean tinker_history_set_head(TinkerHistory *history, const TinkerSceneHead *head, GError **error);

/* Adds a graph behind the others and answers its index in tinker_scene_graphs, or -1 where its block, a quantity or its
 * size is not good. Graphs are copied. */
int32_t tinker_history_add_graph(TinkerHistory *history, const TinkerSceneGraph *graph, GError **error);
void tinker_history_remove_graph(TinkerHistory *history, int32_t index);
gboolean tinker_history_change_graph(TinkerHistory *history, int32_t index, const TinkerSceneGraph *graph,
                                     GError **error);
/* Puts an instrument in place of the one at `index` of tinker_scene_instruments, or behind the last; NULL: takes that
 * one out. FALSE where what it is of, its range or its step are not good. It is copied. */
gboolean tinker_history_set_instrument(TinkerHistory *history, int32_t index, const TinkerSceneInstrument *instrument,
                                       GError **error);

/* Moves blocks, in the order that they have, to the end of the drawing order, on top of all others, or to its
 * beginning. No block is named twice. */
void tinker_history_order_blocks(TinkerHistory *history, const TinkerBlockId *blocks, guint count, gboolean in_front);

/* Titles of what undo and redo would do; NULL where there is nothing. */
const char *tinker_history_can_undo(const TinkerHistory *history);
const char *tinker_history_can_redo(const TinkerHistory *history);
/* An undone removal brings the block back under its old id, name and place in the drawing order, ends included. */
void tinker_history_undo(TinkerHistory *history);
void tinker_history_redo(TinkerHistory *history);

/* Whether the scene is as it was when it was marked last, or at the beginning where it was not: also after undo and
 * redo that lead back to that state. Steps with the same `merge` key stay apart where the state between them was
 * marked. */
gboolean tinker_history_is_saved(const TinkerHistory *history);
void tinker_history_mark_saved(TinkerHistory *history);

/* A number that grows with every change, undo and redo, also inside an open step. No other history has it: what is
 * known of one scene is not taken for known of the next. */
guint64 tinker_history_revision(const TinkerHistory *history);

#endif
