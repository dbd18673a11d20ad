/* A force element that misbehaves in the way that `mode` says. */
#include "block.h"

enum { COLUMN_MODE };

enum {
    MODE_NAN,
    MODE_INFINITE,
    MODE_FAILS,
    MODE_FAILS_SILENTLY,
    MODE_WALL,
    MODE_NEVER,
    MODE_NONE,
    MODE_NO_STATUS,
    MODE_NAN_ENERGY,
    MODE_INFINITE_ENERGY
};

/* A wall at x = 1 that repels with 1 / (1 - x): behind it there is no force to tell. */
static TinkerStatus wall(TinkerBatch *batch, int32_t i, const TinkerPoint *end, double *force)
{
    if (!(end->x < 1.0)) return tinker_retry(batch, i, "nobody knows what is behind the wall");
    force[0] = -1.0 / (1.0 - end->x);
    return TINKER_OK;
}

static TinkerStatus misbehave(TinkerBatch *batch, int32_t i, const TinkerPoint *end, double *force)
{
    const int mode = (int)tinker_column(batch, COLUMN_MODE)[i];
    force[0] = force[1] = 0.0;
    if (mode == MODE_WALL) return wall(batch, i, end, force);
    if (batch->time <= 1.0) return TINKER_OK;
    if (mode == MODE_NAN) force[0] = NAN;
    if (mode == MODE_INFINITE) force[1] = HUGE_VAL;
    if (mode == MODE_FAILS) return tinker_fail(batch, i, "the fuse has blown (put in a new one)");
    if (mode == MODE_FAILS_SILENTLY) return TINKER_FAILED;
    if (mode == MODE_NO_STATUS) return TINKER_FAILED + 40;
    return mode == MODE_NEVER ? TINKER_RETRY_SMALLER : TINKER_OK;
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerStatus status = misbehave(batch, i, &ends[i], &result[2 * i]);
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerPoint *ends, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const int mode = (int)tinker_column(batch, COLUMN_MODE)[i];
        stored[i] = 0.0;
        if (batch->time > 1.0 && mode == MODE_NAN_ENERGY) stored[i] = NAN;
        if (batch->time > 1.0 && mode == MODE_INFINITE_ENERGY) stored[i] = HUGE_VAL;
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("mode", "Mode", "Faulty", TINKER_DIMENSION_NONE), TINKER_ANY_VALUE(0, 0, 9)},
};

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = force, .energy = energy};

TEST_BLOCK("faulty", "Faulty", TINKER_FORCE, 1, 1, TINKER_ACCEPTS_BODY, .force_element = &element)
