/* Products of small dense matrices: tiles of sums stay in registers. Every entry is summed in the order of the inner
 * index, so that its bits depend neither on the tiling nor on the vector width. */
#include "numerics/exact/linear-dense.h"

#include <tinker/types.h>

#define TILE_ROWS 2
#define WIDE      20 /* columns of a tile: GCC 12 keeps the sums of this one in registers, not those of many others */
#define NARROW    4

static inline __attribute__((always_inline)) void tile(const int rows, const int columns, int32_t inner, TinkerDense a,
                                                       TinkerDense b, double *restrict c, int32_t c_row, int add)
{
    double sum[TILE_ROWS][WIDE] = {{0.0}};
    for (int32_t k = 0; k < inner; k++) {
        const double *restrict from = b.at + (int64_t)k * b.row;
        for (int r = 0; r < rows; r++) {
            double factor = a.at[(int64_t)r * a.row + (int64_t)k * a.step];
            for (int s = 0; s < columns; s++)
                sum[r][s] += factor * from[s];
        }
    }
    for (int r = 0; r < rows; r++)
        for (int s = 0; s < columns; s++)
            c[(int64_t)r * c_row + s] = add ? c[(int64_t)r * c_row + s] + sum[r][s] : sum[r][s];
}

/* All rows of some columns. */
static inline __attribute__((always_inline)) void strip(int32_t rows, const int columns, int32_t inner, TinkerDense a,
                                                        TinkerDense b, double *c, int32_t c_row, int add)
{
    int32_t i = 0;
    for (; i + TILE_ROWS <= rows; i += TILE_ROWS) {
        TinkerDense left = {a.at + (int64_t)i * a.row, a.row, a.step};
        tile(TILE_ROWS, columns, inner, left, b, c + (int64_t)i * c_row, c_row, add);
    }
    for (; i < rows; i++) {
        TinkerDense left = {a.at + (int64_t)i * a.row, a.row, a.step};
        tile(1, columns, inner, left, b, c + (int64_t)i * c_row, c_row, add);
    }
}

/* Of a column and a row: nothing is summed up. */
static inline __attribute__((always_inline)) void multiply_outer(int32_t rows, int32_t columns, TinkerDense a,
                                                                 const double *restrict b, double *restrict c,
                                                                 int32_t c_row, int add)
{
    for (int32_t i = 0; i < rows; i++) {
        double factor = a.at[(int64_t)i * a.row], *restrict to = c + (int64_t)i * c_row;
        for (int32_t j = 0; j < columns; j++)
            to[j] = add ? to[j] + factor * b[j] : factor * b[j];
    }
}

TINKER_VARIANTS
void tinker_dense_multiply(int32_t rows, int32_t inner, int32_t columns, TinkerDense a, TinkerDense b, double *c,
                           int32_t c_row, int add)
{
    int32_t j = 0;
    if (inner == 1) {
        multiply_outer(rows, columns, a, b.at, c, c_row, add);
        return;
    }
    for (; j + WIDE <= columns; j += WIDE)
        strip(rows, WIDE, inner, a, (TinkerDense){b.at + j, b.row, 1}, c + j, c_row, add);
    for (; j + NARROW <= columns; j += NARROW)
        strip(rows, NARROW, inner, a, (TinkerDense){b.at + j, b.row, 1}, c + j, c_row, add);
    for (; j < columns; j++)
        strip(rows, 1, inner, a, (TinkerDense){b.at + j, b.row, 1}, c + j, c_row, add);
}

/* Four sums side by side, whatever the vector width: always the same order. */
TINKER_VARIANTS
void tinker_dense_apply(int32_t rows, int32_t columns, const double *a, const double *x, double *y)
{
    for (int32_t i = 0; i < rows; i++) {
        const double *restrict row = a + (int64_t)i * columns;
        double sum[4] = {0.0};
        int32_t j = 0;
        for (; j + 4 <= columns; j += 4)
            for (int s = 0; s < 4; s++)
                sum[s] += row[j + s] * x[j + s];
        for (; j < columns; j++)
            sum[0] += row[j] * x[j];
        y[i] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }
}
