/* Typed laws that jump back and forth without end; see the header. */
#include "physics/limit/law-chatter.h"

#include <math.h>

#include "physics/limit/tolerances.h"

/* As many jumps one after the other lead back and forth. */
#define MOST_JUMPS 1000

gboolean tinker_law_chatters(TinkerLawForce *law, const TinkerLawStep *step, double left)
{
    if (step->to - step->from > TINKER_LAW_CHATTERS * left) {
        law->jumps = 0;
        return FALSE;
    }
    TinkerInterval force;
    if (tinker_law_enclose(law, step, 0, 1, &force)) return FALSE;
    const double width = force.high - force.low, largest = fmax(fabs(force.low), fabs(force.high));
    if (!isfinite(width) || width > TINKER_LAW_JUMP * largest) law->jumps++;
    return law->jumps > MOST_JUMPS;
}
