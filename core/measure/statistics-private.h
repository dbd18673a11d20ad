/* What the extrema of a curve tell of its swings, and what its samples leave open. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include <float.h>

#include "measure/curve-pieces.h"
#include "measure/statistics.h"

#define TINKER_STATISTIC_ROUNDING (4 * DBL_EPSILON) /* of the largest value: of samples and sums */

/* Sets period, decrement, damping and why there is none. `extrema` of double: time and value in turn; all of their
 * values may be off by `band`. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

/* Every second of these samples, the last, and both ends of each jump: without one of them it would lean. They lie in a
 * room that is made. (transfer full) */
TinkerCurveSamples tinker_every_second(const TinkerCurveSamples *samples, double **room);

/* Whether nothing is known between the samples i and i + 1, which are of two events, or of one and an end of the curve:
 * every second sample tells the same there. */
gboolean tinker_is_between_events(const TinkerCurveSamples *samples, gsize i);
/* The least and the greatest y'' that three samples in a row tell, with no event between them: not above 0, and not
 * below. */
void tinker_bends(const TinkerCurveSamples *samples, double bends[2]);

#endif
