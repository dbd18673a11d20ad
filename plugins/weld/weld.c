/* Weld: two points coincide and what they are on keeps the relative angle that it is placed with,
 *
 *     g = (x_2 - x_1, y_2 - y_1, (theta_2 - theta_1) - (theta_2 - theta_1) as placed).
 *
 * The third row is in rad and its multiplier a torque. With a mass, which has no angle, a weld is a pin: the row is 0.
 */
#include <tinker/sdk.h>

enum { ROWS = 3 };

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t a = 2 * i, b = a + 1;
        double *j = jacobian + 4 * ROWS * i, *angular = batch->angular + 2 * ROWS * i;
        for (int32_t r = 0; r < ROWS; r++) {
            tinker_row_clear(j + 4 * r, angular + 2 * r, 2);
            g[ROWS * i + r] = drift[ROWS * i + r] = 0.0;
        }
        g[ROWS * i] = ends[b].x - ends[a].x;
        g[ROWS * i + 1] = ends[b].y - ends[a].y;
        j[0] = j[5] = -1.0;
        j[2] = j[7] = 1.0;
        if (!batch->has_angle[a] || !batch->has_angle[b]) continue;
        g[ROWS * i + 2] = (batch->poses[b].angle - batch->poses[a].angle) -
                          (batch->placed_poses[b].angle - batch->placed_poses[a].angle);
        angular[4] = -1.0;
        angular[5] = 1.0;
    }
    return TINKER_OK;
}

static TinkerStatus turning(TinkerBatch *batch, double *factors)
{
    for (int32_t i = 0; i < batch->count; i++) {
        factors[2 * i] = -1.0;
        factors[2 * i + 1] = 1.0;
    }
    return TINKER_OK;
}

/* Drawing: a full square, as a bead of a weld */

static double bead(const TinkerStyle *style)
{
    return 0.7 * style->symbol_size;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    tinker_joint_draw_gap(instance, cairo, style, bead(style));
    style->box(style, cairo, TINKER_COLOUR_CONNECTOR, TINKER_COLOUR_CONNECTOR, instance->x, instance->y, bead(style),
               bead(style), instance->ends > 0 ? instance->end[0].angle : 0.0);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the weld's force is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double *l = input->multipliers + ROWS * i;
        result[i] = tinker_joint_value(quantity, -l[0], -l[1], -l[2]);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g1", "x2 - x1", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g2", "y2 - y1", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g3", "turns1*turns2*(theta2 - theta2_start - theta1 + theta1_start)", NULL,
                    TINKER_DIMENSION_ANGLE),
};

static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = ROWS,
                                            .joint = 1,
                                            .rows_at = rows_at,
                                            .angles = 1,
                                            .turning = turning};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {TINKER_JOINT_UNITS};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("weld", "Weld", TINKER_JOINT), .summary = "Holds two points together and lets nothing turn",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.weld", "Weld", "0.1.0", "MIT", blocks)
