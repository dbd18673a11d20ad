/* The motions that constraints allow, and those that they ask for. */
#ifndef TINKER_ANALYSIS_NULL_SPACE_PRIVATE_H
#define TINKER_ANALYSIS_NULL_SPACE_PRIVATE_H

#include "physics/linearise/linearise.h"

/* The decomposition M^-1/2 J^T P = Q R by columns in the order of what is left of them. */
typedef struct {
    int32_t size, rows, rank;
    double *q; /* size by size: the first `rank` columns span what the rows determine, the others what they allow */
    double *r; /* size by rows; upper triangular in its first `rank` rows */
    int32_t *pivot; /* rows: from 0 */
} TinkerNullSpace;

/* FALSE where the decomposition fails. Rows that depend on others are normal. Clear it either way. */
gboolean tinker_null_space_find(TinkerNullSpace *space, const TinkerLinearisation *linear);
void tinker_null_space_clear(TinkerNullSpace *space);

#endif
