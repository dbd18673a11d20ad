/* What the extrema of a curve tell of its swings. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include <float.h>

#include "measure/curve-pieces.h"
#include "measure/statistics.h"

#define TINKER_STATISTIC_ROUNDING (4 * DBL_EPSILON) /* of the largest value: of samples and sums */

/* Sets period, decrement, damping and why there is none. `extrema` of double: time and value in turn; all of their
 * values may be off by `band`. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

/* Every second of these samples, the last, and both ends of each jump; they lie in a room that is made. (transfer full)
 */
TinkerCurveSamples tinker_every_second(const TinkerCurveSamples *samples, double **room);

#endif
