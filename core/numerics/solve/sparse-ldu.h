/* Sparse L D U of matrices whose pattern is symmetric and never changes, but whose values are not symmetric: as
 * sparse-ldl.h, with the same order of elimination and the same list of updates, for both triangles at once. No rows
 * are exchanged: whoever asks for a factor says how small a pivot he can live with, and mends what rounding left
 * (iterative refinement). */
#ifndef TINKER_CORE_SPARSE_LDU_H
#define TINKER_CORE_SPARSE_LDU_H

#include <glib.h>

typedef struct _TinkerSparseLdu TinkerSparseLdu;

/* As tinker_sparse_ldl_new. (transfer full) */
TinkerSparseLdu *tinker_sparse_ldu_new(int n, const int *rows, const int *columns, gsize count);
void tinker_sparse_ldu_free(TinkerSparseLdu *ldu);

/* Where the entry (row, column) is to be added up in the values; of the pattern both (row, column) and (column, row).
 */
int tinker_sparse_ldu_slot(const TinkerSparseLdu *ldu, int row, int column);

/* The values to assemble into: set to 0 by clear. */
double *tinker_sparse_ldu_values(TinkerSparseLdu *ldu);
void tinker_sparse_ldu_clear(TinkerSparseLdu *ldu);

/* Factors in place, and solves for b in place. A pivot no larger than `least` (of its row, n entries) stops it: FALSE,
 * and b is lost. */
gboolean tinker_sparse_ldu_factor_and_solve(TinkerSparseLdu *ldu, const double *least, double *b);

/* Solves with the last factor, in place. */
void tinker_sparse_ldu_solve(TinkerSparseLdu *ldu, double *b);

/* Entries of L below the diagonal that are kept; U has as many. */
gsize tinker_sparse_ldu_fill(const TinkerSparseLdu *ldu);

#endif
