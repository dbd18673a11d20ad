/* Small dense systems that may be singular: elimination with complete pivoting. */
#ifndef TINKER_NUMERICS_PIVOTED_SOLVE_H
#define TINKER_NUMERICS_PIVOTED_SOLVE_H

#include <stdint.h>

/* Solves A x = b for A of n x n by rows, which is lost; x takes the place of b. Pivots below `smallest` times the
 * largest entry count as 0: the unknowns that are left then become 0, and whether the other equations hold is for the
 * caller to see. `order` is room for n. Answers the rank. */
int32_t tinker_pivoted_solve(int32_t n, double *matrix, double *b, int32_t *order, double smallest);

#endif
