/* The choice of `auto`, and what a method that is named shares of it. */
#ifndef TINKER_CORE_PLAN_AUTOMATIC_H
#define TINKER_CORE_PLAN_AUTOMATIC_H

#include "physics/plan/plan-private.h"

/* The error that the plan aims at where an accuracy is asked for: the estimate of a run claims twice what it sees, and
 * what is expected beforehand is rough. */
double tinker_plan_aim(const TinkerRunOptions *options);

/* Whether the energy is to be held after every step of this method: nothing changes it, and the run is so long that its
 * drift would count. Straight and linear motion has exact solutions. */
gboolean tinker_plan_holds_energy(const TinkerIsland *island, const TinkerRunOptions *options,
                                  const TinkerForecast *forecast, const TinkerIntegrator *method);

/* The tolerance that a method is to be taken at: the one asked for, or that at which the run is expected to end with
 * the accuracy asked for. That of a method of fixed step is what its run may miss. */
double tinker_plan_tolerance(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                             const TinkerRunOptions *options);

/* Adds to the reason, where one is asked for, that the energy is held. */
void tinker_plan_explain_holding(const TinkerDecision *decision);

/* Fills the decision by what meets the tolerance, or the accuracy asked for, at the least cost. */
void tinker_plan_decide_automatically(const TinkerIsland *island, const TinkerRunOptions *options,
                                      const TinkerForecast *forecast, TinkerDecision *decision);

#endif
