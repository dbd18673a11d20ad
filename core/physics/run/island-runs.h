/* The islands of a model, stepped together from sample to sample. What is worked out of them beside, such as an
 * estimate of the error, follows the runs from outside. */
#ifndef TINKER_CORE_ISLAND_RUNS_H
#define TINKER_CORE_ISLAND_RUNS_H

#include "physics/model/model.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/sample-times.h"
#include "physics/record/sampler.h"
#include "physics/run/along-run.h"
#include "physics/run/island-steps.h"
#include "physics/system/summary.h"

typedef struct _TinkerSampleWatch TinkerSampleWatch;

typedef struct {
    TinkerModel *model; /* the whole */
    TinkerRunOptions options;
    GPtrArray *islands; /* of TinkerIsland * */
    GPtrArray *runs;    /* of TinkerIslandRun *, one an island */
    TinkerSampleTimes times;
    double *sample_q, *sample_v; /* of the whole model's bodies */
    double *part_q, *part_v;     /* room for those of one island */
    double *orientation;         /* rad: of bodies that were turned by what they touched; else NAN */
    double sample_time;
    gint64 contact_changes; /* of all runs, when the whole model's closed contacts were gathered */
    double piece_end;       /* of the whole model, where it is not stepped itself */
    gint64 work;            /* of all runs together since the options' functions were last called */
    TinkerSampler *sampler;
    TinkerAlongRun *along; /* NULL where no such column is wanted */
    guint columns;         /* which the sampler evaluates */
    double *values;
    /* Called after each step of an island on its way to a sample at t, and before the first; NULL: nobody follows.
     * FALSE stops. */
    gboolean (*follow)(void *follower, guint island, double t, GError **error);
    void *follower;
    TinkerSampleWatch *samples; /* NULL: nobody asks whether samples show the motion */
    TinkerSummary summary;
} TinkerIslandRuns;

/* Of a TinkerEvent. */
void tinker_event_free(gpointer data);

/* Runs that step their islands as they are told (one choice an island; NULL: as the options say). The model is
 * borrowed. (transfer full) */
TinkerIslandRuns *tinker_island_runs_new(TinkerModel *model, const TinkerRunOptions *options,
                                         const TinkerChoice *choices, GError **error);
void tinker_island_runs_free(TinkerIslandRuns *runs);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerIslandRuns, tinker_island_runs_free)

/* What is to be evaluated at samples (of TinkerColumn; NULL: nothing). */
void tinker_island_runs_take_columns(TinkerIslandRuns *runs, const GArray *columns);

/* One step of the island with this number, or of the one that is farthest behind. */
gboolean tinker_island_runs_step(TinkerIslandRuns *runs, guint number, GError **error);
gboolean tinker_island_runs_step_behind(TinkerIslandRuns *runs, GError **error);
/* As tinker_island_runs_step, on the way to a sample at t, for whom follows. */
gboolean tinker_island_runs_step_towards(TinkerIslandRuns *runs, guint number, double t, GError **error);

/* Brings all islands to time t at least, and the whole model's bodies to where they are then. */
gboolean tinker_island_runs_advance(TinkerIslandRuns *runs, double t, GError **error);

/* The whole model's bodies to where they are at t, on the way to a sample: on the near side of what happens there, or,
 * where it `passes`, on the far side. The last step of no island may have begun behind t. */
gboolean tinker_island_runs_place(TinkerIslandRuns *runs, double t, double sample, gboolean passes, GError **error);

/* Evaluates the columns there; where a waveform jumps, by what it was before. */
TinkerStatus tinker_island_runs_sample(TinkerIslandRuns *runs, double t);
TinkerStatus tinker_island_runs_sample_before(TinkerIslandRuns *runs, double t);

/* What tinker_constraints_wound_length says of a block in the island that it is in, at the last sample. */
double tinker_island_runs_wound_length(TinkerIslandRuns *runs, TinkerBlockId block);

/* The time that all islands have reached. */
double tinker_island_runs_time(const TinkerIslandRuns *runs);

/* The error of runs that the user stopped. Answers FALSE. */
gboolean tinker_island_runs_fail_stopped(const TinkerIslandRuns *runs, GError **error);

/* Ends all runs at the duration. */
gboolean tinker_island_runs_close(TinkerIslandRuns *runs, GError **error);

/* The summary: without anything yet but what the options and the scene say; with what the islands' runs say, added up;
 * gone. */
void tinker_island_runs_open_summary(TinkerIslandRuns *runs);
void tinker_island_runs_add_up(TinkerIslandRuns *runs);
void tinker_island_runs_clear_summary(TinkerIslandRuns *runs);

#endif
