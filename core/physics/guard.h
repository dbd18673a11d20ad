/* The guard: what to say about a run that left the numbers' range. */
#ifndef TINKER_CORE_GUARD_H
#define TINKER_CORE_GUARD_H

#include "physics/model-private.h"

/* The stiffest part of a model at its start. */
typedef struct {
    double frequency;     /* rad/s: of the largest natural frequency, were there no constraints; from below */
    double damping_rate;  /* 1/s: of the largest damping over mass */
    TinkerBlockId block;  /* the connector to blame; TINKER_NO_BLOCK where there is none */
    const char *property; /* its property that makes it stiff */
} TinkerStiffness;

TinkerStiffness tinker_guard_stiffness(TinkerModel *model);

/* The largest stable step of a fixed-step explicit method for it; INFINITY where nothing limits it. */
double tinker_guard_stable_step(const TinkerStiffness *stiffness, const TinkerIntegrator *integrator);

/* One sentence for a run that diverged: block, property, stable step, and what may help. (transfer full) */
char *tinker_guard_explain(TinkerModel *model, const TinkerIntegrator *integrator, double step);

#endif
