/* Writes beyond its scratch, as far as the host's memory behind it. */
#include "exhibit.h"

#define SCRATCH 16

__attribute__((no_sanitize("undefined", "address"))) static void misbehave(const TinkerBatch *batch, double *force)
{
    volatile char *scratch = batch->scratch;
    scratch[SCRATCH] = 1;
}

EXHIBIT_OF_PHYSICS("overruns-scratch", .force_element = &exhibit_element, .scratch_size = SCRATCH)
