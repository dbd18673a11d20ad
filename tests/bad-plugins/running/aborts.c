/* An assertion of its own fails. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force)
{
    force[0] = 1;
    abort();
}

RUNNING_EXHIBIT("aborts")
