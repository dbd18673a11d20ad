/* Times at equal spacing, and the times at which a run is to be sampled. */
#ifndef TINKER_CORE_SAMPLE_TIMES_H
#define TINKER_CORE_SAMPLE_TIMES_H

#include <glib.h>

/* Times i * spacing. Where the spacing is a whole fraction of a second they are worked out as i / n, so that they are
 * the doubles nearest to the decimal numbers that people expect: 0.3, not 0.30000000000000004. */
typedef struct {
    double spacing;
    double per_second; /* 0 where the spacing is no whole fraction */
} TinkerTimeGrid;

TinkerTimeGrid tinker_time_grid(double spacing);
static inline double tinker_time_grid_at(const TinkerTimeGrid *grid, gint64 i)
{
    return grid->per_second > 0 ? (double)i / grid->per_second : (double)i * grid->spacing;
}

typedef struct {
    TinkerTimeGrid grid;
    double duration;
    gint64 count;  /* of samples */
    double *given; /* sorted, or NULL: by the grid, the last at `duration` */
} TinkerSampleTimes;

/* `at` NULL: from 0 to duration at the interval. */
TinkerSampleTimes tinker_sample_times(double duration, double interval, const double *at, gsize at_count);
double tinker_sample_times_at(const TinkerSampleTimes *times, gint64 i);
void tinker_sample_times_clear(TinkerSampleTimes *times);

#endif
