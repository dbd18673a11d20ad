/* How contacts of one group of bodies answer to pushes, as the laws of contact ask for it (TinkerContactMotion in
 * numerics/contact/contact-laws.h): each push is one solve of the constraint rows, and what contacts of known states
 * push with is one of the same rows without the contacts' mobility (contact-elimination.h). So the laws cost in
 * proportion to bodies and contacts, where the Delassus matrix of m contacts has 4 m^2 entries, each column a solve.
 *
 * Few contacts are solved by their matrix, by every means that there are for such (contact-solve.c):
 * TINKER_FEW_CONTACTS. */
#ifndef TINKER_CORE_CONTACT_REACH_H
#define TINKER_CORE_CONTACT_REACH_H

#include "physics/contact/contacts.h"

/* Up to here it takes about as long either way (bench-contact-chains). */
#define TINKER_FEW_CONTACTS 8

typedef struct {
    TinkerContactMotion motion;
    /* private */
    TinkerContacts *contacts;
    TinkerContactElimination *elimination;
    int32_t count, unknown;
    gsize room;
    TinkerContactEquation *all;       /* 2m: normal and tangential directions, */
    int32_t *order;                   /* m: contacts by body */
    TinkerContactEquation *equations; /* those of a solve, */
    int32_t *entry;                   /* and where they stand among the 2m */
    double *mass, *b, *x;             /* m; 2m */
} TinkerContactReach;

/* Takes contacts, all of one group of bodies that constraints hold, whatever their modes. FALSE: no memory. Where there
 * are too many at one body a matrix has to do: then `motion.context` is NULL. To be cleared in the end; may take others
 * before. */
gboolean tinker_contact_reach_take(TinkerContactReach *reach, TinkerContacts *contacts, const TinkerContact *touching,
                                   int32_t count);
void tinker_contact_reach_clear(TinkerContactReach *reach);

#endif
