/* Motor: a force on one body that is a function of time, F(t) along an angle. It stores nothing: its power is booked as
 * given by motors. */
#include <tinker/sdk.h>

enum {
    COLUMN_WAVEFORM, /* value, first and second derivative */
    COLUMN_AMPLITUDE = COLUMN_WAVEFORM + 3,
    COLUMN_FREQUENCY,
    COLUMN_PHASE,
    COLUMN_ANGLE,
    COLUMN_FOLLOWS,
};

enum { QUANTITY_FORCE, QUANTITY_POWER };

/* Physics */

/* The angle is in the world, or in the axes of what the motor is on, which is turned by `turned`. */
static double angle_of(double angle, double follows, double turned)
{
    return follows != 0.0 ? angle + turned : angle;
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *value = tinker_column(batch, COLUMN_WAVEFORM), *angle = tinker_column(batch, COLUMN_ANGLE);
    const double *follows = tinker_column(batch, COLUMN_FOLLOWS);
    for (int32_t i = 0; i < batch->count; i++) {
        double direction[2];
        tinker_direction(angle_of(angle[i], follows[i], batch->poses[i].angle), direction);
        result[2 * i] = value[i] * direction[0];
        result[2 * i + 1] = value[i] * direction[1];
    }
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, double *constant, double *direction, int32_t *waveform_column)
{
    const double *angle = tinker_column(batch, COLUMN_ANGLE), *follows = tinker_column(batch, COLUMN_FOLLOWS);
    for (int32_t i = 0; i < batch->count; i++) {
        if (follows[i] != 0.0) return TINKER_RETRY_SMALLER;
        constant[2 * i] = constant[2 * i + 1] = 0.0;
        tinker_direction(angle[i], &direction[2 * i]);
        waveform_column[i] = COLUMN_WAVEFORM;
    }
    return TINKER_OK;
}

/* Drawing */

/* From the body along the force, as long as the force is large: 5 symbols for the amplitude, and for what an expression
 * makes larger than it. Never shorter than a fifth of that, so that it can be seen and picked where the force is 0. */
static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    const double value = instance->columns[COLUMN_WAVEFORM];
    const double greatest = fmax(fabs(instance->columns[COLUMN_AMPLITUDE]), fabs(value));
    const double part = greatest > 0.0 ? value / greatest : 0.0;
    double direction[2];
    tinker_direction(
        angle_of(instance->columns[COLUMN_ANGLE], instance->columns[COLUMN_FOLLOWS], instance->end[0].angle),
        direction);
    return tinker_arrow_from(instance->end[0].x, instance->end[0].y, direction,
                             5.0 * symbol_size * copysign(fmax(fabs(part), 0.2), part));
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    if (instance->columns[COLUMN_WAVEFORM] != 0.0) {
        style->arrow(style, cairo, TINKER_COLOUR_FORCE, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    } else {
        style->line(style, cairo, TINKER_COLOUR_FORCE, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    }
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

/* Dragging the tip turns the force; while the force is negative the tip lies on the other side. */
static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        const double side = copysign(1.0, instance->columns[COLUMN_WAVEFORM]);
        const double dx = side * (x - instance->end[0].x), dy = side * (y - instance->end[0].y);
        if (instance->columns[COLUMN_FOLLOWS] == 0.0) {
            tinker_set_angle(editor, COLUMN_ANGLE, dx, dy);
        } else if (dx != 0.0 || dy != 0.0) {
            editor->set(editor, COLUMN_ANGLE, atan2(dy, dx) - instance->end[0].angle);
        }
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

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *value = tinker_column(batch, COLUMN_WAVEFORM), *angle = tinker_column(batch, COLUMN_ANGLE);
    const double *follows = tinker_column(batch, COLUMN_FOLLOWS);
    const TinkerPose *poses = TINKER_HAS(TinkerGraphInput, input, poses) ? input->poses : NULL;
    for (int32_t i = 0; i < batch->count; i++) {
        double direction[2];
        tinker_direction(angle_of(angle[i], follows[i], poses != NULL ? poses[i].angle : 0.0), direction);
        const double along = direction[0] * input->ends[i].vx + direction[1] * input->ends[i].vy;
        result[i] = quantity == QUANTITY_FORCE ? value[i] : value[i] * along;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Type", "Force", "cosine", TINKER_DIMENSION_FORCE), .symbol = "F",
     .variability = TINKER_TUNABLE, .description = "How the force depends on time"},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Force", TINKER_DIMENSION_FORCE), TINKER_ANY_VALUE(0, -20.0, 20.0),
     .default_value = {1.0}, .symbol = "A", .variability = TINKER_TUNABLE, .description = "Greatest force"},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Force", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0.0, 20.0), .default_value = {1.0}, .symbol = "ω", .variability = TINKER_TUNABLE,
     .description = "Angular frequency"},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Force", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "φ", .variability = TINKER_TUNABLE,
     .description = "Phase at t = 0"},
    {TINKER_REAL_PROPERTY("angle", "Angle", "Force", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "θ", .variability = TINKER_TUNABLE,
     .description = "Direction of the force, counter-clockwise from the right"},
    {TINKER_SWITCH_PROPERTY("follows", "Follows", "Force"), .symbol = "f", .variability = TINKER_STRUCTURAL,
     .description = "Whether the angle is counted from the axes of what it is on, and turns with it"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "F*cos(θ + f*theta)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "F*sin(θ + f*theta)", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "force", "Force", "Force along its angle", TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "power", "Power", "Power given to the body", TINKER_DIMENSION_POWER),
};

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .angles = 1, .force = force, .linear = linear};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"frequency", "rad/s", "rad/s"}, {"phase", "deg", "deg"}, {"angle", "deg", "deg"}, {"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("motor", "Motor", TINKER_FORCE), .summary = "A force on one mass that varies with time",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.motor", "Motor", "0.1.0", "MIT", blocks)
