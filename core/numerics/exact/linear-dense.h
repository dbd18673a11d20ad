/* Products of small dense matrices, by rows. */
#ifndef TINKER_NUMERICS_LINEAR_DENSE_H
#define TINKER_NUMERICS_LINEAR_DENSE_H

#include <stdint.h>

/* A matrix somewhere in memory: entry (i, j) is at[i * row + j * step]; step = 1 but for a transposed one. */
typedef struct {
    const double *at;
    int32_t row, step;
} TinkerDense;

static inline TinkerDense tinker_dense(const double *at, int32_t row)
{
    return (TinkerDense){at, row, 1};
}

static inline TinkerDense tinker_dense_transposed(const double *at, int32_t row)
{
    return (TinkerDense){at, 1, row};
}

/* c = a b, or c += a b where `add` is not 0; `a` is rows x inner, `b` is inner x columns with step 1, rows of c
 * lie c_row doubles apart. c overlaps neither. */
void tinker_dense_multiply(int32_t rows, int32_t inner, int32_t columns, TinkerDense a, TinkerDense b, double *c,
                           int32_t c_row, int add);

/* y = a x for a of rows x columns, by rows without gaps. */
void tinker_dense_apply(int32_t rows, int32_t columns, const double *a, const double *x, double *y);

#endif
