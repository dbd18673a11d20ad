/* Angle spring: turns two arms about a hinge towards their rest angle, M = k (theta - theta0).
 *
 * The ends are the tip of the first arm, the hinge, and the tip of the second arm; theta is the angle from the first
 * arm to the second, counter-clockwise. With a = x0 - x1, c = x2 - x1 and delta = theta - theta0,
 *
 *     E = k delta^2 / 2,   F2 = -M (perp c) / |c|^2,   F0 = M (perp a) / |a|^2,   F1 = -(F0 + F2),
 *
 * where perp (x, y) = (-y, x): the forces and their moments add up to 0.
 *
 * From places alone nobody knows how often an arm has gone round, so delta is the angle from the *rest* direction,
 * between -180 and 180 deg: the jump lies opposite to rest, wherever rest is, and not where atan2 happens to have its
 * own. Beyond 170 deg the law is refused, so that no motion runs into the jump. */
#include <string.h>

#include <tinker/sdk.h>

enum { COLUMN_STIFFNESS, COLUMN_REST_ANGLE };

enum { QUANTITY_ANGLE, QUANTITY_MOMENT, QUANTITY_ENERGY };

enum { TIP, HINGE, OTHER_TIP, ENDS };

#define MOST_TURN (170.0 / 180.0 * TINKER_PI)

/* How far its arc reaches, in symbols. */
#define ARC_RADIUS 1.25

/* Physics */

static double turn_of(const TinkerPoint *end, double rest_angle)
{
    const TinkerPoint *hinge = &end[HINGE];
    return tinker_turn_from_rest(end[TIP].x - hinge->x, end[TIP].y - hinge->y, end[OTHER_TIP].x - hinge->x,
                                 end[OTHER_TIP].y - hinge->y, rest_angle);
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *end = &ends[ENDS * i];
        double *on = &result[2 * ENDS * i];
        const double turn = turn_of(end, rest[i]), moment = stiffness[i] * turn;
        memset(on, 0, 2 * ENDS * sizeof *on);
        if (fabs(turn) > MOST_TURN)
            return tinker_retry(batch, i, "its arms are more than 170 deg from the rest angle (it counts no turns)");
        if (!tinker_add_moment(&end[HINGE], &end[TIP], moment, &on[2 * HINGE], &on[2 * TIP]) ||
            !tinker_add_moment(&end[HINGE], &end[OTHER_TIP], -moment, &on[2 * HINGE], &on[2 * OTHER_TIP]))
            return tinker_retry(batch, i, "an arm has no length (its tip must not lie on the hinge)");
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerPoint *ends, double *stored)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        const double turn = turn_of(&ends[ENDS * i], rest[i]);
        stored[i] = 0.5 * stiffness[i] * turn * turn;
    }
    return TINKER_OK;
}

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .force = force, .energy = energy};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &force_element};

/* Drawing: the arms, and an arc from one to the other that widens on its way */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = instance->end, *hinge = &end[HINGE];
    const double ax = end[TIP].x - hinge->x, ay = end[TIP].y - hinge->y, from = atan2(ay, ax);
    const double rest = instance->columns[COLUMN_REST_ANGLE], radius = ARC_RADIUS * style->symbol_size;
    const double turn = tinker_turn_from_rest(ax, ay, end[OTHER_TIP].x - hinge->x, end[OTHER_TIP].y - hinge->y, rest);
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, end[TIP].x, end[TIP].y, hinge->x, hinge->y);
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, hinge->x, hinge->y, end[OTHER_TIP].x, end[OTHER_TIP].y);
    tinker_draw_arc(style, cairo, turn < 0.0 ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_STRETCHED, hinge->x, hinge->y,
                    from, from + rest + turn, 0.5 * radius, radius);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const double margin = ARC_RADIUS * style->symbol_size + tinker_drawing_margin(style);
    tinker_connector_bounds(instance, style, box);
    tinker_bounds_add(box, instance->end[HINGE].x, instance->end[HINGE].y, margin);
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = bounds};
static const TinkerEdit edit = {.struct_size = sizeof(TinkerEdit),
                                .hit = tinker_connector_hit,
                                .move = tinker_ends_move,
                                .move_absolute = tinker_ends_move_absolute};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *rest = tinker_column(batch, COLUMN_REST_ANGLE);
    for (int32_t i = 0; i < batch->count; i++) {
        const double turn = turn_of(&input->ends[ENDS * i], rest[i]);
        result[i] = quantity == QUANTITY_ANGLE    ? rest[i] + turn
                    : quantity == QUANTITY_MOMENT ? stiffness[i] * turn
                                                  : 0.5 * stiffness[i] * turn * turn;
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* Declaration */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Angle Spring", {1, 2, -2, -1}), TINKER_NOT_NEGATIVE(0, 20.0),
     .default_value = {1.0}, .symbol = "k", .variability = TINKER_TUNABLE, .description = "Moment per angle"},
    {TINKER_REAL_PROPERTY("rest_angle", "Rest Angle", "Angle Spring", TINKER_DIMENSION_ANGLE),
     TINKER_BETWEEN(0, -2.0 * TINKER_PI, 2.0 * TINKER_PI), .default_value = {TINKER_PI}, .symbol = "theta0",
     .variability = TINKER_TUNABLE, .description = "Angle from the first arm to the second without moment"},
};

/* clang-format off */
static const TinkerLawEquation law[] = {
    TINKER_EQUATION("along", "(x1 - x2)*(x3 - x2) + (y1 - y2)*(y3 - y2)", "product of the arms", {0, 2, 0, 0}),
    TINKER_EQUATION("across", "(x1 - x2)*(y3 - y2) - (y1 - y2)*(x3 - x2)", "cross product of the arms", {0, 2, 0, 0}),
    TINKER_EQUATION("turn", "atan2(across*cos(theta0) - along*sin(theta0), along*cos(theta0) + across*sin(theta0))",
                    "angle from rest", TINKER_DIMENSION_ANGLE),
    TINKER_EQUATION("potential", "k*turn^2/2", NULL, TINKER_DIMENSION_ENERGY),
};
/* clang-format on */

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "angle", "Angle", "From the first arm to the second, within 170 deg of rest",
                    TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(0, "moment", "Moment", "Turns the arms back to the rest angle", TINKER_DIMENSION_TORQUE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "k (theta - theta0)^2 / 2", TINKER_DIMENSION_ENERGY),
};

static const TinkerUnitChoice unit_choices[] = {{"rest_angle", "deg", "deg"}, {"angle", "deg", "deg"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("angle-spring", "Angle Spring", TINKER_CONNECTOR),
     .summary = "Turns two arms about a hinge towards their rest angle", .least_ends = ENDS, .most_ends = ENDS,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.angle-spring", "Angle Spring", "1.0.0", "MIT", blocks)
