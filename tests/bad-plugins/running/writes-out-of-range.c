/* Writes behind the end of what it was given. */
#define EXHIBIT_FROM -1.0
#include "exhibit.h"

/* No sanitizer is to stop it: the fault is what the host must tell of. */
__attribute__((no_sanitize("undefined", "address"))) static void misbehave(const TinkerBatch *batch, double *force)
{
    force[2 * batch->count] = 1;
}

RUNNING_EXHIBIT("writes-out-of-range")
