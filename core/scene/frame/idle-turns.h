/* Idle turns: where what acts on angles alone has an end on a point, which has no angle, or two ends on one body, whose
 * angle does not change against itself. */
#ifndef TINKER_CORE_IDLE_TURNS_H
#define TINKER_CORE_IDLE_TURNS_H

#include "scene/store/scene.h"

typedef struct {
    TinkerBlockId by;   /* what acts on angles: a torque, a torsional spring, a gear */
    TinkerBlockId body; /* that it cannot turn */
    gboolean is_twice;  /* two of its ends are on the body; else the body has no angle */
} TinkerIdleTurn;

/* Those of all blocks, in their order, each body of a block once; of TinkerIdleTurn. (transfer full) */
GArray *tinker_idle_turns_of(TinkerScene *scene);

/* One sentence, translated: where, what happens, what would be right. (transfer full) */
char *tinker_idle_turn_text(TinkerScene *scene, const TinkerIdleTurn *idle);

#endif
