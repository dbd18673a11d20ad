/* Contacts with tops: the normal force as the multiplier of the gap, friction as another one where it sticks, as a
 * share of the normal force where it slides.
 *
 * With n across the top and t = (n_y, -n_x) along it, d from its centre to that of the body:
 *
 *     a mass           gap n . d - (H + h) / 2,       place along the top t . d
 *     a disc           gap n . d - H / 2 - R,         rolled t . d + R theta: friction f turns it by R f
 *     another body     gap n . (d + r) - H / 2,       t . (d + r), r the arm from its centre to where it touches */
#include <float.h>
#include <math.h>

#include "equations/newton/contact-terms.h"
#include "law/build.h"

/* Slower than this share of the body's speed and 1 m/s together, a contact whose friction is not the dynamic one
 * sticks. */
#define STICKING 1e-9

/* A top as a body sees it; expressions are owned. */
typedef struct {
    TinkerPointSymbols centre;
    TinkerExpression *normal[2]; /* unit vector; the top runs along (normal[1], -normal[0]) */
    TinkerExpression *dx, *dy;   /* from its centre to the body's, or to where that touches */
    TinkerExpression *radius;    /* of a disc; else NULL */
    TinkerPointSymbols point;    /* of the body, where it touches: with the arm */
} Top;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static TinkerExpression *state_of(const TinkerEquationWriter *writer, TinkerBlockId body, const char *quantity)
{
    g_autofree char *name = g_strconcat(tinker_scene_block_name(writer->scene, body), ".", quantity, NULL);
    return tinker_expression_symbol(name);
}

static const char *name_of(TinkerEquationWriter *writer, const TinkerTopContact *contact, const char *stem,
                           const char *component)
{
    if (contact->index == NULL) return tinker_writer_name(writer, contact->support, stem, 0, component);
    return tinker_equations_free_name(writer->equations, contact->support, stem, contact->index, 0, component);
}

/* The arm to a place of the body that turns with it. */
static void add_arm(TinkerEquationWriter *writer, const TinkerTopContact *contact, Top *top)
{
    static const char *const components[] = {"x", "y"}, *const stems[] = {"ax", "ay"};
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->body);
    g_autoptr(TinkerExpression) angle = state_of(writer, contact->body, "angle");
    const double c = cos(at->orientation), s = sin(at->orientation);
    const double rx = contact->at[0] - at->x, ry = contact->at[1] - at->y;
    const double own[2] = {c * rx + s * ry, c * ry - s * rx};
    const double rounding = DBL_EPSILON * (hypot(contact->at[0], contact->at[1]) + hypot(at->x, at->y));
    TinkerExpression *local[2], *arm[2];
    for (int k = 0; k < 2; k++) {
        local[k] = tinker_writer_symbol(writer, name_of(writer, contact, stems[k], NULL), contact->support, own[k],
                                        tinker_length_dimension, NULL, "where it touches, in the body's axes");
        tinker_equations_set_rounding(writer->equations, local[k]->name, rounding);
    }
    arm[0] =
        tinker_expression_minus(tinker_expression_times(copy(local[0]), tinker_expression_call("cos", copy(angle))),
                                tinker_expression_times(copy(local[1]), tinker_expression_call("sin", copy(angle))));
    arm[1] = tinker_expression_plus(tinker_expression_times(local[0], tinker_expression_call("sin", copy(angle))),
                                    tinker_expression_times(local[1], tinker_expression_call("cos", copy(angle))));
    for (int k = 0; k < 2; k++)
        arm[k] = tinker_writer_define(writer, name_of(writer, contact, "r", components[k]), contact->support,
                                      tinker_length_dimension, "arm from the centre of mass", arm[k], FALSE);
    top->point.arm_x = arm[0];
    top->point.arm_y = arm[1];
    top->dx = tinker_expression_plus(top->dx, copy(arm[0]));
    top->dy = tinker_expression_plus(top->dy, copy(arm[1]));
}

static void top_init(TinkerEquationWriter *writer, const TinkerTopContact *contact, Top *top)
{
    *top = (Top){.point = {.block = contact->body}};
    tinker_writer_centre(writer, contact->support, &top->centre);
    top->normal[0] = tinker_expression_negated(tinker_expression_call("sin", copy(top->centre.angle)));
    top->normal[1] = tinker_expression_call("cos", copy(top->centre.angle));
    top->dx = tinker_expression_minus(state_of(writer, contact->body, "x"), copy(top->centre.x));
    top->dy = tinker_expression_minus(state_of(writer, contact->body, "y"), copy(top->centre.y));
    if (contact->shape == TINKER_TOUCHES_AT_CORNER) add_arm(writer, contact, top);
    if (contact->shape == TINKER_TOUCHES_AS_DISC)
        top->radius = tinker_writer_meaning(writer, contact->body, TINKER_MEANING_RADIUS, 0, "R");
}

static void top_clear(Top *top)
{
    TinkerExpression *const parts[] = {top->normal[0], top->normal[1], top->dx, top->dy};
    tinker_point_symbols_clear(&top->centre);
    tinker_point_symbols_clear(&top->point);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        tinker_expression_unref(parts[i]);
    g_clear_pointer(&top->radius, tinker_expression_unref);
}

/* a along the top. */
static TinkerExpression *along(const Top *top, const TinkerExpression *x, const TinkerExpression *y)
{
    return tinker_expression_minus(tinker_expression_times(copy(top->normal[1]), copy(x)),
                                   tinker_expression_times(copy(top->normal[0]), copy(y)));
}

static TinkerExpression *across(const Top *top, const TinkerExpression *x, const TinkerExpression *y)
{
    return tinker_expression_plus(tinker_expression_times(copy(top->normal[0]), copy(x)),
                                  tinker_expression_times(copy(top->normal[1]), copy(y)));
}

static TinkerExpression *half(TinkerExpression *height)
{
    return tinker_expression_over(height, tinker_expression_number(2));
}

/* What the row that was added last does to the body: along a direction where it touches; a disc it turns by what is
 * along the top alone. */
static void note_slope(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top,
                       const TinkerExpression *x, const TinkerExpression *y, gboolean is_along)
{
    const TinkerEquations *equations = writer->equations;
    double slope[] = {tinker_equations_value(equations, x), tinker_equations_value(equations, y), 0};
    if (top->radius != NULL && is_along) slope[2] = tinker_equations_value(equations, top->radius);
    if (top->point.arm_x != NULL)
        slope[2] = tinker_equations_value(equations, top->point.arm_x) * slope[1] -
                   tinker_equations_value(equations, top->point.arm_y) * slope[0];
    tinker_writer_note_slope(writer, contact->body, slope);
}

static TinkerExpression *add_normal(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top)
{
    const TinkerBlockId support = contact->support;
    TinkerExpression *beyond = half(tinker_writer_meaning(writer, support, TINKER_MEANING_HEIGHT, 0, "H"));
    if (contact->shape == TINKER_TOUCHES_AS_MASS)
        beyond = tinker_expression_plus(
            beyond, half(tinker_writer_meaning(writer, contact->body, TINKER_MEANING_HEIGHT, 0, "h")));
    if (top->radius != NULL) beyond = tinker_expression_plus(beyond, copy(top->radius));
    const char *name = name_of(writer, contact, "N", NULL);
    TinkerExpression *normal =
        tinker_writer_symbol(writer, name, support, contact->normal, tinker_force_dimension, NULL, "normal force");
    tinker_writer_add_row(writer, support, tinker_expression_minus(across(top, top->dx, top->dy), beyond),
                          tinker_length_dimension, name, TRUE);
    note_slope(writer, contact, top, top->normal[0], top->normal[1], FALSE);
    tinker_writer_add_term(writer, &top->point, support, TINKER_TERM_NORMAL,
                           tinker_expression_times(copy(normal), copy(top->normal[0])),
                           tinker_expression_times(copy(normal), copy(top->normal[1])), NULL);
    return normal;
}

static void add_friction_term(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top,
                              TinkerExpression *force)
{
    TinkerExpression *x = tinker_expression_times(copy(force), copy(top->normal[1]));
    TinkerExpression *turning = top->radius != NULL ? tinker_expression_times(copy(force), copy(top->radius)) : NULL;
    TinkerExpression *y = tinker_expression_negated(tinker_expression_times(force, copy(top->normal[0])));
    tinker_writer_add_term(writer, &top->point, contact->support, TINKER_TERM_FRICTION, x, y, turning);
}

/* What a contact that sticks keeps: the place along the top, or how far it has rolled there. */
static TinkerExpression *kept_along(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top)
{
    TinkerExpression *place = along(top, top->dx, top->dy);
    if (top->radius == NULL) return place;
    TinkerExpression *turned = state_of(writer, contact->body, "angle");
    if (!tinker_expression_is_number(top->centre.rate, 0))
        turned = tinker_expression_minus(turned, copy(top->centre.angle));
    return tinker_expression_plus(place, tinker_expression_times(copy(top->radius), turned));
}

static double friction_of(const TinkerEquationWriter *writer, TinkerBlockId block, double otherwise)
{
    return tinker_frame_meaning(writer->frame, block, TINKER_MEANING_DYNAMIC_FRICTION, 0, otherwise);
}

/* A coefficient of friction: the geometric mean where the body has one of its own. */
static TinkerExpression *friction_share(TinkerEquationWriter *writer, const TinkerTopContact *contact, int32_t meaning,
                                        const char *stem)
{
    TinkerExpression *of_support = tinker_writer_meaning(writer, contact->support, meaning, 0, stem);
    if (isnan(tinker_frame_meaning(writer->frame, contact->body, meaning, 0, NAN))) return of_support;
    TinkerExpression *of_body = tinker_writer_meaning(writer, contact->body, meaning, 0, stem);
    return tinker_expression_call("sqrt", tinker_expression_times(of_support, of_body));
}

static void add_sticking(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top,
                         const TinkerExpression *normal)
{
    const TinkerBlockId support = contact->support;
    TinkerExpression *place = kept_along(writer, contact, top);
    const double value = tinker_equations_value(writer->equations, place);
    const char *start = name_of(writer, contact, "s0", NULL);
    TinkerExpression *from = tinker_writer_symbol(writer, start, support, value, tinker_length_dimension, NULL,
                                                  top->radius != NULL ? "place along the top where it has not turned"
                                                                      : "place along the top");
    tinker_equations_set_rounding(writer->equations, start, tinker_equations_rounding(writer->equations, place));
    const char *name = name_of(writer, contact, "f", NULL);
    TinkerExpression *friction =
        tinker_writer_symbol(writer, name, support, contact->friction, tinker_force_dimension, NULL, "friction force");
    tinker_writer_add_row(writer, support, tinker_expression_minus(place, from), tinker_length_dimension, name, TRUE);
    tinker_writer_limit_row(
        writer,
        tinker_expression_times(friction_share(writer, contact, TINKER_MEANING_STATIC_FRICTION, "µs"), copy(normal)));
    g_autoptr(TinkerExpression) back = tinker_expression_negated(copy(top->normal[0]));
    note_slope(writer, contact, top, top->normal[1], back, TRUE);
    add_friction_term(writer, contact, top, friction);
}

static void add_sliding(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top,
                        const TinkerExpression *normal, double direction)
{
    const TinkerBlockId support = contact->support;
    TinkerExpression *share = friction_share(writer, contact, TINKER_MEANING_DYNAMIC_FRICTION, "µd");
    if (tinker_expression_is_number(share, 0)) {
        tinker_expression_unref(share);
        return;
    }
    const char *name = name_of(writer, contact, "σ", NULL);
    TinkerExpression *sign =
        tinker_writer_symbol(writer, name, support, direction, tinker_pure_dimension, NULL, "direction of sliding");
    TinkerExpression *force = tinker_expression_times(tinker_expression_times(sign, share), copy(normal));
    add_friction_term(writer, contact, top, tinker_expression_negated(force));
}

/* m/s: of where the body touches, along the top, against the top there. */
static double speed_along(const TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top)
{
    const TinkerEquations *equations = writer->equations;
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->body);
    const double n[] = {tinker_equations_value(equations, top->normal[0]),
                        tinker_equations_value(equations, top->normal[1])};
    const double rate = contact->shape == TINKER_TOUCHES_AS_MASS ? 0 : at->rate;
    const double turning = tinker_equations_value(equations, top->centre.rate);
    const double x = contact->at[0] - tinker_equations_value(equations, top->centre.x),
                 y = contact->at[1] - tinker_equations_value(equations, top->centre.y);
    const double ux =
        at->vx - rate * (contact->at[1] - at->y) - (tinker_equations_value(equations, top->centre.vx) - turning * y);
    const double uy =
        at->vy + rate * (contact->at[0] - at->x) - (tinker_equations_value(equations, top->centre.vy) + turning * x);
    return n[1] * ux - n[0] * uy;
}

/* What resists rolling: its value, of which no law is written. */
static void add_moment(TinkerEquationWriter *writer, const TinkerTopContact *contact, const Top *top)
{
    const TinkerDimension dimension = TINKER_DIMENSION_ENERGY;
    const char *name = name_of(writer, contact, "M", NULL);
    tinker_writer_note_unwritten(writer, contact->body, name, "the moment that resists its rolling is a number here");
    TinkerExpression *moment = tinker_writer_symbol(writer, name, contact->support, contact->moment, dimension, NULL,
                                                    "moment against rolling");
    tinker_writer_add_term(writer, &top->point, contact->support, TINKER_TERM_FRICTION, tinker_expression_number(0),
                           tinker_expression_number(0), moment);
}

void tinker_writer_add_top_contact(TinkerEquationWriter *writer, const TinkerTopContact *contact)
{
    Top top;
    top_init(writer, contact, &top);
    g_autoptr(TinkerExpression) normal = add_normal(writer, contact, &top);
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->body);
    const double speed = speed_along(writer, contact, &top);
    const double of_support = friction_of(writer, contact->support, 0), own = friction_of(writer, contact->body, NAN);
    const double share = isnan(own) ? of_support : sqrt(of_support * own);
    const double dynamic = share * contact->normal;
    const gboolean moves = fabs(speed) > STICKING * (1 + hypot(at->vx, at->vy));
    const gboolean as_sliding = fabs(fabs(contact->friction) - dynamic) <= STICKING * dynamic;
    if (moves || as_sliding)
        add_sliding(writer, contact, &top, normal, moves ? copysign(1, speed) : -copysign(1, contact->friction));
    else
        add_sticking(writer, contact, &top, normal);
    if (tinker_frame_meaning(writer->frame, contact->body, TINKER_MEANING_ROLLING_RESISTANCE, 0, 0) > 0)
        add_moment(writer, contact, &top);
    top_clear(&top);
}
