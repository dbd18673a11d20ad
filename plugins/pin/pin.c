/* Pin: holds two points together and lets what they are on turn, g = x_b - x_a = 0.
 *
 * Its rows do not depend on where the points are: the Jacobian is constant and the drift is 0. The multipliers push the
 * second end along +x and +y where they are positive, and the first one the other way. */
#include <tinker/sdk.h>

#include <math.h>

enum { COLUMN_FRICTION_RADIUS, COLUMN_FRICTION };

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        double *j = jacobian + 8 * i;
        g[2 * i] = b->x - a->x;
        g[2 * i + 1] = b->y - a->y;
        for (int32_t k = 0; k < 8; k++) {
            j[k] = 0.0;
        }
        j[0] = j[5] = -1.0;
        j[2] = j[7] = 1.0;
        drift[2 * i] = drift[2 * i + 1] = 0.0;
    }
    return TINKER_OK;
}

/* Of a bolt of radius r, which lies in its hole where the force across it and friction along it balance it. */
static TinkerStatus friction(TinkerBatch *batch, double *arm)
{
    const double *radius = tinker_column(batch, COLUMN_FRICTION_RADIUS), *mu = tinker_column(batch, COLUMN_FRICTION);
    for (int32_t i = 0; i < batch->count; i++) {
        arm[i] = radius[i] * mu[i] / sqrt(1.0 + mu[i] * mu[i]);
    }
    return TINKER_OK;
}

/* Drawing */

static double ring(const TinkerStyle *style)
{
    return 0.3 * style->symbol_size;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    tinker_joint_draw_gap(instance, cairo, style, ring(style));
    style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_CONNECTOR, instance->x, instance->y, ring(style));
}

/* Graphs */

/* What acts on end 1. */
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->multipliers == NULL) return tinker_fail(batch, 0, "the pin's force is not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double *l = input->multipliers + 2 * i;
        const double torque = input->torques != NULL ? input->torques[2 * i] : 0.0;
        result[i] = tinker_joint_value(quantity, -l[0], -l[1], torque);
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("friction_radius", "Radius", "Friction", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(0, 0.1), .variability = TINKER_STRUCTURAL,
     .description = "Of the bolt, at whose rim friction acts"},
    {TINKER_REAL_PROPERTY("friction", "Friction", "Friction", TINKER_DIMENSION_NONE), TINKER_NOT_NEGATIVE(0, 1.0),
     .variability = TINKER_STRUCTURAL,
     .description = "Its coefficient: r μ / sqrt(1 + μ^2) times the pin's force resists its turning"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g1", "x2 - x1", NULL, TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("g2", "y2 - y1", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {TINKER_JOINT_QUANTITIES};

static const TinkerConstraint constraint = {.struct_size = sizeof(TinkerConstraint),
                                            .rows = 2,
                                            .joint = 1,
                                            .rows_at = rows_at,
                                            .coincident = 1,
                                            .friction = friction};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"friction_radius", "m", "ft"}, TINKER_JOINT_UNITS};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("pin", "Pin", TINKER_JOINT), .summary = "Holds two points together and lets them turn",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.pin", "Pin", "0.1.0", "MIT", blocks)
