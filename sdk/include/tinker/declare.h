/* Tinker SDK: short ways to declare a block as data (C99 and later: they expand to designated initialisers).
 *
 *     static const TinkerPropertyType properties[] = {
 *         {TINKER_REAL_PROPERTY("stiffness", "K", "Spring Properties", TINKER_DIMENSION_STIFFNESS),
 *          TINKER_NOT_NEGATIVE(0, 200), .default_value = {25}, .symbol = "k", .variability = TINKER_TUNABLE},
 *     };
 *     static const TinkerQuantityType quantities[] = {
 *         TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
 *                         TINKER_DIMENSION_FORCE),
 *     };
 *     static const TinkerBlockType blocks[] = {{TINKER_BLOCK("spring", "Spring", TINKER_CONNECTOR), ...}};
 *     TINKER_DEFINE_PLUGIN("org.example.spring", "Spring", "1.0.0", "MIT", blocks)
 */
#ifndef TINKER_DECLARE_H
#define TINKER_DECLARE_H

#include "plugin.h"

/* Exponents of kg, m, s, rad. */
/* clang-format off */
#define TINKER_DIMENSION_NONE              {0, 0, 0, 0}
#define TINKER_DIMENSION_MASS              {1, 0, 0, 0}
#define TINKER_DIMENSION_LENGTH            {0, 1, 0, 0}
#define TINKER_DIMENSION_TIME              {0, 0, 1, 0}
#define TINKER_DIMENSION_ANGLE             {0, 0, 0, 1}
#define TINKER_DIMENSION_ANGULAR_FREQUENCY {0, 0, -1, 1}
#define TINKER_DIMENSION_VELOCITY          {0, 1, -1, 0}
#define TINKER_DIMENSION_ACCELERATION      {0, 1, -2, 0}
#define TINKER_DIMENSION_MOMENTUM          {1, 1, -1, 0}
#define TINKER_DIMENSION_FORCE             {1, 1, -2, 0}
#define TINKER_DIMENSION_ENERGY            {1, 2, -2, 0}
#define TINKER_DIMENSION_POWER             {1, 2, -3, 0}
#define TINKER_DIMENSION_STIFFNESS         {1, 0, -2, 0}
#define TINKER_DIMENSION_DAMPING           {1, 0, -1, 0}
#define TINKER_DIMENSION_QUADRATIC_DRAG    {1, -1, 0, 0}
/* clang-format on */

/* The first members of a property. The dimension comes last, because its braces hold commas. `panel` is -1 for the
 * block's own panel, or the end whose block shows the property. */
#define TINKER_PROPERTY_IN_PANEL(panel_, kind_, id_, title_, group_, ...)                                              \
    .struct_size = (uint32_t)sizeof(TinkerPropertyType), .kind = (kind_), .id = id_, .title = title_, .group = group_, \
    .panel = (panel_), .dimension = __VA_ARGS__

#define TINKER_REAL_PROPERTY(id_, title_, group_, ...)                                                                 \
    TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_REAL, id_, title_, group_, __VA_ARGS__)

#define TINKER_SWITCH_PROPERTY(id_, title_, group_)                                                                    \
    TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_SWITCH, id_, title_, group_, TINKER_DIMENSION_NONE)

#define TINKER_VECTOR_PROPERTY(id_, title_, group_, x_, y_, ...)                                                       \
    TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_VECTOR, id_, title_, group_, __VA_ARGS__), .component_titles = {x_, y_}

/* A list of points, as "0 0; 1 0; 0 1". */
#define TINKER_POINTS_PROPERTY(id_, title_, group_, points_, ...)                                                      \
    TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_TEXT, id_, title_, group_, __VA_ARGS__), .flags = TINKER_TEXT_POINTS,     \
                                                                                      .default_text = points_

/* A waveform that the properties "amplitude", "frequency" and "phase" of the same block scale, turn and shift. */
#define TINKER_WAVEFORM_IN_PANEL(panel_, id_, title_, group_, kind_, ...)                                              \
    TINKER_PROPERTY_IN_PANEL(panel_, TINKER_KIND_WAVEFORM, id_, title_, group_, __VA_ARGS__),                          \
        .default_text = kind_, .amplitude = "amplitude", .frequency = "frequency", .phase = "phase"

/* Ranges: the hard one, which the host enforces, and that of a slider. `more` are further flags, or 0. */
#define TINKER_ANY_VALUE(more, slider_from, slider_to)                                                                 \
    .flags = TINKER_HAS_SOFT_RANGE | (more), .soft_minimum = (slider_from), .soft_maximum = (slider_to)
#define TINKER_NOT_NEGATIVE(more, slider_to)                                                                           \
    .flags = TINKER_HAS_MINIMUM | TINKER_HAS_SOFT_RANGE | (more), .hard_minimum = 0.0, .soft_minimum = 0.0,            \
    .soft_maximum = (slider_to)
#define TINKER_POSITIVE(more, slider_from, slider_to)                                                                  \
    .flags = TINKER_HAS_MINIMUM | TINKER_OPEN_MINIMUM | TINKER_HAS_SOFT_RANGE | (more), .hard_minimum = 0.0,           \
    .soft_minimum = (slider_from), .soft_maximum = (slider_to)
#define TINKER_BETWEEN(more, least, greatest)                                                                          \
    .flags = TINKER_HAS_MINIMUM | TINKER_HAS_MAXIMUM | TINKER_HAS_SOFT_RANGE | (more), .hard_minimum = (least),        \
    .hard_maximum = (greatest), .soft_minimum = (least), .soft_maximum = (greatest)

/* The surface of a block that moves: three properties, each left out where it has none of its own. */
#define TINKER_SURFACE_PROPERTIES                                                                                      \
    {TINKER_REAL_PROPERTY("static_friction", "Static coefficient", "Friction", TINKER_DIMENSION_NONE),                 \
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_NONE, 1.0),                                                                    \
     .symbol = "μs",                                                                                                   \
     .meaning = TINKER_MEANING_STATIC_FRICTION,                                                                        \
     .variability = TINKER_TUNABLE,                                                                                    \
     .description = "Friction that holds it on what it touches, at most, per normal force"},                           \
        {TINKER_REAL_PROPERTY("dynamic_friction", "Dynamic coefficient", "Friction", TINKER_DIMENSION_NONE),           \
         TINKER_NOT_NEGATIVE(TINKER_DEFAULT_NONE, 1.0),                                                                \
         .symbol = "μd",                                                                                               \
         .meaning = TINKER_MEANING_DYNAMIC_FRICTION,                                                                   \
         .variability = TINKER_TUNABLE,                                                                                \
         .description = "Friction where it slides, per normal force; at most the static coefficient"},                 \
    {                                                                                                                  \
        TINKER_REAL_PROPERTY("restitution", "Restitution", "Properties", TINKER_DIMENSION_NONE),                       \
            TINKER_BETWEEN(TINKER_DEFAULT_NONE, 0.0, 1.0),                                                             \
            .symbol = "e", .meaning = TINKER_MEANING_RESTITUTION, .variability = TINKER_TUNABLE,                       \
            .description = "How much of its normal velocity it keeps when it bounces: 0 none, 1 all"                   \
    }

/* A whole quantity. */
#define TINKER_QUANTITY(flags_, id_, title_, description_, ...)                                                        \
    {                                                                                                                  \
        (uint32_t)sizeof(TinkerQuantityType), (flags_), id_, title_, description_, __VA_ARGS__, 0                      \
    }

/* The six quantities of a point that tinker_point_values (kernels.h) works out, in its order: place, velocity,
 * acceleration. */
#define TINKER_POINT_QUANTITIES(flags_)                                                                                \
    TINKER_QUANTITY(flags_, "x", "X Position", "Horizontal place of the centre", TINKER_DIMENSION_LENGTH),             \
        TINKER_QUANTITY(flags_, "y", "Y Position", "Vertical place of the centre", TINKER_DIMENSION_LENGTH),           \
        TINKER_QUANTITY(flags_, "vx", "X Velocity", "Horizontal velocity", TINKER_DIMENSION_VELOCITY),                 \
        TINKER_QUANTITY(flags_, "vy", "Y Velocity", "Vertical velocity", TINKER_DIMENSION_VELOCITY),                   \
        TINKER_QUANTITY(0, "ax", "X Acceleration", "Horizontal acceleration", TINKER_DIMENSION_ACCELERATION),          \
        TINKER_QUANTITY(0, "ay", "Y Acceleration", "Vertical acceleration", TINKER_DIMENSION_ACCELERATION)

/* The three quantities of what stands on something, or is stood on, that tinker_contact_values (kernels.h) works out,
 * in its order. */
#define TINKER_CONTACT_QUANTITIES                                                                                      \
    TINKER_QUANTITY(0, "normal force", "Normal Force", "What presses across the tops in contact; never negative",      \
                    TINKER_DIMENSION_FORCE),                                                                           \
        TINKER_QUANTITY(0, "friction force", "Friction Force",                                                         \
                        "Friction in contacts, positive towards +x of the support's own axes",                         \
                        TINKER_DIMENSION_FORCE),                                                                       \
        TINKER_QUANTITY(0, "contact force", "Contact Force", "Magnitude of the whole force of all contacts",           \
                        TINKER_DIMENSION_FORCE)

/* An equation of a block's law. */
#define TINKER_EQUATION(symbol_, is_, means_, ...)                                                                     \
    {                                                                                                                  \
        (uint32_t)sizeof(TinkerLawEquation), 0, symbol_, is_, means_, __VA_ARGS__, 0                                   \
    }

/* The first members of a block type. */
#define TINKER_BLOCK(id_, title_, category_)                                                                           \
    .struct_size = (uint32_t)sizeof(TinkerBlockType), .schema_version = 1, .id = id_, .title = title_,                 \
    .category = category_

/* The entry of a plugin whose blocks stand in the static array `blocks_`, and which needs no service and no init. */
#define TINKER_DEFINE_PLUGIN(id_, title_, version_, licence_, blocks_)                                                 \
    static const TinkerPlugin tinker_the_plugin = {                                                                    \
        TINKER_PLUGIN_HEAD, id_, title_, version_, licence_, "", TINKER_SPAN(blocks_), TINKER_NO_SPAN,                 \
        TINKER_NO_SPAN,     NULL};                                                                                     \
    TINKER_DEFINE_ENTRY

/* Declares a plugin whose integrators stand in the static array `integrators_`. */
#define TINKER_DEFINE_INTEGRATOR_PLUGIN(id_, title_, version_, licence_, integrators_)                                 \
    static const TinkerPlugin tinker_the_plugin = {TINKER_PLUGIN_HEAD, id_, title_,         version_,                  \
                                                   licence_,           "",  TINKER_NO_SPAN, TINKER_SPAN(integrators_), \
                                                   TINKER_NO_SPAN,     NULL};                                          \
    TINKER_DEFINE_ENTRY

#define TINKER_DEFINE_ENTRY                                                                                            \
    const TinkerPlugin *tinker_plugin_v1(void)                                                                         \
    {                                                                                                                  \
        return &tinker_the_plugin;                                                                                     \
    }

#endif
