/* What the files of the history share: how changes are recorded. */
#ifndef TINKER_CORE_HISTORY_PRIVATE_H
#define TINKER_CORE_HISTORY_PRIVATE_H

#include "scene/history/history.h"
#include "scene/store/scene-data.h"

/* A kind of thing that changes. A state is all that there is to know about one such thing; NULL where it was not there.
 */
typedef struct {
    enum { HISTORY_BLOCK, HISTORY_HEAD, HISTORY_OTHER } of; /* a block that stays, the scene's head, something else */
    /* Makes what is as in `from` be as in `to`; `id` says which one. */
    void (*make)(TinkerScene *scene, int32_t id, gconstpointer from, gconstpointer to);
    void (*free)(gpointer state);
} HistoryKind;

/* A place in the drawing order as a state. */
static inline gpointer history_place(int32_t place)
{
    return GINT_TO_POINTER(place + 1);
}

TinkerScene *history_scene(TinkerHistory *history);

/* Opens a step where none is open, "VERB NAME"; answers whether it did, and then the caller ends it. */
gboolean history_open_own(TinkerHistory *history, const char *verb, const char *name);
/* Opens a step, "VERB NAME" of one block or "VERB N Blocks", where none is open; answers whether it did. */
gboolean history_open_several(TinkerHistory *history, const char *verb, const TinkerBlockId *blocks, gsize count);

/* Records blocks that were added to the scene, in a step of its own where none is open. */
void history_note_new(TinkerHistory *history, const char *verb, const TinkerBlockId *blocks, gsize count);

/* Adds a change, which has been made, to the open step. Takes both states. */
void history_add(TinkerHistory *history, const HistoryKind *kind, int32_t id, gpointer before, gpointer after);

#endif
