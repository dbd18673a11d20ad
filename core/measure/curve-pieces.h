/* The curve through samples, piece by piece a cubic whose slopes are those through five samples; with kinks, as a blow
 * makes them, where both sides meet. */
#ifndef TINKER_CORE_CURVE_PIECES_H
#define TINKER_CORE_CURVE_PIECES_H

#include <glib.h>

#define TINKER_CURVE_LEAST 5 /* samples */

typedef struct {
    const double *times, *values;
    gsize count; /* TINKER_CURVE_LEAST at least */
} TinkerCurveSamples;

/* With s = (t - start) / width: y = a + b s + c s^2 + d s^3. */
typedef struct {
    double start, width;
    double a, b, c, d;
} TinkerCurvePiece;

/* The curve from sample i to the next, whose times differ: one piece, or two that meet at a kink. Answers how many. */
guint tinker_curve_pieces(const TinkerCurveSamples *samples, gsize i, TinkerCurvePiece pieces[2]);
/* The fourth difference of the samples that the curve there is made of, the larger one of both ends: of a cubic it is
 * 0. Infinite where it goes straight from sample to sample. */
double tinker_curve_roughness(const TinkerCurveSamples *samples, gsize i);
double tinker_curve_piece_value(const TinkerCurvePiece *piece, double s);
/* dy/dt at its end. */
double tinker_curve_piece_end_slope(const TinkerCurvePiece *piece);
/* The places s, anywhere, at which its slope is 0, in order; NAN for one that is not there. */
void tinker_curve_piece_level(const TinkerCurvePiece *piece, double s[2]);

#endif
