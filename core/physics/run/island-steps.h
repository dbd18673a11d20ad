/* The steps of one island: from break to break, past events of contact and lost directions, watched. */
#ifndef TINKER_CORE_ISLAND_STEPS_H
#define TINKER_CORE_ISLAND_STEPS_H

#include "physics/island/island-run.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/system/summary.h"

/* Starts the run of an island, which is borrowed. `run` collects its events and warnings, which are borrowed as well,
 * and `jolts` (may be NULL) what gives bodies impulses, from blows at the start on.
 * (transfer full) */
TinkerIslandRun *tinker_island_run_new(const TinkerIsland *island, const TinkerChoice *choice, double spectral_radius,
                                       double horizon, const TinkerSummary *run, GArray *jolts, GError **error);
void tinker_island_run_free(TinkerIslandRun *run);

/* One step, not beyond `end`. */
gboolean tinker_island_run_step(TinkerIslandRun *run, double end, GError **error);

/* Where the state stands on a break enters the next piece, and where on an event of contact passes it: at the instant
 * of a jump the state after it counts, but where joints cannot follow it: that is the state before. */
gboolean tinker_island_run_pass_instant(TinkerIslandRun *run, double end, GError **error);

/* Enters the piece that begins at the state's time: waveforms switch, a jump of a support is booked, and one that a
 * constraint feels is refused: `jumps`, which may be NULL, says that it was for this, and then nothing is changed but
 * the piece that the model is in. */
gboolean tinker_island_run_enter_piece(TinkerIslandRun *run, double horizon, gboolean *jumps, GError **error);

/* After a step: counts it, and looks into the books now and then. FALSE where the run has to stop. */
gboolean tinker_island_run_watch(TinkerIslandRun *run, const TinkerStepReport *report, GError **error);

/* Ends the run at t, a time within the last step: the state, the summary and its last look into the books are of that
 * time, and no step follows. FALSE where the books say that the run diverged. */
gboolean tinker_island_run_close(TinkerIslandRun *run, double t, GError **error);

#endif
