/* Slider: keeps its second end on a line through the first one, as a slot does, and the relative angle of what they are
 * on. With the line's direction u at the angle alpha + theta_1, its normal n, and d = x_2 - x_1,
 *
 *     g_1 = n . d,   dg_1/dtheta_1 = -u . d,   drift = -w^2 n . d - 2 w u . d',   since n' = -w u and u' = w n,
 *     g_2 = (theta_2 - theta_1) - (theta_2 - theta_1) as placed, in rad: its multiplier is a torque.
 *
 * With a mass, which has no angle, a slider is a slot: the second row is 0. */
#include <tinker/sdk.h>

enum { ROWS = 2 };
enum { COLUMN_ANGLE };

/* Physics */

/* The line's direction u and the normal n of it, turned with what the first end is on. */
static void track_of(double angle, const TinkerPose *pose, double u[2], double n[2])
{
    tinker_direction(angle + pose->angle, u);
    n[0] = -u[1];
    n[1] = u[0];
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *angle = tinker_column(batch, COLUMN_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const TinkerPose *pose = &batch->poses[2 * i];
        const double dx = b->x - a->x, dy = b->y - a->y, rate = pose->rate;
        double u[2], n[2], *j = jacobian + 4 * ROWS * i, *angular = batch->angular + 2 * ROWS * i;
        track_of(angle[i], pose, u, n);
        g[ROWS * i] = n[0] * dx + n[1] * dy;
        j[0] = -n[0];
        j[1] = -n[1];
        j[2] = n[0];
        j[3] = n[1];
        angular[0] = -(u[0] * dx + u[1] * dy);
        angular[1] = 0.0;
        drift[ROWS * i] = -rate * rate * g[ROWS * i] - 2.0 * rate * (u[0] * (b->vx - a->vx) + u[1] * (b->vy - a->vy));
        tinker_row_clear(j + 4, angular + 2, 2);
        g[ROWS * i + 1] = drift[ROWS * i + 1] = 0.0;
        if (!batch->has_angle[2 * i] || !batch->has_angle[2 * i + 1]) continue;
        g[ROWS * i + 1] =
            (pose[1].angle - pose->angle) - (batch->placed_poses[2 * i + 1].angle - batch->placed_poses[2 * i].angle);
        angular[2] = -1.0;
        angular[3] = 1.0;
    }
    return TINKER_OK;
}

/* Drawing: the track as two lines, and what runs in it */

/* Half of the track's length and width, in symbols; it is longer where the second end is far from the first. */
#define TRACK_LENGTH 3.0
#define TRACK_WIDTH  0.45

static double half_length(const TinkerInstance *instance, double symbol)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    return fmax(TRACK_LENGTH * symbol, tinker_length(b->x - a->x, b->y - a->y) + symbol);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double symbol = style->symbol_size, half = half_length(instance, symbol), off = TRACK_WIDTH * symbol;
    const double direction = instance->columns[COLUMN_ANGLE] + a->angle;
    double u[2];
    tinker_direction(direction, u);
    for (int side = -1; side <= 1; side += 2) {
        const double x = a->x - side * off * u[1], y = a->y + side * off * u[0];
        style->line(style, cairo, TINKER_COLOUR_CONNECTOR, x - half * u[0], y - half * u[1], x + half * u[0],
                    y + half * u[1]);
    }
    style->box(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_CONNECTOR, b->x, b->y, 1.2 * symbol, 1.8 * off,
               direction);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_round_bounds(instance, style, half_length(instance, style->symbol_size) + style->symbol_size, box);
}

/* Editing: the handle turns the track */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double symbol = tinker_instance_symbol_size(instance), half = half_length(instance, symbol);
    const TinkerEnd *a = &instance->end[0];
    const int32_t part = tinker_connector_hit(instance, x, y, reach);
    double u[2];
    tinker_direction(instance->columns[COLUMN_ANGLE] + a->angle, u);
    if (part != TINKER_PART_NONE) return part;
    const double distance =
        tinker_segment_distance(x, y, a->x - half * u[0], a->y - half * u[1], a->x + half * u[0], a->y + half * u[1]);
    if (distance <= reach + TRACK_WIDTH * symbol) return TINKER_PART_WHOLE;
    return tinker_length(x - instance->end[1].x, y - instance->end[1].y) <= reach + 0.8 * symbol ? TINKER_PART_WHOLE
                                                                                                 : TINKER_PART_NONE;
}

static void place_handle(const TinkerInstance *instance, double *x, double *y)
{
    const double half = half_length(instance, tinker_instance_symbol_size(instance));
    double u[2];
    tinker_direction(instance->columns[COLUMN_ANGLE] + instance->end[0].angle, u);
    *x = instance->end[0].x + half * u[0];
    *y = instance->end[0].y + half * u[1];
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    const double dx = x - instance->end[0].x, dy = y - instance->end[0].y;
    if (part != TINKER_PART_HANDLE) {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    } else if (dx != 0.0 || dy != 0.0) {
        editor->set(editor, COLUMN_ANGLE, atan2(dy, dx) - instance->end[0].angle);
    }
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    double x, y;
    if (part != TINKER_PART_HANDLE) {
        tinker_ends_move(instance, part, dx, dy, editor);
        return;
    }
    place_handle(instance, &x, &y);
    move_absolute(instance, part, x + dx, y + dy, editor);
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    double x, y;
    place_handle(instance, &x, &y);
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, x, y);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *angle = tinker_column(batch, COLUMN_ANGLE);
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the slider's force is not known yet");
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &input->ends[2 * i], *b = a + 1;
        const double *l = input->multipliers + ROWS * i;
        double u[2], n[2];
        track_of(angle[i], &input->poses[2 * i], u, n);
        const double torque = -l[0] * (u[0] * (b->x - a->x) + u[1] * (b->y - a->y)) - l[1];
        result[i] = tinker_joint_value(quantity, -l[0] * n[0], -l[0] * n[1], torque);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("angle", "Angle", "Track", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI), .symbol = "α", .variability = TINKER_STRUCTURAL,
     .description = "Of the track, from the x axis of what its first end is on"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g1", "(y2 - y1)*cos(α + theta1) - (x2 - x1)*sin(α + theta1)", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g2", "turns1*turns2*(theta2 - theta2_start - theta1 + theta1_start)", NULL,
                    TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = ROWS, .joint = 2, .rows_at = rows_at, .angles = 1};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, handles};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"angle", "deg", "deg"}, TINKER_JOINT_UNITS};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("slider", "Slider", TINKER_JOINT),
     .summary = "Lets a body slide along a line of another without turning against it",
     .formula = "(x2 - x1) · n = 0, n = (-sin α, cos α), θ2 - θ1 stays", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.slider", "Slider", "0.1.0", "MIT", blocks)
