/* What the extrema of a curve tell of its swings. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include "measure/statistics.h"

/* Sets period, decrement, damping and why there is none. `extrema` of double: time and value in turn; all of their
 * values may be off by `band`. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

#endif
