/* What the files of the statistics share: the cubic pieces that are taken for the curve, and what its extrema tell. */
#ifndef TINKER_CORE_STATISTICS_PRIVATE_H
#define TINKER_CORE_STATISTICS_PRIVATE_H

#include "measure/statistics.h"

typedef struct {
    const double *times, *values;
    gsize count; /* five at least */
} TinkerCurveSamples;

/* With s = (t - start) / width: y = a + b s + c s^2 + d s^3. */
typedef struct {
    double start, width;
    double a, b, c, d;
} TinkerCurvePiece;

/* The curve from sample i to the next, whose times differ: one piece, or two that meet at a kink. Answers how many. */
guint tinker_curve_pieces(const TinkerCurveSamples *samples, gsize i, TinkerCurvePiece pieces[2]);
double tinker_curve_piece_value(const TinkerCurvePiece *piece, double s);
/* dy/dt at its end. */
double tinker_curve_piece_end_slope(const TinkerCurvePiece *piece);

/* Sets period, decrement, damping and why there is none. `extrema` of double: time and value in turn; all of their
 * values may be off by `band`. */
void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result);

#endif
