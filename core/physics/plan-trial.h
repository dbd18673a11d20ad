/* A trial: the first steps of a run, counted before the plan tells what the whole of it will take. What a force that jumps,
 * a contact or a swing through the vertical asks for shows in no frequency of the start. */
#ifndef TINKER_CORE_PLAN_TRIAL_H
#define TINKER_CORE_PLAN_TRIAL_H

#include "physics/plan-private.h"

typedef struct {
    double share; /* of the run that was made, in time; 0: it could not begin */
    TinkerCounts counts;
} TinkerTrial;

/* Steps an island by `choice` until the run's end, or until about `operations` have been spent on it. By counts alone: the same
 * scene has the same trial on every machine. The model is left in some state of the motion. */
TinkerTrial tinker_trial_make(const TinkerIsland *island, const TinkerChoice *choice, const TinkerRunOptions *options,
                              double operations);

#endif
