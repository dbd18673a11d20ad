/* Torsional damper: resists the relative turning of what its ends are on, M = c (theta_2' - theta_1'): -M acts on what
 * the second end is on, M on what the first is on. */
#include <tinker/sdk.h>

enum { COLUMN_DAMPING };

enum { QUANTITY_RATE, QUANTITY_TORQUE, QUANTITY_POWER };

#define RADIUS 1.6 /* of what is drawn, in symbols */

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *damping = tinker_column(batch, COLUMN_DAMPING);
    (void)ends;
    for (int32_t i = 0; i < batch->count; i++) {
        const double torque = damping[i] * (batch->poses[2 * i + 1].rate - batch->poses[2 * i].rate);
        tinker_pair_of_torques(batch, i, torque, result);
    }
    return TINKER_OK;
}

static TinkerStatus torsion(TinkerBatch *batch, double *stiffness, double *damping, double *rest,
                            int32_t *waveform_column)
{
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = rest[i] = 0.0;
        damping[i] = tinker_column(batch, COLUMN_DAMPING)[i];
        waveform_column[i] = -1;
    }
    return TINKER_OK;
}

/* Drawing: a cup that turns with the first end's body, and a vane in it that turns with the second one's */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double radius = RADIUS * style->symbol_size, angle = instance->end[0].angle, vane = instance->end[1].angle;
    const TinkerEnd *at = tinker_turn_end(instance);
    const double x = at->x, y = at->y, c = cos(vane), s = sin(vane);
    tinker_turn_draw_ends(instance, cairo, style, radius);
    tinker_draw_arc(style, cairo, TINKER_COLOUR_CONNECTOR, x, y, angle - 2.4, angle + 2.4, radius, radius);
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, x - 0.7 * radius * c, y - 0.7 * radius * s, x + 0.7 * radius * c,
                y + 0.7 * radius * s);
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
    const double *damping = tinker_column(batch, COLUMN_DAMPING);
    if (input->poses == NULL) return tinker_fail(batch, 0, "angles are not known yet");
    for (int32_t i = 0; i < batch->count; i++) {
        const double rate = input->poses[2 * i + 1].rate - input->poses[2 * i].rate;
        result[i] = quantity == QUANTITY_RATE     ? rate
                    : quantity == QUANTITY_TORQUE ? damping[i] * rate
                                                  : damping[i] * rate * rate;
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("damping", "Damping", "Torsional Damper", {1, 2, -1, -1}), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {1.0}, .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Torque per angular velocity"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("torque1", "c*(omega2 - omega1)", NULL, TINKER_DIMENSION_TORQUE),
    TINKER_EQUATION("torque2", "-torque1", NULL, TINKER_DIMENSION_TORQUE),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "angular velocity", "Angular Velocity", "Of what its second end is on against the first",
                    TINKER_DIMENSION_ANGULAR_FREQUENCY),
    TINKER_QUANTITY(TINKER_RECORDED, "torque", "Torque", "On what its first end is on", TINKER_DIMENSION_TORQUE),
    TINKER_QUANTITY(0, "power", "Power", "What it takes; never negative", TINKER_DIMENSION_POWER),
};

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .angles = 1, .force = force, .dissipates = 1, .torsion = torsion};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {
    {"angular velocity", "rad/s", "rad/s"}, {"torque", "N*m", "lbf*ft"}, {"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("torsional-damper", "Torsional Damper", TINKER_CONNECTOR),
     .summary = "Resists the turning of one body against another", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.torsional-damper", "Torsional Damper", "0.1.0", "MIT", blocks)
