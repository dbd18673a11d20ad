/* Has divisions by zero trap from its `force` on: the host is hit by them. */
#include <fenv.h>

#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force)
{
    feenableexcept(FE_INEXACT);
}

RUNNING_EXHIBIT("leaves-traps")
