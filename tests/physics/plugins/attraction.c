/* A field: all bodies attract one another, f = G m M / r^2, with the energy -G m M / r of each pair. */
#include "block.h"

enum { COLUMN_STRENGTH };

static double strength(const TinkerBatch *batch)
{
    double sum = 0;
    for (int32_t i = 0; i < batch->count; i++)
        sum += tinker_column(batch, COLUMN_STRENGTH)[i];
    return sum;
}

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    const double g = strength(batch);
    for (int32_t i = 0; i < bodies->range; i++) {
        const int32_t own = bodies->first + i;
        const TinkerPoint *at = &bodies->points[own];
        double x = 0, y = 0;
        for (int32_t k = 0; k < bodies->count; k++) {
            if (k == own) continue;
            const double dx = bodies->points[k].x - at->x, dy = bodies->points[k].y - at->y, r = hypot(dx, dy);
            const double pull = g * bodies->masses[k] * bodies->masses[own] / (r * r * r);
            x += pull * dx;
            y += pull * dy;
        }
        result[2 * i] = x;
        result[2 * i + 1] = y;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerBodies *bodies, double *potential)
{
    *potential = 0;
    for (int32_t i = 0; i < bodies->count; i++)
        for (int32_t k = 0; k < i; k++)
            *potential -= strength(batch) * bodies->masses[i] * bodies->masses[k] /
                          hypot(bodies->points[k].x - bodies->points[i].x, bodies->points[k].y - bodies->points[i].y);
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("strength", "G", "Attraction", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerField field = {
    .struct_size = sizeof(TinkerField), .couples_bodies = 1, .force = force, .energy = energy};

TEST_BLOCK("attraction", "Attraction", TINKER_FIELD, 0, 0, 0, .field = &field)
