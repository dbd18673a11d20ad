/* The companion of a run: the same scene, off by rounding or by a known share of the run's own error. */
#ifndef TINKER_CORE_COMPANION_H
#define TINKER_CORE_COMPANION_H

#include "physics/island/island-run.h"
#include "physics/model/model.h"
#include "physics/run/island-runs.h"

/* What the error of an island's run is, in units of its distance from its companion; 0 where the run is off by rounding
 * alone, which nothing lets grow: such an island needs none. */
double tinker_companion_factor(const TinkerIslandRun *run);

/* Opens the companion of a simulation that has not taken a step, on a model of its own, which outlives it. (transfer
 * full) */
TinkerIslandRuns *tinker_companion_new(TinkerIslandRuns *runs, TinkerModel *model, GError **error);

/* The ends of an exact island of the companion, which may pass each other: as long as none do, there is nothing that
 * lets rounding grow, and the island is where the run's is. */
typedef struct _TinkerCompanionEnds TinkerCompanionEnds;

/* NULL where none can pass, or where the island is off from its start. The run is borrowed. (transfer full) */
TinkerCompanionEnds *tinker_companion_ends_new(TinkerIslandRun *run);
void tinker_companion_ends_free(TinkerCompanionEnds *ends);

/* To be called between steps: from the first on behind which ends have passed, the island is off by rounding. Answers
 * whether it was put off now, and then the ends are of no more use. */
gboolean tinker_companion_look_at_ends(TinkerCompanionEnds *ends);

#endif
