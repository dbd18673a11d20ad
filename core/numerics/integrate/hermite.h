/* Dense output by Hermite interpolation, for methods that have no polynomial of their own.
 *
 * q is the quintic through q, v, a at both ends of the step, v the cubic through v, a, the books the cubic through w
 * and power: errors of h^6, h^4 and h^4 beside those of the end values. The accelerations are worked out when somebody
 * asks, on copies of the ends, so that recording changes no step.
 */
#ifndef TINKER_NUMERICS_HERMITE_H
#define TINKER_NUMERICS_HERMITE_H

#include <tinker/integrator.h>

/* One end of a step; all arrays lie in the stepper's memory. */
typedef struct TinkerHermiteEnd {
    double t;
    double *q, *v, *a;
    double *books, *power;
    int values_known; /* q, v, books */
    int slopes_known; /* a, power */
} TinkerHermiteEnd;

typedef struct TinkerHermite {
    const TinkerSystem *system;
    TinkerHermiteEnd from, to;
} TinkerHermite;

/* How many doubles of memory an interpolation of n coordinates and m books needs. */
size_t tinker_hermite_doubles(int32_t n, int32_t m);

/* Cuts the arrays off the memory at *next; nothing is known yet. */
void tinker_hermite_init(TinkerHermite *hermite, const TinkerSystem *system, double **next);

/* Forgets the last step. */
void tinker_hermite_forget(TinkerHermite *hermite);

/* Keeps `state` as the start of a new step. Where it is the last step's end to the last bit, what was worked out for
 * that end is taken over. */
void tinker_hermite_start(TinkerHermite *hermite, const TinkerState *state);

/* Keeps `state` as the end of the step. */
void tinker_hermite_finish(TinkerHermite *hermite, const TinkerState *state);

/* Puts the start of the step back into `state`: a step that failed leaves no trace. */
void tinker_hermite_restore(const TinkerHermite *hermite, TinkerState *state);

/* The state at t; `books` may be NULL. TINKER_FAILED where no step was made or an end cannot be evaluated. */
TinkerStatus tinker_hermite_interpolate(TinkerHermite *hermite, double t, double *q, double *v, double *books);

/* The place at t and its rate: the quintic and its derivative, whose error is h^5. Answers as the function above. */
TinkerStatus tinker_hermite_place_and_rate(TinkerHermite *hermite, double t, double *q, double *rate);

#endif
