/* A constraint that keeps its end on a circle about the origin, or about a second end: g = L - radius. */
#include "block.h"

enum { COLUMN_RADIUS };

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), count = tinker_first_end(batch, i + 1) - first;
        const TinkerPoint *at = &ends[first];
        TinkerPoint centre = {-batch->origin[0], -batch->origin[1], 0.0, 0.0};
        if (count > 1) centre = ends[first + 1];
        const double dx = at->x - centre.x, dy = at->y - centre.y, length = hypot(dx, dy);
        const double across = (dx * (at->vy - centre.vy) - dy * (at->vx - centre.vx)) / length;
        for (int32_t e = 0; e < count; e++) {
            jacobian[2 * (first + e)] = (e == 0 ? dx : -dx) / length;
            jacobian[2 * (first + e) + 1] = (e == 0 ? dy : -dy) / length;
        }
        g[i] = length - tinker_column(batch, COLUMN_RADIUS)[i];
        drift[i] = across * across / length;
    }
    return TINKER_OK;
}

static TinkerStatus scale(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++)
        length[i] = tinker_column(batch, COLUMN_RADIUS)[i];
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("radius", "Radius", "Ring", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(1, 9)},
};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .scale = scale};

TEST_BLOCK("ring", "Ring", TINKER_CONNECTOR, 1, 2, TEST_ANY, .constraint = &constraint)
