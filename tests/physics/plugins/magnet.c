/* Magnets, softened: T = c L / r^5 - b L / r^14 + pull + resistance * rate with r^2 = L^2 + s^2. Where s is 0 they
 * attract without bound, unless their cores (b) hold them apart. Once with derivatives, once without. */
#include "block.h"

#include <math.h>

enum { COLUMN_STRENGTH, COLUMN_SOFTENING, COLUMN_CORE, COLUMN_PULL, COLUMN_RESISTANCE };

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double r = hypot(length[i], tinker_column(batch, COLUMN_SOFTENING)[i]);
        const double attraction = tinker_column(batch, COLUMN_STRENGTH)[i] / pow(r, 5);
        const double core = tinker_column(batch, COLUMN_CORE)[i] / pow(r, 14);
        result[i] = (attraction - core) * length[i] + tinker_column(batch, COLUMN_PULL)[i] +
                    tinker_column(batch, COLUMN_RESISTANCE)[i] * rate[i];
        if (!isfinite(result[i])) return tinker_retry(batch, i, "its ends are in one place");
    }
    return TINKER_OK;
}

/* dr/dL = L / r. */
static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double r = hypot(length[i], tinker_column(batch, COLUMN_SOFTENING)[i]), u = length[i] / r;
        by_length[i] = tinker_column(batch, COLUMN_STRENGTH)[i] * (1 - 5 * u * u) / pow(r, 5) -
                       tinker_column(batch, COLUMN_CORE)[i] * (1 - 14 * u * u) / pow(r, 14);
        by_rate[i] = tinker_column(batch, COLUMN_RESISTANCE)[i];
        if (!isfinite(by_length[i])) return tinker_retry(batch, i, "its ends are in one place");
    }
    return TINKER_OK;
}

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("strength", "C", "Magnet", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("softening", "S", "Magnet", TINKER_DIMENSION_LENGTH), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("core", "B", "Magnet", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("pull", "Pull", "Magnet", TINKER_DIMENSION_FORCE), TINKER_NOT_NEGATIVE(0, 10)},
    {TINKER_REAL_PROPERTY("resistance", "Resistance", "Magnet", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 10)},
};

static const TinkerLineLaw exact = {
    .struct_size = sizeof(TinkerLineLaw), .tension = tension, .derivatives = derivatives};
static const TinkerLineLaw plain = {.struct_size = sizeof(TinkerLineLaw), .tension = tension};
static const TinkerPhysics exact_physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &exact};
static const TinkerPhysics plain_physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &plain};
static const TinkerInterface exact_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &exact_physics}};
static const TinkerInterface plain_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &plain_physics}};

#define MAGNET(id_, title_, interfaces_)                                                                               \
    {                                                                                                                  \
        TINKER_BLOCK(id_, title_, TINKER_CONNECTOR), .summary = "A block for tests", .least_ends = 2, .most_ends = 2,  \
                                                     .end_accepts = TEST_ANY, .properties = TINKER_SPAN(properties),   \
                                                     .interfaces = TINKER_SPAN(interfaces_)                            \
    }

static const TinkerBlockType blocks[] = {
    MAGNET("magnet", "Magnet", exact_interfaces),
    MAGNET("plain-magnet", "Plain Magnet", plain_interfaces),
};

TINKER_DEFINE_PLUGIN("org.example.test.magnet", "Magnet", "1.0.0", "MIT", blocks)
