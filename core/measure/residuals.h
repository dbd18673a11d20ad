/* How well a curve fits values that were measured: the differences at their own times. */
#ifndef TINKER_CORE_RESIDUALS_H
#define TINKER_CORE_RESIDUALS_H

#include "measure/curve-pieces.h"
#include "measure/statistics.h"

/* The root mean square of what the measured values (at rising times) differ by from the curve through the samples, at
 * those of their times that lie from `from` to `to` and within the samples; `count` says how many. Its error is what
 * the curve may be off by between samples, what it may be off by between two events with fewer than three samples
 * between them (statistics.h), and the `band` that all of it may be off by: by the triangle inequality they bound it.
 * FALSE where no time lies within, or there are too few samples, as in statistics.h. */
gboolean tinker_residuals(const TinkerCurveSamples *curve, const TinkerCurveSamples *measured, double from, double to,
                          double band, TinkerStatistic *rms, gsize *count);

#endif
