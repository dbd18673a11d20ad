/* Operations that runs take: of each thing that is counted in them. */
#ifndef TINKER_CORE_OPERATIONS_H
#define TINKER_CORE_OPERATIONS_H

#include "physics/plan/islands.h"

/* Seconds that an operation takes on the machine that the counts were calibrated on. */
#define TINKER_SECONDS_PER_OPERATION 2.5e-10

/* Of so many steps of an explicit method with so many evaluations in them, less their Newton steps towards constraint
 * rows. */
double tinker_operations_explicit(const TinkerIsland *island, double steps, double evaluations);
/* Of one step of an implicit method, less the same. */
double tinker_operations_implicit(const TinkerIsland *island);
/* Of so many steps of an exact solution. */
double tinker_operations_exact(const TinkerIsland *island, double steps);
/* Of one sample, by a method that makes steps, and by an exact solution. */
double tinker_operations_sample(const TinkerIsland *island);
double tinker_operations_exact_sample(const TinkerIsland *island);

/* What was counted of a run, or is expected. */
typedef struct {
    double steps, evaluations;
    double looks;       /* states that were looked at in search of contacts */
    double corrections; /* Newton steps by which positions came back onto constraint rows */
} TinkerCounts;

/* Operations of each thing that is counted, and before the first. */
typedef struct {
    double once, step, evaluation, look, correction;
} TinkerOperationRates;

/* Those of a method that suits the island. */
TinkerOperationRates tinker_operations_rates(const TinkerIsland *island, const TinkerIntegrator *method);
/* Operations of what was counted; and of samples, by a method that suits the island. */
double tinker_operations_counted(const TinkerOperationRates *rates, const TinkerCounts *counts);
double tinker_operations_samples(const TinkerIsland *island, const TinkerIntegrator *method, double samples);

#endif
