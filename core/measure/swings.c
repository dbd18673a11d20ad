/* Period and damping from the extrema of a curve. Both say something only of a swing: one that goes to and fro, whose
 * extrema come at equal times, and whose ways go one way, less or more, and damping only where they go by the same
 * share each time. What is put together of several swings has more extrema in a period: it has one where all of them
 * come again, at equal times and at the same values. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "measure/statistics-private.h"

/* Of their mean: how far whole swings may differ and still have a period. */
#define EVEN 0.1
/* How far the logarithms of ways may lie off a line, root mean square, and still fall by a share. */
#define IN_LINE 0.1
/* Of how far the logarithms of ways lie off a line: ways that lie that much nearer to a line of their own, in units of
 * their mean, fall by an amount, as dry friction has it, and by no share. */
#define OF_AMOUNTS 0.1
/* Logarithms that lie nearer to a line than this are on it, and fall by a share. */
#define STRAIGHT 1e-6
/* Of the longest way: how far ways may go back where all others become less, or more. */
#define ONE_WAY 0.01
/* Of the range and of the period: how far a pattern of extrema may differ from the one before. */
#define AGAIN          1e-3
#define MOST_IN_PERIOD 64 /* extrema */

const char *tinker_swings_why(TinkerSwings swings)
{
    switch (swings) {
    case TINKER_SWINGS_TOO_FEW:
        return _("it does not swing to and fro often enough");
    case TINKER_SWINGS_UNEVEN:
        return _("its swings do not take equally long");
    case TINKER_SWINGS_UNLIKE:
        return _("its swings become larger and smaller in turn, and do not come again");
    case TINKER_SWINGS_OFF_SHARE:
        return _("its swings do not shrink by the same share each time");
    case TINKER_SWINGS_COARSE:
        return _("too few samples in a swing");
    case TINKER_SWINGS_UNDEFINED:
        return _("it is not defined everywhere");
    default:
        return "";
    }
}

static const TinkerExtremum *at(const GArray *extrema, guint i)
{
    return &g_array_index(extrema, TinkerExtremum, i);
}

/* Of values y[0] ... y[count - 1] at equal distances: the slope of a line through them. */
static double slope_of(const double *y, guint count)
{
    double slope = 0, weight = 0;
    for (guint i = 0; i < count; i++) {
        const double x = i - 0.5 * (count - 1);
        slope += x * y[i];
        weight += x * x;
    }
    return slope / weight;
}

/* What is farthest from that line; `squares`: the sum over all (may be NULL). */
static double farthest(const double *y, guint count, double slope, double *squares)
{
    double mean = 0, most = 0, sum = 0;
    for (guint i = 0; i < count; i++)
        mean += y[i] / count;
    for (guint i = 0; i < count; i++) {
        const double off = y[i] - mean - slope * (i - 0.5 * (count - 1));
        most = fmax(most, fabs(off));
        sum += off * off;
    }
    if (squares != NULL) *squares = sum;
    return most;
}

/* Of every second extremum, from the one with this number on: the mean time to the next is that between the first and
 * the last, each of which may be off: by what the samples leave open, by as much as the one that is farthest from where
 * equal times would have it, and by what both halves differ in, as while a swing is built up. */
static TinkerStatistic period_of_side(const GArray *extrema, guint side, double *weight)
{
    const guint count = (extrema->len - side + 1) / 2, swings = count - 1, half = (count + 1) / 2;
    const TinkerExtremum *first = at(extrema, side), *last = at(extrema, side + 2 * swings);
    const double mean = (last->time - first->time) / swings;
    g_autofree double *times = g_new(double, count);
    double squares = 0;
    for (guint i = 0; i < count; i++)
        times[i] = at(extrema, side + 2 * i)->time - first->time;
    for (guint i = 0; i < swings; i++)
        squares += pow(times[i + 1] - times[i] - mean, 2);
    const double scatter = swings > 1 ? sqrt(squares / (swings - 1) / swings) : 0;
    const double ends = 2 * farthest(times, count, slope_of(times, count), NULL) / swings;
    const double change = half > 1 ? fabs(slope_of(times + count - half, half) - slope_of(times, half)) : 0;
    *weight = swings;
    return (TinkerStatistic){mean, fmax(fmax(scatter, ends), change) + (first->off_time + last->off_time) / swings};
}

/* Of maxima and of minima, where there are two of either: the way up may take longer than that down. */
static TinkerStatistic whole_period(const GArray *extrema)
{
    double weight, other_weight;
    const TinkerStatistic one = period_of_side(extrema, 0, &weight);
    if (extrema->len < 4) return one;
    const TinkerStatistic other = period_of_side(extrema, 1, &other_weight);
    const double share = weight / (weight + other_weight), rest = 1 - share;
    return (TinkerStatistic){share * one.value + rest * other.value,
                             fmax(share * one.error + rest * other.error, 0.5 * fabs(one.value - other.value))};
}

/* How the logarithm of the way to the next extremum falls from one to the next: a line through them, how far they lie
 * off it, and by how much it differs in both halves: where it does, it is no share that is the same each time. */
static TinkerStatistic half_decrement(const GArray *extrema, double *off_line)
{
    const guint ways = extrema->len - 1, half = (ways + 1) / 2;
    g_autofree double *logarithms = g_new(double, ways);
    double squares;
    if (ways < 3) return (TinkerStatistic){NAN, NAN}; /* of two nothing tells whether both fall by the same share */
    for (guint i = 0; i < ways; i++)
        logarithms[i] = log(tinker_extremum_way(extrema, i));
    const double slope = slope_of(logarithms, ways);
    farthest(logarithms, ways, slope, &squares);
    *off_line = sqrt(squares / (ways - 2));
    const double weight = (double)ways * ((double)ways * ways - 1) / 12;
    const double early = slope_of(logarithms, half), late = slope_of(logarithms + ways - half, half);
    return (TinkerStatistic){-slope, fmax(sqrt(squares / (ways - 2) / weight), fabs(late - early))};
}

static gboolean falls_by_amount(const GArray *extrema, double off_line)
{
    const guint ways = extrema->len - 1;
    g_autofree double *lengths = g_new(double, ways);
    double squares = 0, sum = 0;
    if (off_line < STRAIGHT) return FALSE;
    for (guint i = 0; i < ways; i++)
        sum += lengths[i] = tinker_extremum_way(extrema, i);
    farthest(lengths, ways, slope_of(lengths, ways), &squares);
    return sqrt(squares / (ways - 2)) < OF_AMOUNTS * off_line * sum / ways;
}

/* A swing of amplitude A and frequency w that is off by a swing of amplitude e has its extrema off by e / (w A) in
 * time: those at both ends make the mean of all periods wrong. A way is 2 A, and a period is 2 pi / w. */
static double period_band(const GArray *extrema, double period, double band)
{
    const guint spans = extrema->len - 1;
    return 2 * band * period / G_PI *
           (1 / tinker_extremum_way(extrema, 0) + 1 / tinker_extremum_way(extrema, spans - 1)) / spans;
}

/* Both ends of a way may be off, and the slope of the line through the logarithms is a sum of them with weights. */
static double half_decrement_band(const GArray *extrema, double band)
{
    const guint ways = extrema->len - 1;
    double sum = 0, weight = 0;
    for (guint i = 0; i < ways; i++) {
        const double x = i - 0.5 * (ways - 1), off = at(extrema, i)->off_value + at(extrema, i + 1)->off_value;
        sum += fabs(x) * (2 * band + off) / tinker_extremum_way(extrema, i);
        weight += x * x;
    }
    return sum / weight;
}

/* From one extremum to the next but one; of three extrema, whose only swing has nothing to compare with, twice from one
 * to the next. */
static gboolean is_even(const GArray *extrema)
{
    const guint count = extrema->len, step = count > 3 ? 2 : 1;
    double least = INFINITY, greatest = 0;
    for (guint i = 0; i + step < count; i++) {
        least = fmin(least, at(extrema, i + step)->time - at(extrema, i)->time);
        greatest = fmax(greatest, at(extrema, i + step)->time - at(extrema, i)->time);
    }
    return greatest - least <= EVEN * 0.5 * (least + greatest);
}

/* Whether ways to one side become less all along, or more: they do not in a beat. Those up and those down may differ,
 * as on a slope. */
static gboolean goes_one_way(const GArray *extrema, double band)
{
    const double off = 4 * band;
    double longest = 0, up = 0, down = 0;
    for (guint side = 0; side < 2; side++) {
        double least = INFINITY, greatest = -INFINITY;
        for (guint i = side; i + 1 < extrema->len; i += 2) {
            const double open = 2 * (at(extrema, i)->off_value + at(extrema, i + 1)->off_value) + off;
            const double length = tinker_extremum_way(extrema, i);
            longest = fmax(longest, length);
            up = fmax(up, length - least - open);
            down = fmax(down, greatest - length - open);
            least = fmin(least, length);
            greatest = fmax(greatest, length);
        }
    }
    return fmin(up, down) <= ONE_WAY * longest;
}

/* Whether each extremum comes again as the one so many further on. Sets the period. */
static gboolean comes_again(const GArray *extrema, guint step, double range, double band, TinkerStatistic *period)
{
    const guint count = extrema->len - step;
    double least = INFINITY, greatest = 0, off = 0;
    for (guint i = 0; i < count; i++) {
        const TinkerExtremum *one = at(extrema, i), *other = at(extrema, i + step);
        const double time = other->time - one->time, open = one->off_value + other->off_value + 2 * band;
        if (fabs(other->value - one->value) > AGAIN * range + open) return FALSE;
        least = fmin(least, time);
        greatest = fmax(greatest, time);
        off = fmax(off, one->off_time + other->off_time);
        if (greatest - least > AGAIN * greatest + 2 * off) return FALSE;
    }
    *period = (TinkerStatistic){0.5 * (least + greatest), 0.5 * (greatest - least) + off};
    return TRUE;
}

/* The least number of extrema, two patterns of which are there at least, that come again; FALSE where there is none.
 * Where samples leave the extrema open all would be alike. */
static gboolean find_pattern(const GArray *extrema, double band, TinkerStatistic *period)
{
    double least = INFINITY, greatest = -INFINITY, off = 0;
    for (guint i = 0; i < extrema->len; i++) {
        least = fmin(least, at(extrema, i)->value);
        greatest = fmax(greatest, at(extrema, i)->value);
        off = fmax(off, at(extrema, i)->off_value + band);
    }
    if (off > ONE_WAY * (greatest - least)) return FALSE;
    for (guint step = 4; step <= MOST_IN_PERIOD && 2 * step < extrema->len; step += 2)
        if (comes_again(extrema, step, greatest - least, band, period)) return TRUE;
    return FALSE;
}

static void find_damping(const GArray *extrema, double band, TinkerStatistics *result)
{
    double off_line = 0;
    TinkerStatistic fall = half_decrement(extrema, &off_line);
    if (!isfinite(fall.value)) result->no_damping = TINKER_SWINGS_TOO_FEW;
    if (off_line > IN_LINE || falls_by_amount(extrema, off_line)) result->no_damping = TINKER_SWINGS_OFF_SHARE;
    if (result->no_damping != TINKER_SWINGS_GOOD) return;
    fall.error += half_decrement_band(extrema, band);
    const double d = 2 * fall.value, whole = 4 * G_PI * G_PI + d * d;
    result->decrement = (TinkerStatistic){d, 2 * fall.error};
    result->damping = (TinkerStatistic){d / sqrt(whole), 2 * fall.error * 4 * G_PI * G_PI / pow(whole, 1.5)};
}

void tinker_find_swings(const GArray *extrema, double band, TinkerStatistics *result)
{
    const TinkerStatistic none = {NAN, NAN};
    result->period = result->decrement = result->damping = none;
    if (extrema->len < 3) {
        result->no_period = result->no_damping = TINKER_SWINGS_TOO_FEW;
        return;
    }
    const gboolean even = is_even(extrema);
    result->no_period = result->no_damping = TINKER_SWINGS_GOOD;
    if (even && goes_one_way(extrema, band)) {
        result->period = whole_period(extrema);
        result->period.error += period_band(extrema, result->period.value, band);
        find_damping(extrema, band, result);
        return;
    }
    result->no_damping = even ? TINKER_SWINGS_OFF_SHARE : TINKER_SWINGS_UNEVEN;
    if (!find_pattern(extrema, band, &result->period))
        result->no_period = even ? TINKER_SWINGS_UNLIKE : TINKER_SWINGS_UNEVEN;
}
