/* Force elements, a field and a body. */
#include "planted.h"

/* pair: F = k d on the first end and minus that on the second; it tells of no store. */

static TinkerStatus pair_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y;
        double k = tinker_column(batch, STIFFNESS)[i];
        double *f = &force[4 * i];
#if defined(PLANT_place)
        const double rest = tinker_column(batch, REST_LENGTH)[i];
        const double x = a->x + batch->origin[0], y = a->y + batch->origin[1];
        k *= 1 + 0.01 * (x * x + y * y) / (rest * rest);
#elif defined(PLANT_direction)
        const double length = tinker_length(dx, dy);
        k *= 1 + 0.1 * (length == 0 ? 0 : fabs(dx) / length);
#endif
#if defined(PLANT_origin)
        k *= 1 + 0.01 * fabs(batch->origin[0]) / tinker_column(batch, REST_LENGTH)[i];
#endif
        f[0] = k * dx;
        f[1] = k * dy;
        f[2] = -f[0];
        f[3] = -f[1];
#if defined(PLANT_unbalanced)
        f[2] *= 1.001;
        f[3] *= 1.001;
#elif defined(PLANT_moment)
        f[0] -= k * dy;
        f[1] += k * dx;
        f[2] += k * dy;
        f[3] -= k * dx;
#endif
    }
    return TINKER_OK;
}

/* follow: a jet at the first end, held along the line from the second: forces do not sum to zero, and need not. */

static TinkerStatus follow_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = a->x - b->x, dy = a->y - b->y, length = tinker_length(dx, dy);
        const double thrust = length == 0 ? 0 : tinker_column(batch, 0)[i];
        force[4 * i] = length == 0 ? 0 : thrust * (dx / length);
        force[4 * i + 1] = length == 0 ? 0 : thrust * (dy / length);
        force[4 * i + 2] = force[4 * i + 3] = 0;
    }
    return TINKER_OK;
}

/* gather: each body is drawn to all others, k d. */

static TinkerStatus gather_force(TinkerBatch *batch, const TinkerBodies *bodies, double *force)
{
    double k = 0;
    for (int32_t i = 0; i < batch->count; i++)
        k += tinker_column(batch, STIFFNESS)[i];
    for (int32_t b = 0; b < bodies->range; b++) {
        const TinkerPoint *own = &bodies->points[bodies->first + b];
        double x = 0, y = 0;
        for (int32_t other = 0; other < bodies->count; other++) {
            x += bodies->points[other].x - own->x;
            y += bodies->points[other].y - own->y;
        }
        force[2 * b] = k * x;
        force[2 * b + 1] = k * y;
#if defined(PLANT_body_nan)
        if (own->x == 0) force[2 * b] = NAN;
#endif
    }
    return TINKER_OK;
}

#if defined(PLANT_property_id)
#define THRUST_ID "thr ust"
#else
#define THRUST_ID "thrust"
#endif

const TinkerPropertyType planted_follow_properties[] = {
    {TINKER_REAL_PROPERTY(THRUST_ID, "Thrust", "Follow", TINKER_DIMENSION_FORCE), TINKER_ANY_VALUE(0, -5, 5),
     .default_value = {1}, .description = "How strong the jet is"},
};

const TinkerPropertyType planted_gather_properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Gather", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 5),
     .default_value = {1}, .description = "How strong it is"},
};

const TinkerPropertyType planted_ball_properties[] = {
    {TINKER_REAL_PROPERTY("mass", "Mass", "Ball", TINKER_DIMENSION_MASS), TINKER_POSITIVE(0, 0.1, 10),
     .default_value = {1}, .symbol = "m", .meaning = TINKER_MEANING_MASS, .description = "How heavy it is"},
    {TINKER_REAL_PROPERTY("inertia", "Inertia", "Ball", {1, 2, 0, 0}), TINKER_POSITIVE(0, 0.1, 10),
     .default_value = {1}, .meaning = TINKER_MEANING_INERTIA, .description = "How hard it is to turn"},
    {TINKER_VECTOR_PROPERTY("position", "Position", "Place", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10, 10), .meaning = TINKER_MEANING_POSITION, .description = "Where it starts"},
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Start", "Vx", "Vy", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -10, 10), .meaning = TINKER_MEANING_VELOCITY, .description = "How it starts"},
};

static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = pair_force};

static const TinkerForceElement follow_element = {.struct_size = sizeof(TinkerForceElement), .force = follow_force};

#if defined(PLANT_alone)
#define COUPLES 0
#else
#define COUPLES 1
#endif
static const TinkerField field = {.struct_size = sizeof(TinkerField), .couples_bodies = COUPLES, .force = gather_force};

static const TinkerPhysics pair = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};

static const TinkerPhysics follow = {.struct_size = sizeof(TinkerPhysics), .force_element = &follow_element};

static const TinkerPhysics gather = {.struct_size = sizeof(TinkerPhysics), .field = &field};

#if defined(PLANT_freedoms)
#define FREEDOMS 1
#else
#define FREEDOMS 2
#endif
static const TinkerBody ball_body = {.struct_size = sizeof(TinkerBody), .degrees_of_freedom = FREEDOMS};
static const TinkerPhysics ball = {.struct_size = sizeof(TinkerPhysics), .body = &ball_body};

const TinkerInterface planted_pair_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pair}};

const TinkerInterface planted_follow_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &follow}};

const TinkerInterface planted_gather_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &gather}};

const TinkerInterface planted_ball_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &ball}};
