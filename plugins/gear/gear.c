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

/* Drawing: wheels that fit the distance of the centres and the ratio, with teeth of one pitch that mesh */

#define LEAST_TEETH 16
#define MOST_TEETH  256

/* d = r_1 + r_2, or for internal gears d = r_2 - r_1, with r_1 = ratio r_2; where both are alike nothing fits, and both
 * are of one symbol. Answers whether it fits. */
static int radii_of(const TinkerInstance *instance, double symbol, double radius[2])
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double distance = tinker_length(b->x - a->x, b->y - a->y), ratio = instance->columns[COLUMN_RATIO];
    const double share = instance->columns[COLUMN_INTERNAL] != 0.0 ? fabs(1.0 - ratio) : 1.0 + ratio;
    const int fits = distance > 1e-9 * symbol && share > 1e-9;
    radius[1] = fits ? distance / share : symbol;
    radius[0] = ratio * radius[1];
    return fits;
}

/* The smallest numbers of teeth in the ratio of the radii, of which the smaller wheel has enough to look like one. Of
 * a ratio of no small whole numbers the larger wheel has the nearest number. */
static void teeth_of(const double radius[2], int teeth[2])
{
    const int small = radius[0] > radius[1];
    const double share = radius[1 - small] / radius[small];
    int of_small = 1;
    for (int q = 1; q <= LEAST_TEETH; q++) {
        if (fabs(share * q - floor(share * q + 0.5)) > 1e-6) continue;
        of_small = q;
        break;
    }
    of_small *= (LEAST_TEETH + of_small - 1) / of_small;
    teeth[small] = of_small;
    teeth[1 - small] = (int)fmin(floor(share * of_small + 0.5), MOST_TEETH);
}

/* Where the teeth of both begin (rad). Those of the larger wheel are fixed to it; the smaller one has gaps where these
 * have teeth on the line of the centres, or inside a ring the same outline. It turns so that this stays so. */
static void phases_of(const TinkerInstance *instance, const double radius[2], const int teeth[2], double phase[2])
{
    const int small = radius[0] > radius[1], large = 1 - small, internal = instance->columns[COLUMN_INTERNAL] != 0.0;
    const TinkerEnd *of = instance->end;
    const double way = atan2(of[small].y - of[large].y, of[small].x - of[large].x);
    const double turned = (way - of[large].angle) * teeth[large] / teeth[small];
    phase[large] = of[large].angle;
    phase[small] = internal ? way - turned : way + TINKER_PI + turned;
}

static void draw_wheel(const TinkerEnd *at, struct _cairo *cairo, const TinkerStyle *style, double radius, int teeth,
                       double phase)
{
    const double tooth = radius / teeth;
    double points[8 * MOST_TEETH + 2];
    for (int k = 0; k <= 4 * teeth; k++) {
        const double angle = phase + (k + 0.5) * (0.5 * TINKER_PI / teeth); /* a tooth is the first half of its pitch */
        const double out = radius + (k % 4 < 2 ? tooth : -tooth);
        points[2 * k] = at->x + out * cos(angle);
        points[2 * k + 1] = at->y + out * sin(angle);
    }
    style->polyline(style, cairo, TINKER_COLOUR_CONNECTOR, points, 4 * teeth + 1);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    double radius[2], phase[2] = {instance->end[0].angle, instance->end[1].angle};
    int teeth[2];
    const int fits = radii_of(instance, style->symbol_size, radius);
    teeth_of(radius, teeth);
    if (fits) phases_of(instance, radius, teeth, phase);
    for (int32_t k = 0; k < 2; k++) {
        draw_wheel(&instance->end[k], cairo, style, radius[k], teeth[k], phase[k]);
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
     .least_ends = 2, .most_ends = 3, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.gear", "Gear", "0.1.0", "MIT", blocks)
