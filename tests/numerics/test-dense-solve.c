/* Dense systems of known singular values: products of random rotations and a diagonal. */
#include <glib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/dense-solve.h"

#define MOST 24

/* The columns i and k of a matrix by rows, turned in their plane. */
static void turn_columns(double *a, int32_t n, int32_t i, int32_t k, double angle)
{
    const double c = cos(angle), s = sin(angle);
    for (int32_t row = 0; row < n; row++) {
        const double x = a[row * n + i], y = a[row * n + k];
        a[row * n + i] = c * x - s * y;
        a[row * n + k] = s * x + c * y;
    }
}

static void make_rotation(GRand *dice, int32_t n, double *q)
{
    memset(q, 0, (gsize)(n * n) * sizeof(double));
    for (int32_t i = 0; i < n; i++)
        q[i * n + i] = 1;
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = i + 1; k < n; k++)
            turn_columns(q, n, i, k, g_rand_double_range(dice, -3, 3));
}

typedef struct {
    int32_t n;
    double left[MOST * MOST], right[MOST * MOST], matrix[MOST * MOST]; /* matrix = left diag(values) right^T */
} Case;

static void make_case_of(Case *of, GRand *dice, int32_t n, const double *values)
{
    of->n = n;
    make_rotation(dice, n, of->left);
    make_rotation(dice, n, of->right);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            double sum = 0;
            for (int32_t k = 0; k < n; k++)
                sum += of->left[i * n + k] * values[k] * of->right[j * n + k];
            of->matrix[i * n + j] = sum;
        }
}

/* Singular values of 1, but the last two. */
static void make_case(Case *of, GRand *dice, int32_t n, double last_but_one, double last)
{
    double values[MOST];
    for (int32_t k = 0; k < n; k++)
        values[k] = k == n - 1 ? last : k == n - 2 ? last_but_one : 1;
    make_case_of(of, dice, n, values);
}

static void multiply(const Case *of, const double *x, double *b)
{
    for (int32_t i = 0; i < of->n; i++) {
        b[i] = 0;
        for (int32_t j = 0; j < of->n; j++)
            b[i] += of->matrix[i * of->n + j] * x[j];
    }
}

/* The least singular value is far below what its neighbour and rounding leave of pivots by rows: what nothing
 * determines is that of `near`, and all else solves. */
static void check_singular(const Case *of, GRand *dice)
{
    double x[MOST], near[MOST], b[MOST], again[MOST], along = 0;
    const int32_t n = of->n;
    TinkerDenseSolve *solve = tinker_dense_solve_new(n);
    for (int32_t i = 0; i < n; i++) {
        x[i] = g_rand_double_range(dice, -1, 1);
        near[i] = g_rand_double_range(dice, -1, 1);
    }
    multiply(of, x, b);
    memcpy(x, b, sizeof(x));
    g_assert_false(tinker_dense_solve_factor(solve, of->matrix));
    g_assert_false(tinker_dense_solve_is_full(solve));
    tinker_dense_solve_near(solve, near, x);
    multiply(of, x, again);
    for (int32_t i = 0; i < n; i++) {
        g_assert_cmpfloat_with_epsilon(again[i], b[i], 1e-12);
        along += (x[i] - near[i]) * of->right[i * n + n - 1];
    }
    g_assert_cmpfloat_with_epsilon(along, 0, 1e-6); /* the null direction is known to 1e-13 / 1e-4 and rounding */
    tinker_dense_solve_free(solve);
}

static void check_full(const Case *of, GRand *dice)
{
    double truth[MOST], x[MOST];
    TinkerDenseSolve *solve = tinker_dense_solve_new(of->n);
    for (int32_t i = 0; i < of->n; i++)
        truth[i] = g_rand_double_range(dice, -1, 1);
    multiply(of, truth, x);
    g_assert_true(tinker_dense_solve_factor(solve, of->matrix));
    g_assert_true(tinker_dense_solve_is_full(solve));
    tinker_dense_solve(solve, x);
    for (int32_t i = 0; i < of->n; i++)
        g_assert_cmpfloat_with_epsilon(x[i], truth[i], 1e-6);
    tinker_dense_solve_free(solve);
}

static void test_rank(void)
{
    g_autoptr(GRand) dice = g_rand_new_with_seed(1);
    for (int32_t n = 3; n <= MOST; n++)
        for (int repeat = 0; repeat < 50; repeat++) {
            Case of;
            make_case(&of, dice, n, 1e-4, 1e-13);
            check_singular(&of, dice);
            make_case(&of, dice, n, 1e-4, 1e-7);
            check_full(&of, dice);
        }
}

/* x of least norm: sum of right_k (left_k . b) / value_k, over the values that are not 0, whatever b contradicts. */
static void check_least_norm(TinkerDenseSolve *solve, const Case *of, const double *values, GRand *dice)
{
    double b[MOST], x[MOST], truth[MOST] = {0};
    const int32_t n = of->n;
    for (int32_t i = 0; i < n; i++)
        x[i] = b[i] = g_rand_double_range(dice, -1, 1);
    for (int32_t k = 0; k < n; k++) {
        double along = 0;
        for (int32_t i = 0; i < n; i++)
            along += of->left[i * n + k] * b[i];
        for (int32_t i = 0; values[k] > 0 && i < n; i++)
            truth[i] += of->right[i * n + k] * along / values[k];
    }
    g_assert_false(tinker_dense_solve_factor(solve, of->matrix));
    tinker_dense_solve(solve, x);
    for (int32_t i = 0; i < n; i++)
        g_assert_cmpfloat_with_epsilon(x[i], truth[i], 1e-9);
}

/* Of any rank, by turns with others: what is kept of one matrix is not taken for another's. */
static void test_least_norm(void)
{
    g_autoptr(GRand) dice = g_rand_new_with_seed(2);
    for (int32_t n = 2; n <= MOST; n++) {
        TinkerDenseSolve *solve = tinker_dense_solve_new(n);
        double values[2][MOST] = {{0}, {0}};
        Case of[2];
        for (int k = 0; k < 2; k++) {
            const int32_t rank = g_rand_int_range(dice, 0, n);
            for (int32_t i = 0; i < rank; i++)
                values[k][i] = exp(g_rand_double_range(dice, -6, 0));
            make_case_of(&of[k], dice, n, values[k]);
        }
        for (int times = 0; times < 8; times++)
            check_least_norm(solve, &of[times / 3 % 2], values[times / 3 % 2], dice);
        tinker_dense_solve_free(solve);
    }
}

/* Pivots by rows: 1e-5 and 1e-9. Its singular values are 1.4 and 7e-15: the first unknown is next to nothing. */
static void test_small_pivots(void)
{
    const double matrix[] = {1e-5, 1, 1e-5, 1 + 1e-9}, near[] = {0, 0};
    double x[] = {1, 1 + 1e-9};
    TinkerDenseSolve *solve = tinker_dense_solve_new(2);
    g_assert_false(tinker_dense_solve_factor(solve, matrix));
    tinker_dense_solve_near(solve, near, x);
    g_assert_cmpfloat_with_epsilon(x[0], 1e-5, 1e-8);
    g_assert_cmpfloat_with_epsilon(x[1], 1, 1e-8);
    tinker_dense_solve_free(solve);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/dense-solve/rank", test_rank);
    g_test_add_func("/numerics/dense-solve/least-norm", test_least_norm);
    g_test_add_func("/numerics/dense-solve/small-pivots", test_small_pivots);
    return g_test_run();
}
