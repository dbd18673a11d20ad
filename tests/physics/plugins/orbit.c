/* A motion that is no waveform times a direction: round a circle, beginning at the support's place. */
#include "block.h"

enum { COLUMN_RADIUS, COLUMN_RATE };

static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double r = tinker_column(batch, COLUMN_RADIUS)[i], w = tinker_column(batch, COLUMN_RATE)[i];
        const double c = r * cos(w * batch->time), s = r * sin(w * batch->time);
        displacement[2 * i] = c - r;
        displacement[2 * i + 1] = s;
        velocity[2 * i] = -w * s;
        velocity[2 * i + 1] = w * c;
        acceleration[2 * i] = -w * w * c;
        acceleration[2 * i + 1] = -w * w * s;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("radius", "Radius", "Orbit", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 1)},
    {TINKER_REAL_PROPERTY("rate", "Rate", "Orbit", TINKER_DIMENSION_ANGULAR_FREQUENCY), TINKER_ANY_VALUE(0, 0, 1)},
};

static const TinkerMotion role = {.struct_size = sizeof(TinkerMotion), .motion = motion};

TEST_BLOCK("orbit", "Orbit", TINKER_MOTION, 1, 1, TINKER_ACCEPTS_SUPPORT, .motion = &role)
