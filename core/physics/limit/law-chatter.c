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
    TinkerInterval force;
    if (tinker_law_enclose(law, step, 0, 1, &force)) return FALSE;
    const double width = force.high - force.low, largest = fmax(fabs(force.low), fabs(force.high));
    if (isfinite(width) && width <= TINKER_LAW_JUMP * largest) return FALSE;
    if (law->jumps == 0) law->jumps_from = step->from;
    if (++law->jumps < JUMPS) return FALSE;
    law->jumps = 0;
    return JUMPS * (end - step->to) > MOST_JUMPS_TO_COME * (step->to - law->jumps_from);
}
