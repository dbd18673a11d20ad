/* What the extrema of a curve tell of its swings, and what its samples leave open. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include <float.h>
#include <math.h>

#include "measure/curve-pieces.h"
#include "measure/statistics.h"

#define TINKER_STATISTIC_ROUNDING (4 * DBL_EPSILON) /* of the largest value: of samples and sums */

/* A place where the curve turns back, and how far the samples may have it off. */
typedef struct {
    double time, value;         /* s, y */
    double off_time, off_value; /* s, y */
} TinkerExtremum;

/* From extremum i to the next one. */
static inline double tinker_extremum_way(const GArray *extrema, guint i)
{
    return fabs(g_array_index(extrema, TinkerExtremum, i + 1).value - g_array_index(extrema, TinkerExtremum, i).value);
}

/* What is found on the way along a curve. */
typedef struct {
    double mean, square;    /* integrals of y and y^2 over the time */
    double off, off_square; /* of what y may be off by, and of what y^2 may be off by */
    double least, greatest; /* of y */
    double below, above;    /* of y with what it may be off by */
    GArray *extrema;        /* of TinkerExtremum, without ripple */
} TinkerCurveSums;

/* From one time to another. `off` (borrowed): how far the curve may be off between each sample and the
 * next, as tinker_between_samples tells. Swings at both ends that are hardly larger than `band` are left out of the
 * extrema. tinker_curve_sums_clear frees them. */
TinkerCurveSums tinker_curve_sums(const TinkerCurveSamples *samples, const double *off, double from, double to,
                                  double band);
void tinker_curve_sums_clear(TinkerCurveSums *sums);

/* Sets period, decrement, damping and why there is none. The values of all extrema may be off by `band`, beside what
 * the samples leave open. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

/* Every second of these samples, from the first or from the second on, with the first, the last, and both ends of each
 * jump: without one of them it would lean. They lie in a room that is made. (transfer full) */
TinkerCurveSamples tinker_every_second(const TinkerCurveSamples *samples, gboolean from_second, double **room);

/* How far the curve may be off between each sample and the next: what the curve through every second sample misses the
 * others by thereabouts. (transfer full) */
double *tinker_between_samples(const TinkerCurveSamples *samples);

/* Whether too little is known between the samples i and i + 1: from one event, or an end of the curve, to the next
 * there are fewer samples than a cubic takes. */
gboolean tinker_is_between_events(const TinkerCurveSamples *samples, gsize i);
/* The least and the greatest y'' that three samples in a row tell, with no event between them: not above 0, and not
 * below. */
void tinker_bends(const TinkerCurveSamples *samples, double bends[2]);

#endif
