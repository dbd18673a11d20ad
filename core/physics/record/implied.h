/* Quantities that no plugin declares, worked out from the state of a model: angles and lengths of what has two ends,
 * distances, and the energies and momenta of the whole scene. */
#ifndef TINKER_CORE_IMPLIED_H
#define TINKER_CORE_IMPLIED_H

#include "physics/model/model.h"

/* Of columns (TinkerColumn) those that are implied and that a state alone tells; the others are left alone. */
typedef struct _TinkerImplied TinkerImplied;
/* NULL where there is none of them. (transfer full) */
TinkerImplied *tinker_implied_new(TinkerModel *model, const GArray *columns);
void tinker_implied_free(TinkerImplied *implied);

/* The values for a state that is in the model's points, by column. */
TinkerStatus tinker_implied_values(const TinkerImplied *implied, const double *q, const double *v, double *values);

#endif
