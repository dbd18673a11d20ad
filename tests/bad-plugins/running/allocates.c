/* Allocates on the hot path. */
#define EXHIBIT_FROM -1.0
#include "exhibit.h"

static void *volatile kept;

static void misbehave(const TinkerBatch *batch, double *force)
{
    kept = malloc(64);
    force[0] = kept == NULL ? 1 : 0;
    free(kept);
}

RUNNING_EXHIBIT("allocates")
