/* Quantities that add up along a run: the lengths of paths, and the energy that was taken and given. They are worked
 * out on the dense output of every step, so that how often a run is sampled does not matter. */
#ifndef TINKER_CORE_ALONG_RUN_H
#define TINKER_CORE_ALONG_RUN_H

#include "physics/island/island-run.h"

typedef struct _TinkerAlongRun TinkerAlongRun;

/* For those of the columns (TinkerColumn) that add up; NULL where there is none. The model is that of the whole scene,
 * the runs (TinkerIslandRun) those of its islands; all are borrowed. (transfer full) */
TinkerAlongRun *tinker_along_run_new(TinkerModel *model, const GPtrArray *runs, const GArray *columns);
void tinker_along_run_free(TinkerAlongRun *along);

/* Goes along the island's path up to t, which lies within its last step, or to its end: before it makes another, and
 * at a sample. */
TinkerStatus tinker_along_run_follow(TinkerAlongRun *along, guint island, double t);

/* The values at t, up to which all islands were followed, by column. The state at t is in the points of the model. */
TinkerStatus tinker_along_run_values(TinkerAlongRun *along, double t, double *values);

#endif
