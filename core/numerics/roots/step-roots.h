/* Where in a step a function falls below zero: from its values at a few nodes, all roots are found, not only changes of
 * sign between the ends.
 *
 * The values at Chebyshev-Lobatto nodes give the polynomial through them; its Bernstein coefficients enclose it, so
 * that where all are positive there is no root; else it is halved (de Casteljau) until every root is isolated. Source:
 * Farouki, "The Bernstein polynomial basis: a centennial retrospective", CAGD 29 (2012). Times are shares of the step:
 * 0 its start, 1 its end. */
#ifndef TINKER_NUMERICS_STEP_ROOTS_H
#define TINKER_NUMERICS_STEP_ROOTS_H

#include <stdint.h>

#define TINKER_MOST_DEGREE 10

/* The degree + 1 nodes, ascending, from 0 to 1. */
void tinker_step_nodes(int32_t degree, double *nodes);

/* A bound, cheap and from below, of the least value that the polynomial through these values takes on [0, 1]; cheapest
 * and loosest where it is above 0. -HUGE_VAL where a value is no number. */
double tinker_step_least(int32_t degree, const double *values);

/* The like of the least value on [0, place], place at most 1; dearer, and tighter. */
double tinker_step_least_before(int32_t degree, const double *values, double place);

/* All places in [0, 1] where the polynomial through the values passes from above `level` to below it, ascending; at
 * most `room` of them, and their number is answered. A place where it only touches the level and turns is none; one
 * where it dips below and comes back is, however narrow the dip is, down to rounding (a share of 1e-14 of the largest
 * value) in depth. A polynomial that is below at 0 does not pass there; one that is at the level there and falls passes
 * at 0; one that falls to the level at 1 passes only if its last value is below. So of two steps that share a value,
 * one has the fall. Values that are no numbers have none. */
int32_t tinker_step_falls(int32_t degree, const double *values, double level, double *places, int32_t room);

/* The place in [from, to] where f falls through 0, with f(from) > 0 >= f(to) or nearly so: bracketed by inverse
 * parabolas with safeguards (Chandrupatla), to the last bits of the place. `f` is asked at most 100 times. */
double tinker_step_refine(double from, double to, double (*f)(void *data, double place), void *data);

#endif
