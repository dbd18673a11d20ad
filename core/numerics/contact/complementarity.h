/* Linear complementarity problems: find z with
 *
 *     w = M z + q,   w >= 0,   z >= 0,   w . z = 0.
 *
 * By Lemke's method: complementary pivots along the path that a covering vector opens, with constants that are set
 * apart by 1e-10 of the largest, so that ties never cycle. Source: Cottle, Pang, Stone, "The Linear Complementarity
 * Problem" (1992), sections 4.4, 4.9.
 */
#ifndef TINKER_NUMERICS_COMPLEMENTARITY_H
#define TINKER_NUMERICS_COMPLEMENTARITY_H

#include <stdint.h>

typedef enum {
    TINKER_LCP_SOLVED,
    TINKER_LCP_RAY,     /* the path ends in a ray: of a copositive-plus M that means that there is no solution */
    TINKER_LCP_GAVE_UP, /* more pivots than the cap, or a number that is none (then z is 0); or one that is a solution
                           with constants that are set apart, and not by the true ones: z is that */
} TinkerLcpResult;

/* Doubles of room that a problem of n unknowns needs. */
int64_t tinker_lcp_room(int32_t n);

/* `matrix` is n x n by rows; the unknowns go to z. What is solved is accurate to rounding: the basis that Lemke's path
 * ends in is solved once more from the matrix itself. */
TinkerLcpResult tinker_lcp_solve(int32_t n, const double *matrix, const double *q, double *z, double *room);

#endif
