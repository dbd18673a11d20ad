/* Contacts: the normal force as the multiplier of the gap, friction as another one where it sticks, as a share of the
 * normal force where it slides. With n, t, h, r and s as in contact-geometry.c, N n + f t acts on what has the tip, at
 * its arm, and friction turns a disc by r f besides; the opposite acts on what has the seat, which
 *
 *     by an edge   h f - N a turns, a = t . d the place along it
 *     by a round   s f turns, besides the moment of the force at the round's arm */
#include <float.h>
#include <math.h>

#include "equations/newton/contact-geometry.h"
#include "law/build.h"

/* Slower than this share of the body's speed and 1 m/s together, a contact whose friction is not the dynamic one
 * sticks. */
#define STICKING 1e-9
/* Of a coefficient of friction: what the run has differs by no more from what the properties say. */
#define SAME_SHARE 1e-12

typedef struct {
    TinkerEquationWriter *writer;
    const TinkerContactForce *contact;
    TinkerContactGeometry geometry;
    TinkerExpression *normal; /* N: the symbol of the normal force */
    TinkerExpression *along;  /* m: the place along an edge of a body; else NULL */
} Touching;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

/* Rows --------------------------------------------------------------------------------------------------------------
 */

static double value_of(const Touching *touching, const TinkerExpression *expression)
{
    return expression != NULL ? tinker_equations_value(touching->writer->equations, expression) : 0;
}

/* What the row that was added last does to both: along n, or along t. */
static void note_slopes(const Touching *touching, gboolean is_along)
{
    const TinkerContactGeometry *geometry = &touching->geometry;
    const TinkerTouching *tip = &geometry->tip, *seat = &geometry->seat;
    const double n[] = {value_of(touching, geometry->normal[0]), value_of(touching, geometry->normal[1])};
    const double x = is_along ? n[1] : n[0], y = is_along ? -n[0] : n[1];
    double on_tip[] = {x, y, value_of(touching, tip->point.arm_x) * y - value_of(touching, tip->point.arm_y) * x};
    double on_seat[] = {-x, -y, value_of(touching, seat->point.arm_y) * x - value_of(touching, seat->point.arm_x) * y};
    if (is_along) {
        on_tip[2] += value_of(touching, tip->radius);
        on_seat[2] += value_of(touching, geometry->distance != NULL ? seat->radius : geometry->off);
    } else {
        on_seat[2] -= value_of(touching, touching->along);
    }
    tinker_writer_note_slope(touching->writer, touching->contact->tip, on_tip);
    tinker_writer_note_slope(touching->writer, touching->contact->seat, on_seat);
}

/* A force on what has the tip, and the opposite on what has the seat; `turning` (NULL: nothing) beside their moments
 * about the places that they act at. All are taken over. */
static void add_pair(const Touching *touching, TinkerTermKind kind, TinkerExpression *x, TinkerExpression *y,
                     TinkerExpression *turning_tip, TinkerExpression *turning_seat)
{
    TinkerExpression *back_x = tinker_expression_negated(copy(x)), *back_y = tinker_expression_negated(copy(y));
    tinker_writer_add_term(touching->writer, &touching->geometry.tip.point, touching->contact->seat, kind, x, y,
                           turning_tip);
    tinker_writer_add_term(touching->writer, &touching->geometry.seat.point, touching->contact->tip, kind, back_x,
                           back_y, turning_seat);
}

static void add_normal(Touching *touching)
{
    const TinkerContactForce *contact = touching->contact;
    const TinkerContactGeometry *geometry = &touching->geometry;
    TinkerEquationWriter *writer = touching->writer;
    const char *name = tinker_contact_name(writer, contact, "N", NULL);
    touching->normal = tinker_writer_symbol(writer, name, contact->seat, contact->normal, tinker_force_dimension, NULL,
                                            "normal force");
    tinker_writer_add_row(writer, contact->seat, tinker_contact_gap(geometry), tinker_length_dimension, name, TRUE);
    note_slopes(touching, FALSE);
    TinkerExpression *turning =
        touching->along != NULL
            ? tinker_expression_negated(tinker_expression_times(copy(touching->normal), copy(touching->along)))
            : NULL;
    add_pair(touching, TINKER_TERM_NORMAL, tinker_expression_times(copy(touching->normal), copy(geometry->normal[0])),
             tinker_expression_times(copy(touching->normal), copy(geometry->normal[1])), NULL, turning);
}

/* Friction
 * ------------------------------------------------------------------------------------------------------------- */

/* Takes the force (N, along t on what has the tip) over. */
static void add_friction_terms(const Touching *touching, TinkerExpression *force)
{
    const TinkerContactGeometry *geometry = &touching->geometry;
    const TinkerExpression *of_tip = geometry->tip.radius,
                           *of_seat = geometry->distance != NULL ? geometry->seat.radius : geometry->off;
    TinkerExpression *turning_tip = of_tip != NULL ? tinker_expression_times(copy(force), copy(of_tip)) : NULL;
    TinkerExpression *turning_seat = of_seat != NULL ? tinker_expression_times(copy(force), copy(of_seat)) : NULL;
    TinkerExpression *x = tinker_expression_times(copy(force), copy(geometry->normal[1]));
    TinkerExpression *y = tinker_expression_negated(tinker_expression_times(force, copy(geometry->normal[0])));
    add_pair(touching, TINKER_TERM_FRICTION, x, y, turning_tip, turning_seat);
}

static double coefficient_of(const TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning)
{
    return tinker_frame_meaning(writer->frame, block, meaning, 0, NAN);
}

/* The coefficient of friction between the two: the geometric mean where both have one of their own; NAN where neither
 * has. */
static double share_by_properties(const Touching *touching, int32_t meaning)
{
    const double a = coefficient_of(touching->writer, touching->contact->seat, meaning),
                 b = coefficient_of(touching->writer, touching->contact->tip, meaning);
    return isnan(a) ? b : isnan(b) ? a : sqrt(a * b);
}

/* The coefficient in its properties; where these do not say it, as between two that have none, a number. */
static TinkerExpression *friction_share(const Touching *touching, int32_t meaning, double share, const char *stem)
{
    TinkerEquationWriter *writer = touching->writer;
    const TinkerBlockId blocks[] = {touching->contact->seat, touching->contact->tip};
    TinkerExpression *product = NULL;
    if (!(fabs(share_by_properties(touching, meaning) - share) <= SAME_SHARE * share)) {
        const char *name = tinker_contact_name(writer, touching->contact, stem, NULL);
        return tinker_writer_symbol(writer, name, touching->contact->seat, share, tinker_pure_dimension, NULL,
                                    "coefficient of friction of the two");
    }
    for (int k = 0; k < 2; k++) {
        if (isnan(coefficient_of(writer, blocks[k], meaning))) continue;
        TinkerExpression *own = tinker_writer_meaning(writer, blocks[k], meaning, 0, stem);
        if (product == NULL)
            product = own;
        else
            product = tinker_expression_call("sqrt", tinker_expression_times(product, own));
    }
    return product;
}

/* The coefficients that the run has, static and dynamic. */
static void shares_of(const Touching *touching, double shares[2])
{
    const TinkerTouch *touch = touching->contact->touch;
    shares[0] = touch != NULL ? touch->friction[0] : share_by_properties(touching, TINKER_MEANING_STATIC_FRICTION);
    shares[1] = touch != NULL ? touch->friction[1] : share_by_properties(touching, TINKER_MEANING_DYNAMIC_FRICTION);
}

static const char *means_of_place(const Touching *touching)
{
    const gboolean rolls = touching->geometry.tip.radius != NULL || touching->geometry.seat.radius != NULL;
    if (!tinker_contact_is_on_top(touching->writer, touching->contact))
        return rolls ? "place along the other where it has not turned" : "place along the other";
    return rolls ? "place along the top where it has not turned" : "place along the top";
}

static void add_sticking(const Touching *touching, double share)
{
    const TinkerContactForce *contact = touching->contact;
    TinkerEquationWriter *writer = touching->writer;
    TinkerExpression *place = tinker_contact_rolled(&touching->geometry);
    if (place == NULL) return;
    const char *start = tinker_contact_name(writer, contact, "s0", NULL);
    TinkerExpression *from = tinker_writer_symbol(writer, start, contact->seat, value_of(touching, place),
                                                  tinker_length_dimension, NULL, means_of_place(touching));
    tinker_equations_set_rounding(writer->equations, start, tinker_equations_rounding(writer->equations, place));
    const char *name = tinker_contact_name(writer, contact, "f", NULL);
    TinkerExpression *friction = tinker_writer_symbol(writer, name, contact->seat, contact->friction,
                                                      tinker_force_dimension, NULL, "friction force");
    tinker_writer_add_row(writer, contact->seat, tinker_expression_minus(place, from), tinker_length_dimension, name,
                          TRUE);
    tinker_writer_limit_row(
        writer, tinker_expression_times(friction_share(touching, TINKER_MEANING_STATIC_FRICTION, share, "µs"),
                                        copy(touching->normal)));
    note_slopes(touching, TRUE);
    add_friction_terms(touching, friction);
}

static void add_sliding(const Touching *touching, double share, gboolean at_limit, double direction)
{
    const TinkerContactForce *contact = touching->contact;
    TinkerEquationWriter *writer = touching->writer;
    if (!(share > 0)) return;
    TinkerExpression *coefficient = at_limit ? friction_share(touching, TINKER_MEANING_STATIC_FRICTION, share, "µs")
                                             : friction_share(touching, TINKER_MEANING_DYNAMIC_FRICTION, share, "µd");
    const char *name = tinker_contact_name(writer, contact, "σ", NULL);
    TinkerExpression *sign = tinker_writer_symbol(writer, name, contact->seat, direction, tinker_pure_dimension, NULL,
                                                  "direction of sliding");
    TinkerExpression *force = tinker_expression_negated(
        tinker_expression_times(tinker_expression_times(sign, coefficient), copy(touching->normal)));
    if (touching->geometry.seat.point.block >= 0) { /* it stands in the equations of both, and in their moments */
        const char *of_force = tinker_contact_name(writer, contact, "f", NULL);
        force = tinker_writer_define(writer, of_force, contact->seat, tinker_force_dimension, "friction force", force,
                                     FALSE);
    }
    add_friction_terms(touching, force);
}

/* m/s: of where a body touches the top of a support, along it, against the top there. */
static double speed_along(const Touching *touching)
{
    const TinkerEquationWriter *writer = touching->writer;
    const TinkerContactForce *contact = touching->contact;
    const TinkerPointSymbols *seat = &touching->geometry.seat.point;
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->tip);
    const double n[] = {value_of(touching, touching->geometry.normal[0]),
                        value_of(touching, touching->geometry.normal[1])};
    const double rate = contact->shape == TINKER_TOUCHES_AS_MASS ? 0 : at->rate,
                 turning = value_of(touching, seat->rate);
    const double x = contact->at[0] - value_of(touching, seat->x), y = contact->at[1] - value_of(touching, seat->y);
    const double ux = at->vx - rate * (contact->at[1] - at->y) - (value_of(touching, seat->vx) - turning * y);
    const double uy = at->vy + rate * (contact->at[0] - at->x) - (value_of(touching, seat->vy) + turning * x);
    return n[1] * ux - n[0] * uy;
}

/* Of a contact with a top of which speeds and forces alone are known. */
static void add_friction_by_speed(const Touching *touching, const double shares[2])
{
    const TinkerContactForce *contact = touching->contact;
    const TinkerBodySample *at = tinker_model_state_body(touching->writer->state, contact->tip);
    const double speed = speed_along(touching), dynamic = shares[1] * contact->normal;
    const gboolean moves = fabs(speed) > STICKING * (1 + hypot(at->vx, at->vy));
    const gboolean as_sliding = fabs(fabs(contact->friction) - dynamic) <= STICKING * dynamic;
    if (moves || as_sliding)
        add_sliding(touching, shares[1], FALSE, moves ? copysign(1, speed) : -copysign(1, contact->friction));
    else
        add_sticking(touching, shares[0]);
}

static void add_friction(const Touching *touching)
{
    const TinkerTouch *touch = touching->contact->touch;
    double shares[2];
    shares_of(touching, shares);
    if (touch == NULL)
        add_friction_by_speed(touching, shares);
    else if (touch->mode == TINKER_CONTACT_STICK)
        add_sticking(touching, shares[0]);
    else if (touch->mode != TINKER_CONTACT_SMOOTH)
        add_sliding(touching, touch->at_limit ? shares[0] : shares[1], touch->at_limit,
                    touch->mode == TINKER_CONTACT_SLIP_BACKWARD ? -1 : 1);
}

/* What resists rolling: its value, of which no law is written. */
static void add_moment(const Touching *touching)
{
    const TinkerContactForce *contact = touching->contact;
    const TinkerDimension dimension = TINKER_DIMENSION_ENERGY;
    const char *name = tinker_contact_name(touching->writer, contact, "M", NULL);
    tinker_writer_note_unwritten(touching->writer, contact->tip, name,
                                 "the moment that resists its rolling is a number here");
    TinkerExpression *moment = tinker_writer_symbol(touching->writer, name, contact->seat, contact->moment, dimension,
                                                    NULL, "moment against rolling");
    TinkerExpression *back = tinker_expression_negated(copy(moment));
    add_pair(touching, TINKER_TERM_FRICTION, tinker_expression_number(0), tinker_expression_number(0), moment, back);
}

/* The place along an edge of a body, about whose centre the normal force turns that. */
static TinkerExpression *define_along(TinkerEquationWriter *writer, const TinkerContactForce *contact,
                                      const TinkerContactGeometry *geometry)
{
    if (geometry->seat.point.block < 0 || geometry->distance != NULL) return NULL;
    const char *name = tinker_contact_name(writer, contact, "a", NULL);
    return tinker_writer_define(writer, name, contact->seat, tinker_length_dimension, "place along its edge",
                                tinker_contact_along(geometry), FALSE);
}

static gboolean resists_rolling(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    return coefficient_of(writer, contact->tip, TINKER_MEANING_ROLLING_RESISTANCE) > 0 ||
           coefficient_of(writer, contact->seat, TINKER_MEANING_ROLLING_RESISTANCE) > 0;
}

void tinker_writer_add_contact(TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    Touching touching = {.writer = writer, .contact = contact};
    tinker_contact_geometry_init(writer, contact, &touching.geometry);
    touching.along = define_along(writer, contact, &touching.geometry);
    add_normal(&touching);
    add_friction(&touching);
    if (resists_rolling(writer, contact)) add_moment(&touching);
    tinker_expression_unref(touching.normal);
    g_clear_pointer(&touching.along, tinker_expression_unref);
    tinker_contact_geometry_clear(&touching.geometry);
}
