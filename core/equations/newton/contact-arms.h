/* The two blocks that touch, and the places of each where they do. */
#ifndef TINKER_CORE_CONTACT_ARMS_H
#define TINKER_CORE_CONTACT_ARMS_H

#include "equations/newton/contact-terms.h"

/* One of the two; expressions are owned. */
typedef struct {
    TinkerPointSymbols point; /* its centre, with the arm to a corner that turns with it */
    TinkerExpression *radius; /* of a disc; else NULL */
} TinkerContactSide;

void tinker_contact_side_clear(TinkerContactSide *side);

/* A name for a symbol of a contact. Borrowed from the equations. */
const char *tinker_contact_name(TinkerEquationWriter *writer, const TinkerContactForce *contact, const char *stem,
                                const char *component);

/* How exact a place is where they touch (m). */
double tinker_contact_rounding(const TinkerEquationWriter *writer, const TinkerContactForce *contact);

/* The names of an arm and of its parts in the axes of the block. */
typedef struct {
    TinkerBlockId of; /* the block */
    const char *local, *arm;
} TinkerContactArmNames;

/* The arm to a place of a block, `own` in its own axes; nothing at its centre. */
void tinker_contact_add_arm(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactSide *side,
                            const TinkerContactArmNames *names, const double own[2]);

/* A place in the axes of a shape, in those of its block: a mass has no angle, and its shape one that stays. */
void tinker_contact_in_block_axes(const TinkerContactSide *side, double angle, const double place[2], double own[2]);

#endif
