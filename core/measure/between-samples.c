/* How far the curve may be off between two samples is asked of the samples themselves: the curve through every second
 * one is drawn, and misses those that were left out by a distance that is seen. Of a smooth curve that is sixteen times
 * what the curve through all of them is off by; where they are too few for what happens, as few in a swing, both are
 * off by as much. So that distance is taken as it is. At one sample it may be 0 by chance: the largest of those about
 * counts.
 *
 * Where the samples are smooth another bound is less, and holds beside a kink, too, which every second sample may tell
 * only badly. Between samples of distance h a cubic is off by y'''' h^4 / 384, and h^4 y'''' is the fourth difference
 * of five samples: it is taken 24 times as large, as y'''' may differ beside them, and slopes may be off. */
#include <math.h>

#include "measure/statistics-private.h"

#define ABOUT  2 /* samples to each side */
#define SMOOTH (24 / 384.0)

static double value_of(const TinkerCurvePiece *pieces, guint count, double time)
{
    const TinkerCurvePiece *piece = &pieces[count == 2 && time >= pieces[1].start];
    return tinker_curve_piece_value(piece, (time - piece->start) / piece->width);
}

/* Sets what the curve through the coarse samples misses each of the others by. */
static void miss(const TinkerCurveSamples *samples, const TinkerCurveSamples *coarse, double *missed)
{
    gsize i = 0;
    for (gsize k = 0; k + 1 < coarse->count; k++) {
        TinkerCurvePiece pieces[2];
        guint count = 0;
        for (; i < samples->count && samples->times[i] < coarse->times[k + 1]; i++) {
            if (!(samples->times[i] > coarse->times[k])) continue;
            if (count == 0) count = tinker_curve_pieces(coarse, k, pieces);
            missed[i] = fabs(samples->values[i] - value_of(pieces, count, samples->times[i]));
        }
    }
}

/* Of the sample i and those beside it, up to so many before and behind. */
static double largest_about(const double *values, gsize count, gsize i, gsize before, gsize behind)
{
    double largest = 0;
    for (gsize j = i > before ? i - before : 0; j < count && j <= i + behind; j++)
        largest = fmax(largest, values[j]);
    return largest;
}

static double smallest_bound(const double *missed, const double *rough, gsize count, gsize i)
{
    return fmin(largest_about(missed, count, i, ABOUT - 1, ABOUT), largest_about(rough, count, i, 1, 1));
}

double *tinker_between_samples(const TinkerCurveSamples *samples)
{
    const gsize count = samples->count;
    g_autofree double *missed = g_new0(double, count), *rough = g_new0(double, count);
    double *off = g_new0(double, count), largest = 0;
    for (int from_second = 0; from_second < 2; from_second++) {
        g_autofree double *room = NULL;
        const TinkerCurveSamples coarse = tinker_every_second(samples, from_second, &room);
        if (coarse.count >= TINKER_CURVE_LEAST) miss(samples, &coarse, missed);
    }
    for (gsize i = 0; i < count; i++)
        largest = fmax(largest, fabs(samples->values[i]));
    for (gsize i = 0; i + 1 < count; i++)
        rough[i] = samples->times[i] < samples->times[i + 1] ? SMOOTH * tinker_curve_roughness(samples, i) : 0;
    /* between events that are close to one another bounds come from elsewhere: between-events.c */
    for (gsize i = 0; i + 1 < count; i++)
        off[i] = TINKER_STATISTIC_ROUNDING * largest +
                 (tinker_is_between_events(samples, i) ? 0 : smallest_bound(missed, rough, count, i));
    return off;
}
