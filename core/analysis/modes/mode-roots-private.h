/* The roots of coupled modes, and what they are made of. */
#ifndef TINKER_ANALYSIS_MODE_ROOTS_PRIVATE_H
#define TINKER_ANALYSIS_MODE_ROOTS_PRIVATE_H

#include "analysis/modes/complex-numbers.h"
#include "analysis/modes/modal-basis.h"

typedef struct {
    double complex s;
    double complex *shape; /* by the members of the group */
} TinkerModeRoot;

/* Modes of a basis that damping or following forces couple. */
typedef struct {
    const TinkerModalBasis *basis;
    const int32_t *members;
    int32_t count;
} TinkerModeGroup;

/* The groups of a basis: how many members each has (of int32_t), their numbers one after another in `order` (count
 * entries). (transfer full) */
GArray *tinker_mode_groups(const TinkerModalBasis *basis, int32_t *order);

/* The group as a system of first order, z' = A z, column by column; the last `count` states are the velocities.
 * (transfer full) */
double *tinker_mode_state_matrix(const TinkerModeGroup *group, int32_t *order);

/* Roots with Im s >= 0 but for those at 0, which rigid motions make; of TinkerModeRoot *, which they free. NULL where
 * they do not converge. (transfer full) */
GPtrArray *tinker_mode_roots(const TinkerModeGroup *group);

#endif
