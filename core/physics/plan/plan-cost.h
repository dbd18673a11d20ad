/* What a method is expected to cost on an island. */
#ifndef TINKER_CORE_PLAN_COST_H
#define TINKER_CORE_PLAN_COST_H

#include "physics/plan/forecast.h"
#include "physics/plan/run-options.h"

/* What a method is expected to cost on an island, and to miss. */
typedef struct {
    double step;        /* s, of a fixed-step method: as asked for, or as the tolerance wants it */
    double steps;       /* of the whole run */
    double evaluations; /* likewise */
    double operations;  /* likewise, of its steps */
    double sample;      /* operations of one sample */
    double error;       /* relative to the scales */
} TinkerCost;

/* The tolerance that an explicit adaptive method keeps at the same cost, as stability makes its steps small anyway: at
 * most the one asked for. Energies that strong dampers take are known far worse than places are at a loose one. */
double tinker_free_tolerance(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                             double tolerance);

/* Of a run by this method. A fixed-step method with `step` 0 takes the one that `tolerance` wants.
 * FALSE where the method does not suit the island. */
gboolean tinker_cost_of(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                        const TinkerRunOptions *options, double step, double tolerance, TinkerCost *cost);

/* The interval (s) of an exact solution of a linear island: see tinker_exact_interval. */
double tinker_cost_interval(const TinkerIsland *island, const TinkerRunOptions *options);

/* The number of two digits below x, so that a message suggests a step that can be typed. */
double tinker_round_down(double x);

#endif
