/* Impulse: a blow at an instant on one place of a body, along an angle, and a turning one beside it. Joints and
 * contacts answer to it as to an impact; between blows it does nothing, and costs nothing. */
#include <tinker/sdk.h>

enum {
    COLUMN_IMPULSE,
    COLUMN_ANGLE,
    COLUMN_ANGULAR_IMPULSE,
    COLUMN_TIME,
};

enum { QUANTITY_GIVEN };

#define LENGTH 5.0 /* of the arrow, in symbols */
#define RADIUS 2.0 /* of that which turns */

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        result[2 * i] = result[2 * i + 1] = 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus linear(TinkerBatch *batch, double *constant, double *direction, int32_t *waveform_column)
{
    for (int32_t i = 0; i < batch->count; i++) {
        constant[2 * i] = constant[2 * i + 1] = 0.0;
        direction[2 * i] = direction[2 * i + 1] = 0.0;
        waveform_column[i] = -1;
    }
    return TINKER_OK;
}

static double next_blow(TinkerBatch *batch)
{
    const double *time = tinker_column(batch, COLUMN_TIME);
    double next = INFINITY;
    for (int32_t i = 0; i < batch->count; i++) {
        if (time[i] > batch->time && time[i] < next) next = time[i];
    }
    return next;
}

static TinkerStatus blow(TinkerBatch *batch, const TinkerPoint *ends, double *impulse)
{
    const double *given = tinker_column(batch, COLUMN_IMPULSE), *angle = tinker_column(batch, COLUMN_ANGLE);
    const double *turning = tinker_column(batch, COLUMN_ANGULAR_IMPULSE), *time = tinker_column(batch, COLUMN_TIME);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const double now = time[i] == batch->time ? 1.0 : 0.0;
        double direction[2];
        tinker_direction(angle[i], direction);
        impulse[2 * i] = now * given[i] * direction[0];
        impulse[2 * i + 1] = now * given[i] * direction[1];
        batch->angular[i] = now * turning[i];
    }
    return TINKER_OK;
}

/* Drawing: the arrow ends where it strikes, as one that is dealt from outside. A blow that is over is thin. */

static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    const double side = instance->columns[COLUMN_IMPULSE] < 0.0 ? -1.0 : 1.0;
    double direction[2];
    tinker_direction(instance->columns[COLUMN_ANGLE], direction);
    const TinkerArrow out =
        tinker_arrow_from(instance->end[0].x, instance->end[0].y, direction, -side * LENGTH * symbol_size);
    const TinkerArrow in = {out.x2, out.y2, out.x1, out.y1};
    return in;
}

static int is_straight(const TinkerInstance *instance)
{
    return instance->columns[COLUMN_IMPULSE] != 0.0 || instance->columns[COLUMN_ANGULAR_IMPULSE] == 0.0;
}

static int is_over(const TinkerInstance *instance)
{
    return instance->time > instance->columns[COLUMN_TIME];
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const int32_t colour = is_over(instance) ? TINKER_COLOUR_DETACHED : TINKER_COLOUR_FORCE;
    const double turning = instance->columns[COLUMN_ANGULAR_IMPULSE];
    if (is_straight(instance)) {
        const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
        style->arrow(style, cairo, colour, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    }
    if (turning != 0.0) {
        tinker_draw_turn_arrow(style, cairo, colour, instance->end[0].x, instance->end[0].y,
                               RADIUS * style->symbol_size, turning);
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    tinker_round_bounds(instance, style, (RADIUS + 1.0) * style->symbol_size, box);
    tinker_bounds_add(box, arrow.x1, arrow.y1, tinker_drawing_margin(style));
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double symbol = tinker_instance_symbol_size(instance);
    const TinkerArrow arrow = arrow_of(instance, symbol);
    const double out = tinker_length(x - instance->end[0].x, y - instance->end[0].y);
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    if (is_straight(instance) && tinker_arrow_is_hit(&arrow, x, y, reach)) return TINKER_PART_WHOLE;
    const int turns = instance->columns[COLUMN_ANGULAR_IMPULSE] != 0.0;
    return turns && fabs(out - RADIUS * symbol) <= reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* Dragging the tail turns the blow. */
static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        const double side = instance->columns[COLUMN_IMPULSE] < 0.0 ? -1.0 : 1.0;
        tinker_set_angle(editor, COLUMN_ANGLE, side * (instance->end[0].x - x), side * (instance->end[0].y - y));
    } else {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    }
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
        move_absolute(instance, part, arrow.x1 + dx, arrow.y1 + dy, editor);
    } else {
        tinker_ends_move(instance, part, dx, dy, editor);
    }
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    if (!is_straight(instance)) return 0;
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, arrow.x1, arrow.y1);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *given = tinker_column(batch, COLUMN_IMPULSE), *time = tinker_column(batch, COLUMN_TIME);
    (void)input;
    (void)quantity;
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = time[i] >= 0.0 && batch->time >= time[i] ? given[i] : 0.0;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("impulse", "Impulse", "Blow", TINKER_DIMENSION_MOMENTUM), TINKER_ANY_VALUE(0, -10.0, 10.0),
     .symbol = "J", .variability = TINKER_TUNABLE, .description = "Momentum that the blow gives along its angle"},
    {TINKER_REAL_PROPERTY("angle", "Angle", "Blow", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI),
     .symbol = "θ", .variability = TINKER_TUNABLE,
     .description = "Direction of the blow, counter-clockwise from the right"},
    {TINKER_REAL_PROPERTY("angular_impulse", "Angular Impulse", "Blow", {1, 2, -1, 0}),
     TINKER_ANY_VALUE(0, -10.0, 10.0), .symbol = "H", .variability = TINKER_TUNABLE,
     .description = "Angular momentum that it gives beside that, counter-clockwise"},
    {TINKER_REAL_PROPERTY("time", "Time", "Blow", TINKER_DIMENSION_TIME), TINKER_ANY_VALUE(0, 0.0, 10.0), .symbol = "τ",
     .meaning = TINKER_MEANING_INSTANT, .variability = TINKER_TUNABLE,
     .description = "When it strikes; before 0, it does not"},
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "impulse", "Impulse", "Momentum along its angle that it has given so far",
                    TINKER_DIMENSION_MOMENTUM),
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("force_x", "0", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("force_y", "0", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("impulse_x", "J*cos(θ)", NULL, TINKER_DIMENSION_MOMENTUM),
    TINKER_EQUATION("impulse_y", "J*sin(θ)", NULL, TINKER_DIMENSION_MOMENTUM),
    TINKER_EQUATION("angular_impulse", "H", NULL, {1, 2, -1, 0}),
};

static const TinkerForceElement force_element = {.struct_size = sizeof(TinkerForceElement),
                                                 .angles = 1,
                                                 .force = force,
                                                 .linear = linear,
                                                 .next_blow = next_blow,
                                                 .blow = blow};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"impulse", "N*s", "lbf*s"}, {"angle", "deg", "deg"}, {"angular_impulse", "N*m*s", "lbf*ft*s"}, {"time", "s", "s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("impulse", "Impulse", TINKER_FORCE), .summary = "A blow on a body at an instant", .least_ends = 1,
     .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.impulse", "Impulse", "0.1.0", "MIT", blocks)
