/* What a comparison is made of. */
#ifndef TINKER_CORE_COMPARISON_PRIVATE_H
#define TINKER_CORE_COMPARISON_PRIVATE_H

#include <stdatomic.h>

#include "physics/run/companion.h"
#include "physics/run/comparison.h"

/* What the distances had come to at a point. */
typedef struct {
    double t, places, speeds; /* s, m^2, m^2/s^2 */
} ComparisonMark;

/* Of one island. */
typedef struct {
    double factor;             /* error over distance; 0 where rounding is all there is, and nothing is compared */
    double places, speeds;     /* m^2, m^2/s^2: squares of the largest distances so far */
    GArray *marks;             /* of ComparisonMark: how they grew since the last sample */
    double error;              /* of the scales, at the sample looked at last */
    TinkerCompanionEnds *ends; /* NULL where they are not watched, or not any more */
    TinkerImpacts impacts;     /* of the run */
    double length, to, beyond; /* of its last step, see TinkerStepNews; ... */
    int32_t points, behind;    /* ... and its points, of which the first are behind */
    double times[TINKER_MOST_STEP_POINTS];
    const double *states; /* in the news, or in what is kept of them */
    double *kept;
} ComparisonPart;

struct _TinkerComparison {
    GArray *sizes; /* of int32_t: the coordinates of each island */
    guint islands;
    int32_t coordinates;
    TinkerModel *model;          /* of the companion */
    TinkerIslandRuns *companion; /* NULL where no island needs one */
    ComparisonPart *parts;       /* island by island */
    double *q, *v;               /* room for the coordinates of one */
    guint columns;               /* 0: no bands */
    gboolean *turns;             /* of each column: whether it starts again after 2 pi */
    gboolean *places;            /* ... and whether it goes on through impacts */
    double *bands;
    TinkerFindings findings;
    gint state;              /* atomic: a TinkerComparisonState */
    _Atomic gint64 deadline; /* us: then the companion stops; 0: never */
    GThread *owner;          /* whose the run is: it alone asks the user */
    TinkerRunOptions of_the_run;
};

/* comparison-distances.c */

/* Where the companion has come to a point, or past it where it is exact, which states within its steps are then,
 * too. */
void comparison_look_at_point(TinkerComparison *self, ComparisonPart *part, TinkerIslandRun *other);
/* What an island is off by at the sample; of one that is not determined any more, what it was off by until then. */
/* When (s) the distance of an island first made an error of this size, since the sample before one at t that has found
 * it to: by the scales of that sample. */
double comparison_time_of(const ComparisonPart *part, const TinkerIslandNews *news, double error, double t);
double comparison_error_of(TinkerComparison *self, guint number, const TinkerIslandNews *news, const double *q,
                           const double *v, double t);

/* comparison-news.c: the companion goes as far as the news say. */
void comparison_take_step(TinkerComparison *self, const TinkerStepNews *news);
void comparison_take_sample(TinkerComparison *self, const TinkerSampleNews *news);

#endif
