/* Elimination with row pivoting; least norms behind it. Pivots by rows alone may be far larger than the least singular
 * value: where one is small, complete pivoting tells the rank. */
#include "numerics/solve/dense-solve.h"

#include <glib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/least-norm.h"
#include "numerics/solve/pivoted-solve.h"
#include "numerics/solve/rank.h"

/* The largest n whose square is an int32_t. */
#define MOST_UNKNOWNS 46340
/* Of the largest entry: behind a smaller pivot the rank is looked at. */
#define SMALL_PIVOT 1e-2

struct TinkerDenseSolve {
    int32_t n;
    gboolean taken; /* a matrix was */
    gboolean full;  /* rank, of the matrix taken last */
    int32_t rank;   /* of one that is not full, once it is factored for least norms; else -1 */
    double dependent;
    double *matrix; /* its factors: by rows; for least norms by columns */
    double *given;  /* by columns */
    double *trial;  /* of one with a small pivot, for its rank */
    double *work;
    int32_t *pivots;
    int32_t *order;
};

TinkerDenseSolve *tinker_dense_solve_new(int32_t n)
{
    if (n > MOST_UNKNOWNS) return NULL;
    TinkerDenseSolve *solve = g_new0(TinkerDenseSolve, 1);
    gsize size = (gsize)MAX(n, 1);
    solve->n = n;
    solve->dependent = TINKER_DEPENDENT;
    solve->matrix = g_try_new0(double, size *size);
    solve->given = g_try_new0(double, size *size);
    solve->trial = g_try_new0(double, size *size);
    solve->work = g_try_new0(double, tinker_least_norm_room((int32_t)size));
    solve->pivots = g_try_new0(int32_t, size);
    solve->order = g_try_new0(int32_t, size);
    if (solve->matrix == NULL || solve->given == NULL || solve->trial == NULL || solve->work == NULL ||
        solve->pivots == NULL || solve->order == NULL)
        g_clear_pointer(&solve, tinker_dense_solve_free);
    return solve;
}

void tinker_dense_solve_free(TinkerDenseSolve *solve)
{
    if (solve == NULL) return;
    gpointer arrays[] = {solve->matrix, solve->given, solve->trial, solve->work, solve->pivots, solve->order};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(solve);
}

void tinker_dense_solve_set_dependent(TinkerDenseSolve *solve, double dependent)
{
    solve->dependent = dependent;
    solve->taken = FALSE; /* by this its rank may be another */
}

static void exchange_rows(double *a, int32_t n, int32_t i, int32_t k)
{
    for (int32_t j = 0; i != k && j < n; j++) {
        double kept = a[i * n + j];
        a[i * n + j] = a[k * n + j];
        a[k * n + j] = kept;
    }
}

static double greatest_entry(const double *a, int32_t count)
{
    double greatest = 0;
    for (int32_t i = 0; i < count; i++)
        greatest = fmax(greatest, fabs(a[i]));
    return greatest;
}

/* By elimination with complete pivoting. */
static gboolean has_full_rank(TinkerDenseSolve *solve, const double *matrix)
{
    const int32_t n = solve->n;
    memcpy(solve->trial, matrix, (gsize)n * (gsize)n * sizeof(double));
    memset(solve->work, 0, (gsize)n * sizeof(double));
    return tinker_pivoted_solve(n, solve->trial, solve->work, solve->order, solve->dependent) == n;
}

/* Whether its numbers are those of the matrix taken last: what rests asks for the same again and again. */
static gboolean is_given(const TinkerDenseSolve *solve, const double *matrix)
{
    const int32_t n = solve->n;
    for (int32_t i = 0; solve->taken && i < n; i++)
        for (int32_t j = 0; j < n; j++)
            if (!(solve->given[j * n + i] == matrix[i * n + j])) return FALSE;
    return solve->taken;
}

int tinker_dense_solve_factor(TinkerDenseSolve *solve, const double *matrix)
{
    int32_t n = solve->n;
    if (is_given(solve, matrix)) return solve->full;
    double *a = solve->matrix, greatest = greatest_entry(matrix, n * n), least = greatest;
    memcpy(a, matrix, (gsize)n * (gsize)n * sizeof(double));
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            solve->given[j * n + i] = matrix[i * n + j];
    solve->taken = TRUE;
    solve->full = FALSE;
    solve->rank = -1;
    for (int32_t k = 0; k < n; k++) {
        int32_t pivot = k;
        for (int32_t i = k + 1; i < n; i++)
            if (fabs(a[i * n + k]) > fabs(a[pivot * n + k])) pivot = i;
        least = fmin(least, fabs(a[pivot * n + k]));
        if (!(least > solve->dependent * greatest)) return 0;
        solve->pivots[k] = pivot;
        exchange_rows(a, n, k, pivot);
        for (int32_t i = k + 1; i < n; i++) {
            double factor = a[i * n + k] /= a[k * n + k];
            for (int32_t j = k + 1; factor != 0 && j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    solve->full = least > SMALL_PIVOT * greatest || has_full_rank(solve, matrix);
    return solve->full;
}

static void substitute(const TinkerDenseSolve *solve, double *b)
{
    int32_t n = solve->n;
    const double *a = solve->matrix;
    for (int32_t k = 0; k < n; k++) {
        double kept = b[k];
        b[k] = b[solve->pivots[k]];
        b[solve->pivots[k]] = kept;
    }
    for (int32_t i = 1; i < n; i++)
        for (int32_t j = 0; j < i; j++)
            b[i] -= a[i * n + j] * b[j];
    for (int32_t i = n - 1; i >= 0; i--) {
        for (int32_t j = i + 1; j < n; j++)
            b[i] -= a[i * n + j] * b[j];
        b[i] /= a[i * n + i];
    }
}

int tinker_dense_solve_is_full(const TinkerDenseSolve *solve)
{
    return solve->full;
}

void tinker_dense_solve(TinkerDenseSolve *solve, double *b)
{
    if (solve->full) {
        substitute(solve, b);
        return;
    }
    const int32_t n = solve->n;
    if (solve->rank < 0) {
        memcpy(solve->matrix, solve->given, (gsize)n * (gsize)n * sizeof(double));
        solve->rank = tinker_least_norm_factor(n, solve->matrix, solve->dependent, solve->order, solve->work);
    }
    tinker_least_norm_solve(n, solve->rank, solve->matrix, solve->order, solve->work, b);
}

void tinker_dense_solve_near(TinkerDenseSolve *solve, const double *near, double *b)
{
    int32_t n = solve->n;
    if (solve->full) {
        substitute(solve, b);
        return;
    }
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = 0; i < n; i++)
            b[i] -= solve->given[j * n + i] * near[j];
    tinker_dense_solve(solve, b);
    for (int32_t i = 0; i < n; i++)
        b[i] += near[i];
}
