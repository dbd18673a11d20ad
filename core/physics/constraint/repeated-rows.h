/* Rows that repeat others at every state: those of blocks of one class that are on the same places and say the same, as
 * two pins in one hole do. The columns of such a row are those of the first that says so, up to a sign. With n of them,
 * c their signs and S of the first alone,
 *
 *     c S c^T lambda = b,  which lambda = c mu / n solves with S mu = c . b / n,
 *
 * of all multipliers those of least norm, with what the rows disagree in left over. So only the first of them is in the
 * matrix, and what depends on other rows depends on them as if it were alone. */
#ifndef TINKER_CORE_REPEATED_ROWS_H
#define TINKER_CORE_REPEATED_ROWS_H

#include "physics/model/model-data.h"

/* Finds them, before the pattern of the matrix is compiled. FALSE: there is no memory. */
gboolean tinker_repeated_rows_find(TinkerModel *model);
/* Once it is: where they stand in it. */
void tinker_repeated_rows_place(TinkerConstraints *constraints);

/* From demands b of all rows those of the first ones; 0 for the others. Answers the largest disagreement. */
double tinker_repeated_rows_fold(const TinkerConstraints *constraints, double *b);
/* From multipliers of the first ones those of all rows: equal shares. */
void tinker_repeated_rows_spread(const TinkerConstraints *constraints, double *x);

/* Whether a row is one of them. */
static inline gboolean tinker_row_repeats(const TinkerConstraints *all, int32_t row)
{
    return all->repeats != NULL && all->repeats[row];
}

#endif
