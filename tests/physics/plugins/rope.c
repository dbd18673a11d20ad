/* A rope between two ends: g = L - length <= 0. */
#include "block.h"

enum { COLUMN_LENGTH };

static TinkerStatus distance(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        length[i] = tinker_column(batch, COLUMN_LENGTH)[i];
    }
    return TINKER_OK;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, now = hypot(dx, dy), nx = dx / now, ny = dy / now;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        g[i] = now - tinker_column(batch, COLUMN_LENGTH)[i];
        jacobian[4 * i] = -nx;
        jacobian[4 * i + 1] = -ny;
        jacobian[4 * i + 2] = nx;
        jacobian[4 * i + 3] = ny;
        drift[i] = across * across / now;
    }
    return TINKER_OK;
}

static TinkerStatus scale(TinkerBatch *batch, double *length)
{
    return distance(batch, length);
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Rope", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 9)},
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .unilateral = 1,
                                            .rows_at = rows_at,
                                            .scale = scale,
                                            .distance = distance};

TEST_BLOCK("rope", "Rope", TINKER_CONNECTOR, 2, 2, TEST_ANY, .constraint = &constraint)
