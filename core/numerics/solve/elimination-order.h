/* In which order the rows of a sparse symmetric matrix are eliminated, so that its factor gets few entries that the
 * matrix has not. Private to the factors.
 *
 * Source: Amestoy, Davis, Duff, "An approximate minimum degree ordering algorithm", SIAM J. Matrix Anal. Appl. 17
 * (1996). */
#ifndef TINKER_CORE_ELIMINATION_ORDER_H
#define TINKER_CORE_ELIMINATION_ORDER_H

#include <glib.h>

/* The pattern by columns, both triangles without the diagonal, sorted and without repetition: the neighbours of row i
 * are entries[starts[i]] to entries[starts[i + 1] - 1]. */
typedef struct {
    int n;
    int *starts, *entries;
} TinkerNeighbours;

/* Of order n with the off-diagonal places (rows[k], columns[k]), each pair once or more, in either triangle. FALSE: no
 * memory. To be cleared either way. */
gboolean tinker_neighbours_init(TinkerNeighbours *by, int n, const int *rows, const int *columns, gsize count);
void tinker_neighbours_clear(TinkerNeighbours *by);

/* Takes leaves away in turns, so that a chain is eliminated from both ends at once: `sequence` gets the rows in this
 * order, `parents` for each of them the row that it hung on then, itself where it hung on none. Answers how many were
 * taken: all, unless a cycle is left over; -1: no memory. */
int tinker_neighbours_peel(const TinkerNeighbours *by, int *sequence, int *parents);

/* Orders by approximate minimum degree, the last `border` rows behind all others. FALSE: no memory. */
gboolean tinker_neighbours_order(const TinkerNeighbours *by, int border, int *sequence);

/* As qsort and bsearch ask for it. */
static inline int tinker_compare_ints(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Sorts ascending; each is kept once. Answers how many there are then. */
gsize tinker_sort_uniquely(int *values, gsize count);

#endif
