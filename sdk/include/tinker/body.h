/* Tinker SDK: what blocks that turn have in common, whatever their shape: properties, quantities, editing. C99 and
 * later.
 *
 *     enum { COLUMN_RADIUS = TINKER_BODY_COLUMNS };
 *     static const TinkerPropertyType properties[] = {
 *         TINKER_BODY_PROPERTIES(TINKER_SOLID),
 *         {TINKER_REAL_PROPERTY("radius", "Radius", "Size", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 2.0),
 *          .default_value = {0.4}, .variability = TINKER_STRUCTURAL},
 *     };
 *     static const TinkerQuantityType quantities[] = {TINKER_BODY_QUANTITIES};
 *     static const TinkerBody body = {sizeof(TinkerBody), 3, TINKER_SHAPE_DISC, 0, as_shaped};
 *     static const TinkerGraph graph = {sizeof(TinkerGraph), 0, tinker_body_values};
 */
#ifndef TINKER_BODY_H
#define TINKER_BODY_H

#include "declare.h"
#include "kernels.h"
#include "shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The columns of TINKER_BODY_PROPERTIES, which come first; those of the block's own properties begin behind them. */
enum {
    TINKER_BODY_MASS,
    TINKER_BODY_INERTIA,
    TINKER_BODY_POSITION,
    TINKER_BODY_ORIENTATION = TINKER_BODY_POSITION + 2,
    TINKER_BODY_VELOCITY,
    TINKER_BODY_ANGULAR_VELOCITY = TINKER_BODY_VELOCITY + 2,
    TINKER_BODY_LOCAL_ORIGIN,
    TINKER_BODY_SOLID = TINKER_BODY_LOCAL_ORIGIN + 2,
    TINKER_BODY_STATIC_FRICTION,
    TINKER_BODY_DYNAMIC_FRICTION,
    TINKER_BODY_RESTITUTION,
    TINKER_BODY_COLUMNS
};

/* Its number among the properties: what TinkerBody.as_shaped is asked for. */
#define TINKER_BODY_INERTIA_PROPERTY 1

/* Whether it is solid where a scene does not say. */
#define TINKER_SOLID     1
#define TINKER_NOT_SOLID 0

#define TINKER_DIMENSION_INERTIA                                                                                       \
    {                                                                                                                  \
        1, 2, 0, 0                                                                                                     \
    }

#define TINKER_BODY_PROPERTIES(solid_)                                                                                 \
    {TINKER_REAL_PROPERTY("mass", "Mass", "Properties", TINKER_DIMENSION_MASS),                                        \
     TINKER_POSITIVE(0, 0.1, 10.0),                                                                                    \
     .default_value = {1.0},                                                                                           \
     .symbol = "m",                                                                                                    \
     .meaning = TINKER_MEANING_MASS,                                                                                   \
     .variability = TINKER_STRUCTURAL,                                                                                 \
     .description = "How much it resists being accelerated"},                                                          \
        {TINKER_REAL_PROPERTY("inertia", "Inertia", "Properties", TINKER_DIMENSION_INERTIA),                           \
         TINKER_POSITIVE(TINKER_DEFAULT_AS_SHAPED, 0.01, 10.0),                                                        \
         .symbol = "I",                                                                                                \
         .meaning = TINKER_MEANING_INERTIA,                                                                            \
         .variability = TINKER_STRUCTURAL,                                                                             \
         .description = "How much it resists being turned, about its centre of mass"},                                 \
        {TINKER_VECTOR_PROPERTY("position", "Position", "Global Position", "X", "Y", TINKER_DIMENSION_LENGTH),         \
         TINKER_ANY_VALUE(TINKER_REQUIRED, -10.0, 10.0),                                                               \
         .symbol = "x",                                                                                                \
         .meaning = TINKER_MEANING_POSITION,                                                                           \
         .variability = TINKER_INITIAL,                                                                                \
         .description = "Where its centre of mass starts"},                                                            \
        {TINKER_REAL_PROPERTY("orientation", "Orientation", "Properties", TINKER_DIMENSION_ANGLE),                     \
         TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .meaning = TINKER_MEANING_ORIENTATION,                            \
         .variability = TINKER_INITIAL, .description = "How it is turned at the start, counter-clockwise"},            \
        {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Initial Velocity", "Vx", "Vy", TINKER_DIMENSION_VELOCITY),    \
         TINKER_ANY_VALUE(0, -10.0, 10.0),                                                                             \
         .symbol = "v",                                                                                                \
         .meaning = TINKER_MEANING_VELOCITY,                                                                           \
         .variability = TINKER_INITIAL,                                                                                \
         .description = "How its centre of mass moves at the start"},                                                  \
        {TINKER_REAL_PROPERTY("angular_velocity", "Angular Velocity", "Initial Velocity",                              \
                              TINKER_DIMENSION_ANGULAR_FREQUENCY),                                                     \
         TINKER_ANY_VALUE(0, -10.0, 10.0), .meaning = TINKER_MEANING_ANGULAR_VELOCITY, .variability = TINKER_INITIAL,  \
         .description = "How fast it turns at the start, counter-clockwise"},                                          \
        {TINKER_VECTOR_PROPERTY("local_origin", "Local Origin", "Offset (Local Coordinates)", "X", "Y",                \
                                TINKER_DIMENSION_LENGTH),                                                              \
         TINKER_ANY_VALUE(TINKER_DEFAULT_SAME_AS, -10.0, 10.0),                                                        \
         .default_from = "position",                                                                                   \
         .meaning = TINKER_MEANING_LOCAL_ORIGIN,                                                                       \
         .variability = TINKER_TUNABLE,                                                                                \
         .description = "Where its offset is measured from; the motion does not depend on it"},                        \
        {TINKER_SWITCH_PROPERTY("solid", "Solid", "Properties"), .default_value = {solid_},                            \
         .meaning = TINKER_MEANING_SOLID, .variability = TINKER_STRUCTURAL,                                            \
         .description = "Whether it meets the solid sides of supports, and other solid bodies"},                       \
        TINKER_SURFACE_PROPERTIES

/* The quantities that tinker_body_values works out, in its order. */
#define TINKER_BODY_QUANTITIES                                                                                         \
    TINKER_QUANTITY(TINKER_RECORDED, "x", "X Position", "Horizontal place of the centre of mass",                      \
                    TINKER_DIMENSION_LENGTH),                                                                          \
        TINKER_QUANTITY(TINKER_RECORDED, "y", "Y Position", "Vertical place of the centre of mass",                    \
                        TINKER_DIMENSION_LENGTH),                                                                      \
        TINKER_QUANTITY(TINKER_RECORDED, "vx", "X Velocity", "Horizontal velocity", TINKER_DIMENSION_VELOCITY),        \
        TINKER_QUANTITY(TINKER_RECORDED, "vy", "Y Velocity", "Vertical velocity", TINKER_DIMENSION_VELOCITY),          \
        TINKER_QUANTITY(TINKER_RECORDED, "angle", "Angle", "How it is turned, counter-clockwise, counting turns",      \
                        TINKER_DIMENSION_ANGLE),                                                                       \
        TINKER_QUANTITY(TINKER_RECORDED, "angular velocity", "Angular Velocity", "How fast it turns",                  \
                        TINKER_DIMENSION_ANGULAR_FREQUENCY),                                                           \
        TINKER_QUANTITY(0, "ax", "X Acceleration", "Horizontal acceleration", TINKER_DIMENSION_ACCELERATION),          \
        TINKER_QUANTITY(0, "ay", "Y Acceleration", "Vertical acceleration", TINKER_DIMENSION_ACCELERATION),            \
        TINKER_QUANTITY(0, "angular acceleration", "Angular Acceleration", "How fast the angular velocity grows",      \
                        {0, 0, -2, 1}),                                                                                \
        TINKER_QUANTITY(0, "kinetic energy", "Kinetic Energy", "m v^2 / 2 + I w^2 / 2", TINKER_DIMENSION_ENERGY),      \
        TINKER_QUANTITY(0, "translational energy", "Translational Energy", "m v^2 / 2", TINKER_DIMENSION_ENERGY),      \
        TINKER_QUANTITY(0, "rotational energy", "Rotational Energy", "I w^2 / 2", TINKER_DIMENSION_ENERGY),            \
        TINKER_QUANTITY(0, "angular momentum", "Angular Momentum", "I w, about the centre of mass", {1, 2, -1, 0}),    \
        TINKER_CONTACT_QUANTITIES,                                                                                     \
        TINKER_QUANTITY(0, "speed", "Speed", "Magnitude of the velocity", TINKER_DIMENSION_VELOCITY),                  \
        TINKER_QUANTITY(0, "acceleration", "Acceleration", "Magnitude of the acceleration",                            \
                        TINKER_DIMENSION_ACCELERATION),                                                                \
        TINKER_QUANTITY(0, "x momentum", "X Momentum", "m vx", TINKER_DIMENSION_MOMENTUM),                             \
        TINKER_QUANTITY(0, "y momentum", "Y Momentum", "m vy", TINKER_DIMENSION_MOMENTUM)

/* TinkerGraph.values of a block with these properties and quantities. */
static inline TinkerStatus tinker_body_values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity,
                                              double *values)
{
    static const int32_t of_point[] = {0, 1, 2, 3, -1, -1, 4, 5};
    const double *mass = tinker_column(batch, TINKER_BODY_MASS), *inertia = tinker_column(batch, TINKER_BODY_INERTIA);
    const TinkerPose *poses = TINKER_HAS(TinkerGraphInput, input, poses) ? input->poses : NULL;
    if (quantity < 8 && of_point[quantity] >= 0) return tinker_point_values(batch, input, of_point[quantity], values);
    if (quantity >= 13 && quantity < 16) return tinker_contact_values(batch, input, quantity - 13, values);
    if (quantity >= 16) return tinker_centre_values(batch, input, mass, quantity - 16, values);
    if (poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *point = &input->ends[i];
        const double translational = 0.5 * mass[i] * (point->vx * point->vx + point->vy * point->vy);
        const double rotational = 0.5 * inertia[i] * poses[i].rate * poses[i].rate;
        values[i] = quantity == 4    ? poses[i].angle
                    : quantity == 5  ? poses[i].rate
                    : quantity == 8  ? poses[i].acceleration
                    : quantity == 9  ? translational + rotational
                    : quantity == 10 ? translational
                    : quantity == 11 ? rotational
                                     : inertia[i] * poses[i].rate;
    }
    return TINKER_OK;
}

/* The columns for the functions of boxes (shapes.h), of a block whose box is so wide and so high. */
#define TINKER_BODY_BOX(width_, height_)                                                                               \
    {                                                                                                                  \
        TINKER_BODY_POSITION, TINKER_BODY_LOCAL_ORIGIN, TINKER_BODY_ORIENTATION, (width_), (height_)                   \
    }

/* The units that its quantities are shown in at first. */
#define TINKER_BODY_UNITS                                                                                              \
    {"orientation", "deg", "deg"}, {"kinetic energy", "J", "lbf*ft"}, {"translational energy", "J", "lbf*ft"},         \
        {"rotational energy", "J", "lbf*ft"}, {"x momentum", "kg*m/s", "slug*ft/s"},                                   \
    {                                                                                                                  \
        "y momentum", "kg*m/s", "slug*ft/s"                                                                            \
    }

#ifdef __cplusplus
}
#endif
#endif
