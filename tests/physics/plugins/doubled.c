/* A linear law, T = k (L - l), that tells twice the energy it stores: k (L - l)^2. */
#include "block.h"

enum { COLUMN_STIFFNESS, COLUMN_LENGTH };

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *l = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const double stretch = length[i] - l[i];
        result[i] = k[i] * stretch;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *l = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const double square = (length[i] - l[i]) * (length[i] - l[i]);
        stored[i] = k[i] * square;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Doubled", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("length", "Length", "Doubled", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerLineLaw law = {.struct_size = sizeof(TinkerLineLaw), .tension = tension, .energy = energy};

TEST_BLOCK("doubled", "Doubled", TINKER_CONNECTOR, 2, 2, TEST_ANY, .line_law = &law)
