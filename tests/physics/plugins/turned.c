/* A field: F = m W (vy, -vx) - m c v on every body, as a frame's that turns with W/2, or a magnet's. It says what it
 * holds about velocities, but no energy: the part across the velocity does no work. */
#include "block.h"

enum { COLUMN_RATE, COLUMN_DRAG };

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    for (int32_t k = 0; k < bodies->range; k++) {
        const TinkerPoint *at = &bodies->points[bodies->first + k];
        const double mass = bodies->masses[bodies->first + k];
        result[2 * k] = result[2 * k + 1] = 0;
        for (int32_t i = 0; i < batch->count; i++) {
            const double w = tinker_column(batch, COLUMN_RATE)[i], c = tinker_column(batch, COLUMN_DRAG)[i];
            result[2 * k] += mass * (w * at->vy - c * at->vx);
            result[2 * k + 1] += mass * (-w * at->vx - c * at->vy);
        }
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("rate", "W", "Turned", TINKER_DIMENSION_ANGULAR_FREQUENCY), TINKER_ANY_VALUE(0, -10, 10)},
    {TINKER_REAL_PROPERTY("drag", "c", "Turned", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerField field = {.struct_size = sizeof(TinkerField), .force = force};

TEST_BLOCK("turned", "Turned", TINKER_FIELD, 0, 0, 0, .field = &field)
