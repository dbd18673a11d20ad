/* Rack: as its first end's body turns, its second end moves along a fixed direction u, counted from where they are
 * placed: with d = x_2 - x_1 and the pitch radius R of the pinion,
 *
 *     g = u . (d - d(0)) - R (theta_1 - theta_1(0)),   dg/dx_2 = u,   dg/dx_1 = -u,   dg/dtheta_1 = -R,   drift = 0. */
#include <tinker/sdk.h>

enum { COLUMN_RADIUS, COLUMN_ANGLE };

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *radius = tinker_column(batch, COLUMN_RADIUS), *angle = tinker_column(batch, COLUMN_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1, *a0 = &batch->placed[2 * i], *b0 = a0 + 1;
        double u[2], *j = jacobian + 4 * i;
        if (!batch->has_angle[2 * i])
            return tinker_fail(batch, i,
                               "its first end is on something that has no angle, as a mass has none (attach it to a "
                               "disc, a bar, a box or a support)");
        tinker_direction(angle[i], u);
        g[i] = u[0] * ((b->x - a->x) - (b0->x - a0->x)) + u[1] * ((b->y - a->y) - (b0->y - a0->y)) -
               radius[i] * (batch->poses[2 * i].angle - batch->placed_poses[2 * i].angle);
        j[0] = -u[0];
        j[1] = -u[1];
        j[2] = u[0];
        j[3] = u[1];
        batch->angular[2 * i] = -radius[i];
        batch->angular[2 * i + 1] = 0.0;
        drift[i] = 0.0;
    }
    return TINKER_OK;
}

/* Drawing: the pitch circle about the first end, and the toothed line that touches it on the side of the second end */

#define TEETH 12

/* Where the line touches the circle, and half of its length. */
static double line_of(const TinkerInstance *instance, double u[2], double touch[2])
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double dx = b->x - a->x, dy = b->y - a->y, radius = instance->columns[COLUMN_RADIUS];
    tinker_direction(instance->columns[COLUMN_ANGLE], u);
    /* counter-clockwise the pinion drives what is below it (to the right of u) along u */
    touch[0] = a->x + radius * u[1];
    touch[1] = a->y - radius * u[0];
    return fmax(2.0 * radius, fabs(u[0] * dx + u[1] * dy));
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double radius = instance->columns[COLUMN_RADIUS], tooth = fmin(0.3 * style->symbol_size, 0.15 * radius);
    double u[2], touch[2], points[8 * TEETH + 2];
    const double half = line_of(instance, u, touch);
    for (int k = 0; k <= 4 * TEETH; k++) {
        const double along = half * (k / (2.0 * TEETH) - 1.0), out = k % 4 < 2 ? 0.0 : tooth;
        points[2 * k] = touch[0] + along * u[0] + out * u[1];
        points[2 * k + 1] = touch[1] + along * u[1] - out * u[0];
    }
    style->circle(style, cairo, -1, TINKER_COLOUR_CONNECTOR, instance->end[0].x, instance->end[0].y, radius);
    style->polyline(style, cairo, TINKER_COLOUR_CONNECTOR, points, 4 * TEETH + 1);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    double u[2], touch[2];
    const double half = line_of(instance, u, touch), margin = tinker_drawing_margin(style) + style->symbol_size;
    tinker_round_bounds(instance, style, instance->columns[COLUMN_RADIUS], box);
    tinker_bounds_add(box, touch[0] + half * u[0], touch[1] + half * u[1], margin);
    tinker_bounds_add(box, touch[0] - half * u[0], touch[1] - half * u[1], margin);
}

/* Editing: the handle at the rim sets the radius */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double radius = instance->columns[COLUMN_RADIUS];
    const int32_t part = tinker_connector_hit(instance, x, y, reach);
    double u[2], touch[2];
    const double half = line_of(instance, u, touch);
    const double out = tinker_length(x - instance->end[0].x, y - instance->end[0].y);
    if (part != TINKER_PART_NONE) return part;
    if (fabs(out - radius) <= reach) return TINKER_PART_WHOLE;
    const double distance = tinker_segment_distance(x, y, touch[0] - half * u[0], touch[1] - half * u[1],
                                                    touch[0] + half * u[0], touch[1] + half * u[1]);
    return distance <= reach + 0.3 * tinker_instance_symbol_size(instance) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    if (part == TINKER_PART_HANDLE) {
        editor->set(editor, COLUMN_RADIUS, tinker_length(x - instance->end[0].x, y - instance->end[0].y));
    } else {
        tinker_ends_move_absolute(instance, part, x, y, editor);
    }
}

static int32_t handles(const TinkerInstance *instance, TinkerHandle *list, int32_t room)
{
    double u[2], touch[2];
    (void)line_of(instance, u, touch);
    return tinker_handle_add(list, room, 0, TINKER_PART_HANDLE, touch[0], touch[1]);
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    double u[2], touch[2];
    (void)line_of(instance, u, touch);
    if (part == TINKER_PART_HANDLE) {
        move_absolute(instance, part, touch[0] + dx, touch[1] + dy, editor);
    } else {
        tinker_ends_move(instance, part, dx, dy, editor);
    }
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *radius = tinker_column(batch, COLUMN_RADIUS), *angle = tinker_column(batch, COLUMN_ANGLE);
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the rack's force is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double l = input->multipliers[i];
        double u[2];
        tinker_direction(angle[i], u);
        result[i] = tinker_joint_value(quantity, -l * u[0], -l * u[1], -l * radius[i]);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("radius", "Radius", "Rack", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.1, 2.0),
     .default_value = {0.4}, .symbol = "R", .variability = TINKER_STRUCTURAL,
     .description = "Pitch radius of the pinion, which its first end is on"},
    {TINKER_REAL_PROPERTY("angle", "Angle", "Rack", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, -TINKER_PI, TINKER_PI),
     .symbol = "α", .variability = TINKER_STRUCTURAL,
     .description = "Direction in which the rack moves while the pinion turns counter-clockwise"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION(
        "g",
        "(x2 - x1 - x2_start + x1_start)*cos(α) + (y2 - y1 - y2_start + y1_start)*sin(α) - R*(theta1 - theta1_start)",
        NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .angles = 1};
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
    {TINKER_BLOCK("rack", "Rack", TINKER_JOINT), .summary = "Moves along a line as a pinion turns", .least_ends = 2,
     .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.rack", "Rack", "0.1.0", "MIT", blocks)
