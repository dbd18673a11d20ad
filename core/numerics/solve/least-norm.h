/* Dense systems of any rank, solved by the x of least norm that minimises |A x - b|: as LAPACK's xGELSY, with a factor
 * that is kept, so that it is made once for all right-hand sides of a matrix. Allots nothing.
 *
 * Source: G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th edition, sections 5.4.7 and 5.5.2: the complete
 * orthogonal factorisation A P = Q (T 0; 0 0) Z, by a QR with columns in the order of what is left of them. Its rank is
 * where the triangle R begins to be dependent, by an estimate of its condition: C. H. Bischof, "Incremental Condition
 * Estimation", SIAM Journal on Matrix Analysis and Applications 11 (1990) 312-322. */
#ifndef TINKER_NUMERICS_LEAST_NORM_H
#define TINKER_NUMERICS_LEAST_NORM_H

#include <glib.h>

/* Doubles of room for order n. */
int32_t tinker_least_norm_room(int32_t n);

/* Factors a matrix by columns (n by n), in its place; singular values below `dependent` of the largest count as 0.
 * `order` gets n entries, the room what the solve needs besides. Answers the rank. */
int32_t tinker_least_norm_factor(int32_t n, double *matrix, double dependent, int32_t *order, double *room);

/* x in place of b, by the factor. */
void tinker_least_norm_solve(int32_t n, int32_t rank, const double *factor, const int32_t *order, double *room,
                             double *b);

#endif
