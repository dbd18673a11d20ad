/* A trial: the first steps of a run, counted before the plan tells what the whole of it will take. What a force that
 * jumps, a contact or a swing through the vertical asks for shows in no frequency of the start. */
#ifndef TINKER_CORE_PLAN_TRIAL_H
#define TINKER_CORE_PLAN_TRIAL_H

#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

/* As tinker_plan_new, but what the run takes is told by a trial instead of the forecast alone. The islands are left in
 * some state of the motion. (transfer full) */
TinkerPlan *tinker_plan_new_counted(TinkerModel *model, GPtrArray *islands, const TinkerRunOptions *options,
                                    GError **error);

#endif
