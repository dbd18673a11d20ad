/* The curve has both sides of each event at the event's own time. So between two events that follow on one another
 * within few intervals of samples, as the flights of what bounces to rest do, there are too few values for a cubic. The
 * straight piece between them is off from a curve that bends by y'' by
 *
 *     y'' / 2 (t - t0) (t1 - t),
 *
 * at most y'' h^2 / 8 in the middle, with h = t1 - t0. How the curve bends there no sample tells; three that follow on
 * one another within a flight or a swing tell it elsewhere, of a parabola exactly. */
#include <math.h>

#include "measure/statistics-private.h"

/* Of the mean distance of samples, and of the distance beside it: nearer ones tell rounding. */
#define TOO_NEAR 0.1

static gboolean is_at_jump(const TinkerCurveSamples *samples, gsize i)
{
    const double *times = samples->times;
    return (i > 0 && times[i] == times[i - 1]) || (i + 1 < samples->count && times[i] == times[i + 1]);
}

TinkerCurveSamples tinker_every_second(const TinkerCurveSamples *samples, gboolean from_second, double **room)
{
    const gsize count = samples->count;
    double *times = *room = g_new(double, 2 * count + 1), *values = times + count;
    gsize kept = 0, skipped = 0;
    for (gsize i = 0; i < count; i++) {
        const gboolean is_kept = i == 0 || skipped == 1 || i + 1 == count || is_at_jump(samples, i);
        skipped = !is_kept || (i == 0 && from_second) ? 1 : 0;
        if (!is_kept) continue;
        times[kept] = samples->times[i];
        values[kept++] = samples->values[i];
    }
    return (TinkerCurveSamples){times, values, kept};
}

gboolean tinker_is_between_events(const TinkerCurveSamples *samples, gsize i)
{
    const double *times = samples->times;
    gsize first = i, last = i + 1;
    if (last >= samples->count || !(times[i] < times[last])) return FALSE;
    while (first > 0 && times[first - 1] < times[first] && last - first < TINKER_CURVE_LEAST)
        first--;
    while (last + 1 < samples->count && times[last] < times[last + 1] && last - first < TINKER_CURVE_LEAST)
        last++;
    return last - first + 1 < TINKER_CURVE_LEAST;
}

void tinker_bends(const TinkerCurveSamples *samples, double bends[2])
{
    const double *t = samples->times, *y = samples->values;
    const gsize last = samples->count - 1;
    const double near = last > 0 ? TOO_NEAR * (t[last] - t[0]) / (double)last : 0;
    bends[0] = bends[1] = 0;
    for (gsize i = 1; i < last; i++) {
        const double before = t[i] - t[i - 1], behind = t[i + 1] - t[i];
        if (!(fmin(before, behind) > fmax(near, TOO_NEAR * fmax(before, behind)))) continue;
        const double bend = 2 * ((y[i + 1] - y[i]) / behind - (y[i] - y[i - 1]) / before) / (before + behind);
        bends[0] = fmin(bends[0], bend);
        bends[1] = fmax(bends[1], bend);
    }
}
