/* Sparse L D L^T of symmetric matrices whose pattern never changes: ordered once (elimination-order.h), every update's
 * place worked out once, so that the numeric phase is a straight run over index lists. */
#ifndef TINKER_CORE_SPARSE_LDL_H
#define TINKER_CORE_SPARSE_LDL_H

#include <glib.h>

typedef struct _TinkerSparseLdl TinkerSparseLdl;

/* A matrix of order n with a full diagonal and the off-diagonal places (rows[k], columns[k]), each pair once or more,
 * in either triangle. NULL where the factor would be too large (errno EOVERFLOW), or there is no memory for it
 * (ENOMEM). (transfer full) */
TinkerSparseLdl *tinker_sparse_ldl_new(int n, const int *rows, const int *columns, gsize count);
/* One whose last `border` rows are eliminated behind all others: of a matrix (A C; C^T -B) with A and B positive
 * definite, any order of elimination has pivots, those of the border below 0. What many rows of C have in common
 * then costs as much as these rows are, where C B^-1 C^T added to A would be full. Source: R. J. Vanderbei,
 * "Symmetric quasidefinite matrices", SIAM J. Optimization 5 (1995) 100-113. (transfer full) */
TinkerSparseLdl *tinker_sparse_ldl_new_bordered(int n, int border, const int *rows, const int *columns, gsize count);
void tinker_sparse_ldl_free(TinkerSparseLdl *ldl);

/* Where the entry (row, column) is to be added up in the values. */
int tinker_sparse_ldl_slot(const TinkerSparseLdl *ldl, int row, int column);

/* The values to assemble into: set to 0 by clear. */
double *tinker_sparse_ldl_values(TinkerSparseLdl *ldl);
void tinker_sparse_ldl_clear(TinkerSparseLdl *ldl);

/* Adds `shift` to the diagonal, but for the border's, and factors in place. A pivot that falls to `threshold` times its
 * diagonal entry or below stops it: FALSE; of the border, one that is not below 0. */
gboolean tinker_sparse_ldl_factor(TinkerSparseLdl *ldl, double shift, double threshold);

/* Factors as tinker_sparse_ldl_factor does without a shift, and solves with it in place of b; on the way, where the
 * pattern allows it. On FALSE b is lost. */
gboolean tinker_sparse_ldl_factor_and_solve(TinkerSparseLdl *ldl, double threshold, double *b);

/* Factors in place, but for the border, and counts the pivots that fall to `threshold` times their diagonal entry or
 * below; such a row is left out. `dependent` (n entries, may be NULL) is set to 1 for each of them. The factor is of no
 * use for solving. */
int tinker_sparse_ldl_count_dependent(TinkerSparseLdl *ldl, double threshold, char *dependent);

/* After that: of the rows w that the rows left out have in the border once the others are eliminated the sum of w w^T,
 * as a matrix of the border's order by columns. Its rank, weighed by B^-1, is how many of them do not depend on others.
 */
void tinker_sparse_ldl_left_out(const TinkerSparseLdl *ldl, double *products);

/* Solves with the last factor, in place. */
void tinker_sparse_ldl_solve(TinkerSparseLdl *ldl, double *b);

/* Products that a factorisation takes off. */
gsize tinker_sparse_ldl_updates(const TinkerSparseLdl *ldl);

/* Entries of L below the diagonal that are kept. */
gsize tinker_sparse_ldl_fill(const TinkerSparseLdl *ldl);

#endif
