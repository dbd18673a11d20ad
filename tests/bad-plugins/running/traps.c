/* An instruction that does not exist: SIGILL. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force)
{
    force[0] = 1;
    __builtin_trap();
}

RUNNING_EXHIBIT("traps")
