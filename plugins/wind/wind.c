/* Wind: drag on all masses against uniformly moving air, F = -c u - c2 |u| u with u = v - w. */
#include <tinker/sdk.h>

enum {
    COLUMN_VELOCITY,
    COLUMN_DRAG = COLUMN_VELOCITY + 2,
    COLUMN_DRAG_QUADRATIC,
};

/* One instance: its air and its drag. */
typedef struct {
    double wx, wy, drag, quadratic;
} Air;

static Air air_of(const TinkerBatch *batch, int32_t i)
{
    return (Air){tinker_column(batch, COLUMN_VELOCITY)[i], tinker_column(batch, COLUMN_VELOCITY + 1)[i],
                 tinker_column(batch, COLUMN_DRAG)[i], tinker_column(batch, COLUMN_DRAG_QUADRATIC)[i]};
}

/* Physics */

static void add_forces(int32_t count, Air air, const TinkerPoint *restrict points, double *restrict result)
{
    for (int32_t k = 0; k < count; k++) {
        const double ux = points[k].vx - air.wx, uy = points[k].vy - air.wy;
        const double factor = air.drag + air.quadratic * tinker_length(ux, uy);
        result[2 * k] -= factor * ux;
        result[2 * k + 1] -= factor * uy;
    }
}

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    for (int32_t k = 0; k < 2 * bodies->range; k++) {
        result[k] = 0.0;
    }
    for (int32_t i = 0; i < batch->count; i++) {
        add_forces(bodies->range, air_of(batch, i), &bodies->points[bodies->first], result);
    }
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, TinkerLinearField *law)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const Air air = air_of(batch, i);
        if (air.quadratic != 0.0) return TINKER_RETRY_SMALLER;
        law[i] = (TinkerLinearField){.force = {air.drag * air.wx, air.drag * air.wy}, .drag = air.drag};
    }
    return TINKER_OK;
}

/* d(c2 |u| u)/du = c2 (|u| 1 + u u^T / |u|), whose limit at u = 0 is 0. */
static void add_derivatives(Air air, const TinkerPoint *point, double *jacobian)
{
    const double ux = point->vx - air.wx, uy = point->vy - air.wy, speed = tinker_length(ux, uy);
    const double nx = speed > 0.0 ? ux / speed : 0.0, ny = speed > 0.0 ? uy / speed : 0.0;
    const double quadratic = air.quadratic * speed;
    jacobian[4] -= air.drag + quadratic * (1.0 + nx * nx);
    jacobian[5] -= quadratic * nx * ny;
    jacobian[6] -= quadratic * nx * ny;
    jacobian[7] -= air.drag + quadratic * (1.0 + ny * ny);
}

static TinkerStatus derivatives(TinkerBatch *batch, const TinkerBodies *bodies, double *jacobian)
{
    for (int32_t k = 0; k < 8 * bodies->range; k++) {
        jacobian[k] = 0.0;
    }
    for (int32_t i = 0; i < batch->count; i++) {
        const Air air = air_of(batch, i);
        for (int32_t k = 0; k < bodies->range; k++) {
            add_derivatives(air, &bodies->points[bodies->first + k], &jacobian[8 * k]);
        }
    }
    return TINKER_OK;
}

/* Drawing */

/* The middle one of three parallel arrows of two symbols along the wind; in still air it points nowhere. */
static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    const double wx = instance->columns[COLUMN_VELOCITY], wy = instance->columns[COLUMN_VELOCITY + 1];
    const double speed = tinker_length(wx, wy);
    const double direction[2] = {speed > 0.0 ? wx / speed : 0.0, speed > 0.0 ? wy / speed : 0.0};
    return tinker_arrow_from(instance->x - symbol_size * direction[0], instance->y - symbol_size * direction[1],
                             direction, 2.0 * symbol_size);
}

static int is_still(const TinkerInstance *instance)
{
    return instance->columns[COLUMN_VELOCITY] == 0.0 && instance->columns[COLUMN_VELOCITY + 1] == 0.0;
}

/* The arrow moved to its left by a part of its length. */
static TinkerArrow lane_of(const TinkerArrow *arrow, double part)
{
    const double dx = -part * (arrow->y2 - arrow->y1), dy = part * (arrow->x2 - arrow->x1);
    return (TinkerArrow){arrow->x1 + dx, arrow->y1 + dy, arrow->x2 + dx, arrow->y2 + dy};
}

/* Lanes of the wind lie this part of an arrow's length apart. */
#define LANE 0.35

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    if (is_still(instance)) {
        style->circle(style, cairo, -1, TINKER_COLOUR_FIELD, instance->x, instance->y, style->symbol_size);
        style->text(style, cairo, TINKER_COLOUR_FIELD, instance->x, instance->y, "w");
        return;
    }
    for (int number = -1; number <= 1; number++) {
        const TinkerArrow lane = lane_of(&arrow, number * LANE);
        style->arrow(style, cairo, TINKER_COLOUR_FIELD, lane.x1, lane.y1, lane.x2, lane.y2);
    }
    const TinkerArrow beside = lane_of(&arrow, 2.0 * LANE);
    style->text(style, cairo, TINKER_COLOUR_FIELD, (beside.x1 + beside.x2) / 2.0, (beside.y1 + beside.y2) / 2.0, "w");
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    const double margin = tinker_drawing_margin(style);
    const TinkerArrow right = lane_of(&arrow, -LANE), left = lane_of(&arrow, 2.0 * LANE);
    tinker_arrow_bounds(&right, margin, box);
    tinker_bounds_add(box, left.x1, left.y1, margin);
    tinker_bounds_add(box, left.x2, left.y2, margin);
    tinker_bounds_add(box, instance->x, instance->y, style->symbol_size + margin);
}

/* Editing: it stands where the host shows it; what can be dragged is its tip, which turns the wind and keeps its
 * speed. */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double symbol = tinker_instance_symbol_size(instance);
    const TinkerArrow arrow = arrow_of(instance, symbol);
    return tinker_arrow_is_hit(&arrow, x, y, reach + symbol) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    const double dx = x - instance->x, dy = y - instance->y, distance = tinker_length(dx, dy);
    const double *wind = &instance->columns[COLUMN_VELOCITY];
    const double speed = tinker_length(wind[0], wind[1]);
    if (part != TINKER_PART_HANDLE || distance == 0.0) return;
    editor->set(editor, COLUMN_VELOCITY, speed * (dx / distance));
    editor->set(editor, COLUMN_VELOCITY + 1, speed * (dy / distance));
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    move_absolute(instance, part, arrow.x2 + dx, arrow.y2 + dy, editor);
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    return is_still(instance) ? 0 : tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, arrow.x2, arrow.y2);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const Air air = air_of(batch, i);
        result[i] = 0.0;
        for (int32_t k = 0; k < input->body_count; k++) {
            double on_body[2] = {0.0, 0.0};
            add_forces(1, air, &input->bodies[k], on_body);
            result[i] += on_body[0] * input->bodies[k].vx + on_body[1] * input->bodies[k].vy;
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Wind", "X Velocity", "Y Velocity", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -20.0, 20.0), .symbol = "w", .variability = TINKER_TUNABLE,
     .description = "How the air moves"},
    {TINKER_REAL_PROPERTY("drag", "Drag", "Wind", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 5.0), .symbol = "c",
     .variability = TINKER_TUNABLE, .description = "Force per speed relative to the air"},
    {TINKER_REAL_PROPERTY("drag_quadratic", "Quadratic Drag", "Wind", TINKER_DIMENSION_QUADRATIC_DRAG),
     TINKER_NOT_NEGATIVE(0, 5.0), .symbol = "c2", .variability = TINKER_TUNABLE,
     .description = "Force per square of the speed relative to the air"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("u", "sqrt((vx - wx)^2 + (vy - wy)^2)", "speed against the air", TINKER_DIMENSION_VELOCITY),
    TINKER_EQUATION("force_x", "-(c + c2*u)*(vx - wx)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "-(c + c2*u)*(vy - wy)", NULL, TINKER_DIMENSION_FORCE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "power", "Power", "Power given to all masses", TINKER_DIMENSION_POWER),
};

static const TinkerField field = {
    .struct_size = sizeof(TinkerField), .force = force, .linear = linear, .derivatives = derivatives};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .field = &field};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"drag", "N*s/m", "lbf*s/ft"}, {"drag_quadratic", "N*s^2/m^2", "lbf*s^2/ft^2"}, {"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("wind", "Wind", TINKER_FIELD), .summary = "Drag of moving or still air on all masses",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.wind", "Wind", "0.1.0", "MIT", blocks)
