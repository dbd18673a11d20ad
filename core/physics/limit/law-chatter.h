/* A typed force that turns against a motion whenever that does, as friction by hand, F = -vx/abs(vx), has no motion of
 * its own at rest: an adaptive method passes from one side of the jump to the other in steps that its tolerance allows
 * and never comes away from it. */
#ifndef TINKER_CORE_LAW_CHATTER_H
#define TINKER_CORE_LAW_CHATTER_H

#include "physics/force/law-paths.h"

/* Looks at a step that is made, along which the law is enclosed as a whole: TRUE where the law jumps back and forth so
 * often that the run would hardly come to its `end` (s). */
gboolean tinker_law_chatters(TinkerLawForce *law, const TinkerLawStep *step, double end);

#endif
