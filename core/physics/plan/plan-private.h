/* What the files of the plan share. */
#ifndef TINKER_CORE_PLAN_PRIVATE_H
#define TINKER_CORE_PLAN_PRIVATE_H

#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-cost.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

/* A part is under-resolved where h omega is above this. */
#define TINKER_LEAST_RESOLVED 0.5
/* A method that misses the tolerance by more does not meet it. */
#define TINKER_MEETS 2.0

/* How a method was come by. */
typedef struct {
    TinkerChoice choice;
    TinkerCost cost;
    GString *reason;        /* a sentence; NULL: not asked for */
    double speed_of_change; /* rad/s: of the forecast, where one was made */
} TinkerDecision;

/* As tinker_plan_choose. `spectrum` may be NULL: it is worked out where a step is near a limit. */
gboolean tinker_decide(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerSpectrum *spectrum,
                       TinkerDecision *decision, GPtrArray *warnings, GError **error);

/* FALSE, with what to change in `error`, where the island has what contacts as impulses do not know. */
gboolean tinker_plan_check_impulses(const TinkerIsland *island, GError **error);

/* A step (s) that is stable and resolves what carries energy; `stable` may be INFINITY. */
double tinker_advised_step(const TinkerForecast *forecast, double stable);

/* Sentences about a whole model. */
void tinker_plan_describe(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options);

#endif
