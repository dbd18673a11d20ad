#include "numerics/solve/pivoted-solve.h"

#include <math.h>

static void swap(double *a, double *b)
{
    double kept = *a;
    *a = *b;
    *b = kept;
}

/* The size of the largest, by four at a time that do not wait for one another; numbers that are none are passed over.
 */
static double largest_entry(int32_t count, const double *entries)
{
    double most[4] = {0, 0, 0, 0};
    int32_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (int lane = 0; lane < 4; lane++)
            most[lane] = fabs(entries[i + lane]) > most[lane] ? fabs(entries[i + lane]) : most[lane];
    for (; i < count; i++)
        most[0] = fabs(entries[i]) > most[0] ? fabs(entries[i]) : most[0];
    const double low = most[0] > most[1] ? most[0] : most[1], high = most[2] > most[3] ? most[2] : most[3];
    return low > high ? low : high;
}

/* Brings the largest entry of what is left to place (k, k), and answers its size. */
static double bring_pivot(int32_t n, double *matrix, double *b, int32_t *order, int32_t k)
{
    int32_t row = k, column = k;
    double largest = 0;
    for (int32_t i = k; i < n; i++) {
        const double most = largest_entry(n - k, matrix + i * n + k);
        if (!(most > largest)) continue;
        largest = most;
        row = i;
    }
    while (largest > 0 && fabs(matrix[row * n + column]) != largest)
        column++;
    if (row != k) {
        for (int32_t j = k; j < n; j++)
            swap(&matrix[row * n + j], &matrix[k * n + j]);
        swap(&b[row], &b[k]);
    }
    if (column != k) {
        for (int32_t i = 0; i < n; i++)
            swap(&matrix[i * n + column], &matrix[i * n + k]);
        int32_t kept = order[column];
        order[column] = order[k];
        order[k] = kept;
    }
    return largest;
}

int32_t tinker_pivoted_solve(int32_t n, double *matrix, double *b, int32_t *order, double smallest)
{
    int32_t rank = 0;
    double first = 0;
    for (int32_t i = 0; i < n; i++)
        order[i] = i;
    for (; rank < n; rank++) {
        double pivot = bring_pivot(n, matrix, b, order, rank);
        if (rank == 0) first = pivot;
        if (!(pivot > smallest * first)) break;
        for (int32_t i = rank + 1; i < n; i++) {
            double factor = matrix[i * n + rank] / matrix[rank * n + rank];
            if (factor == 0) continue;
            for (int32_t j = rank + 1; j < n; j++)
                matrix[i * n + j] -= factor * matrix[rank * n + j];
            b[i] -= factor * b[rank];
        }
    }
    for (int32_t i = rank; i < n; i++)
        b[i] = 0;
    for (int32_t i = rank - 1; i >= 0; i--) {
        for (int32_t j = i + 1; j < rank; j++)
            b[i] -= matrix[i * n + j] * b[j];
        b[i] /= matrix[i * n + i];
    }
    /* back from the order of the pivots: cycle by cycle */
    for (int32_t i = 0; i < n; i++)
        while (order[i] != i) {
            int32_t target = order[i];
            swap(&b[i], &b[target]);
            order[i] = order[target];
            order[target] = target;
        }
    return rank;
}
