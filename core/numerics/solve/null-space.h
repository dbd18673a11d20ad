/* The motions that rows allow, and those that they ask for. */
#ifndef TINKER_NUMERICS_NULL_SPACE_H
#define TINKER_NUMERICS_NULL_SPACE_H

#include <glib.h>

/* The decomposition A^T P = Q R of a matrix A of `rows` rows and `size` columns: its rows in the order of what is left
 * of them. */
typedef struct {
    int32_t size, rows, rank;
    double *q; /* size by size, column by column: the first `rank` columns span what the rows determine, the others what
                  they allow */
    double *r; /* size by rows; upper triangular in its first `rank` rows */
    int32_t *pivot; /* rows: from 0 */
} TinkerNullSpace;

/* Opens one with room for the rows of A, one behind the other, in `r`: to be filled in. */
void tinker_null_space_open(TinkerNullSpace *space, int32_t rows, int32_t size);

/* Decomposes what was filled in. FALSE where a number is not finite or the decomposition fails. Rows that depend on
 * others are normal. */
gboolean tinker_null_space_find(TinkerNullSpace *space);

void tinker_null_space_clear(TinkerNullSpace *space);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerNullSpace, tinker_null_space_clear)

#endif
