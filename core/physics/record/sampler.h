/* The values of columns at one instant, through the blocks' graph interfaces. */
#ifndef TINKER_CORE_SAMPLER_H
#define TINKER_CORE_SAMPLER_H

#include "physics/model/model.h"

typedef struct _TinkerSampler TinkerSampler;

/* For these columns (of TinkerColumn; NULL: none), which are borrowed. (transfer full) */
TinkerSampler *tinker_sampler_new(TinkerModel *model, const GArray *columns);
void tinker_sampler_free(TinkerSampler *sampler);

/* Evaluates the model at a state (relative to its origin) and writes one value a column. Values that are not finite are
 * failures. */
TinkerStatus tinker_sampler_values(TinkerSampler *sampler, double t, const double *q, const double *v, double *values);

/* Evaluates the model at a state, with what touches as it is closed now: `a` (m/s^2) gets the accelerations of the
 * bodies, 2 each; multipliers and forces of contacts are left where they are kept. Changes no bit of a run that stands
 * there. */
TinkerStatus tinker_sampler_look_at(TinkerModel *model, double t, const double *q, const double *v, double *a);

#endif
