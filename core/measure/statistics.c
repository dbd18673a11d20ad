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

/* Of a period: where every second sample tells none, its error may be no more than that. */
#define FEW 0.02

/* What every second sample tells, too. A period or a damping that it does not tell is told by samples that are too few,
 * unless what they leave open is little. */
static void add_differences(TinkerStatistics *found, const TinkerStatistics *rough)
{
    const TinkerStatistic none = {NAN, NAN};
    TinkerStatistic *all[] = {&found->mean,      &found->rms,    &found->least,     &found->greatest,
                              &found->amplitude, &found->period, &found->decrement, &found->damping};
    const TinkerStatistic *others[] = {&rough->mean,      &rough->rms,    &rough->least,     &rough->greatest,
                                       &rough->amplitude, &rough->period, &rough->decrement, &rough->damping};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        if (isfinite(others[i]->value)) all[i]->error += fabs(all[i]->value - others[i]->value);
    const gboolean is_untold = !isfinite(rough->period.value) || !isfinite(rough->decrement.value);
    if (found->no_period != TINKER_SWINGS_GOOD || !is_untold || found->period.error <= FEW * found->period.value)
        return;
    if (found->no_damping == TINKER_SWINGS_GOOD) found->no_damping = TINKER_SWINGS_COARSE;
    found->decrement = found->damping = none;
    if (isfinite(rough->period.value)) return;
    found->period = none;
    found->no_period = TINKER_SWINGS_COARSE;
}

/* Where the curve is not defined everywhere it may be anything there. */
static void forget_all(TinkerStatistics *found)
{
    const TinkerStatistic none = {NAN, NAN};
    found->mean = found->rms = found->least = found->greatest = found->amplitude = none;
    found->period = found->decrement = found->damping = none;
    found->no_period = found->no_damping = TINKER_SWINGS_UNDEFINED;
}

gboolean tinker_statistics(const double *times, const double *values, gsize count, double from, double to, double band,
                           TinkerStatistics *statistics)
{
    if (count / 2 + 1 < TINKER_CURVE_LEAST || !(to > from)) return FALSE;
    g_autofree double *room = NULL;
    const TinkerCurveSamples fine = {times, values, count}, coarse = tinker_every_second(&fine, FALSE, &room);
    g_autofree double *off = tinker_between_samples(&fine), *rough_off = tinker_between_samples(&coarse);
    *statistics = measure(&fine, off, from, to, band);
    const TinkerStatistics rough = measure(&coarse, rough_off, from, to, band);
    add_differences(statistics, &rough);
    add_between_events(&fine, from, to, statistics);
    if (!isfinite(statistics->mean.value)) forget_all(statistics);
    return TRUE;
}

double tinker_greatest_about(const double *times, const double *values, gsize count, double from, double to)
{
    double greatest = -INFINITY;
    for (gsize i = 0; i < count; i++) {
        if (times[i] < from || times[i] > to) continue;
        if (isnan(values[i])) return NAN;
        greatest = fmax(greatest, values[i]);
    }
    TinkerStatistics found;
    if (count == 0 ||
        !tinker_statistics(times, values, count, fmax(from, times[0]), fmin(to, times[count - 1]), 0, &found))
        return greatest;
    const double above = found.greatest.value + found.greatest.error;
    return isfinite(above) ? fmax(greatest, above) : NAN;
}
