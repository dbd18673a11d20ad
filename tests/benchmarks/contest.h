/* A contest: solvers of one scene, each at several settings, timed in turns, and who needs the least time for an error.
 */
#ifndef BENCHMARK_CONTEST_H
#define BENCHMARK_CONTEST_H

#include "measure.h"
#include "report.h"

typedef enum {
    CONTEST_OURS,
    CONTEST_OURS_EXACT, /* that makes no error of its own: a separate comparison goes without it */
    CONTEST_PEER,       /* of the same equations */
    CONTEST_ANGLES,     /* of equations in coordinates that were chosen by hand: shown, but no yardstick */
} ContestSide;

/* One solver at one setting. */
typedef struct {
    char *solver; /* "dop853", "GSL rk8pd" (transfer full) */
    ContestSide side;
    const char *setting; /* what was set: "tolerance", "step", "samples" */
    double value;
    double error;
    double preparing;              /* s before the first step, which `timing` leaves out; NAN where it is within */
    double (*once)(gpointer data); /* does it and answers the seconds; NULL where `timing` is known already */
    gpointer data;
    GDestroyNotify free_data;
    BenchmarkTiming timing;
} Contestant;

typedef struct {
    const char *scene;
    GArray *contestants; /* of Contestant */
} Contest;

Contest *contest_new(const char *scene);
void contest_free(Contest *contest);

/* (transfer full) what the contestant holds. */
void contest_add(Contest *contest, const Contestant *contestant);

/* Times all in turns, so that what slows the machine down meets everybody; prints the table and the verdicts. */
void contest_hold(Contest *contest, BenchmarkReport *report);

#endif
