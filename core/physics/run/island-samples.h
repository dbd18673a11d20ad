/* Bringing the whole model to where the runs of its islands are. */
#ifndef TINKER_CORE_ISLAND_SAMPLES_H
#define TINKER_CORE_ISLAND_SAMPLES_H

#include "physics/island/island-run.h"
#include "physics/run/island-runs.h"

/* Notes where the bodies of one island are at t, which lies in its last step, and how what they touched turned them. */
TinkerStatus tinker_island_runs_collect(TinkerIslandRuns *runs, TinkerIslandRun *run, double t);

/* Where the islands are stepped apart, the whole model's contacts are closed as theirs are. */
gboolean tinker_island_runs_gather_contacts(TinkerIslandRuns *runs, GError **error);

/* The whole model's coordinate that one of an island's is. */
int32_t tinker_island_runs_coordinate(const TinkerIslandRuns *runs, const TinkerIslandRun *run, int32_t coordinate);

/* A state of the bodies of one island, among all: the others' stay as they are. */
void tinker_island_runs_spread(const TinkerIslandRuns *runs, const TinkerIslandRun *run, const double *part_q,
                               const double *part_v, double *q, double *v);

#endif
