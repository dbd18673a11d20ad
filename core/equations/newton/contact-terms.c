/* Contacts: the normal force as the multiplier of the gap, friction as another one where it sticks, as a share of the
 * normal force where it slides; both as numbers where they are means of a step. */
#include "equations/newton/contact-friction.h"
#include "equations/newton/contact-means.h"
#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static void add_normal(TinkerContactTerms *terms)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerContactGeometry *geometry = &terms->geometry;
    TinkerEquationWriter *writer = terms->writer;
    const char *name = tinker_contact_name(writer, contact, "N", NULL);
    TinkerExpression *force = tinker_writer_symbol(writer, name, contact->seat, contact->normal, tinker_force_dimension,
                                                   NULL, "normal force");
    if (contact->is_mean) {
        tinker_contact_note_mean(writer, contact, name);
    } else {
        tinker_writer_add_row(writer, contact->seat, tinker_contact_gap(geometry), tinker_length_dimension, name, TRUE);
        tinker_contact_note_slopes(terms, FALSE);
    }
    tinker_contact_add_pair(terms, TINKER_TERM_NORMAL, tinker_expression_times(copy(force), copy(geometry->normal[0])),
                            tinker_expression_times(copy(force), copy(geometry->normal[1])),
                            tinker_contact_moment_by(force, terms->tip.normal),
                            tinker_contact_moment_by(force, terms->seat.normal));
    terms->normal = force;
}

/* What resists rolling: its value, of which no law is written. */
static void add_moment(const TinkerContactTerms *terms)
{
    const TinkerContactForce *contact = terms->contact;
    const TinkerDimension dimension = TINKER_DIMENSION_ENERGY;
    const char *name = tinker_contact_name(terms->writer, contact, "M", NULL);
    tinker_writer_note_unwritten(terms->writer, contact->tip, name,
                                 "the moment that resists its rolling is a number here");
    TinkerExpression *moment = tinker_writer_symbol(terms->writer, name, contact->seat, contact->moment, dimension,
                                                    NULL, "moment against rolling");
    TinkerExpression *back = tinker_expression_negated(copy(moment));
    tinker_contact_add_pair(terms, TINKER_TERM_FRICTION, tinker_expression_number(0), tinker_expression_number(0),
                            moment, back);
}

static gboolean resists_rolling(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    return tinker_frame_meaning(writer->frame, contact->tip, TINKER_MEANING_ROLLING_RESISTANCE, 0, 0) > 0 ||
           tinker_frame_meaning(writer->frame, contact->seat, TINKER_MEANING_ROLLING_RESISTANCE, 0, 0) > 0;
}

void tinker_writer_add_contact(TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    TinkerContactTerms terms;
    tinker_contact_terms_init(&terms, writer, contact);
    add_normal(&terms);
    tinker_contact_add_friction(&terms);
    if (!contact->is_mean && resists_rolling(writer, contact)) add_moment(&terms);
    tinker_contact_terms_clear(&terms);
}
