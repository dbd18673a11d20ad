/* Small wheels: where what goes over several blocks goes over the centre of a body that turns. It goes over an ideal
 * wheel of no size there and does not turn it; where the body is round, that is seldom what one who attaches it there
 * means. */
#ifndef TINKER_CORE_SMALL_WHEELS_H
#define TINKER_CORE_SMALL_WHEELS_H

#include "scene/store/scene.h"

typedef struct {
    TinkerBlockId over; /* what goes over it: a constraint in one direction with an end between its first and last */
    TinkerBlockId body; /* to whose centre that end is attached */
    gboolean is_round;  /* it has a radius */
} TinkerSmallWheel;

/* Those of all blocks, in their order; of TinkerSmallWheel. (transfer full) */
GArray *tinker_small_wheels_of(TinkerScene *scene);

/* Of a round one one sentence, translated: where, what happens, what would be right. (transfer full) */
char *tinker_small_wheel_text(TinkerScene *scene, const TinkerSmallWheel *wheel);

#endif
