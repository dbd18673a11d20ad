/* Support turn: turns a support about its centre by a function of time, beside its orientation. Its properties are
 * shown in the support's panel. */
#include <tinker/sdk.h>

enum {
    COLUMN_WAVEFORM, /* value, first and second derivative */
    COLUMN_AMPLITUDE = COLUMN_WAVEFORM + 3,
    COLUMN_FREQUENCY,
    COLUMN_PHASE,
};

#define RADIUS 2.4 /* of what is drawn, in symbols */

/* Physics */

static TinkerStatus rotation(TinkerBatch *batch, TinkerPose *rotation)
{
    const double *w = tinker_column(batch, COLUMN_WAVEFORM), *dw = tinker_column(batch, COLUMN_WAVEFORM + 1);
    const double *ddw = tinker_column(batch, COLUMN_WAVEFORM + 2);
    for (int32_t i = 0; i < batch->count; i++) {
        rotation[i].angle = w[i];
        rotation[i].rate = dw[i];
        rotation[i].acceleration = ddw[i];
    }
    return TINKER_OK;
}

/* Drawing: an arc with a head at both ends */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *at = &instance->end[0];
    const double radius = RADIUS * style->symbol_size, middle = at->angle + 0.5 * TINKER_PI;
    tinker_draw_arc(style, cairo, TINKER_COLOUR_MOTION, at->x, at->y, middle - 0.8, middle + 0.8, radius, radius);
    for (int side = -1; side <= 1; side += 2) {
        const double from = middle + side * 0.8, to = middle + side * 0.9;
        style->arrow(style, cairo, TINKER_COLOUR_MOTION, at->x + radius * cos(from), at->y + radius * sin(from),
                     at->x + radius * cos(to), at->y + radius * sin(to));
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_round_bounds(instance, style, (RADIUS + 1.0) * style->symbol_size, box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double radius = RADIUS * tinker_instance_symbol_size(instance);
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    const double out = tinker_length(x - instance->end[0].x, y - instance->end[0].y);
    if (part != TINKER_PART_NONE) return part;
    return fabs(out - radius) <= reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* Graphs: the three quantities are the waveform's three columns. */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *column = tinker_column(batch, COLUMN_WAVEFORM + quantity);
    (void)input;
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = column[i];
    }
    return TINKER_OK;
}

/* Tables */

/* Shown where its support is, not in a panel of its own. */
#define PANEL_OF_SUPPORT 0

static const TinkerPropertyType properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(PANEL_OF_SUPPORT, "waveform", "Type", "Turning", "none", TINKER_DIMENSION_ANGLE),
     .symbol = "u", .variability = TINKER_STRUCTURAL, .description = "How the angle depends on time"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "amplitude", "Amplitude", "Turning",
                              TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "A", .variability = TINKER_STRUCTURAL,
     .description = "Greatest angle from its orientation"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "frequency", "Frequency", "Turning",
                              TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0.0, 20.0), .symbol = "ω", .variability = TINKER_STRUCTURAL,
     .description = "Angular frequency"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "phase", "Phase", "Turning", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "φ", .variability = TINKER_STRUCTURAL,
     .description = "Phase at t = 0"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("rotation", "u", NULL, TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "angle", "Angle", "By which it is turned, beside its orientation", TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(0, "angular velocity", "Angular Velocity", "How fast it turns", TINKER_DIMENSION_ANGULAR_FREQUENCY),
    TINKER_QUANTITY(0, "angular acceleration", "Angular Acceleration", "How fast the angular velocity grows",
                    {0, 0, -2, 1}),
};

static const TinkerMotion motion_role = {.struct_size = sizeof(TinkerMotion), .rotation = rotation};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .motion = &motion_role};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"waveform", "deg", "deg"},
                                                {"amplitude", "deg", "deg"},
                                                {"frequency", "rad/s", "rad/s"},
                                                {"phase", "deg", "deg"},
                                                {"angle", "deg", "deg"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("support-turn", "Support Turn", TINKER_MOTION), .summary = "Turns a support as time goes",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.support-turn", "Support Turn", "0.1.0", "MIT", blocks)
