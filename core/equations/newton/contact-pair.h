/* What the force of a contact along a direction does to the two bodies that touch: the same to one as, backward, to the
 * other, with moments by levers. */
#ifndef TINKER_CORE_CONTACT_PAIR_H
#define TINKER_CORE_CONTACT_PAIR_H

#include "equations/newton/contact-geometry.h"

/* Moments of the normal force and of friction on a body by their levers (m); NULL: there is none. Owned. */
typedef struct {
    TinkerExpression *normal, *friction;
} TinkerContactLevers;

typedef struct {
    TinkerEquationWriter *writer;
    const TinkerContactForce *contact;
    TinkerContactGeometry geometry;
    TinkerExpression *normal;      /* N: the symbol of the normal force; owned */
    TinkerContactLevers tip, seat; /* on a top the force at the arm says what it does to the tip's body */
} TinkerContactTerms;

/* Its geometry and levers; the normal force is set by who has it. */
void tinker_contact_terms_init(TinkerContactTerms *terms, TinkerEquationWriter *writer,
                               const TinkerContactForce *contact);
void tinker_contact_terms_clear(TinkerContactTerms *terms);

/* What an expression (NULL: 0) is worth. */
double tinker_contact_value(const TinkerContactTerms *terms, const TinkerExpression *expression);

/* What the row that was added last does to both: along n, or along t. */
void tinker_contact_note_slopes(const TinkerContactTerms *terms, gboolean is_along);

/* The moment of a force by a lever; NULL: there is none. (transfer full) */
TinkerExpression *tinker_contact_moment_by(const TinkerExpression *force, const TinkerExpression *lever);

/* A force on what has the tip, and the opposite on what has the seat, with the moments (NULL: none) that they have by
 * their levers. All are taken over. */
void tinker_contact_add_pair(const TinkerContactTerms *terms, TinkerTermKind kind, TinkerExpression *x,
                             TinkerExpression *y, TinkerExpression *on_tip, TinkerExpression *on_seat);

#endif
