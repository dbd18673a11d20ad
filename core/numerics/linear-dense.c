/* Products of small dense matrices: tiles of 4 x 8 sums stay in registers, the rest goes entry by entry. Every
 * entry is summed in the order of the inner index, so that its bits depend neither on the tiling nor on the vector
 * width. */
#include "numerics/linear-dense.h"

#include <tinker/types.h>

#define TILE_ROWS    4
#define TILE_COLUMNS 8

static inline __attribute__((always_inline)) void tile(int rows, int32_t inner, TinkerDense a, TinkerDense b,
                                                       double *restrict c, int32_t c_row, int add)
{
    double sum[TILE_ROWS][TILE_COLUMNS] = {{0.0}};
    for (int32_t k = 0; k < inner; k++) {
        const double *restrict from = b.at + (int64_t)k * b.row;
        for (int r = 0; r < rows; r++) {
            double factor = a.at[(int64_t)r * a.row + (int64_t)k * a.step];
            for (int s = 0; s < TILE_COLUMNS; s++)
                sum[r][s] += factor * from[s];
        }
    }
    for (int r = 0; r < rows; r++)
        for (int s = 0; s < TILE_COLUMNS; s++)
            c[(int64_t)r * c_row + s] = add ? c[(int64_t)r * c_row + s] + sum[r][s] : sum[r][s];
}

/* The last columns. */
static inline __attribute__((always_inline)) void edge(int32_t rows, int32_t inner, int32_t columns, TinkerDense a,
                                                       TinkerDense b, double *restrict c, int32_t c_row, int add)
{
    for (int32_t i = 0; i < rows; i++) {
        for (int32_t j = 0; j < columns; j++) {
            double sum = 0.0;
            for (int32_t k = 0; k < inner; k++)
                sum += a.at[(int64_t)i * a.row + (int64_t)k * a.step] * b.at[(int64_t)k * b.row + j];
            c[(int64_t)i * c_row + j] = add ? c[(int64_t)i * c_row + j] + sum : sum;
        }
    }
}

TINKER_VARIANTS
void tinker_dense_multiply(int32_t rows, int32_t inner, int32_t columns, TinkerDense a, TinkerDense b, double *c,
                           int32_t c_row, int add)
{
    int32_t whole = columns - columns % TILE_COLUMNS;
    for (int32_t j = 0; j < whole; j += TILE_COLUMNS) {
        TinkerDense right = {b.at + j, b.row, 1};
        int32_t i = 0;
        for (; i + TILE_ROWS <= rows; i += TILE_ROWS) {
            TinkerDense left = {a.at + (int64_t)i * a.row, a.row, a.step};
            tile(TILE_ROWS, inner, left, right, c + (int64_t)i * c_row + j, c_row, add);
        }
        for (; i < rows; i++) {
            TinkerDense left = {a.at + (int64_t)i * a.row, a.row, a.step};
            tile(1, inner, left, right, c + (int64_t)i * c_row + j, c_row, add);
        }
    }
    TinkerDense right = {b.at + whole, b.row, 1};
    edge(rows, inner, columns - whole, a, right, c + whole, c_row, add);
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
