#include "equations/newton/contact-friction.h"

#include <float.h>
#include <math.h>

#include "equations/newton/contact-means.h"
#include "law/build.h"

/* Slower than this share of the body's speed and 1 m/s together, a contact whose friction is not the dynamic one
 * sticks. */
#define STICKING 1e-9
/* Of a coefficient of friction: what the run has differs by no more from what the properties say. */
#define SAME_SHARE 1e-12

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

/* Takes the force (N, along t on what has the tip) over. */
static void add_friction_terms(const TinkerContactTerms *terms, TinkerExpression *force)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    TinkerExpression *on_tip = tinker_contact_moment_by(force, terms->tip.friction),
                     *on_seat = tinker_contact_moment_by(force, terms->seat.friction);
    TinkerExpression *x = tinker_expression_times(copy(force), copy(geometry->normal[1]));
    TinkerExpression *y = tinker_expression_negated(tinker_expression_times(force, copy(geometry->normal[0])));
    tinker_contact_add_pair(terms, TINKER_TERM_FRICTION, x, y, on_tip, on_seat);
}

static double coefficient_of(const TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning)
{
    return tinker_frame_meaning(writer->frame, block, meaning, 0, NAN);
}

/* The coefficient of friction between the two: the geometric mean where both have one of their own; NAN where neither
 * has. */
static double share_by_properties(const TinkerContactTerms *terms, int32_t meaning)
{
    const double a = coefficient_of(terms->writer, terms->contact->seat, meaning),
                 b = coefficient_of(terms->writer, terms->contact->tip, meaning);
    return isnan(a) ? b : isnan(b) ? a : sqrt(a * b);
}

/* The coefficient in its properties; where these do not say it, as between two that have none, a number. */
static TinkerExpression *friction_share(const TinkerContactTerms *terms, int32_t meaning, double share,
                                        const char *stem)
{
    TinkerEquationWriter *writer = terms->writer;
    const TinkerBlockId blocks[] = {terms->contact->seat, terms->contact->tip};
    TinkerExpression *product = NULL;
    if (!(fabs(share_by_properties(terms, meaning) - share) <= SAME_SHARE * share)) {
        const char *name = tinker_contact_name(writer, terms->contact, stem, NULL);
        return tinker_writer_symbol(writer, name, terms->contact->seat, share, tinker_pure_dimension, NULL,
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
static void shares_of(const TinkerContactTerms *terms, double shares[2])
{
    const TinkerActingTouch *touch = terms->contact->touch;
    shares[0] = touch != NULL ? touch->friction[0] : share_by_properties(terms, TINKER_MEANING_STATIC_FRICTION);
    shares[1] = touch != NULL ? touch->friction[1] : share_by_properties(terms, TINKER_MEANING_DYNAMIC_FRICTION);
}

static const char *means_of_place(const TinkerContactTerms *terms)
{
    const gboolean rolls = terms->geometry.tip.radius != NULL || terms->geometry.seat.radius != NULL;
    if (!tinker_contact_is_on_top(terms->writer, terms->contact))
        return rolls ? "place along the other where it has not turned" : "place along the other";
    return rolls ? "place along the top where it has not turned" : "place along the top";
}

static void add_sticking(const TinkerContactTerms *terms, double share)
{
    const TinkerContactForce *contact = terms->contact;
    TinkerEquationWriter *writer = terms->writer;
    TinkerExpression *place = tinker_contact_rolled(&terms->geometry);
    if (place == NULL) return;
    const char *start = tinker_contact_name(writer, contact, "s0", NULL);
    TinkerExpression *from = tinker_writer_symbol(writer, start, contact->seat, tinker_contact_value(terms, place),
                                                  tinker_length_dimension, NULL, means_of_place(terms));
    tinker_equations_set_rounding(writer->equations, start, tinker_equations_rounding(writer->equations, place));
    const char *name = tinker_contact_name(writer, contact, "f", NULL);
    TinkerExpression *friction = tinker_writer_symbol(writer, name, contact->seat, contact->friction,
                                                      tinker_force_dimension, NULL, "friction force");
    tinker_writer_add_row(writer, contact->seat, tinker_expression_minus(place, from), tinker_length_dimension, name,
                          TRUE);
    tinker_writer_limit_row(writer,
                            tinker_expression_times(friction_share(terms, TINKER_MEANING_STATIC_FRICTION, share, "μs"),
                                                    copy(terms->normal)));
    tinker_contact_note_slopes(terms, TRUE);
    add_friction_terms(terms, friction);
}

static void add_sliding(const TinkerContactTerms *terms, double share, gboolean at_limit, double direction)
{
    const TinkerContactForce *contact = terms->contact;
    TinkerEquationWriter *writer = terms->writer;
    if (!(share > 0)) return;
    TinkerExpression *coefficient = at_limit ? friction_share(terms, TINKER_MEANING_STATIC_FRICTION, share, "μs")
                                             : friction_share(terms, TINKER_MEANING_DYNAMIC_FRICTION, share, "μd");
    const char *name = tinker_contact_name(writer, contact, "σ", NULL);
    TinkerExpression *sign = tinker_writer_symbol(writer, name, contact->seat, direction, tinker_pure_dimension, NULL,
                                                  "direction of sliding");
    TinkerExpression *force = tinker_expression_negated(
        tinker_expression_times(tinker_expression_times(sign, coefficient), copy(terms->normal)));
    if (terms->geometry.seat.point.block >= 0) { /* it stands in the equations of both, and in their moments */
        const char *of_force = tinker_contact_name(writer, contact, "f", NULL);
        force = tinker_writer_define(writer, of_force, contact->seat, tinker_force_dimension, "friction force", force,
                                     FALSE);
    }
    add_friction_terms(terms, force);
}

/* m/s: of a mass along the top of a support, against the top there. */
static double speed_along(const TinkerContactTerms *terms)
{
    const TinkerEquationWriter *writer = terms->writer;
    const TinkerContactForce *contact = terms->contact;
    const TinkerPointSymbols *seat = &terms->geometry.seat.point;
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->tip);
    const double n[] = {tinker_contact_value(terms, terms->geometry.normal[0]),
                        tinker_contact_value(terms, terms->geometry.normal[1])};
    const double turning = tinker_contact_value(terms, seat->rate);
    const double x = contact->at[0] - tinker_contact_value(terms, seat->x),
                 y = contact->at[1] - tinker_contact_value(terms, seat->y);
    const double ux = at->vx - (tinker_contact_value(terms, seat->vx) - turning * y);
    const double uy = at->vy - (tinker_contact_value(terms, seat->vy) + turning * x);
    return n[1] * ux - n[0] * uy;
}

/* Of a mass on a top, of which speeds and forces alone are known. */
static void add_friction_by_speed(const TinkerContactTerms *terms, const double shares[2])
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerBodySample *at = tinker_model_state_body(terms->writer->state, contact->tip);
    const double speed = speed_along(terms), dynamic = shares[1] * contact->normal;
    const gboolean moves = fabs(speed) > STICKING * (1 + hypot(at->vx, at->vy));
    const gboolean as_sliding = fabs(fabs(contact->friction) - dynamic) <= STICKING * dynamic;
    if (moves || as_sliding)
        add_sliding(terms, shares[1], FALSE, moves ? copysign(1, speed) : -copysign(1, contact->friction));
    else
        add_sticking(terms, shares[0]);
}

/* The mean of a step: by its law where it has the value of that, or else a number. */
static void add_mean_friction(const TinkerContactTerms *terms, const double shares[2])
{
    const TinkerContactForce *contact = terms->contact;
    const double dynamic = shares[1] * contact->normal, direction = -copysign(1, contact->friction);
    if (contact->friction == 0) return;
    if (fabs(fabs(contact->friction) - dynamic) <= SAME_SHARE * dynamic) {
        add_sliding(terms, shares[1], FALSE, direction);
        return;
    }
    const char *name = tinker_contact_name(terms->writer, contact, "f", NULL);
    tinker_contact_note_mean(terms->writer, contact, name);
    add_friction_terms(terms, tinker_writer_symbol(terms->writer, name, contact->seat, contact->friction,
                                                   tinker_force_dimension, NULL, "friction force"));
}

void tinker_contact_add_friction(const TinkerContactTerms *terms)
{
    const TinkerActingTouch *touch = terms->contact->touch;
    double shares[2];
    shares_of(terms, shares);
    if (terms->contact->is_mean)
        add_mean_friction(terms, shares);
    else if (touch == NULL)
        add_friction_by_speed(terms, shares);
    else if (touch->mode == TINKER_CONTACT_STICK)
        add_sticking(terms, shares[0]);
    else if (touch->mode != TINKER_CONTACT_SMOOTH)
        add_sliding(terms, touch->at_limit ? shares[0] : shares[1], touch->at_limit,
                    touch->mode == TINKER_CONTACT_SLIP_BACKWARD ? -1 : 1);
}
