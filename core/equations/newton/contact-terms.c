/* Contacts: the normal force as the multiplier of the gap, friction as another one where it sticks, as a share of the
 * normal force where it slides. With n, t, h, r and s as in contact-geometry.c, N n + f t acts on what has the tip, and
 * the opposite on what has the seat. About their centres these have moments by their levers; with p and q the arms of
 * the tip and of a round:
 *
 *                  of N                of f
 *     a corner     p x n               p x t = -p . n
 *     a disc                           r, or s
 *     an edge      -a, a = t . d       h
 *     a round      -q x n              q . n */
#include <float.h>
#include <math.h>

#include "equations/newton/contact-geometry.h"
#include "law/build.h"

/* Slower than this share of the body's speed and 1 m/s together, a contact whose friction is not the dynamic one
 * sticks. */
#define STICKING 1e-9
/* Of a coefficient of friction: what the run has differs by no more from what the properties say. */
#define SAME_SHARE 1e-12

/* Moments of the normal force and of friction on a body by their levers (m); NULL: there is none. Owned. */
typedef struct {
    TinkerExpression *normal, *friction;
} Levers;

typedef struct {
    TinkerEquationWriter *writer;
    const TinkerContactForce *contact;
    TinkerContactGeometry geometry;
    TinkerExpression *normal; /* N: the symbol of the normal force */
    Levers tip, seat;         /* on a top the force at the arm says what it does to the tip's body */
} ContactTerms;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

static double value_of(const ContactTerms *terms, const TinkerExpression *expression)
{
    return expression != NULL ? tinker_equations_value(terms->writer->equations, expression) : 0;
}

/* What the row that was added last does to both: along n, or along t. */
static void note_slopes(const ContactTerms *terms, gboolean is_along)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->tip.point;
    const double n[] = {value_of(terms, geometry->normal[0]), value_of(terms, geometry->normal[1])};
    const double x = is_along ? n[1] : n[0], y = is_along ? -n[0] : n[1];
    double on_tip[] = {x, y, value_of(terms, is_along ? terms->tip.friction : terms->tip.normal)};
    const double on_seat[] = {-x, -y, value_of(terms, is_along ? terms->seat.friction : terms->seat.normal)};
    if (tinker_contact_is_on_top(terms->writer, terms->contact))
        on_tip[2] += value_of(terms, arm->arm_x) * y - value_of(terms, arm->arm_y) * x;
    tinker_writer_note_slope(terms->writer, terms->contact->tip, on_tip);
    tinker_writer_note_slope(terms->writer, terms->contact->seat, on_seat);
}

static TinkerExpression *moment_by(const TinkerExpression *force, const TinkerExpression *lever)
{
    return lever != NULL ? tinker_expression_times(copy(force), copy(lever)) : NULL;
}

/* A force on what has the tip, and the opposite on what has the seat, with the moments (NULL: none) that they have by
 * their levers. All are taken over. */
static void add_pair(const ContactTerms *terms, TinkerTermKind kind, TinkerExpression *x, TinkerExpression *y,
                     TinkerExpression *on_tip, TinkerExpression *on_seat)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerPointSymbols *tip = &terms->geometry.tip.point, centre = {.block = tip->block},
                             seat = {.block = terms->geometry.seat.point.block};
    const gboolean on_top = tinker_contact_is_on_top(terms->writer, contact);
    TinkerExpression *back_x = tinker_expression_negated(copy(x)), *back_y = tinker_expression_negated(copy(y));
    tinker_writer_add_term(terms->writer, on_top ? tip : &centre, contact->seat, kind, x, y, on_tip);
    tinker_writer_add_term(terms->writer, &seat, contact->tip, kind, back_x, back_y, on_seat);
}

static void add_normal(ContactTerms *terms)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerContactGeometry *geometry = &terms->geometry;
    TinkerEquationWriter *writer = terms->writer;
    const char *name = tinker_contact_name(writer, contact, "N", NULL);
    TinkerExpression *force = tinker_writer_symbol(writer, name, contact->seat, contact->normal, tinker_force_dimension,
                                                   NULL, "normal force");
    tinker_writer_add_row(writer, contact->seat, tinker_contact_gap(geometry), tinker_length_dimension, name, TRUE);
    note_slopes(terms, FALSE);
    add_pair(terms, TINKER_TERM_NORMAL, tinker_expression_times(copy(force), copy(geometry->normal[0])),
             tinker_expression_times(copy(force), copy(geometry->normal[1])), moment_by(force, terms->tip.normal),
             moment_by(force, terms->seat.normal));
    terms->normal = force;
}

/* Levers ----------------------------------------------------------------------------------------------------------- */

static TinkerExpression *define_lever(const ContactTerms *terms, const char *stem, const char *means,
                                      TinkerExpression *is)
{
    const char *name = tinker_contact_name(terms->writer, terms->contact, stem, NULL);
    return tinker_writer_define(terms->writer, name, terms->contact->seat, tinker_length_dimension, means, is, FALSE);
}

/* a x n. */
static TinkerExpression *arm_across(const TinkerPointSymbols *arm, TinkerExpression *const n[2])
{
    return tinker_expression_minus(tinker_expression_times(copy(arm->arm_x), copy(n[1])),
                                   tinker_expression_times(copy(arm->arm_y), copy(n[0])));
}

/* a . n. */
static TinkerExpression *arm_along(const TinkerPointSymbols *arm, TinkerExpression *const n[2])
{
    return tinker_expression_plus(tinker_expression_times(copy(arm->arm_x), copy(n[0])),
                                  tinker_expression_times(copy(arm->arm_y), copy(n[1])));
}

static void add_levers_of_tip(ContactTerms *terms)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->tip.point;
    TinkerExpression *const *n = geometry->normal;
    Levers *levers = &terms->tip;
    if (geometry->tip.radius != NULL) levers->friction = copy(geometry->tip.radius);
    if (arm->block < 0 || arm->arm_x == NULL || tinker_contact_is_on_top(terms->writer, terms->contact)) return;
    levers->normal = define_lever(terms, "b", "lever of the normal force", arm_across(arm, n));
    TinkerExpression *back = tinker_expression_negated(tinker_expression_times(copy(arm->arm_x), copy(n[0])));
    levers->friction =
        define_lever(terms, "c", "lever of friction",
                     tinker_expression_minus(back, tinker_expression_times(copy(arm->arm_y), copy(n[1]))));
}

static void add_levers_of_seat(ContactTerms *terms)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->seat.point;
    Levers *levers = &terms->seat;
    if (arm->block < 0) return;
    if (geometry->distance == NULL) {
        TinkerExpression *along = define_lever(terms, "a", "place along its edge", tinker_contact_along(geometry));
        levers->normal = tinker_expression_negated(along);
        levers->friction = copy(geometry->off);
    } else if (arm->arm_x != NULL) {
        TinkerExpression *across =
            define_lever(terms, "a", "lever of the normal force", arm_across(arm, geometry->normal));
        levers->normal = tinker_expression_negated(across);
        levers->friction = define_lever(terms, "h", "lever of friction", arm_along(arm, geometry->normal));
    } else if (geometry->seat.radius != NULL) {
        levers->friction = copy(geometry->seat.radius);
    }
}

static void levers_clear(Levers *levers)
{
    g_clear_pointer(&levers->normal, tinker_expression_unref);
    g_clear_pointer(&levers->friction, tinker_expression_unref);
}

/* Friction --------------------------------------------------------------------------------------------------------- */

/* Takes the force (N, along t on what has the tip) over. */
static void add_friction_terms(const ContactTerms *terms, TinkerExpression *force)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    TinkerExpression *on_tip = moment_by(force, terms->tip.friction), *on_seat = moment_by(force, terms->seat.friction);
    TinkerExpression *x = tinker_expression_times(copy(force), copy(geometry->normal[1]));
    TinkerExpression *y = tinker_expression_negated(tinker_expression_times(force, copy(geometry->normal[0])));
    add_pair(terms, TINKER_TERM_FRICTION, x, y, on_tip, on_seat);
}

static double coefficient_of(const TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning)
{
    return tinker_frame_meaning(writer->frame, block, meaning, 0, NAN);
}

/* The coefficient of friction between the two: the geometric mean where both have one of their own; NAN where neither
 * has. */
static double share_by_properties(const ContactTerms *terms, int32_t meaning)
{
    const double a = coefficient_of(terms->writer, terms->contact->seat, meaning),
                 b = coefficient_of(terms->writer, terms->contact->tip, meaning);
    return isnan(a) ? b : isnan(b) ? a : sqrt(a * b);
}

/* The coefficient in its properties; where these do not say it, as between two that have none, a number. */
static TinkerExpression *friction_share(const ContactTerms *terms, int32_t meaning, double share, const char *stem)
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
static void shares_of(const ContactTerms *terms, double shares[2])
{
    const TinkerActingTouch *touch = terms->contact->touch;
    shares[0] = touch != NULL ? touch->friction[0] : share_by_properties(terms, TINKER_MEANING_STATIC_FRICTION);
    shares[1] = touch != NULL ? touch->friction[1] : share_by_properties(terms, TINKER_MEANING_DYNAMIC_FRICTION);
}

static const char *means_of_place(const ContactTerms *terms)
{
    const gboolean rolls = terms->geometry.tip.radius != NULL || terms->geometry.seat.radius != NULL;
    if (!tinker_contact_is_on_top(terms->writer, terms->contact))
        return rolls ? "place along the other where it has not turned" : "place along the other";
    return rolls ? "place along the top where it has not turned" : "place along the top";
}

static void add_sticking(const ContactTerms *terms, double share)
{
    const TinkerContactForce *contact = terms->contact;
    TinkerEquationWriter *writer = terms->writer;
    TinkerExpression *place = tinker_contact_rolled(&terms->geometry);
    if (place == NULL) return;
    const char *start = tinker_contact_name(writer, contact, "s0", NULL);
    TinkerExpression *from = tinker_writer_symbol(writer, start, contact->seat, value_of(terms, place),
                                                  tinker_length_dimension, NULL, means_of_place(terms));
    tinker_equations_set_rounding(writer->equations, start, tinker_equations_rounding(writer->equations, place));
    const char *name = tinker_contact_name(writer, contact, "f", NULL);
    TinkerExpression *friction = tinker_writer_symbol(writer, name, contact->seat, contact->friction,
                                                      tinker_force_dimension, NULL, "friction force");
    tinker_writer_add_row(writer, contact->seat, tinker_expression_minus(place, from), tinker_length_dimension, name,
                          TRUE);
    tinker_writer_limit_row(writer,
                            tinker_expression_times(friction_share(terms, TINKER_MEANING_STATIC_FRICTION, share, "µs"),
                                                    copy(terms->normal)));
    note_slopes(terms, TRUE);
    add_friction_terms(terms, friction);
}

static void add_sliding(const ContactTerms *terms, double share, gboolean at_limit, double direction)
{
    const TinkerContactForce *contact = terms->contact;
    TinkerEquationWriter *writer = terms->writer;
    if (!(share > 0)) return;
    TinkerExpression *coefficient = at_limit ? friction_share(terms, TINKER_MEANING_STATIC_FRICTION, share, "µs")
                                             : friction_share(terms, TINKER_MEANING_DYNAMIC_FRICTION, share, "µd");
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

/* m/s: of where a body touches the top of a support, along it, against the top there. */
static double speed_along(const ContactTerms *terms)
{
    const TinkerEquationWriter *writer = terms->writer;
    const TinkerContactForce *contact = terms->contact;
    const TinkerPointSymbols *seat = &terms->geometry.seat.point;
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->tip);
    const double n[] = {value_of(terms, terms->geometry.normal[0]), value_of(terms, terms->geometry.normal[1])};
    const double rate = contact->shape == TINKER_TOUCHES_AS_MASS ? 0 : at->rate, turning = value_of(terms, seat->rate);
    const double x = contact->at[0] - value_of(terms, seat->x), y = contact->at[1] - value_of(terms, seat->y);
    const double ux = at->vx - rate * (contact->at[1] - at->y) - (value_of(terms, seat->vx) - turning * y);
    const double uy = at->vy + rate * (contact->at[0] - at->x) - (value_of(terms, seat->vy) + turning * x);
    return n[1] * ux - n[0] * uy;
}

/* Of a contact with a top of which speeds and forces alone are known. */
static void add_friction_by_speed(const ContactTerms *terms, const double shares[2])
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

static void add_friction(const ContactTerms *terms)
{
    const TinkerActingTouch *touch = terms->contact->touch;
    double shares[2];
    shares_of(terms, shares);
    if (touch == NULL)
        add_friction_by_speed(terms, shares);
    else if (touch->mode == TINKER_CONTACT_STICK)
        add_sticking(terms, shares[0]);
    else if (touch->mode != TINKER_CONTACT_SMOOTH)
        add_sliding(terms, touch->at_limit ? shares[0] : shares[1], touch->at_limit,
                    touch->mode == TINKER_CONTACT_SLIP_BACKWARD ? -1 : 1);
}

/* What resists rolling: its value, of which no law is written. */
static void add_moment(const ContactTerms *terms)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerDimension dimension = TINKER_DIMENSION_ENERGY;
    const char *name = tinker_contact_name(terms->writer, contact, "M", NULL);
    tinker_writer_note_unwritten(terms->writer, contact->tip, name,
                                 "the moment that resists its rolling is a number here");
    TinkerExpression *moment = tinker_writer_symbol(terms->writer, name, contact->seat, contact->moment, dimension,
                                                    NULL, "moment against rolling");
    TinkerExpression *back = tinker_expression_negated(copy(moment));
    add_pair(terms, TINKER_TERM_FRICTION, tinker_expression_number(0), tinker_expression_number(0), moment, back);
}

static gboolean resists_rolling(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    return coefficient_of(writer, contact->tip, TINKER_MEANING_ROLLING_RESISTANCE) > 0 ||
           coefficient_of(writer, contact->seat, TINKER_MEANING_ROLLING_RESISTANCE) > 0;
}

void tinker_writer_add_contact(TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    ContactTerms terms = {.writer = writer, .contact = contact};
    tinker_contact_geometry_init(writer, contact, &terms.geometry);
    add_levers_of_tip(&terms);
    add_levers_of_seat(&terms);
    add_normal(&terms);
    add_friction(&terms);
    if (resists_rolling(writer, contact)) add_moment(&terms);
    tinker_expression_unref(terms.normal);
    levers_clear(&terms.tip);
    levers_clear(&terms.seat);
    tinker_contact_geometry_clear(&terms.geometry);
}
