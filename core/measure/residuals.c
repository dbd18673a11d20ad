/* The curve is asked at the times of the values, not the values between their times: what is measured is known there
 * alone. */
#include "measure/residuals.h"

#include <math.h>

#include "measure/statistics-private.h"

/* Root mean squares of what measured values differ by from the curve, of what the curve may be off by at their times
 * where it is unknown between events (between-events.c), and of what it may be off by between samples. */
typedef struct {
    double differs, unknown, open;
    gsize count;
} Fit;

/* The number of the last sample that is not later, but for that at the curve's end; FALSE where it is not known. */
static gboolean find_piece(const TinkerCurveSamples *curve, double time, gsize *piece)
{
    gsize low = 0, high = curve->count - 1; /* times[low] <= time <= times[high] */
    if (!(time >= curve->times[low] && time <= curve->times[high])) return FALSE;
    while (high - low > 1) {
        const gsize middle = low + (high - low) / 2;
        if (curve->times[middle] <= time)
            low = middle;
        else
            high = middle;
    }
    *piece = low;
    return TRUE;
}

static double value_in(const TinkerCurveSamples *curve, gsize i, double time)
{
    if (!(curve->times[i] < curve->times[i + 1])) return curve->values[i + 1];
    TinkerCurvePiece pieces[2];
    const guint count = tinker_curve_pieces(curve, i, pieces);
    const TinkerCurvePiece *piece = &pieces[count == 2 && time >= pieces[1].start];
    return tinker_curve_piece_value(piece, (time - piece->start) / piece->width);
}

static Fit fit_of(const TinkerCurveSamples *curve, const double *between, const TinkerCurveSamples *measured,
                  double from, double to)
{
    Fit fit = {0, 0, 0, 0};
    double bends[2];
    gsize piece;
    tinker_bends(curve, bends);
    const double bend = fmax(-bends[0], bends[1]);
    for (gsize i = 0; i < measured->count; i++) {
        const double time = measured->times[i];
        if (!(time >= from && time <= to) || !find_piece(curve, time, &piece)) continue;
        const double difference = measured->values[i] - value_in(curve, piece, time);
        if (!isfinite(difference)) continue;
        fit.differs += difference * difference;
        fit.open += between[piece] * between[piece];
        fit.count++;
        if (!tinker_is_between_events(curve, piece)) continue;
        const double off = 0.5 * bend * (time - curve->times[piece]) * (curve->times[piece + 1] - time);
        fit.unknown += off * off;
    }
    fit.differs = sqrt(fit.differs / (double)fit.count);
    fit.unknown = sqrt(fit.unknown / (double)fit.count);
    fit.open = sqrt(fit.open / (double)fit.count);
    return fit;
}

gboolean tinker_residuals(const TinkerCurveSamples *curve, const TinkerCurveSamples *measured, double from, double to,
                          double band, TinkerStatistic *rms, gsize *count)
{
    *count = 0;
    if (curve->count / 2 + 1 < TINKER_CURVE_LEAST) return FALSE;
    g_autofree double *off = tinker_between_samples(curve);
    const Fit fit = fit_of(curve, off, measured, from, to);
    rms->value = fit.differs;
    *count = fit.count;
    if (*count == 0) return FALSE;
    rms->error = band + fit.unknown + fit.open;
    return TRUE;
}
