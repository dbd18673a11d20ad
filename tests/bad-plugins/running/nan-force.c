/* A force that is not a number. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force)
{
    force[2 * (batch->count - 1)] = strtod("nan", NULL);
}

RUNNING_EXHIBIT("nan-force")
