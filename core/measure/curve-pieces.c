/* Slopes are those of the polynomial through five samples about each. At a blow a curve has a kink: a polynomial across
 * it would swing beyond the samples. There five samples are taken that hold no kink (as ENO schemes do: Harten,
 * Engquist, Osher, Chakravarthy, J. Comput. Phys. 71, 1987); and where it is between two samples, both sides go on to
 * where they meet:
 *
 *     o            o
 *        o      o
 *           o o          the samples
 *            v           where both sides meet
 */
#include "measure/curve-pieces.h"

#include <math.h>
#include <string.h>

#define POINTS     TINKER_CURVE_LEAST
#define ROUGH      0.02 /* fourth difference, of what five samples go through: 14 samples of a swing have less */
#define BISECTIONS 60

/* Newton's divided differences of the five samples from the first on: their polynomial is c0 + (t - t0) (c1 + (t - t1)
 * (c2 + ...)). Not finite where two are at one time. */
static void divide(const TinkerCurveSamples *samples, gsize first, double c[POINTS])
{
    const double *times = samples->times + first;
    memcpy(c, samples->values + first, POINTS * sizeof(double));
    for (gsize order = 1; order < POINTS; order++)
        for (gsize k = POINTS - 1; k >= order; k--)
            c[k] = (c[k] - c[k - 1]) / (times[k] - times[k - order]);
}

/* The polynomial and, where asked for, its slope. */
static double value_at(const TinkerCurveSamples *samples, gsize first, double time, double *slope)
{
    const double *times = samples->times + first;
    double c[POINTS], value, rise = 0;
    divide(samples, first, c);
    value = c[POINTS - 1];
    for (gsize k = POINTS - 1; k-- > 0;) {
        rise = rise * (time - times[k]) + value;
        value = value * (time - times[k]) + c[k];
    }
    if (slope != NULL) *slope = rise;
    return value;
}

static double slope_at(const TinkerCurveSamples *samples, gsize first, double time)
{
    double slope;
    value_at(samples, first, time, &slope);
    return slope;
}

/* The fourth difference of five samples: 0 of a cubic, whatever their distances; infinite where two are at one time. */
static double fourth_difference(const TinkerCurveSamples *samples, gsize first)
{
    const double *times = samples->times + first, step = (times[POINTS - 1] - times[0]) / (POINTS - 1);
    double c[POINTS];
    divide(samples, first, c);
    const double size = fabs(24 * c[POINTS - 1] * step * step * step * step);
    return isfinite(size) ? size : INFINITY;
}

static gboolean is_rough(const TinkerCurveSamples *samples, gsize first)
{
    const double *values = samples->values + first;
    double least = values[0], greatest = values[0];
    for (gsize i = 1; i < POINTS; i++) {
        least = fmin(least, values[i]);
        greatest = fmax(greatest, values[i]);
    }
    return fourth_difference(samples, first) > ROUGH * (greatest - least);
}

static gsize first_of(const TinkerCurveSamples *samples, gsize i, gsize before)
{
    return MIN(i > before ? i - before : 0, samples->count - POINTS);
}

static TinkerCurvePiece piece_of(double start, double end, double y0, double y1, double slope0, double slope1)
{
    const double h = end - start, m0 = h * slope0, m1 = h * slope1;
    return (TinkerCurvePiece){start, h, y0, m0, 3 * (y1 - y0) - 2 * m0 - m1, 2 * (y0 - y1) + m0 + m1};
}

/* Where the polynomials of both sides meet between the samples i and i + 1; FALSE where they do not, as at a jump. */
static gboolean find_kink(const TinkerCurveSamples *samples, gsize i, gsize left, gsize right, double *time)
{
    double low = samples->times[i], high = samples->times[i + 1];
    const double first = value_at(samples, left, low, NULL) - value_at(samples, right, low, NULL);
    if (!(first * (value_at(samples, left, high, NULL) - value_at(samples, right, high, NULL)) < 0)) return FALSE;
    for (int k = 0; k < BISECTIONS; k++) {
        *time = 0.5 * (low + high);
        if ((value_at(samples, left, *time, NULL) - value_at(samples, right, *time, NULL)) * first > 0)
            low = *time;
        else
            high = *time;
    }
    return *time > samples->times[i] && *time < samples->times[i + 1];
}

/* Whether both sides tell how the curve goes on, as far as they meet. */
static gboolean find_sides(const TinkerCurveSamples *samples, gsize i, gsize *left, gsize *right, double *kink)
{
    *left = i + 1 - POINTS;
    *right = i + 1;
    return i + 1 >= POINTS && *right + POINTS <= samples->count && !is_rough(samples, *left) &&
           !is_rough(samples, *right) && find_kink(samples, i, *left, *right, kink);
}

/* The five samples that tell the slopes at both ends; FALSE where they would swing beyond the samples. */
static gboolean find_smooth(const TinkerCurveSamples *samples, gsize i, gsize *first, gsize *second)
{
    *first = first_of(samples, i, 2);
    *second = first_of(samples, i + 1, 2);
    if (!is_rough(samples, *first) && !is_rough(samples, *second)) return TRUE;
    for (gsize back = 0; back <= 3; back++) {
        const gsize tried = first_of(samples, i, back);
        if (fourth_difference(samples, tried) < fourth_difference(samples, *first)) *first = tried;
    }
    *second = *first;
    return !is_rough(samples, *first);
}

guint tinker_curve_pieces(const TinkerCurveSamples *samples, gsize i, TinkerCurvePiece pieces[2])
{
    const double start = samples->times[i], end = samples->times[i + 1], y0 = samples->values[i],
                 y1 = samples->values[i + 1], chord = (y1 - y0) / (end - start);
    gsize left, right;
    double kink;
    if (find_smooth(samples, i, &left, &right)) {
        pieces[0] = piece_of(start, end, y0, y1, slope_at(samples, left, start), slope_at(samples, right, end));
        return 1;
    }
    if (!find_sides(samples, i, &left, &right, &kink)) {
        pieces[0] = piece_of(start, end, y0, y1, chord, chord);
        return 1;
    }
    const double y = value_at(samples, left, kink, NULL);
    pieces[0] = piece_of(start, kink, y0, y, slope_at(samples, left, start), slope_at(samples, left, kink));
    pieces[1] = piece_of(kink, end, y, y1, slope_at(samples, right, kink), slope_at(samples, right, end));
    return 2;
}

double tinker_curve_roughness(const TinkerCurveSamples *samples, gsize i)
{
    gsize left, right;
    double kink;
    if (!find_smooth(samples, i, &left, &right) && !find_sides(samples, i, &left, &right, &kink)) return INFINITY;
    return fmax(fourth_difference(samples, left), fourth_difference(samples, right));
}

double tinker_curve_piece_value(const TinkerCurvePiece *piece, double s)
{
    return piece->a + s * (piece->b + s * (piece->c + s * piece->d));
}

double tinker_curve_piece_end_slope(const TinkerCurvePiece *piece)
{
    return (piece->b + 2 * piece->c + 3 * piece->d) / piece->width;
}

/* 3 d s^2 + 2 c s + b = 0, in the form that loses no digits. */
void tinker_curve_piece_level(const TinkerCurvePiece *piece, double s[2])
{
    const double under = piece->c * piece->c - 3 * piece->d * piece->b;
    s[0] = s[1] = NAN;
    if (under < 0) return;
    const double q = -(piece->c + copysign(sqrt(under), piece->c));
    const double roots[2] = {q != 0 ? piece->b / q : NAN, piece->d != 0 ? q / (3 * piece->d) : NAN};
    const gboolean turned = roots[0] > roots[1];
    s[0] = roots[turned];
    s[1] = roots[!turned];
}
