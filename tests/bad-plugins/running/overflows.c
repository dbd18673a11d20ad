/* Calls itself until the stack is used up. */
#include "exhibit.h"

/* Never inlined, and not a loop: each call has a frame of its own. */
__attribute__((noinline)) static double descend(double depth)
{
    volatile double frame[512];
    frame[0] = depth;
    return depth < 0 ? depth : descend(depth + 1) + frame[0];
}

static void misbehave(const TinkerBatch *batch, double *force)
{
    force[0] = descend(batch->time);
}

RUNNING_EXHIBIT("overflows")
