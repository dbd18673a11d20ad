/* Writes through a null pointer. */
#include "exhibit.h"

static double *volatile nowhere;

/* No sanitizer is to stop it: the fault is what the host must tell of. */
__attribute__((no_sanitize("undefined", "address"))) static void misbehave(const TinkerBatch *batch, double *force)
{
    force[0] = *nowhere;
}

RUNNING_EXHIBIT("segfaults")
