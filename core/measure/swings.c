/* Period and damping from the extrema of a curve. Both say something only of a swing: one whose extrema come at equal
 * times, and whose ways shrink by the same share each time. */
#include <math.h>

#include "measure/statistics-private.h"

/* Of their mean: how far whole swings may differ and still have a period. */
#define EVEN 0.1
/* How far the logarithms of ways may lie off a line, root mean square, and still fall by a share. */
#define IN_LINE 0.1

static double time_of(const GArray *extrema, guint i)
{
    return g_array_index(extrema, double, 2 * i);
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

/* How the logarithm of the way to the next extremum falls from one to the next: a line through them, and how far they
 * lie off it. */
static TinkerStatistic half_decrement(const GArray *extrema, double *off_line)
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
    if (ways > 2) *off_line = sqrt(squares / (ways - 2));
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

/* From one extremum to the next but one; of three extrema, whose only swing has nothing to compare with, twice from one
 * to the next. */
static gboolean is_even(const GArray *extrema)
{
    const guint count = extrema->len / 2, step = count > 3 ? 2 : 1;
    double least = INFINITY, greatest = 0;
    for (guint i = 0; i + step < count; i++) {
        least = fmin(least, time_of(extrema, i + step) - time_of(extrema, i));
        greatest = fmax(greatest, time_of(extrema, i + step) - time_of(extrema, i));
    }
    return greatest - least <= EVEN * 0.5 * (least + greatest);
}

void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result)
{
    const TinkerStatistic none = {NAN, NAN};
    double off_line = 0;
    result->period = result->decrement = result->damping = none;
    result->no_period = result->no_damping = extrema->len < 6    ? TINKER_SWINGS_TOO_FEW
                                             : !is_even(extrema) ? TINKER_SWINGS_UNEVEN
                                                                 : TINKER_SWINGS_GOOD;
    if (result->no_period != TINKER_SWINGS_GOOD) return;
    TinkerStatistic half = half_period(extrema), fall = half_decrement(extrema, &off_line);
    half.error += half_period_band(extrema, half.value, band);
    result->period = (TinkerStatistic){2 * half.value, 2 * half.error};
    if (!isfinite(fall.value)) result->no_damping = TINKER_SWINGS_TOO_FEW;
    if (off_line > IN_LINE) result->no_damping = TINKER_SWINGS_OFF_SHARE;
    if (result->no_damping != TINKER_SWINGS_GOOD) return;
    fall.error += half_decrement_band(extrema, band);
    const double d = 2 * fall.value, whole = 4 * G_PI * G_PI + d * d;
    result->decrement = (TinkerStatistic){d, 2 * fall.error};
    result->damping = (TinkerStatistic){d / sqrt(whole), 2 * fall.error * 4 * G_PI * G_PI / pow(whole, 1.5)};
}
