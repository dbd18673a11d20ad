/* The guard: what to say about a run that left the numbers' range. */
#ifndef TINKER_CORE_GUARD_H
#define TINKER_CORE_GUARD_H

#include "physics/model/model.h"

/* One sentence for a run that diverged: block, property, stable step, and what may help.
 * `accurate`: the steps are known to be no reason, and blocks whose plugins give forces and energy are doubted first.
 * (transfer full) */
char *tinker_guard_explain(TinkerModel *model, const TinkerIntegrator *integrator, double step, gboolean accurate);

/* The largest step (s) at which a method is stable, for the model linearised about its start; INFINITY where nothing
 * limits it, 0 where no step is stable, NAN where it is not known. Leaves the model in another state. */
double tinker_guard_stable_step(TinkerModel *model, const TinkerIntegrator *integrator);

#endif
