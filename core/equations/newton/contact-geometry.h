/* Where two shapes touch, in expressions: what has the tip (a corner, or the centre of a disc), and the seat that it is
 * on, an edge or a round (physics/shapes/gaps.h). */
#ifndef TINKER_CORE_CONTACT_GEOMETRY_H
#define TINKER_CORE_CONTACT_GEOMETRY_H

#include "equations/newton/contact-arms.h"

typedef struct {
    TinkerContactSide tip, seat;
    TinkerExpression
        *normal[2];             /* unit vector, from the seat to the tip; the seat runs along (normal[1], -normal[0]) */
    TinkerExpression *dx, *dy;  /* to the tip, from the centre of what has the seat; of a round, from that; of what
    touches as impulses have it, NULL as the next two */
    TinkerExpression *off;      /* of an edge: how far it is from that centre; else NULL, and then */
    TinkerExpression *distance; /* from the round to the tip */
} TinkerContactGeometry;

void tinker_contact_geometry_init(TinkerEquationWriter *writer, const TinkerContactForce *contact,
                                  TinkerContactGeometry *geometry);
void tinker_contact_geometry_clear(TinkerContactGeometry *geometry);

/* The gap: 0 where they touch. (transfer full) */
TinkerExpression *tinker_contact_gap(const TinkerContactGeometry *geometry);

/* The place of the tip along an edge, from the foot of the seat's centre. (transfer full) */
TinkerExpression *tinker_contact_along(const TinkerContactGeometry *geometry);

/* What stays constant of a contact that sticks: the place along the edge, or how far it has rolled. NULL: a corner on a
 * corner has neither. (transfer full) */
TinkerExpression *tinker_contact_rolled(const TinkerContactGeometry *geometry);

#endif
