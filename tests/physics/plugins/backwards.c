/* A line whose force has the wrong sign for its energy: it pushes with k (L - L0) and stores k (L - L0)^2 / 2. */
#include "block.h"

enum { COLUMN_STIFFNESS, COLUMN_LENGTH };

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    for (int32_t i = 0; i < batch->count; i++)
        result[i] = -tinker_column(batch, COLUMN_STIFFNESS)[i] * (length[i] - tinker_column(batch, COLUMN_LENGTH)[i]);
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double stretch = length[i] - tinker_column(batch, COLUMN_LENGTH)[i];
        stored[i] = 0.5 * tinker_column(batch, COLUMN_STIFFNESS)[i] * stretch * stretch;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "k", "Backwards", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("length", "L0", "Backwards", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerLineLaw law = {.struct_size = sizeof(TinkerLineLaw), .tension = tension, .energy = energy};

TEST_BLOCK("backwards", "Backwards", TINKER_CONNECTOR, 2, 2, TEST_ANY, .line_law = &law)
