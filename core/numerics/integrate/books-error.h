/* What a trial of an embedded method is off by in its books. What is held at rest moves nothing that tells of a damper
 * that works on it: the error of the motion alone would let one step pass over all of that. */
#ifndef TINKER_NUMERICS_BOOKS_ERROR_H
#define TINKER_NUMERICS_BOOKS_ERROR_H

#include <glib.h>

#include "numerics/integrate/explicit-rk.h"

/* J: the largest of what was held or exchanged before, what the motion holds and what the books have taken. */
double tinker_books_energy(const TinkerSystem *system, const double *v, const double *books, double before);

/* A trial whose motion may be accepted. */
typedef struct TinkerBooksTrial {
    const TinkerTableau *tableau;
    double *const *power; /* of every stage */
    double h;
    const double *v0;    /* where it begins */
    const double *q, *v; /* where it ends */
    double tolerance;
} TinkerBooksTrial;

/* Whether nothing moves in it by more than places may be off by. */
gboolean tinker_books_trial_stands(const TinkerSystem *system, const TinkerBooksTrial *trial);

/* The error of the books' integrals over a trial, relative to what one step may be off by in them: a share of the
 * largest energy so far, to which is added what the trial exchanges, and what would set the system going no faster than
 * its places may be off by. */
double tinker_books_error(const TinkerSystem *system, const TinkerBooksTrial *trial, double *energy);

#endif
