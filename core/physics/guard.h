/* The guard: what to say about a run that left the numbers' range. */
#ifndef TINKER_CORE_GUARD_H
#define TINKER_CORE_GUARD_H

#include "physics/model-private.h"

/* One sentence for a run that diverged: block, property, stable step, and what may help. (transfer full) */
char *tinker_guard_explain(TinkerModel *model, const TinkerIntegrator *integrator, double step);

#endif
