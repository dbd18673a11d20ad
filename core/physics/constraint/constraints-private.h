/* What the files of the solve share: the factor of S = J M^-1 J^T, and products with J. */
#ifndef TINKER_CORE_CONSTRAINTS_PRIVATE_H
#define TINKER_CORE_CONSTRAINTS_PRIVATE_H

#include "physics/constraint/constraints.h"

/* Whether the factor is of the rows evaluated last. The matrix depends on the Jacobian alone, so the factor is kept as
 * long as that stays the same to the bit: after a projection the next step's first stage needs no other. */
gboolean tinker_constraints_are_factored(const TinkerConstraints *all);

/* Factors S of the rows evaluated last and solves with it, in place of b; FALSE, with b as it was, where the factor had
 * to be shifted. */
gboolean tinker_constraints_factor_and_solve(TinkerConstraints *all, double *b);

/* Solves with the factor at hand, in place of b. */
void tinker_constraints_substitute(TinkerConstraints *all, double *b);

/* Factors S + eps I of the rows evaluated last. */
void tinker_constraints_factor_shifted(TinkerConstraints *all);

/* Adds M^-1 J^T x to the target, of one entry a coordinate. */
void tinker_constraints_add_impulse(TinkerModel *model, const double *restrict x, double *restrict target);

#endif
