/* A constraint that a waveform drives: a rod of the length u(t), g = L - u, dg/dt of what is prescribed = -u'. */
#include "block.h"

enum { COLUMN_WAVEFORM };

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *u = tinker_column(batch, COLUMN_WAVEFORM), *bend = tinker_column(batch, COLUMN_WAVEFORM + 2);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, length = hypot(dx, dy), nx = dx / length, ny = dy / length;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        g[i] = length - u[i];
        jacobian[4 * i] = -nx;
        jacobian[4 * i + 1] = -ny;
        jacobian[4 * i + 2] = nx;
        jacobian[4 * i + 3] = ny;
        drift[i] = across * across / length - bend[i];
    }
    return TINKER_OK;
}

static TinkerStatus prescribed_rate(TinkerBatch *batch, const TinkerPoint *ends, double *rate)
{
    for (int32_t i = 0; i < batch->count; i++)
        rate[i] = -tinker_column(batch, COLUMN_WAVEFORM + 1)[i];
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Length", "Actuator", "none", TINKER_DIMENSION_LENGTH)},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Actuator", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 1)},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Actuator", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0, 1)},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Actuator", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, 0, 1)},
};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .prescribed_rate = prescribed_rate};

TEST_BLOCK("actuator", "Actuator", TINKER_CONNECTOR, 2, 2, TEST_ANY, .constraint = &constraint)
