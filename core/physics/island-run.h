/* The run of one island: its state, its method, its books. */
#ifndef TINKER_CORE_ISLAND_RUN_H
#define TINKER_CORE_ISLAND_RUN_H

#include "physics/books.h"
#include "physics/islands.h"
#include "physics/method-call.h"
#include "physics/plan.h"
#include "physics/sample-times.h"
#include "physics/simulation.h"
#include "physics/stability-watch.h"

struct _TinkerContactRun;

typedef struct {
    const TinkerIsland *island;
    TinkerModel *model; /* the island's */
    TinkerChoice choice;
    void *stepper;
    TinkerModelSystem system;
    TinkerState state; /* in the coordinates of the system */
    double *q, *v; /* of the model's bodies: see tinker_island_run_place. Those of the state where they are the same */
    double *sample_x, *sample_u;
    TinkerTimeGrid step_grid;
    gint64 next_step;       /* on the step grid, of a fixed-step method */
    double piece_end;       /* the current piece ends here: */
    gboolean ends_on_break; /* with a break, or only because nobody looked further */
    TinkerBooks books;
    struct _TinkerContactRun *contacts; /* NULL where nothing can touch anything */
    TinkerStabilityWatch *stability;
    gint64 looked_at;   /* steps at the last look into the books */
    int singular_steps; /* in a row */
    int tiny_steps;     /* likewise: of which the rest of the run would take too many */
    double spectral_radius;
    TinkerSummary summary; /* of this island; events and warnings are those of the whole run, borrowed */
} TinkerIslandRun;

/* Starts the run of an island, which is borrowed. `run` collects its events and warnings, which are borrowed as well.
 * (transfer full) */
TinkerIslandRun *tinker_island_run_new(const TinkerIsland *island, const TinkerChoice *choice, double spectral_radius,
                                       double horizon, const TinkerSummary *run, GError **error);
void tinker_island_run_free(TinkerIslandRun *run);

/* One step, not beyond `end`; a method that steps exactly goes to `target` where that comes first. */
gboolean tinker_island_run_step(TinkerIslandRun *run, double target, double end, GError **error);

/* Where the state stands on a break enters the next piece, and where on an event of contact passes it: at the instant of a
 * jump the state after it counts. */
gboolean tinker_island_run_pass_instant(TinkerIslandRun *run, double end, GError **error);

/* Bodies are going to rest on plates: from the present state on the run is stepped in the plane, by a method that takes
 * constraints. */
gboolean tinker_island_run_enter_plane(TinkerIslandRun *run, GError **error);

/* The state of the model's bodies (relative to its origin) at time t, within the last step, on the constraints. */
TinkerStatus tinker_island_run_state_at(TinkerIslandRun *run, double t, double *q, double *v);

/* Speeds (m/s) up to here are rounding of places from step to step: what is at rest has them. */
double tinker_island_run_speed_noise(const TinkerIslandRun *run, double extent);

/* Brings q and v to the state. */
void tinker_island_run_place(TinkerIslandRun *run);

/* Enters the piece that begins at the state's time: waveforms switch, a jump of a support is booked, and one that a
 * constraint feels is refused. */
gboolean tinker_island_run_enter_piece(TinkerIslandRun *run, double horizon, GError **error);

/* After a step: counts it, and looks into the books now and then. FALSE where the run has to stop. */
gboolean tinker_island_run_watch(TinkerIslandRun *run, const TinkerStepReport *report, gboolean last, GError **error);

/* Notes an event at the state's time. `blocks` are names, joined by ", ". */
void tinker_island_run_add_event(TinkerIslandRun *run, const char *kind, const char *blocks);

/* Looks into the books at the state: where they balance, it vouches for all before it. */
TinkerStatus tinker_island_run_vouch(TinkerIslandRun *run);

/* The error of a run that failed, and why (NULL or "" where nobody said). Answers FALSE. */
gboolean tinker_island_run_fail(TinkerIslandRun *run, const char *why, GError **error);
/* Likewise where the state is still that of the last good step: what it vouches for is not lost. */
gboolean tinker_island_run_fail_step(TinkerIslandRun *run, const char *why, GError **error);

#endif
