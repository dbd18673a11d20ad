/* Never comes back. */
#include "exhibit.h"

static volatile int forever = 1;

static void misbehave(const TinkerBatch *batch, double *force)
{
    while (forever)
        force[0] += 1;
}

RUNNING_EXHIBIT("hangs")
