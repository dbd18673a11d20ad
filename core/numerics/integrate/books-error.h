/* What a trial of an embedded method is off by in its books. What is held at rest, or moves evenly, has no motion that
 * tells of a damper that works on it: the error of the motion alone would let one step pass over all of that. */
#ifndef TINKER_NUMERICS_BOOKS_ERROR_H
#define TINKER_NUMERICS_BOOKS_ERROR_H

#include "numerics/integrate/explicit-rk.h"

/* A trial whose motion may be accepted. */
typedef struct TinkerBooksTrial {
    const TinkerTableau *tableau;
    double *const *a;     /* of every stage */
    double *const *power; /* of every stage */
    double h;
    const double *books0; /* where it begins */
    const double *q, *v;  /* where it ends */
    double tolerance;
} TinkerBooksTrial;

/* The error of the books' integrals over a trial in which velocities hardly change, relative to what one step may be
 * off by in them: a share of what was and is exchanged and of the kinetic energy, and what would set the system going
 * so slowly that its places are known as well without. 0 where velocities change by more, as the error of the motion
 * tells of the powers, too. */
double tinker_books_error(const TinkerSystem *system, const TinkerBooksTrial *trial);

#endif
