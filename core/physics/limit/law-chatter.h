/* A typed force that turns against a motion whenever that does, as friction by hand, F = -vx/abs(vx), has no motion of
 * its own at rest: an adaptive method passes from one side of the jump to the other in steps that its tolerance allows
 * and never comes away from it. */
#ifndef TINKER_CORE_LAW_CHATTER_H
#define TINKER_CORE_LAW_CHATTER_H

#include "physics/force/law-paths.h"

/* Looks at a step that is made, with `left` (s) of the piece before it: TRUE where the law has jumped back and forth so
 * often in steps so short that the run would hardly end. */
gboolean tinker_law_chatters(TinkerLawForce *law, const TinkerLawStep *step, double left);

#endif
