/* Ends the process as if all were done. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force)
{
    force[0] = 1;
    exit(0);
}

RUNNING_EXHIBIT("exits")
