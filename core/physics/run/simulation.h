/* A run: steps a model from t = 0 to its end and hands out samples.
 *
 * Samples come from dense output, projected onto the constraints, so how often and where one looks never changes a
 * step.
 */
#ifndef TINKER_CORE_SIMULATION_H
#define TINKER_CORE_SIMULATION_H

#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/system/summary.h"

typedef struct _TinkerSimulation TinkerSimulation;

/* Prepares a run. The model is borrowed, outlives the simulation and serves one at a time. Errors:
 * TINKER_MODEL_ERROR_METHOD. (transfer full) */
TinkerSimulation *tinker_simulation_new(TinkerModel *model, const TinkerRunOptions *options, GError **error);
void tinker_simulation_free(TinkerSimulation *simulation);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSimulation, tinker_simulation_free)

/* One sample: time, and the value of each column. Answering FALSE with `error` set stops the run. */
typedef gboolean (*TinkerSampleFunc)(TinkerSimulation *simulation, double time, const double *values, void *data,
                                     GError **error);

/* The columns just before and just behind an instant at which the motion or a waveform jumps, or may: bodies touch,
 * part, begin to slip; a force is switched on. They come before the sample that is not earlier than the instant. FALSE
 * as of a sample. */
typedef gboolean (*TinkerEventsFunc)(TinkerSimulation *simulation, double time, const double *before,
                                     const double *behind, void *data, GError **error);

/* Before the run: asks for the columns at events, too. They change no step and no sample, but for the last digits of
 * the length of a path, which is added up to each of them, too; and they are no more than there are samples and a few
 * hundred. */
void tinker_simulation_ask_at_events(TinkerSimulation *simulation, TinkerEventsFunc at_events);

/* Runs to the end. `columns` (of TinkerColumn, may be NULL) are evaluated at every sample. On failure
 * (TINKER_MODEL_ERROR_RUN) the message names the block, and the samples up to then have been handed out;
 * summary->valid_until says how far they are to be believed. All functions that were given are called on the caller's
 * thread, but TinkerRunOptions.found; another one may step the companion meanwhile, so the scene must stay as it is. */
gboolean tinker_simulation_run(TinkerSimulation *simulation, const GArray *columns, TinkerSampleFunc sample, void *data,
                               GError **error);

/* Inside a sample function: puts bodies and supports of the frame where they are at this sample, and tells it how long
 * what is wound on bodies is. */
gboolean tinker_simulation_place(TinkerSimulation *simulation, TinkerFrame *frame, GError **error);

/* A body that can move, at a sample. */
typedef struct {
    double x, y;        /* m, in the world */
    double vx, vy;      /* m/s */
    double orientation; /* rad; NAN where nothing has turned it since the start */
    double rate;        /* rad/s; 0 where it does not turn */
} TinkerBodySample;

/* Inside a sample function: a body's state at this sample. FALSE for a block that is no body that can move. */
gboolean tinker_simulation_body(const TinkerSimulation *simulation, TinkerBlockId block, TinkerBodySample *sample);

/* Inside a sample function: the length (m) of what is off the body that a block is wound on, with what of it is slack;
 * NAN for blocks that are not wound, or not in the model. */
double tinker_simulation_wound_length(TinkerSimulation *simulation, TinkerBlockId block);

/* Inside a sample function, or at the end: the error estimate up to this sample, for which the companion is waited for;
 * NAN without one, and from where the companion has stopped on. Who need not know at once is told by
 * TinkerRunOptions.found.
 */
double tinker_simulation_error(TinkerSimulation *simulation);

/* Inside a sample function: how far each column may be off at this sample (the running maximum of its estimate), in the
 * column's unit; NAN from where the companion has stopped on. NULL at all samples of a run where `bands` was not asked
 * for or there is no companion. Waits for the companion, as above. Borrowed. */
const double *tinker_simulation_bands(TinkerSimulation *simulation);

/* What has happened so far, added up at every call and at the end of a run: it alone knows the error estimate.
 * Borrowed. */
const TinkerSummary *tinker_simulation_summary(TinkerSimulation *simulation);

/* One step of the island that is farthest behind, without samples, for benchmarks and single stepping. */
gboolean tinker_simulation_step(TinkerSimulation *simulation, GError **error);

/* The time that all islands have reached. */
double tinker_simulation_time(const TinkerSimulation *simulation);

/* Where a body that can move is now, in the world; FALSE for any other block. */
gboolean tinker_simulation_state(TinkerSimulation *simulation, TinkerBlockId block, double position[2],
                                 double velocity[2]);

#endif
