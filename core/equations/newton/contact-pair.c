/* With n, t, h, r and s as in contact-geometry.c, N n + f t acts on what has the tip, and the opposite on what has the
 * seat. About their centres these have moments by their levers; with p and q the arms of the tip and of a round:
 *
 *                  of N                of f
 *     a corner     p x n               p x t = -p . n
 *     a disc                           r, or s
 *     an edge      -a, a = t . d       h
 *     a round      -q x n              q . n */
#include "equations/newton/contact-pair.h"

#include "equations/newton/contact-means.h"
#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

double tinker_contact_value(const TinkerContactTerms *terms, const TinkerExpression *expression)
{
    return expression != NULL ? tinker_equations_value(terms->writer->equations, expression) : 0;
}

void tinker_contact_note_slopes(const TinkerContactTerms *terms, gboolean is_along)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->tip.point;
    const double n[] = {tinker_contact_value(terms, geometry->normal[0]),
                        tinker_contact_value(terms, geometry->normal[1])};
    const double x = is_along ? n[1] : n[0], y = is_along ? -n[0] : n[1];
    double on_tip[] = {x, y, tinker_contact_value(terms, is_along ? terms->tip.friction : terms->tip.normal)};
    const double on_seat[] = {-x, -y,
                              tinker_contact_value(terms, is_along ? terms->seat.friction : terms->seat.normal)};
    if (tinker_contact_is_on_top(terms->writer, terms->contact))
        on_tip[2] += tinker_contact_value(terms, arm->arm_x) * y - tinker_contact_value(terms, arm->arm_y) * x;
    tinker_writer_note_slope(terms->writer, terms->contact->tip, on_tip);
    tinker_writer_note_slope(terms->writer, terms->contact->seat, on_seat);
}

TinkerExpression *tinker_contact_moment_by(const TinkerExpression *force, const TinkerExpression *lever)
{
    return lever != NULL ? tinker_expression_times(copy(force), copy(lever)) : NULL;
}

void tinker_contact_add_pair(const TinkerContactTerms *terms, TinkerTermKind kind, TinkerExpression *x,
                             TinkerExpression *y, TinkerExpression *on_tip, TinkerExpression *on_seat)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerPointSymbols *tip = &terms->geometry.tip.point, centre = {.block = tip->block},
                             seat = {.block = terms->geometry.seat.point.block};
    const gboolean on_top = tinker_contact_is_on_top(terms->writer, contact);
    TinkerExpression *back_x = tinker_expression_negated(copy(x)), *back_y = tinker_expression_negated(copy(y));
    tinker_writer_add_term(terms->writer, on_top ? tip : &centre, contact->seat, kind, x, y, on_tip);
    tinker_writer_add_term(terms->writer, &seat, contact->tip, kind, back_x, back_y, on_seat);
}

/* Levers ----------------------------------------------------------------------------------------------------------- */

static TinkerExpression *define_lever(const TinkerContactTerms *terms, const char *stem, const char *means,
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

static void add_levers_of_tip(TinkerContactTerms *terms)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->tip.point;
    TinkerExpression *const *n = geometry->normal;
    TinkerContactLevers *levers = &terms->tip;
    if (geometry->tip.radius != NULL) levers->friction = copy(geometry->tip.radius);
    if (arm->block < 0 || arm->arm_x == NULL || tinker_contact_is_on_top(terms->writer, terms->contact)) return;
    levers->normal = define_lever(terms, "b", "lever of the normal force", arm_across(arm, n));
    TinkerExpression *back = tinker_expression_negated(tinker_expression_times(copy(arm->arm_x), copy(n[0])));
    levers->friction =
        define_lever(terms, "c", "lever of friction",
                     tinker_expression_minus(back, tinker_expression_times(copy(arm->arm_y), copy(n[1]))));
}

static void add_levers_of_seat(TinkerContactTerms *terms)
{
    const TinkerContactGeometry *geometry = &terms->geometry;
    const TinkerPointSymbols *arm = &geometry->seat.point;
    TinkerContactLevers *levers = &terms->seat;
    if (arm->block < 0) return;
    if (geometry->off != NULL) {
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

static void levers_clear(TinkerContactLevers *levers)
{
    g_clear_pointer(&levers->normal, tinker_expression_unref);
    g_clear_pointer(&levers->friction, tinker_expression_unref);
}

void tinker_contact_terms_init(TinkerContactTerms *terms, TinkerEquationWriter *writer,
                               const TinkerContactForce *contact)
{
    *terms = (TinkerContactTerms){.writer = writer, .contact = contact};
    if (contact->is_mean)
        tinker_contact_mean_geometry(writer, contact, &terms->geometry);
    else
        tinker_contact_geometry_init(writer, contact, &terms->geometry);
    add_levers_of_tip(terms);
    add_levers_of_seat(terms);
}

void tinker_contact_terms_clear(TinkerContactTerms *terms)
{
    g_clear_pointer(&terms->normal, tinker_expression_unref);
    levers_clear(&terms->tip);
    levers_clear(&terms->seat);
    tinker_contact_geometry_clear(&terms->geometry);
}
