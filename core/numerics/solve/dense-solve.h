/* Small dense systems A x = b that may be singular: by elimination where they are not, by the solution of least norm
 * (least squares, where they contradict themselves) where they are. Scale A so that its entries are about 1. */
#ifndef TINKER_NUMERICS_DENSE_SOLVE_H
#define TINKER_NUMERICS_DENSE_SOLVE_H

#include <stdint.h>

typedef struct TinkerDenseSolve TinkerDenseSolve;

/* Room for systems of n unknowns; NULL where there is no memory for it, or n is above 46340, whose n x n entries no
 * int32_t counts. (transfer full) */
TinkerDenseSolve *tinker_dense_solve_new(int32_t n);
void tinker_dense_solve_free(TinkerDenseSolve *solve);

/* What a pivot or a singular value of the matrices taken from here on is at least, beside the largest, to count as more
 * than 0; before, TINKER_DEPENDENT (rank.h). */
void tinker_dense_solve_set_dependent(TinkerDenseSolve *solve, double dependent);

/* Takes a matrix, n x n by rows; of the one that it has already it keeps the factors. Answers 0 where its rank is not
 * full. Allots nothing. */
int tinker_dense_solve_factor(TinkerDenseSolve *solve, const double *matrix);

/* Whether the rank of the matrix taken last was full; 0 before the first. */
int tinker_dense_solve_is_full(const TinkerDenseSolve *solve);

/* Solves for the matrix taken last, in place of b. Singular values that are dependent count as 0 (least-norm.h). Allots
 * nothing. */
void tinker_dense_solve(TinkerDenseSolve *solve, double *b);

/* Solves in place of b, nearest to `near` where the matrix is singular: its parts that nothing determines are those of
 * `near`. */
void tinker_dense_solve_near(TinkerDenseSolve *solve, const double *near, double *b);

#endif
