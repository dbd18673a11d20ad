/* Fails, and gives a reason of three lines, with an escape sequence and bytes that are no UTF-8. */
#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force) {}

static TinkerStatus fail(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    if (batch->time <= EXHIBIT_FROM) return exhibit_force(batch, ends, force);
    batch->failure = "\033[31mtoo\nfast\xff\r\n";
    return TINKER_FAILED;
}

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = fail};

EXHIBIT_OF_PHYSICS("rough-words", .force_element = &element)
