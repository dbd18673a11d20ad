/* The stable step, estimated anew while a run goes on: what was stable at the start need not be so where springs have
 * turned or stretched. */
#ifndef TINKER_CORE_STABILITY_WATCH_H
#define TINKER_CORE_STABILITY_WATCH_H

#include "physics/system/system.h"

typedef struct _TinkerStabilityWatch TinkerStabilityWatch;

/* For the state in the model's points. NULL where there is nothing to watch: the method takes any step, the forces are
 * linear, or the step is too long from the start, which was said before the run. All memory is allotted here. (transfer
 * full) */
TinkerStabilityWatch *tinker_stability_watch_new(const TinkerModelSystem *system, const TinkerIntegrator *method,
                                                 double step);
void tinker_stability_watch_free(TinkerStabilityWatch *watch);

/* Looks at the state in the model's points, once in a while: most calls do nothing. The first time that the step comes
 * near the stable one it answers that (s), else 0, as with NULL. */
double tinker_stability_watch_look(TinkerStabilityWatch *watch);

#endif
