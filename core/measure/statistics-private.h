/* What the extrema of a curve tell of its swings. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include <float.h>

#include "measure/statistics.h"

#define TINKER_STATISTIC_ROUNDING (4 * DBL_EPSILON) /* of the largest value: of samples and sums */

/* Sets period, decrement, damping and why there is none. `extrema` of double: time and value in turn; all of their
 * values may be off by `band`. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

/* Every second of so many samples, and the last: count / 2 + 1 of them. (transfer full) */
double *tinker_every_second(const double *values, gsize count);

#endif
