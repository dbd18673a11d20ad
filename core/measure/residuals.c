/* The curve is asked at the times of the values, not the values between their times: what is measured is known there
 * alone. */
#include "measure/residuals.h"

#include <math.h>

#include "measure/statistics-private.h"

/* The curve at a time; NAN where it is not known. */
static double value_at(const TinkerCurveSamples *curve, double time)
{
    gsize low = 0, high = curve->count - 1; /* times[low] <= time <= times[high] */
    if (!(time >= curve->times[low] && time <= curve->times[high])) return NAN;
    while (high - low > 1) {
        const gsize middle = low + (high - low) / 2;
        if (curve->times[middle] <= time)
            low = middle;
        else
            high = middle;
    }
    if (!(curve->times[low] < curve->times[high])) return curve->values[high];
    TinkerCurvePiece pieces[2];
    const guint count = tinker_curve_pieces(curve, low, pieces);
    const TinkerCurvePiece *piece = &pieces[count == 2 && time >= pieces[1].start];
    return tinker_curve_piece_value(piece, (time - piece->start) / piece->width);
}

static double rms_of(const TinkerCurveSamples *curve, const TinkerCurveSamples *measured, double from, double to,
                     gsize *count)
{
    double sum = 0;
    *count = 0;
    for (gsize i = 0; i < measured->count; i++) {
        const double time = measured->times[i];
        if (!(time >= from && time <= to)) continue;
        const double difference = measured->values[i] - value_at(curve, time);
        if (!isfinite(difference)) continue;
        sum += difference * difference;
        ++*count;
    }
    return sqrt(sum / (double)*count);
}

gboolean tinker_residuals(const TinkerCurveSamples *curve, const TinkerCurveSamples *measured, double from, double to,
                          double band, TinkerStatistic *rms, gsize *count)
{
    gsize coarse_count;
    double largest = 0;
    *count = 0;
    if (curve->count / 2 + 1 < TINKER_CURVE_LEAST) return FALSE;
    rms->value = rms_of(curve, measured, from, to, count);
    if (*count == 0) return FALSE;
    g_autofree double *room = NULL;
    const TinkerCurveSamples coarse = tinker_every_second(curve, &room);
    for (gsize i = 0; i < curve->count; i++)
        largest = fmax(largest, fabs(curve->values[i]));
    rms->error = band + TINKER_STATISTIC_ROUNDING * largest +
                 fabs(rms->value - rms_of(&coarse, measured, from, to, &coarse_count));
    return TRUE;
}
