/* A contact of a body with the top of a support, and what it adds to the equations. */
#ifndef TINKER_CORE_CONTACT_TERMS_H
#define TINKER_CORE_CONTACT_TERMS_H

#include "equations/newton/writer.h"

typedef enum { TINKER_TOUCHES_AS_MASS, TINKER_TOUCHES_AS_DISC, TINKER_TOUCHES_AT_CORNER } TinkerTouchShape;

typedef struct {
    TinkerBlockId support, body;
    double normal, friction; /* N: across the top, along it */
    double moment;           /* N m: what resists rolling */
    double at[2];            /* m: where it touches */
    TinkerTouchShape shape;
    const char *index; /* of its symbols; NULL: that of the support */
} TinkerTopContact;

/* Adds its rows and terms. */
void tinker_writer_add_top_contact(TinkerEquationWriter *writer, const TinkerTopContact *contact);

#endif
