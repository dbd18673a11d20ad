/* A line law that is not linear and leaves its derivatives to the host: T = k (L - l)^3, energy k (L - l)^4 / 4. */
#include "block.h"

enum { COLUMN_STIFFNESS, COLUMN_LENGTH };

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *l = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const double stretch = length[i] - l[i];
        result[i] = k[i] * stretch * stretch * stretch;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *l = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const double square = (length[i] - l[i]) * (length[i] - l[i]);
        stored[i] = 0.25 * k[i] * square * square;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Cubic", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("length", "Length", "Cubic", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerLineLaw law = {.struct_size = sizeof(TinkerLineLaw), .tension = tension, .energy = energy};

TEST_BLOCK("cubic", "Cubic", TINKER_CONNECTOR, 2, 2, TEST_ANY, .line_law = &law)
