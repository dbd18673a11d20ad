/* What the files of a run share. */
#ifndef TINKER_CORE_SIMULATION_PRIVATE_H
#define TINKER_CORE_SIMULATION_PRIVATE_H

#include "physics/books.h"
#include "physics/passing.h"
#include "physics/sample-times.h"
#include "physics/simulation.h"

struct _TinkerSimulation {
    TinkerModel *model;
    TinkerRunOptions options;
    const TinkerIntegrator *method;
    void *stepper;
    TinkerModelSystem system;
    TinkerState state;
    TinkerSampleTimes times;
    TinkerTimeGrid step_grid;
    gint64 next_step;       /* on the step grid, of a fixed-step method */
    double piece_end;       /* the current piece ends here: */
    gboolean ends_on_break; /* with a break, or only because nobody looked further */
    TinkerBooks books;
    TinkerPassing *passing;
    gint64 looked_at; /* steps at the last look into the books */
    double *sample_q, *sample_v;
    double sample_time;
    int singular_steps; /* in a row */
    TinkerSummary summary;
    gint64 started; /* µs, monotonic */
};

/* The integrator of this name: built in, or of a plugin; "auto" is the default one. NULL with
 * TINKER_MODEL_ERROR_METHOD. */
const TinkerIntegrator *tinker_run_method(TinkerScene *scene, const char *id, GError **error);

gboolean tinker_run_options_check(const TinkerRunOptions *options, const TinkerIntegrator *method, double duration,
                                  GError **error);

/* Enters the piece that begins at the state's time: waveforms switch, a jump of a support is booked, and one that a
 * constraint feels is refused. */
gboolean tinker_simulation_enter_piece(TinkerSimulation *simulation, double horizon, GError **error);

/* After a step: counts it, and looks into the books now and then. FALSE where the run has to stop. */
gboolean tinker_simulation_watch(TinkerSimulation *simulation, const TinkerStepReport *report, gboolean last,
                                 GError **error);

/* Notes an event at the state's time. `blocks` are names, joined by ", ". */
void tinker_simulation_add_event(TinkerSimulation *simulation, const char *kind, const char *blocks);

/* Looks into the books at the state: where they balance, it vouches for all before it. */
TinkerStatus tinker_simulation_vouch(TinkerSimulation *simulation);

/* The error of a run that failed, and why (NULL or "" where nobody said). Answers FALSE. */
gboolean tinker_simulation_fail(TinkerSimulation *simulation, const char *why, GError **error);
/* Likewise where the state is still that of the last good step: what it vouches for is not lost. */
gboolean tinker_simulation_fail_step(TinkerSimulation *simulation, const char *why, GError **error);

#endif
