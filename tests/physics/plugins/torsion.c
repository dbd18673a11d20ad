/* A force element of three ends: a torsional spring about the second, E = k phi^2 / 2, with phi the angle from the arm
 * of the first end to that of the third. The force on the end of an arm r is -(dE/dphi)(dphi/dr), across the arm. */
#include "block.h"

enum { COLUMN_STIFFNESS };

static double angle(const TinkerPoint *ends)
{
    const double ax = ends[0].x - ends[1].x, ay = ends[0].y - ends[1].y;
    const double cx = ends[2].x - ends[1].x, cy = ends[2].y - ends[1].y;
    return atan2(ax * cy - ay * cx, ax * cx + ay * cy);
}

static void across(const TinkerPoint *from, const TinkerPoint *to, double moment, double *force)
{
    const double x = to->x - from->x, y = to->y - from->y, square = x * x + y * y;
    force[0] = -moment * y / square;
    force[1] = moment * x / square;
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *end = &ends[3 * i];
        double *f = &result[6 * i], moment = k[i] * angle(end);
        across(&end[1], &end[0], moment, f);
        across(&end[1], &end[2], -moment, f + 4);
        f[2] = -f[0] - f[4];
        f[3] = -f[1] - f[5];
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerPoint *ends, double *stored)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS);
    for (int32_t i = 0; i < batch->count; i++)
        stored[i] = 0.5 * k[i] * angle(&ends[3 * i]) * angle(&ends[3 * i]);
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Torsion", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = force, .energy = energy};

TEST_BLOCK("torsion", "Torsion", TINKER_CONNECTOR, 3, 3, TEST_ANY, .force_element = &element)
