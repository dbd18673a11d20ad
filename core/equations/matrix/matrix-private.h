/* Work on the numbers of a matrix form. */
#ifndef TINKER_CORE_EQUATION_MATRIX_PRIVATE_H
#define TINKER_CORE_EQUATION_MATRIX_PRIVATE_H

#include "equations/matrix/matrix.h"

/* A matrix by rows. (transfer full) */
double *tinker_matrix_numbers(const TinkerEquations *equations, const TinkerMatrixIsland *island,
                              TinkerMatrixKind kind);

/* Fills omega, zeta, decay and unstable. */
void tinker_matrix_roots(const TinkerEquations *equations, TinkerMatrixIsland *island);

/* Whether it has no damping, and K is symmetric. */
gboolean tinker_matrix_is_symmetric(const TinkerEquations *equations, const TinkerMatrixIsland *island);

/* Counts from rest where K is regular: fills `about` by the constant loads, and leaves those that vary in `load`. */
void tinker_matrix_count_from_rest(const TinkerEquations *equations, TinkerMatrixIsland *island);

/* matrix-sparse.c: entries by their numbers, for islands with many coordinates. */
void tinker_matrix_sparse_init(TinkerMatrixIsland *island);
/* Adds to one; uses the expression up. */
void tinker_matrix_sparse_add(TinkerMatrixIsland *island, TinkerMatrixKind kind, guint number, TinkerExpression *more);

#endif
