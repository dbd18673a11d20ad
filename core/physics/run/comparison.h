/* The companion's side of the error estimate: brings the companion along with the run, and compares the two.
 *
 * It knows nothing of the run but the news of it, in the order in which they came: so it may be behind the run, on
 * another thread, and finds the same to the last bit. News are written in one piece, with their numbers behind them. */
#ifndef TINKER_CORE_COMPARISON_H
#define TINKER_CORE_COMPARISON_H

#include "physics/run/impacts.h"
#include "physics/run/island-runs.h"

/* Within one step. */
#define TINKER_MOST_STEP_POINTS 3

typedef enum { TINKER_NEWS_STEP, TINKER_NEWS_SAMPLE } TinkerNewsKind;

/* An island of the run has made a step, or is looked at once more within its last one. */
typedef struct {
    TinkerNewsKind kind; /* TINKER_NEWS_STEP */
    guint warnings;      /* that the run had before */
    guint island;
    gboolean steps; /* it made a step, of this length (s), to this time (s) */
    double length, to;
    double until;  /* s: the companion is to come so far: a sample lies there, or the end of the step */
    double beyond; /* s: where it goes from the last point of the step, if a sample lies there */
    TinkerImpacts impacts;
    int32_t points; /* where the two are compared: times in ascending order; 0 unless it made a step */
    double times[TINKER_MOST_STEP_POINTS];
    /* 4 a body for each point: places, then speeds, as the method has them; NAN where they are not known */
} TinkerStepNews;

/* Of one island at a sample. */
typedef struct {
    double extent, speed; /* m, m/s: its scales */
    double noise;         /* m/s: speeds up to here are rounding */
    double rounding;      /* of an exact solution, in units of the scales */
    TinkerImpacts impacts;
    gboolean determined, rests;
} TinkerIslandNews;

typedef struct {
    TinkerNewsKind kind; /* TINKER_NEWS_SAMPLE */
    guint warnings;      /* that the run had before */
    double t;
    /* of each island a TinkerIslandNews; where there is a companion the places, then the speeds, of all bodies; and
     * where there are bands the values of all columns */
} TinkerSampleNews;

typedef struct _TinkerComparison TinkerComparison;

/* With a companion of these runs where an island needs one: it can be told that it does. The runs may go on; nothing
 * of them is looked at later but what never changes. NULL with an error where the companion cannot be set up.
 * (transfer full) */
TinkerComparison *tinker_comparison_new(TinkerIslandRuns *runs, const GArray *columns, GError **error);
void tinker_comparison_free(TinkerComparison *comparison);

gboolean tinker_comparison_has_companion(const TinkerComparison *comparison);
/* The number of bands; 0: none. */
guint tinker_comparison_columns(const TinkerComparison *comparison);

/* Sizes of news, in bytes. */
gsize tinker_comparison_step_bytes(const TinkerComparison *comparison, guint island, int32_t points);
gsize tinker_comparison_sample_bytes(const TinkerComparison *comparison);

/* Goes on to what the news tell. */
void tinker_comparison_take(void *comparison, const void *news);

/* From any thread: whether news are of any use yet. */
typedef enum {
    TINKER_COMPARISON_GOES_ON,
    TINKER_COMPARISON_FAILED,  /* the companion could not go on */
    TINKER_COMPARISON_STOPPED, /* nobody wanted it to */
} TinkerComparisonState;
TinkerComparisonState tinker_comparison_state(const TinkerComparison *comparison);

/* From any thread: has the companion stop whatever it is at, at once, or where it has not caught up in a moment. The
 * user of the run, who is asked while the companion is stepped by the thread that made the comparison, has it hurry. */
void tinker_comparison_stop(TinkerComparison *comparison);
void tinker_comparison_hurry(TinkerComparison *comparison);

/* What has been found. */
typedef struct {
    double error;             /* the largest so far, in units of the scales; NAN from where the companion stopped on */
    double predictable_until; /* s: where it passed a tenth, between two samples too; INFINITY */
    const double *bands;      /* by column, or NULL */
    char *failure; /* the warning of a companion that failed, and behind how many of the run's it comes; NULL */
    guint failure_place;
} TinkerFindings;
TinkerFindings *tinker_comparison_findings(TinkerComparison *comparison);

#endif
