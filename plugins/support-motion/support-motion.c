/* Support motion: displaces a support from its place by a function of time, u(t) along an angle. Its properties are
 * shown in the support's panel. */
#include <tinker/sdk.h>

enum {
    COLUMN_WAVEFORM, /* value, first and second derivative */
    COLUMN_VELOCITY,
    COLUMN_ACCELERATION,
    COLUMN_AMPLITUDE,
    COLUMN_FREQUENCY,
    COLUMN_PHASE,
    COLUMN_ANGLE,
};

/* Physics */

static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    const double *u = tinker_column(batch, COLUMN_WAVEFORM), *du = tinker_column(batch, COLUMN_VELOCITY);
    const double *ddu = tinker_column(batch, COLUMN_ACCELERATION), *angle = tinker_column(batch, COLUMN_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        double direction[2];
        tinker_direction(angle[i], direction);
        for (int axis = 0; axis < 2; axis++) {
            displacement[2 * i + axis] = u[i] * direction[axis];
            velocity[2 * i + axis] = du[i] * direction[axis];
            acceleration[2 * i + axis] = ddu[i] * direction[axis];
        }
    }
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, double *direction, int32_t *waveform_column)
{
    const double *angle = tinker_column(batch, COLUMN_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        tinker_direction(angle[i], &direction[2 * i]);
        waveform_column[i] = COLUMN_WAVEFORM;
    }
    return TINKER_OK;
}

/* Drawing */

/* A double arrow across the support's centre, along the motion. */
static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    double direction[2];
    tinker_direction(instance->columns[COLUMN_ANGLE], direction);
    const double x = instance->end[0].x, y = instance->end[0].y, half = 3.0 * symbol_size;
    return tinker_arrow_from(x - half * direction[0], y - half * direction[1], direction, 2.0 * half);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    style->arrow(style, cairo, TINKER_COLOUR_MOTION, instance->end[0].x, instance->end[0].y, arrow.x1, arrow.y1);
    style->arrow(style, cairo, TINKER_COLOUR_MOTION, instance->end[0].x, instance->end[0].y, arrow.x2, arrow.y2);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    tinker_arrow_bounds(&arrow, tinker_drawing_margin(style), box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    return tinker_arrow_is_hit(&arrow, x, y, reach) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        tinker_set_angle(editor, COLUMN_ANGLE, x - instance->end[0].x, y - instance->end[0].y);
    } else {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    }
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
        move_absolute(instance, part, arrow.x2 + dx, arrow.y2 + dy, editor);
    } else {
        tinker_ends_move(instance, part, dx, dy, editor);
    }
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, arrow.x2, arrow.y2);
}

/* Graphs: the three quantities are the waveform's three columns. */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *column = tinker_column(batch, COLUMN_WAVEFORM + quantity);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = column[i];
    }
    return TINKER_OK;
}

/* Tables */

/* Shown where its support is, not in a panel of its own. */
#define PANEL_OF_SUPPORT 0

static const TinkerPropertyType properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(PANEL_OF_SUPPORT, "waveform", "Type", "Motion", "sine", TINKER_DIMENSION_LENGTH),
     .symbol = "u", .variability = TINKER_STRUCTURAL, .description = "How the displacement depends on time"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "amplitude", "Amplitude", "Motion",
                              TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -2.0, 2.0), .symbol = "A", .variability = TINKER_STRUCTURAL,
     .description = "Greatest displacement from its place"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "frequency", "Frequency", "Motion",
                              TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0.0, 20.0), .symbol = "ω", .variability = TINKER_STRUCTURAL,
     .description = "Angular frequency"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "phase", "Phase", "Motion", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "φ", .variability = TINKER_STRUCTURAL,
     .description = "Phase at t = 0"},
    {TINKER_PROPERTY_IN_PANEL(PANEL_OF_SUPPORT, TINKER_KIND_REAL, "angle", "Angle", "Motion", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "θ", .variability = TINKER_STRUCTURAL,
     .description = "Direction of the motion, counter-clockwise from the right"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("displacement_x", "u*cos(θ)", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("displacement_y", "u*sin(θ)", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "displacement", "Displacement", "Along its angle, from the support's place",
                    TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(0, "velocity", "Velocity", "Along its angle", TINKER_DIMENSION_VELOCITY),
    TINKER_QUANTITY(0, "acceleration", "Acceleration", "Along its angle", TINKER_DIMENSION_ACCELERATION),
};

static const TinkerMotion motion_role = {.struct_size = sizeof(TinkerMotion), .motion = motion, .linear = linear};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .motion = &motion_role};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"frequency", "rad/s", "rad/s"}, {"phase", "deg", "deg"}, {"angle", "deg", "deg"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("support-motion", "Support Motion", TINKER_MOTION), .summary = "Moves a support as time goes",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.support-motion", "Support Motion", "0.1.0", "MIT", blocks)
