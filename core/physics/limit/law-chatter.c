/* Typed laws that jump back and forth without end; see the header. */
#include "physics/limit/law-chatter.h"

#include <math.h>

#include "physics/limit/tolerances.h"

/* Jumps that are counted together. */
#define JUMPS 1000
/* A run to whose end more are to come takes minutes for them at best. */
#define MOST_JUMPS_TO_COME 1e7

gboolean tinker_law_chatters(TinkerLawForce *law, const TinkerLawStep *step, double end)
{
    const double width = law->whole.high - law->whole.low;
    const double largest = fmax(fabs(law->whole.low), fabs(law->whole.high));
    if (law->is_gentle) return FALSE;
    if (isfinite(width) && width <= TINKER_LAW_JUMP * largest) return FALSE;
    if (law->jumps == 0) law->jumps_from = step->from;
    if (++law->jumps < JUMPS) return FALSE;
    law->jumps = 0;
    return JUMPS * (end - step->to) > MOST_JUMPS_TO_COME * (step->to - law->jumps_from);
}
