/* A constraint that keeps a length, g = steepness (L - length): of the form that the host works out where the steepness
 * is 1 alone. Asked for rows of that form it fails, since nobody should. */
#include "block.h"

enum { COLUMN_LENGTH, COLUMN_STEEPNESS };

static int keeps_distances(const TinkerBatch *batch)
{
    for (int32_t i = 0; i < batch->count; i++) {
        if (tinker_column(batch, COLUMN_STEEPNESS)[i] != 1.0) return 0;
    }
    return 1;
}

static TinkerStatus distance(TinkerBatch *batch, double *length)
{
    if (!keeps_distances(batch)) return TINKER_RETRY_SMALLER;
    for (int32_t i = 0; i < batch->count; i++) {
        length[i] = tinker_column(batch, COLUMN_LENGTH)[i];
    }
    return TINKER_OK;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    if (keeps_distances(batch)) return tinker_fail(batch, 0, "nobody should ask for rows that the host works out");
    for (int32_t i = 0; i < batch->count; i++) {
        const double steepness = tinker_column(batch, COLUMN_STEEPNESS)[i];
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, now = hypot(dx, dy), nx = dx / now, ny = dy / now;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        g[i] = steepness * (now - tinker_column(batch, COLUMN_LENGTH)[i]);
        jacobian[4 * i] = -steepness * nx;
        jacobian[4 * i + 1] = -steepness * ny;
        jacobian[4 * i + 2] = steepness * nx;
        jacobian[4 * i + 3] = steepness * ny;
        drift[i] = steepness * across * across / now;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Tie", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 9)},
    {TINKER_REAL_PROPERTY("steepness", "Steepness", "Tie", TINKER_DIMENSION_NONE), TINKER_ANY_VALUE(0, 0, 2)},
};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .distance = distance};

TEST_BLOCK("tie", "Tie", TINKER_CONNECTOR, 2, 2, TEST_ANY, .constraint = &constraint)
