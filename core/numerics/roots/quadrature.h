/* Integrals over time, of functions that may have kinks. */
#ifndef TINKER_CORE_QUADRATURE_H
#define TINKER_CORE_QUADRATURE_H

#include <tinker/types.h>

/* `count` values at t. */
typedef TinkerStatus (*TinkerIntegrandFunc)(double t, double *values, void *data);

/* A time inside the interval at which some function has a kink; NAN where there is none. */
typedef double (*TinkerKinkFunc)(double from, double to, void *data);

/* Adds to `sums` the integrals of `count` functions from `from` to `to`, each to about `tolerance` of its absolute sum,
 * or of what `noise` would add up to: a value so large is rounding. By the rules of Gauss (7 nodes) and Kronrod (15),
 * halving where they disagree, a thousand times at most. No function is evaluated at an end of the interval. A kink so
 * near to an end that no node sees it is looked for by `kink`. `room` has 3 * count entries. */
TinkerStatus tinker_integrate(TinkerIntegrandFunc function, TinkerKinkFunc kink, void *data, int32_t count, double from,
                              double to, double tolerance, double noise, double *sums, double *room);

#endif
