/* What the files that check the start of a model share. */
#ifndef TINKER_CORE_START_PRIVATE_H
#define TINKER_CORE_START_PRIVATE_H

#include "physics/model/model.h"

/* Whether the start positions nearly fit the constraints that were evaluated there; what does not is refused by name.
 */
gboolean tinker_start_check_positions(const TinkerModel *model, GError **error);

/* Of each row: the largest sum of what its ends by themselves, as `by_point` has them move, and its own term ask for:
 * where they cancel each other, rounding of it is all that is left. */
void tinker_start_demands(const TinkerModel *model, const double *by_point, const double *terms, double *demand);

/* Bring velocities from `given`, and accelerations from the applied ones on, to the rows, with the shift that misses
 * least of them: what is missed, as a share of what is asked. The answer is `found`. */
double tinker_start_meet_velocities(TinkerModel *model, const double *given, double *found);
double tinker_start_meet_accelerations(TinkerModel *model, const double *applied, double *found);

/* Makes the shift so small that the softest motions are held as well. */
void tinker_start_reach_soft_motions(TinkerModel *model);

#endif
