/* Torsional spring: turns what its ends are on towards a relative angle, M = k (theta_2 - theta_1 - rest): -M acts on
 * what the second end is on, M on what the first is on. Angles count turns. */
#include <tinker/sdk.h>

enum { COLUMN_STIFFNESS, COLUMN_REST_ANGLE };

enum { QUANTITY_ANGLE, QUANTITY_TORQUE, QUANTITY_ENERGY };

/* How its spiral is drawn: turns at rest, and the radius of its outer end in symbols. */
#define TURNS  2.5
#define RADIUS 1.6

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const double turn = batch->poses[2 * i + 1].angle - batch->poses[2 * i].angle - rest[i];
        tinker_pair_of_torques(batch, i, stiffness[i] * turn, result);
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerPoint *ends, double *stored)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const double turn = batch->poses[2 * i + 1].angle - batch->poses[2 * i].angle - rest[i];
        stored[i] = 0.5 * stiffness[i] * turn * turn;
    }
    return TINKER_OK;
}

static TinkerStatus torsion(TinkerBatch *batch, double *stiffness, double *damping, double *rest,
                            int32_t *waveform_column)
{
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = tinker_column(batch, COLUMN_STIFFNESS)[i];
        damping[i] = 0.0;
        rest[i] = tinker_column(batch, COLUMN_REST_ANGLE)[i];
        waveform_column[i] = -1;
    }
    return TINKER_OK;
}

/* Drawing: a spiral that winds up, from the second end's body inside to the first one's outside */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1], *at = tinker_turn_end(instance);
    const double turn = b->angle - a->angle - instance->columns[COLUMN_REST_ANGLE];
    const double whole = 2.0 * TINKER_PI * TURNS + (fabs(turn) < 4.0 * TINKER_PI ? turn : 0.0);
    const double radius = RADIUS * style->symbol_size;
    tinker_turn_draw_ends(instance, cairo, style, radius);
    for (int part = 0; part < 4; part++) { /* so that each has lines enough */
        const double from = part / 4.0, to = (part + 1) / 4.0;
        tinker_draw_arc(style, cairo, turn < 0.0 ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_STRETCHED, at->x, at->y,
                        a->angle + from * whole, a->angle + to * whole, radius * (1.0 - 0.8 * from),
                        radius * (1.0 - 0.8 * to));
    }
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_turn_bounds(instance, style, RADIUS * style->symbol_size, box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    return tinker_turn_hit(instance, RADIUS * tinker_instance_symbol_size(instance), x, y, reach);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double angle = input->poses[2 * i + 1].angle - input->poses[2 * i].angle, turn = angle - rest[i];
        result[i] = quantity == QUANTITY_ANGLE    ? angle
                    : quantity == QUANTITY_TORQUE ? stiffness[i] * turn
                                                  : 0.5 * stiffness[i] * turn * turn;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Torsional Spring", {1, 2, -2, -1}), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {1.0}, .symbol = "k", .variability = TINKER_TUNABLE, .description = "Torque per angle"},
    {TINKER_REAL_PROPERTY("rest_angle", "Rest Angle", "Torsional Spring", TINKER_DIMENSION_ANGLE),
     TINKER_ANY_VALUE(TINKER_DEFAULT_AS_PLACED, -TINKER_PI, TINKER_PI), .symbol = "θ0", .variability = TINKER_TUNABLE,
     .description = "Angle from what its first end is on to what its second is on, without torque"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("potential", "k*(theta2 - theta1 - θ0)^2/2", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "angle", "Angle", "From what its first end is on to what its second is on",
                    TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(0, "torque", "Torque", "On what its first end is on", TINKER_DIMENSION_TORQUE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "k (θ - θ0)² / 2", TINKER_DIMENSION_ENERGY),
};

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .angles = 1, .force = force, .energy = energy, .torsion = torsion};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"rest_angle", "deg", "deg"}, {"angle", "deg", "deg"}, {"torque", "N*m", "lbf*ft"}, {"energy", "J", "lbf*ft"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("torsional-spring", "Torsional Spring", TINKER_CONNECTOR),
     .summary = "Turns two bodies towards their angle at rest", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.torsional-spring", "Torsional Spring", "0.1.0", "MIT", blocks)
