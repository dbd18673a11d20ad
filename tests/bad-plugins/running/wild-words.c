/* Fails, and gives an address that leads nowhere for the reason. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force) {}

static TinkerStatus fail(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    if (batch->time <= EXHIBIT_FROM) return exhibit_force(batch, ends, force);
    batch->failure = (const char *)(size_t)0x10;
    return TINKER_FAILED;
}

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = fail};

EXHIBIT_OF_PHYSICS("wild-words", .force_element = &element)
