/* Everything is measured twice, with all samples and with every second one: what it differs by is part of its error.
 * What the curve may be off by between samples (between-samples.c) is another. */
#include <math.h>

#include "measure/curve-pieces.h"
#include "measure/statistics-private.h"

static TinkerStatistics measure(const TinkerCurveSamples *samples, const double *off, double from, double to,
                                double band)
{
    TinkerCurveSums sums = tinker_curve_sums(samples, off, from, to, band);
    const double lasts = to - from, rms = sqrt(sums.square / lasts);
    const double above = sums.above - sums.greatest, below = sums.least - sums.below;
    TinkerStatistics result = {.mean = {sums.mean / lasts, band + sums.off / lasts},
                               .rms = {rms, band + (rms > 0 ? sums.off_square / lasts / rms : 0)},
                               .least = {sums.least, band + below},
                               .greatest = {sums.greatest, band + above},
                               .amplitude = {0.5 * (sums.greatest - sums.least), band + 0.5 * (above + below)}};
    tinker_find_swings(sums.extrema, band, &result);
    tinker_curve_sums_clear(&sums);
    return result;
}

/* What is unknown between events (between-events.c). The root mean square is off by no more than that of what the curve
 * is, and by the mean of what its square is off by, over the rms itself. */
static void add_between_events(const TinkerCurveSamples *samples, double from, double to, TinkerStatistics *found)
{
    const double *times = samples->times, *values = samples->values;
    double bends[2], area = 0, square = 0, moment = 0, above = 0, below = 0;
    tinker_bends(samples, bends);
    const double bend = fmax(-bends[0], bends[1]);
    for (gsize i = 0; i + 1 < samples->count; i++) {
        if (times[i + 1] <= from || times[i] >= to || !tinker_is_between_events(samples, i)) continue;
        const double h = times[i + 1] - times[i];
        const double largest = fmax(fabs(values[i]), fabs(values[i + 1]));
        area += bend * h * h * h / 12;
        moment += largest * bend * h * h * h / 12;
        square += bend * bend * h * h * h * h * h / 120;
        above = fmax(above, fmax(values[i], values[i + 1]) - bends[0] * h * h / 8 - found->greatest.value);
        below = fmax(below, found->least.value - fmin(values[i], values[i + 1]) + bends[1] * h * h / 8);
    }
    found->mean.error += area / (to - from);
    found->rms.error += fmin(sqrt(square / (to - from)), (2 * moment + square) / (to - from) / fabs(found->rms.value));
    found->greatest.error += above;
    found->least.error += below;
    found->amplitude.error += 0.5 * (above + below);
}

/* What the samples tell only as they are, and every second of them would not, has no error that is known. */
static void forget_untold(TinkerStatistics *found)
{
    const TinkerStatistic none = {NAN, NAN};
    if (found->no_period == TINKER_SWINGS_GOOD && !isfinite(found->period.error)) {
        found->period = none;
        found->no_period = TINKER_SWINGS_COARSE;
    }
    if (found->no_damping == TINKER_SWINGS_GOOD && isfinite(found->decrement.value) &&
        !isfinite(found->decrement.error)) {
        found->decrement = found->damping = none;
        found->no_damping = TINKER_SWINGS_COARSE;
    }
}

gboolean tinker_statistics(const double *times, const double *values, gsize count, double from, double to, double band,
                           TinkerStatistics *statistics)
{
    if (count / 2 + 1 < TINKER_CURVE_LEAST || !(to > from)) return FALSE;
    g_autofree double *room = NULL;
    const TinkerCurveSamples fine = {times, values, count}, coarse = tinker_every_second(&fine, FALSE, &room);
    g_autofree double *off = tinker_between_samples(&fine);
    *statistics = measure(&fine, off, from, to, band);
    const TinkerStatistics rough = measure(&coarse, NULL, from, to, band);
    TinkerStatistic *all[] = {&statistics->mean,      &statistics->rms,       &statistics->least,
                              &statistics->greatest,  &statistics->amplitude, &statistics->period,
                              &statistics->decrement, &statistics->damping};
    const TinkerStatistic *others[] = {&rough.mean,      &rough.rms,    &rough.least,     &rough.greatest,
                                       &rough.amplitude, &rough.period, &rough.decrement, &rough.damping};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        all[i]->error += fabs(all[i]->value - others[i]->value);
    add_between_events(&fine, from, to, statistics);
    forget_untold(statistics);
    return TRUE;
}
