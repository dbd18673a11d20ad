/* A contact of two shapes, and what it adds to the equations. */
#ifndef TINKER_CORE_CONTACT_TERMS_H
#define TINKER_CORE_CONTACT_TERMS_H

#include "equations/newton/writer.h"

typedef enum { TINKER_TOUCHES_AS_MASS, TINKER_TOUCHES_AS_DISC, TINKER_TOUCHES_AT_CORNER } TinkerTouchShape;

typedef struct {
    TinkerBlockId tip, seat;        /* of the seat: a support, or another body */
    double normal, friction;        /* N, on what has the tip: from the seat to the tip, and along the seat */
    double moment;                  /* N m: what resists rolling, on what has the tip */
    double at[2];                   /* m: where it touches */
    TinkerTouchShape shape;         /* of the tip */
    const TinkerActingTouch *touch; /* NULL: nothing is known but that the seat is the top of a support */
    const char *index;              /* of its symbols; NULL: that of the seat's block */
    gboolean is_mean;               /* of a step, as impulses have it, and then ... */
    double direction[2];            /* ... n, across what touches, and ... */
    double at_seat[2];              /* m: ... where it touches the seat's body */
} TinkerContactForce;

/* Whether the seat is the top of a support, whose size says where it is. */
gboolean tinker_contact_is_on_top(const TinkerEquationWriter *writer, const TinkerContactForce *contact);

/* Adds its rows and terms. */
void tinker_writer_add_contact(TinkerEquationWriter *writer, const TinkerContactForce *contact);

#endif
