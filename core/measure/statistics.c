/* On each piece, with s = (t - t0) / h: y = a + b s + c s^2 + d s^3. Its extrema are the roots of a quadratic; the mean
 * is integrated exactly, the square by four nodes of Gauss, which are exact to degree 7. */
#include "measure/statistics.h"

#include <math.h>
#include <string.h>

#define LEAST_SAMPLES 5
/* Of the whole range: smaller ways between two extrema are ripple of rounding. */
#define RIPPLE 1e-9
/* Of what the curve may be off by: smaller ways at both ends, as of a swing that has died away, tell nothing. */
#define CERTAIN 10.0

typedef struct {
    const double *times, *values;
    gsize count;
} Samples;

static double time_at(const Samples *samples, gsize i)
{
    return samples->times[i];
}

static double value_at(const Samples *samples, gsize i)
{
    return samples->values[i];
}

/* The slope at sample i of the polynomial through five samples about it. */
static double slope_at(const Samples *samples, gsize i)
{
    const gsize first = MIN(i > 2 ? i - 2 : 0, samples->count - 5), at = i - first;
    double sum = 0, own = 0;
    for (gsize j = 0; j < 5; j++) {
        if (j == at) continue;
        double weight = 1 / (time_at(samples, first + j) - time_at(samples, first + at));
        own -= weight;
        for (gsize k = 0; k < 5; k++)
            if (k != j && k != at)
                weight *= (time_at(samples, first + at) - time_at(samples, first + k)) /
                          (time_at(samples, first + j) - time_at(samples, first + k));
        sum += weight * value_at(samples, first + j);
    }
    return sum + own * value_at(samples, i);
}

typedef struct {
    double start, width;
    double a, b, c, d;
} Piece;

static Piece piece_at(const Samples *samples, gsize i)
{
    const double h = time_at(samples, i + 1) - time_at(samples, i), y0 = value_at(samples, i),
                 y1 = value_at(samples, i + 1), m0 = h * slope_at(samples, i), m1 = h * slope_at(samples, i + 1);
    return (Piece){time_at(samples, i), h, y0, m0, 3 * (y1 - y0) - 2 * m0 - m1, 2 * (y0 - y1) + m0 + m1};
}

static double piece_value(const Piece *piece, double s)
{
    return piece->a + s * (piece->b + s * (piece->c + s * piece->d));
}

/* What is found on the way through the pieces. */
typedef struct {
    double mean, square, least, greatest;
    GArray *extrema; /* of double: time and value in turn */
} Sums;

static void note(Sums *sums, double value)
{
    sums->least = fmin(sums->least, value);
    sums->greatest = fmax(sums->greatest, value);
}

static void add_piece(Sums *sums, const Piece *piece, double from, double to)
{
    static const double nodes[2] = {0.33998104358485626480, 0.86113631159405257522};
    static const double weights[2] = {0.65214515486254614263, 0.34785484513745385737};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (int k = 0; k < 4; k++) {
        const double y = piece_value(piece, middle + (k % 2 ? half : -half) * nodes[k / 2]);
        sums->mean += piece->width * half * weights[k / 2] * y;
        sums->square += piece->width * half * weights[k / 2] * y * y;
    }
    note(sums, piece_value(piece, from));
    note(sums, piece_value(piece, to));
    /* 3 d s^2 + 2 c s + b = 0, in the form that loses no digits */
    const double under = piece->c * piece->c - 3 * piece->d * piece->b;
    if (under < 0) return;
    const double q = -(piece->c + copysign(sqrt(under), piece->c));
    double roots[2] = {q != 0 ? piece->b / q : NAN, piece->d != 0 ? q / (3 * piece->d) : NAN};
    if (roots[0] > roots[1]) {
        const double later = roots[0];
        roots[0] = roots[1];
        roots[1] = later;
    }
    for (int k = 0; k < 2; k++) {
        if (!(roots[k] > from && roots[k] <= to)) continue;
        const double extremum[2] = {piece->start + roots[k] * piece->width, piece_value(piece, roots[k])};
        note(sums, extremum[1]);
        g_array_append_vals(sums->extrema, extremum, 2);
    }
}

/* Extrema that are no ripple: a way back that is too small takes both its ends away. */
static void drop_ripple(Sums *sums)
{
    const double least = RIPPLE * (sums->greatest - sums->least);
    double *all = (double *)(gpointer)sums->extrema->data;
    guint kept = 0;
    for (guint i = 0; i + 1 < sums->extrema->len; i += 2) {
        if (kept >= 2 && fabs(all[i + 1] - all[kept - 1]) <= least) {
            kept -= 2;
            continue;
        }
        all[kept++] = all[i];
        all[kept++] = all[i + 1];
    }
    g_array_set_size(sums->extrema, kept);
}

/* Of both ends, as far as ways are not certain; each goes with the extremum at its outer end. */
static void drop_uncertain_ends(Sums *sums, double band)
{
    const double least = CERTAIN * band;
    GArray *extrema = sums->extrema;
    while (extrema->len >= 4 && fabs(g_array_index(extrema, double, extrema->len - 1) -
                                     g_array_index(extrema, double, extrema->len - 3)) < least)
        g_array_set_size(extrema, extrema->len - 2);
    guint first = 0;
    while (first + 3 < extrema->len &&
           fabs(g_array_index(extrema, double, first + 3) - g_array_index(extrema, double, first + 1)) < least)
        first += 2;
    if (first > 0) g_array_remove_range(extrema, 0, first);
}

static TinkerStatistic half_period(const GArray *extrema)
{
    const guint spans = extrema->len / 2 - 1;
    const double *all = (const double *)(gconstpointer)extrema->data;
    const double mean = (all[2 * spans] - all[0]) / spans;
    double squares = 0;
    for (guint i = 0; i < spans; i++)
        squares += pow(all[2 * i + 2] - all[2 * i] - mean, 2);
    return (TinkerStatistic){mean, spans > 1 ? sqrt(squares / (spans - 1) / spans) : 0};
}

/* How the logarithm of the way to the next extremum falls from one to the next: a line through them. */
static TinkerStatistic half_decrement(const GArray *extrema)
{
    const guint ways = extrema->len / 2 - 1;
    const double *all = (const double *)(gconstpointer)extrema->data;
    double mean = 0, slope = 0, weight = 0, squares = 0;
    if (ways < 2) return (TinkerStatistic){NAN, NAN};
    for (guint i = 0; i < ways; i++)
        mean += log(fabs(all[2 * i + 3] - all[2 * i + 1])) / ways;
    for (guint i = 0; i < ways; i++) {
        const double x = i - 0.5 * (ways - 1);
        slope += x * (log(fabs(all[2 * i + 3] - all[2 * i + 1])) - mean);
        weight += x * x;
    }
    slope /= weight;
    for (guint i = 0; i < ways; i++)
        squares += pow(log(fabs(all[2 * i + 3] - all[2 * i + 1])) - mean - slope * (i - 0.5 * (ways - 1)), 2);
    return (TinkerStatistic){-slope, ways > 2 ? sqrt(squares / (ways - 2) / weight) : 0};
}

/* A swing of amplitude A and frequency w that is off by a swing of amplitude e has its extrema off by e / (w A) in
 * time: those at both ends make the mean of all half periods wrong. A way is 2 A, and half a period is pi / w. */
static double half_period_band(const GArray *extrema, double half, double band)
{
    const guint spans = extrema->len / 2 - 1;
    const double *all = (const double *)(gconstpointer)extrema->data;
    const double first = fabs(all[3] - all[1]), last = fabs(all[2 * spans + 1] - all[2 * spans - 1]);
    return 2 * band * half / G_PI * (1 / first + 1 / last) / spans;
}

/* Both ends of a way may be off, and the slope of the line through the logarithms is a sum of them with weights. */
static double half_decrement_band(const GArray *extrema, double band)
{
    const guint ways = extrema->len / 2 - 1;
    const double *all = (const double *)(gconstpointer)extrema->data;
    double sum = 0, weight = 0;
    for (guint i = 0; i < ways; i++) {
        const double x = i - 0.5 * (ways - 1);
        sum += fabs(x) * 2 * band / fabs(all[2 * i + 3] - all[2 * i + 1]);
        weight += x * x;
    }
    return sum / weight;
}

static void find_oscillation(const Sums *sums, double band, TinkerStatistics *result)
{
    const TinkerStatistic none = {NAN, NAN};
    result->period = result->decrement = result->damping = none;
    if (sums->extrema->len < 6) return;
    TinkerStatistic half = half_period(sums->extrema), fall = half_decrement(sums->extrema);
    half.error += half_period_band(sums->extrema, half.value, band);
    fall.error += half_decrement_band(sums->extrema, band);
    const double d = 2 * fall.value, whole = 4 * G_PI * G_PI + d * d;
    result->period = (TinkerStatistic){2 * half.value, 2 * half.error};
    result->decrement = (TinkerStatistic){d, 2 * fall.error};
    result->damping = (TinkerStatistic){d / sqrt(whole), 2 * fall.error * 4 * G_PI * G_PI / pow(whole, 1.5)};
}

static TinkerStatistics measure(const Samples *samples, double from, double to, double band)
{
    Sums sums = {0, 0, INFINITY, -INFINITY, g_array_new(FALSE, FALSE, sizeof(double))};
    for (gsize i = 0; i + 1 < samples->count; i++) {
        const double start = time_at(samples, i), end = time_at(samples, i + 1);
        if (end <= from || start >= to || !(end > start)) continue;
        const Piece piece = piece_at(samples, i);
        add_piece(&sums, &piece, fmax(0, (from - start) / piece.width), fmin(1, (to - start) / piece.width));
    }
    drop_ripple(&sums);
    drop_uncertain_ends(&sums, band);
    TinkerStatistics result = {.mean = {sums.mean / (to - from), band},
                               .rms = {sqrt(sums.square / (to - from)), band},
                               .least = {sums.least, band},
                               .greatest = {sums.greatest, band},
                               .amplitude = {0.5 * (sums.greatest - sums.least), band}};
    find_oscillation(&sums, band, &result);
    g_array_unref(sums.extrema);
    return result;
}

/* Every second sample, and the last. (transfer full) */
static double *thin(const double *values, gsize count)
{
    double *half = g_new(double, count / 2 + 1);
    for (gsize i = 0; 2 * i < count; i++)
        half[i] = values[2 * i];
    half[count / 2] = values[count - 1];
    return half;
}

gboolean tinker_statistics(const double *times, const double *values, gsize count, double from, double to, double band,
                           TinkerStatistics *statistics)
{
    if (count / 2 + 1 < LEAST_SAMPLES || !(to > from)) return FALSE;
    g_autofree double *half_times = thin(times, count), *half_values = thin(values, count);
    const Samples fine = {times, values, count}, coarse = {half_times, half_values, count / 2 + 1};
    *statistics = measure(&fine, from, to, band);
    const TinkerStatistics rough = measure(&coarse, from, to, band);
    TinkerStatistic *all[] = {&statistics->mean,      &statistics->rms,       &statistics->least,
                              &statistics->greatest,  &statistics->amplitude, &statistics->period,
                              &statistics->decrement, &statistics->damping};
    const TinkerStatistic *others[] = {&rough.mean,      &rough.rms,    &rough.least,     &rough.greatest,
                                       &rough.amplitude, &rough.period, &rough.decrement, &rough.damping};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        all[i]->error += fabs(all[i]->value - others[i]->value);
    return TRUE;
}
