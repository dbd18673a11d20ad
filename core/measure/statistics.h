/* Statistics of a curve over an interval. The curve is that through the samples, piece by piece a cubic with slopes
 * from five samples each (of fourth order in their spacing), not the samples themselves. At a kink, as a blow makes,
 * the slopes are those of either side. */
#ifndef TINKER_CORE_STATISTICS_H
#define TINKER_CORE_STATISTICS_H

#include <glib.h>

/* A number and how far it may be off; NAN where it is not defined, as all of them where the curve has
 * a sample that is no number. The error is the sum of what the number changes by
 * where every second sample is left out, of what the curve may be off by between samples, of the scatter of periods and
 * decrements and what their first half differs by from the second, and of what the band about the curve makes of it.
 * Between two events with fewer than three samples between them the curve is taken as straight: what it would be off by
 * there if it bent as much as it does between samples elsewhere is added to the errors of mean, rms, extrema and
 * amplitude. What happens between two samples and shows in none of them is not known. */
typedef struct {
    double value, error;
} TinkerStatistic;

/* Why a curve has no period, or no damping. */
typedef enum {
    TINKER_SWINGS_GOOD,      /* it has */
    TINKER_SWINGS_TOO_FEW,   /* fewer than three extrema; for damping four */
    TINKER_SWINGS_UNEVEN,    /* whole swings differ in length by more than a tenth, as of a ball that bounces */
    TINKER_SWINGS_UNLIKE,    /* they become larger and smaller in turn, and do not come again */
    TINKER_SWINGS_OFF_SHARE, /* they do not shrink by the same share each time, as by dry friction or in a beat */
    TINKER_SWINGS_COARSE,    /* every second sample would not have told them */
    TINKER_SWINGS_UNDEFINED  /* the curve is not defined everywhere: nothing is known of it */
} TinkerSwings;

/* That as words, without a stop; "" of one that has. */
const char *tinker_swings_why(TinkerSwings swings);

typedef struct {
    TinkerStatistic mean, rms, least, greatest;
    TinkerStatistic amplitude; /* half of greatest less least */
    TinkerStatistic period;    /* s: mean time from one extremum to the next but one; where swings become larger and
                                  smaller in turn, that after which all extrema come again; of three at least */
    TinkerStatistic decrement; /* logarithmic, a period: of the ways from one extremum to the next, by least squares; of
                                  four at least */
    TinkerStatistic damping;   /* ratio of critical damping, d / sqrt(4 pi^2 + d^2) */
    TinkerSwings no_period, no_damping;
} TinkerStatistics;

/* Of a curve given by at least eight samples at rising times, from `from` to `to`, which lie within them. All values
 * may be off by as much as `band` (0: by nothing), slowly: by a swing that is a little too large, too early or too
 * late. Swings at both ends that are hardly larger than that are left out of period, decrement and damping. FALSE where
 * there are too few. */
gboolean tinker_statistics(const double *times, const double *values, gsize count, double from, double to, double band,
                           TinkerStatistics *statistics);

/* The greatest that a curve may be from one time to another, samples at both of which are about: with what it may be
 * off by between samples. Of fewer samples than statistics take it is the greatest of them; NAN where one is NAN. */
double tinker_greatest_about(const double *times, const double *values, gsize count, double from, double to);

#endif
