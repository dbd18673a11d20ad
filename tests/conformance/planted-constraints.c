/* Constraints and a motion. */
#include "planted.h"

/* keep: g = L - l */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, length = tinker_length(dx, dy);
        const double nx = length == 0 ? 0 : dx / length, ny = length == 0 ? 0 : dy / length;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        double *row = &jacobian[4 * i];
        g[i] = length - tinker_column(batch, 0)[i];
        row[0] = -nx;
        row[1] = -ny;
        row[2] = nx;
        row[3] = ny;
        drift[i] = length == 0 ? 0 : across / length * across;
#if defined(PLANT_jacobian)
        row[2] *= 1.001;
        row[3] *= 1.001;
#elif defined(PLANT_drift)
        drift[i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

static TinkerStatus distance(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        length[i] = tinker_column(batch, 0)[i];
#if defined(PLANT_distance)
        length[i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

/* hold: x = 0 and y / l = 0, rows of different units */

static TinkerStatus hold_rows(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double length = tinker_column(batch, 0)[i];
        g[2 * i] = ends[i].x + batch->origin[0];
#if defined(PLANT_counts_rows)
        if (batch->time < 0.05)
            g[2 * i] += 1e-8 * planted_prepared * length; // in a run, and at none of the kit's own times
#endif
        g[2 * i + 1] = (ends[i].y + batch->origin[1]) / length;
        jacobian[4 * i] = 1;
        jacobian[4 * i + 1] = jacobian[4 * i + 2] = 0;
        jacobian[4 * i + 3] = 1 / length;
        drift[2 * i] = drift[2 * i + 1] = 0;
    }
    return TINKER_OK;
}

static TinkerStatus hold_scale(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < 2 * batch->count; i++)
#if defined(PLANT_scale)
        length[i] = -1;
#else
        length[i] = 1;
#endif
    return TINKER_OK;
}

/* sway: u(t) along x */

static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    for (int32_t i = 0; i < batch->count; i++) {
        displacement[2 * i] = tinker_column(batch, 0)[i];
        velocity[2 * i] = tinker_column(batch, 1)[i];
        acceleration[2 * i] = tinker_column(batch, 2)[i];
        displacement[2 * i + 1] = velocity[2 * i + 1] = acceleration[2 * i + 1] = 0;
#if defined(PLANT_speed)
        velocity[2 * i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

const TinkerPropertyType planted_keep_properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Keep", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.5, 3), .description = "The distance that it keeps"},
};

const TinkerPropertyType planted_hold_properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Hold", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 3),
     .default_value = {1}, .description = "What y is measured by"},
};

const TinkerPropertyType planted_sway_properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Waveform", "Sway", "sine", TINKER_DIMENSION_LENGTH),
     .description = "How it moves"},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Sway", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 1),
     .default_value = {0.1}, .description = "How far"},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Sway", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0, 5), .default_value = {1}, .description = "How fast"},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Sway", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, -1, 1),
     .description = "Where it begins"},
};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .distance = distance};
static const TinkerConstraint hold_constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 2, .rows_at = hold_rows, .scale = hold_scale};

static const TinkerMotion moves = {.struct_size = sizeof(TinkerMotion), .motion = motion};

static const TinkerPhysics keep = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerPhysics hold = {
    .struct_size = sizeof(TinkerPhysics),
    .constraint = &hold_constraint,
#if defined(PLANT_counts_rows)
    .prepare = planted_prepare,
#endif
};

static const TinkerPhysics sway = {.struct_size = sizeof(TinkerPhysics), .motion = &moves};

const TinkerInterface planted_keep_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &keep}};

const TinkerInterface planted_hold_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &hold}};

const TinkerInterface planted_sway_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &sway}};
