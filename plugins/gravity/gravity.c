/* Gravity: the same acceleration on all masses, F = m g, with the potential energy -m g . x. */
#include <tinker/sdk.h>

enum { COLUMN_ACCELERATION, COLUMN_ANGLE };

/* Physics */

static void acceleration_of(const TinkerBatch *batch, int32_t i, double acceleration[2])
{
    const double magnitude = tinker_column(batch, COLUMN_ACCELERATION)[i];
    tinker_direction(tinker_column(batch, COLUMN_ANGLE)[i], acceleration);
    acceleration[0] *= magnitude;
    acceleration[1] *= magnitude;
}

/* All instances act at once: their accelerations add up. */
static void total_acceleration(const TinkerBatch *batch, double total[2])
{
    total[0] = total[1] = 0.0;
    for (int32_t i = 0; i < batch->count; i++) {
        double acceleration[2];
        acceleration_of(batch, i, acceleration);
        total[0] += acceleration[0];
        total[1] += acceleration[1];
    }
}

static void force_loop(int32_t count, const double *restrict mass, double ax, double ay, double *restrict result)
{
    for (int32_t i = 0; i < count; i++) {
        result[2 * i] = mass[i] * ax;
        result[2 * i + 1] = mass[i] * ay;
    }
}

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    double total[2];
    total_acceleration(batch, total);
    force_loop(bodies->range, &bodies->masses[bodies->first], total[0], total[1], result);
    return TINKER_OK;
}

/* Positions count from where the caller does, which shifts the energy by a constant and keeps its digits. */
static double energy_of(int32_t count, const TinkerPoint *points, const double *masses, const double acceleration[2])
{
    double sum = 0.0;
    for (int32_t k = 0; k < count; k++) {
        sum -= masses[k] * (acceleration[0] * points[k].x + acceleration[1] * points[k].y);
    }
    return sum;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerBodies *bodies, double *potential)
{
    double total[2];
    total_acceleration(batch, total);
    *potential = energy_of(bodies->count, bodies->points, bodies->masses, total);
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, TinkerLinearField *law)
{
    for (int32_t i = 0; i < batch->count; i++) {
        acceleration_of(batch, i, law[i].acceleration);
        law[i].force[0] = law[i].force[1] = law[i].drag = 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const TinkerBodies *bodies, double *jacobian)
{
    for (int32_t k = 0; k < 8 * bodies->range; k++) {
        jacobian[k] = 0.0;
    }
    return TINKER_OK;
}

/* Drawing */

/* Of two symbols, about the point where the host wants it. */
static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    double direction[2];
    tinker_direction(instance->columns[COLUMN_ANGLE], direction);
    return tinker_arrow_from(instance->x - symbol_size * direction[0], instance->y - symbol_size * direction[1],
                             direction, 2.0 * symbol_size);
}

/* The letter stands beside the arrow, to the left of its direction. */
static void letter_place(const TinkerInstance *instance, const TinkerArrow *arrow, double *x, double *y)
{
    *x = instance->x - 0.35 * (arrow->y2 - arrow->y1);
    *y = instance->y + 0.35 * (arrow->x2 - arrow->x1);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    double x, y;
    letter_place(instance, &arrow, &x, &y);
    style->arrow(style, cairo, TINKER_COLOUR_FIELD, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    style->text(style, cairo, TINKER_COLOUR_FIELD, x, y, "g");
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    double x, y;
    letter_place(instance, &arrow, &x, &y);
    tinker_arrow_bounds(&arrow, tinker_drawing_margin(style), box);
    tinker_bounds_add(box, x, y, tinker_drawing_margin(style));
}

/* Editing: it stands where the host shows it; what can be dragged is its tip, which turns it. */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    return tinker_arrow_is_hit(&arrow, x, y, reach) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) tinker_set_angle(editor, COLUMN_ANGLE, x - instance->x, y - instance->y);
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    move_absolute(instance, part, arrow.x2 + dx, arrow.y2 + dy, editor);
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, arrow.x2, arrow.y2);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        double acceleration[2];
        acceleration_of(batch, i, acceleration);
        result[i] = energy_of(input->body_count, input->bodies, input->masses, acceleration);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("acceleration", "Acceleration", "Gravity", TINKER_DIMENSION_ACCELERATION),
     TINKER_ANY_VALUE(0, 0.0, 25.0), .default_value = {9.81}, .symbol = "g", .variability = TINKER_TUNABLE,
     .description = "Acceleration of free fall"},
    {TINKER_REAL_PROPERTY("angle", "Angle", "Gravity", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .default_value = {-TINKER_PI / 2.0}, .symbol = "θ",
     .variability = TINKER_TUNABLE, .description = "Direction of falling, counter-clockwise from the right"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "m*g*cos(θ)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "m*g*sin(θ)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("potential", "-m*g*(x*cos(θ) + y*sin(θ))", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "potential energy", "Potential Energy", "Of all masses, 0 at the origin",
                    TINKER_DIMENSION_ENERGY),
};

static const TinkerField field = {
    .struct_size = sizeof(TinkerField), .force = force, .energy = energy, .linear = linear, .derivatives = derivatives};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .field = &field};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"angle", "deg", "deg"}, {"potential energy", "J", "lbf*ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("gravity", "Gravity", TINKER_FIELD), .summary = "Makes all masses fall",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.gravity", "Gravity", "0.1.0", "MIT", blocks)
