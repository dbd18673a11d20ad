/* Sample times without accumulated rounding. */
#include "physics/record/sample-times.h"

#include <math.h>
#include <stdlib.h>

#include "physics/record/tolerances.h"

TinkerTimeGrid tinker_time_grid(double spacing)
{
    double per_second = nearbyint(1.0 / spacing);
    gboolean whole = per_second >= 1 && per_second < 1e15 && 1.0 / per_second == spacing;
    return (TinkerTimeGrid){spacing, whole ? per_second : 0.0};
}

static int compare(const void *a, const void *b)
{
    double l = *(const double *)a, r = *(const double *)b;
    return (l > r) - (l < r);
}

TinkerSampleTimes tinker_sample_times(double duration, double interval, const double *at, gsize at_count)
{
    TinkerSampleTimes times = {.grid = tinker_time_grid(interval), .duration = duration};
    if (at != NULL) {
        times.given = g_memdup2(at, MAX(at_count, 1) * sizeof(double));
        qsort(times.given, at_count, sizeof(double), compare);
        times.count = (gint64)at_count;
        return times;
    }
    /* A duration that is a whole number of intervals but for rounding ends with the last of them. */
    double intervals = duration / interval, slack = fmin(TINKER_WHOLE_INTERVALS * fmax(intervals, 1.0), 0.01);
    double whole = floor(intervals + slack);
    gboolean fits = fabs(intervals - whole) <= slack;
    times.count = (gint64)whole + (fits ? 1 : 2);
    return times;
}

double tinker_sample_times_at(const TinkerSampleTimes *times, gint64 i)
{
    if (times->given != NULL) return times->given[i];
    return i == times->count - 1 ? times->duration : tinker_time_grid_at(&times->grid, i);
}

void tinker_sample_times_clear(TinkerSampleTimes *times)
{
    g_clear_pointer(&times->given, g_free);
}
