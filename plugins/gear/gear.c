/* Gear: ties the angles of two wheels, counted from where they are placed,
 *
 *     g = (theta_2 - theta_2(0)) + s ratio (theta_1 - theta_1(0)),   s = 1 for external gears, -1 for internal ones.
 *
 * With a third end, the arm that carries the wheels, all angles are counted from that of the arm. g is in rad and its
 * multiplier a torque. It holds no places: pins do. */
#include <tinker/sdk.h>

enum { COLUMN_RATIO, COLUMN_INTERNAL };

enum { QUANTITY_TORQUE };

/* Physics */

static double side_of(const double *internal, int32_t i)
{
    return internal[i] != 0.0 ? -1.0 : 1.0;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *ratio = tinker_column(batch, COLUMN_RATIO), *internal = tinker_column(batch, COLUMN_INTERNAL);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), count = tinker_first_end(batch, i + 1) - first;
        const double by = side_of(internal, i) * ratio[i];
        double turned[3] = {0.0, 0.0, 0.0}, *angular = batch->angular + first;
        tinker_row_clear(jacobian + 2 * first, angular, count);
        for (int32_t k = 0; k < count && k < 3; k++) {
            if (!batch->has_angle[first + k])
                return tinker_fail(
                    batch, i,
                    "an end is on something that has no angle, as a mass has none (attach it to a disc, a bar, a box "
                    "or a support)");
            turned[k] = batch->poses[first + k].angle - batch->placed_poses[first + k].angle;
        }
        g[i] = (turned[1] - turned[2]) + by * (turned[0] - turned[2]);
        angular[0] = by;
        angular[1] = 1.0;
        if (count > 2) angular[2] = -(1.0 + by);
        drift[i] = 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus turning(TinkerBatch *batch, double *factors)
{
    const double *ratio = tinker_column(batch, COLUMN_RATIO), *internal = tinker_column(batch, COLUMN_INTERNAL);
    for (int32_t i = 0; i < batch->count; i++) {
        double *of = factors + tinker_first_end(batch, i);
        of[0] = side_of(internal, i) * ratio[i];
        of[1] = 1.0;
        if (tinker_first_end(batch, i + 1) - tinker_first_end(batch, i) > 2) of[2] = -(1.0 + of[0]);
    }
    return TINKER_OK;
}

/* Drawing: wheels that fit the distance of the centres and the ratio, with teeth about them */

#define TEETH 24

/* d = r_1 + r_2, or for internal gears d = r_2 - r_1, with r_1 = ratio r_2; where both are alike nothing fits, and both
 * are of one symbol. */
static void radii_of(const TinkerInstance *instance, double symbol, double radius[2])
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double distance = tinker_length(b->x - a->x, b->y - a->y), ratio = instance->columns[COLUMN_RATIO];
    const double share = instance->columns[COLUMN_INTERNAL] != 0.0 ? fabs(1.0 - ratio) : 1.0 + ratio;
    const int fits = distance > 1e-9 * symbol && share > 1e-9;
    radius[1] = fits ? distance / share : symbol;
    radius[0] = ratio * radius[1];
}

static void draw_wheel(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style, int32_t end,
                       double radius)
{
    const TinkerEnd *at = &instance->end[end];
    const double tooth = fmin(0.3 * style->symbol_size, 0.1 * radius);
    double points[8 * TEETH + 2];
    for (int k = 0; k <= 4 * TEETH; k++) {
        const double angle = at->angle + k * (0.5 * TINKER_PI / TEETH);
        const double out = radius + (k % 4 < 2 ? tooth : -tooth);
        points[2 * k] = at->x + out * cos(angle);
        points[2 * k + 1] = at->y + out * sin(angle);
    }
    style->polyline(style, cairo, TINKER_COLOUR_CONNECTOR, points, 4 * TEETH + 1);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    double radius[2];
    radii_of(instance, style->symbol_size, radius);
    for (int32_t k = 0; k < 2; k++) {
        draw_wheel(instance, cairo, style, k, radius[k]);
    }
    if (instance->ends > 2) {
        style->line(style, cairo, TINKER_COLOUR_CONNECTOR, instance->end[0].x, instance->end[0].y, instance->end[1].x,
                    instance->end[1].y);
    }
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    double radius[2];
    radii_of(instance, style->symbol_size, radius);
    tinker_bounds_clear(box);
    for (int32_t k = 0; k < instance->ends; k++) {
        tinker_bounds_add(box, instance->end[k].x, instance->end[k].y,
                          tinker_drawing_margin(style) + (k < 2 ? 1.1 * radius[k] : 0.0));
    }
}

/* Editing: its rims are hit as well as the line between its ends */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    double radius[2];
    int32_t part = tinker_connector_hit(instance, x, y, reach);
    radii_of(instance, tinker_instance_symbol_size(instance), radius);
    for (int32_t k = 0; k < 2 && part == TINKER_PART_NONE; k++) {
        const double out = tinker_length(x - instance->end[k].x, y - instance->end[k].y);
        if (fabs(out - radius[k]) <= reach) part = TINKER_PART_WHOLE;
    }
    return part;
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *ratio = tinker_column(batch, COLUMN_RATIO), *internal = tinker_column(batch, COLUMN_INTERNAL);
    (void)quantity;
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the gear's torque is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = side_of(internal, i) * ratio[i] * input->multipliers[i];
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("ratio", "Ratio", "Gear", TINKER_DIMENSION_NONE), TINKER_POSITIVE(0, 0.1, 10.0),
     .default_value = {1.0}, .symbol = "i", .variability = TINKER_STRUCTURAL,
     .description = "How often the second wheel turns while the first one turns once"},
    {TINKER_SWITCH_PROPERTY("internal", "Internal", "Gear"), .symbol = "f", .variability = TINKER_STRUCTURAL,
     .description = "Whether one wheel runs inside the other, so that both turn the same way"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g",
                    "theta2 - theta2_start - (theta3 - theta3_start) + (1 - 2*f)*i*(theta1 - theta1_start - (theta3 - "
                    "theta3_start))",
                    NULL, TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "torque", "Torque", "On what its first end is on", TINKER_DIMENSION_TORQUE),
};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 1,
                                            .rows_at = rows_at,
                                            .scale = tinker_scale_of_angles,
                                            .angles = 1,
                                            .turning = turning};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"torque", "N*m", "lbf*ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("gear", "Gear", TINKER_JOINT), .summary = "Ties the turning of two wheels by a ratio",
     .formula = "θ2 - θ2(0) = ∓ i (θ1 - θ1(0))", .least_ends = 2, .most_ends = 3,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.gear", "Gear", "0.1.0", "MIT", blocks)
