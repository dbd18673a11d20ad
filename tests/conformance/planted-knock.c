/* knock: a blow at an instant, of which the law tells. clap: one between two ends, along the line between them. */
#include "planted.h"

enum { COLUMN_BLOW, COLUMN_TIME };

static TinkerStatus knock_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < batch->count; i++)
        force[2 * i] = force[2 * i + 1] = 0;
    return TINKER_OK;
}

static double next_blow(TinkerBatch *batch)
{
    const double *time = tinker_column(batch, COLUMN_TIME);
    double next = INFINITY;
    for (int32_t i = 0; i < batch->count; i++)
        if (time[i] > batch->time && time[i] < next) next = time[i];
    return next;
}

static TinkerStatus blow(TinkerBatch *batch, const TinkerPoint *ends, double *impulse)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double now = tinker_column(batch, COLUMN_TIME)[i] == batch->time ? 1 : 0;
        const double given = now * tinker_column(batch, COLUMN_BLOW)[i];
#if defined(PLANT_blow_value)
        impulse[2 * i] = 1.001 * given;
#else
        impulse[2 * i] = given;
#endif
        impulse[2 * i + 1] = -2 * given;
    }
    return TINKER_OK;
}

static TinkerStatus clap_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < 4 * batch->count; i++)
        force[i] = 0;
    return TINKER_OK;
}

static TinkerStatus clap_blow(TinkerBatch *batch, const TinkerPoint *ends, double *impulse)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, length = tinker_length(dx, dy);
        const int strikes = tinker_column(batch, COLUMN_TIME)[i] == batch->time && length > 0;
        const double given = strikes ? tinker_column(batch, COLUMN_BLOW)[i] : 0;
        double *j = &impulse[4 * i];
        j[0] = length > 0 ? given * (dx / length) : 0;
        j[1] = length > 0 ? given * (dy / length) : 0;
        j[2] = -j[0];
        j[3] = -j[1];
#if defined(PLANT_blow_unbalanced)
        j[2] *= 1.001;
        j[3] *= 1.001;
#endif
    }
    return TINKER_OK;
}

const TinkerPropertyType planted_knock_properties[] = {
    {TINKER_REAL_PROPERTY("blow", "Blow", "Knock", TINKER_DIMENSION_MOMENTUM), TINKER_ANY_VALUE(0, -10, 10),
     .symbol = "J", .description = "How hard it strikes"},
    {TINKER_REAL_PROPERTY("time", "Time", "Knock", TINKER_DIMENSION_TIME), TINKER_ANY_VALUE(0, 0, 10),
     .meaning = TINKER_MEANING_INSTANT, .description = "When it strikes"},
};

const TinkerLawEquation planted_knock_law[PLANTED_KNOCK_LAW] = {
    TINKER_EQUATION("force_x", "0", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "0", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("impulse_x", "J", NULL, TINKER_DIMENSION_MOMENTUM),
#if !defined(PLANT_blow_missing)
    TINKER_EQUATION("impulse_y", "-2*J", NULL, TINKER_DIMENSION_MOMENTUM),
#endif
};

static const TinkerForceElement element = {
    .struct_size = sizeof(TinkerForceElement), .force = knock_force, .next_blow = next_blow, .blow = blow};
static const TinkerPhysics knock = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};

const TinkerInterface planted_knock_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &knock}};

static const TinkerForceElement clap_element = {
    .struct_size = sizeof(TinkerForceElement), .force = clap_force, .next_blow = next_blow, .blow = clap_blow};
static const TinkerPhysics clap = {.struct_size = sizeof(TinkerPhysics), .force_element = &clap_element};

const TinkerInterface planted_clap_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &clap}};
