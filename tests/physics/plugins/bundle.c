/* A force element of any number of ends: pulls each towards the middle of all, f = -k (x - mean). */
#include "block.h"

enum { COLUMN_STIFFNESS };

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS);
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = batch->ends < 0 ? batch->end_offsets[i] : i * batch->ends;
        const int32_t past = batch->ends < 0 ? batch->end_offsets[i + 1] : first + batch->ends;
        double x = 0, y = 0;
        for (int32_t e = first; e < past; e++) {
            x += ends[e].x / (past - first);
            y += ends[e].y / (past - first);
        }
        for (int32_t e = first; e < past; e++) {
            result[2 * e] = -k[i] * (ends[e].x - x);
            result[2 * e + 1] = -k[i] * (ends[e].y - y);
        }
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Bundle", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = force};

TEST_BLOCK("bundle", "Bundle", TINKER_CONNECTOR, 2, -1, TEST_ANY, .force_element = &element)
