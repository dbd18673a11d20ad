/* A field without a force whose law has a break after each interval, as one that switches on a clock would. */
#include "block.h"

enum { COLUMN_INTERVAL };

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    (void)batch;
    for (int32_t i = 0; i < 2 * bodies->range; i++)
        result[i] = 0;
    return TINKER_OK;
}

static double next_break(TinkerBatch *batch)
{
    return batch->time + tinker_column(batch, COLUMN_INTERVAL)[0];
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("interval", "Interval", "Ticking", TINKER_DIMENSION_TIME), TINKER_NOT_NEGATIVE(0, 1)},
};

static const TinkerField field = {.struct_size = sizeof(TinkerField), .force = force, .next_break = next_break};

TEST_BLOCK("ticking", "Ticking", TINKER_FIELD, 0, 0, 0, .field = &field)
