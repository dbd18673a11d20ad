/* Sparse L D L^T, and L D U of values that are not symmetric, against dense elimination with pivoting, on patterns of
 * chance and of frames. */
#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"
#include "numerics/solve/sparse-ldl.h"
#include "numerics/solve/sparse-ldu.h"

/* A random symmetric pattern, each pair named once or more, in either triangle. */
typedef struct {
    int n;
    GArray *rows, *columns; /* of int */
    double *dense;
} Problem;

static void add_pair(Problem *problem, int row, int column)
{
    g_array_append_val(problem->rows, row);
    g_array_append_val(problem->columns, column);
}

static void problem_init(Problem *problem, int n)
{
    *problem = (Problem){n, g_array_new(FALSE, FALSE, sizeof(int)), g_array_new(FALSE, FALSE, sizeof(int)),
                         g_new0(double, (gsize)n *(gsize)n + 1)};
}

static void problem_clear(Problem *problem)
{
    g_array_unref(problem->rows);
    g_array_unref(problem->columns);
    g_free(problem->dense);
}

static TinkerSparseLdl *compile(const Problem *problem)
{
    TinkerSparseLdl *ldl = tinker_sparse_ldl_new(problem->n, (const int *)(const void *)problem->rows->data,
                                                 (const int *)(const void *)problem->columns->data, problem->rows->len);
    g_assert_nonnull(ldl);
    return ldl;
}

/* Puts a value into both; an entry is added up in two parts, so that adding is what is tested. */
static void add(const Problem *problem, TinkerSparseLdl *ldl, int row, int column, double value)
{
    double *values = tinker_sparse_ldl_values(ldl);
    values[tinker_sparse_ldl_slot(ldl, row, column)] += 0.75 * value;
    values[tinker_sparse_ldl_slot(ldl, column, row)] += 0.25 * value;
    problem->dense[row * problem->n + column] += value;
    if (row != column) problem->dense[column * problem->n + row] += value;
}

/* Gaussian elimination with partial pivoting, in extended precision; FALSE for a singular matrix. */
static gboolean dense_solve(int n, const double *matrix, double *b)
{
    gsize size = (gsize)n * (gsize)n;
    g_autofree long double *a = g_new(long double, size + 1), *x = g_new(long double, n + 1);
    for (gsize i = 0; i < size; i++)
        a[i] = matrix[i];
    for (int i = 0; i < n; i++)
        x[i] = b[i];
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
            if (fabsl(a[i * n + k]) > fabsl(a[pivot * n + k])) pivot = i;
        if (a[pivot * n + k] == 0) return FALSE;
        for (int j = 0; j < n; j++) {
            long double kept = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = kept;
        }
        long double kept = x[k];
        x[k] = x[pivot];
        x[pivot] = kept;
        for (int i = k + 1; i < n; i++) {
            long double factor = a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
            x[i] -= factor * x[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            x[k] -= a[k * n + j] * x[j];
        x[k] /= a[k * n + k];
        b[k] = (double)x[k];
    }
    return TRUE;
}

/* Diagonally dominant matrices have a condition of a few units, so both solutions agree to rounding. */
static void compare_solutions(Problem *problem, GRand *random)
{
    int n = problem->n;
    TinkerSparseLdl *ldl = compile(problem);
    g_autofree double *b = g_new0(double, n + 1), *truth = g_new0(double, n + 1);
    for (int round = 0; round < 3; round++) {
        tinker_sparse_ldl_clear(ldl);
        memset(problem->dense, 0, (gsize)n * (gsize)n * sizeof(double));
        g_autofree double *weight = g_new0(double, n + 1);
        for (guint k = 0; k < problem->rows->len; k++) {
            int i = g_array_index(problem->rows, int, k), j = g_array_index(problem->columns, int, k);
            double value = g_rand_double_range(random, -1, 1);
            add(problem, ldl, i, j, value);
            weight[i] += fabs(value);
            weight[j] += fabs(value);
        }
        double shift = round == 2 ? 0.5 : 0.0;
        for (int i = 0; i < n; i++) {
            add(problem, ldl, i, i, 1 + weight[i]);
            problem->dense[i * n + i] += shift;
            b[i] = truth[i] = g_rand_double_range(random, -1, 1);
        }
        if (round == 1) {
            g_assert_true(tinker_sparse_ldl_factor_and_solve(ldl, 1e-12, b));
        } else {
            g_assert_true(tinker_sparse_ldl_factor(ldl, shift, 1e-12));
            tinker_sparse_ldl_solve(ldl, b);
        }
        g_assert_true(dense_solve(n, problem->dense, truth));
        for (int i = 0; i < n; i++)
            g_assert_cmpfloat(fabs(b[i] - truth[i]), <=, 1e-14);
    }
    tinker_sparse_ldl_free(ldl);
}

/* The same pattern with values that are not symmetric. */
static void compare_unsymmetric(const Problem *problem, GRand *random)
{
    const int n = problem->n;
    TinkerSparseLdu *ldu = tinker_sparse_ldu_new(n, (const int *)(const void *)problem->rows->data,
                                                 (const int *)(const void *)problem->columns->data, problem->rows->len);
    g_assert_nonnull(ldu);
    double *values = tinker_sparse_ldu_values(ldu);
    g_autofree double *b = g_new0(double, n + 1), *truth = g_new0(double, n + 1), *weight = g_new0(double, n + 1);
    g_autofree double *least = g_new0(double, n + 1), *again = g_new0(double, n + 1);
    tinker_sparse_ldu_clear(ldu);
    memset(problem->dense, 0, (gsize)n * (gsize)n * sizeof(double));
    for (guint k = 0; k < 2 * problem->rows->len; k++) {
        int i = g_array_index(problem->rows, int, k / 2), j = g_array_index(problem->columns, int, k / 2);
        if (k % 2 == 1) {
            const int kept = i;
            i = j;
            j = kept;
        }
        const double value = g_rand_double_range(random, -1, 1);
        values[tinker_sparse_ldu_slot(ldu, i, j)] += value;
        problem->dense[i * n + j] += value;
        weight[i] += fabs(value);
        weight[j] += fabs(value);
    }
    for (int i = 0; i < n; i++) {
        const double own = (i % 2 == 0 ? 1 : -1) * (1 + weight[i]);
        values[tinker_sparse_ldu_slot(ldu, i, i)] += own;
        problem->dense[i * n + i] += own;
        b[i] = again[i] = truth[i] = g_rand_double_range(random, -1, 1);
    }
    g_assert_true(tinker_sparse_ldu_factor_and_solve(ldu, least, b));
    tinker_sparse_ldu_solve(ldu, again);
    g_assert_true(dense_solve(n, problem->dense, truth));
    for (int i = 0; i < n; i++) {
        g_assert_cmpfloat(fabs(b[i] - truth[i]), <=, 1e-14);
        g_assert_cmpfloat(again[i], ==, b[i]);
    }
    tinker_sparse_ldu_free(ldu);
}

/* A pivot that is as small as `least` stops it. */
static void test_vanishing_pivot(void)
{
    static const int row[] = {1}, column[] = {0};
    for (int vanishes = 0; vanishes < 2; vanishes++) {
        TinkerSparseLdu *ldu = tinker_sparse_ldu_new(2, row, column, 1);
        double *values = tinker_sparse_ldu_values(ldu);
        tinker_sparse_ldu_clear(ldu);
        values[tinker_sparse_ldu_slot(ldu, 0, 0)] = 2;
        values[tinker_sparse_ldu_slot(ldu, 0, 1)] = 4;
        values[tinker_sparse_ldu_slot(ldu, 1, 0)] = 3;
        values[tinker_sparse_ldu_slot(ldu, 1, 1)] = vanishes ? 6 : 5;
        g_assert_true(tinker_sparse_ldu_factor_and_solve(ldu, (double[]){1e-10, 1e-10}, (double[]){1, 1}) == !vanishes);
        tinker_sparse_ldu_free(ldu);
    }
}

static void test_random_patterns(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(7);
    for (int trial = 0; trial < 200; trial++) {
        Problem problem;
        int n = 1 + trial % 40, pairs = g_rand_int_range(random, 0, 1 + n * (1 + trial % 5));
        problem_init(&problem, n);
        for (int k = 0; k < pairs && n > 1; k++) {
            int row = g_rand_int_range(random, 0, n);
            add_pair(&problem, row, (row + g_rand_int_range(random, 1, n)) % n);
        }
        compare_solutions(&problem, random);
        compare_unsymmetric(&problem, random);
        problem_clear(&problem);
    }
}

/* Chains, trees, stars, rings and the full matrix; a chain, a tree and a star numbered at random have no fill. */
static void test_shapes(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(8);
    enum { CHAIN, TREE, STAR, RING, FULL, EMPTY, SHAPES };
    for (int shape = 0; shape < SHAPES; shape++) {
        const int n = 60;
        int number[60];
        Problem problem;
        problem_init(&problem, n);
        for (int i = 0; i < n; i++)
            number[i] = i;
        for (int i = n - 1; i > 0; i--) {
            int other = g_rand_int_range(random, 0, i + 1), kept = number[i];
            number[i] = number[other];
            number[other] = kept;
        }
        for (int i = 1; i < n && shape != EMPTY; i++) {
            int parent = shape == STAR ? 0 : shape == TREE ? g_rand_int_range(random, 0, i) : i - 1;
            for (int j = shape == FULL ? 0 : parent; j < (shape == FULL ? i : parent + 1); j++)
                add_pair(&problem, number[i], number[j]);
        }
        if (shape == RING) add_pair(&problem, number[0], number[n - 1]);
        compare_solutions(&problem, random);
        compare_unsymmetric(&problem, random);
        TinkerSparseLdl *ldl = compile(&problem);
        /* A root may keep an entry of 0. */
        if (shape <= STAR) g_assert_cmpuint(tinker_sparse_ldl_fill(ldl), <=, n);
        if (shape == FULL) g_assert_cmpuint(tinker_sparse_ldl_fill(ldl), ==, n * (n - 1) / 2);
        tinker_sparse_ldl_free(ldl);
        problem_clear(&problem);
    }
}

/* S = J J^T with rows of J of which `dependent` are sums of two others: that many pivots vanish, and what is marked can
 * be left out without loss of rank. Entries of J are small integers, so that sums are exact. */
static void count_dependent(GRand *random, int rows, int dependent)
{
    enum { WIDTH = 24 };
    g_autofree double *j = g_new0(double, rows *WIDTH + 1);
    Problem problem;
    problem_init(&problem, rows);
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < WIDTH; c++) {
            int a = r > 1 ? (r * 7) % (rows - dependent) : 0, b = (a + 1) % (rows - dependent);
            /* Independent rows have an entry of their own. */
            if (r >= rows - dependent)
                j[r * WIDTH + c] = j[a * WIDTH + c] + j[b * WIDTH + c];
            else
                j[r * WIDTH + c] = c == r ? 4 : c >= rows - dependent ? g_rand_int_range(random, -1, 2) : 0;
        }
    for (int r = 0; r < rows; r++)
        for (int s = 0; s < r; s++)
            add_pair(&problem, r, s);
    TinkerSparseLdl *ldl = compile(&problem);
    for (int pass = 0; pass < 2; pass++) {
        tinker_sparse_ldl_clear(ldl);
        for (int r = 0; r < rows; r++)
            for (int s = 0; s <= r; s++) {
                double sum = 0;
                for (int c = 0; c < WIDTH; c++)
                    sum += j[r * WIDTH + c] * j[s * WIDTH + c];
                tinker_sparse_ldl_values(ldl)[tinker_sparse_ldl_slot(ldl, r, s)] += sum;
            }
        if (pass == 0) {
            g_autofree char *marked = g_new0(char, rows + 1);
            g_assert_cmpint(tinker_sparse_ldl_count_dependent(ldl, 1e-10, marked), ==, dependent);
            int marks = 0;
            for (int r = 0; r < rows; r++)
                marks += marked[r];
            g_assert_cmpint(marks, ==, dependent);
        } else {
            g_assert_true(tinker_sparse_ldl_factor(ldl, 0, 1e-10) == (dependent == 0));
        }
    }
    tinker_sparse_ldl_free(ldl);
    problem_clear(&problem);
}

static void test_rank(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(9);
    for (int rows = 4; rows < 16; rows++)
        for (int dependent = 0; dependent < rows - 2 && dependent < 6; dependent++)
            count_dependent(random, rows, dependent);
}

/* (A C; C^T -B) with A = J J^T of which `deficient` rows of J are sums of two others, B diagonal, and C of chance: with
 * A shifted it is solved as dense elimination does; without, as many pivots vanish, and what they leave in the border
 * has the rank of as many of them as the border has room for. */
static void try_border(GRand *random, int rows, int deficient, int border)
{
    enum { WIDTH = 24 };
    const int n = rows + border;
    const double shift = 1e-3;
    g_autofree double *j = g_new0(double, rows *WIDTH + 1), *b = g_new0(double, n), *truth = g_new0(double, n);
    Problem problem;
    problem_init(&problem, n);
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < WIDTH; c++)
            j[r * WIDTH + c] = r >= rows - deficient ? j[(r - rows + deficient) * WIDTH + c] + j[WIDTH + c]
                               : c == r              ? 4
                                                     : 0;
    for (int r = 0; r < n; r++)
        for (int s = 0; s < MIN(r, rows); s++)
            add_pair(&problem, r, s);
    TinkerSparseLdl *ldl =
        tinker_sparse_ldl_new_bordered(n, border, (const int *)(const void *)problem.rows->data,
                                       (const int *)(const void *)problem.columns->data, problem.rows->len);
    g_assert_nonnull(ldl);
    for (int pass = 0; pass < 2; pass++) {
        g_autoptr(GRand) entries = g_rand_new_with_seed(17);
        tinker_sparse_ldl_clear(ldl);
        memset(problem.dense, 0, (gsize)n * (gsize)n * sizeof(double));
        for (int r = 0; r < rows; r++)
            for (int s = 0; s <= r; s++) {
                double sum = 0;
                for (int c = 0; c < WIDTH; c++)
                    sum += j[r * WIDTH + c] * j[s * WIDTH + c];
                add(&problem, ldl, r, s, sum);
            }
        for (int h = rows; h < n; h++)
            for (int r = 0; r <= rows; r++)
                add(&problem, ldl, h, r < rows ? r : h, r < rows ? g_rand_double_range(entries, -3, 3) : -2 - h % 3);
        if (pass == 1) {
            g_autofree double *products = g_new0(double, border *border), *values = g_new0(double, border);
            int rank = 0;
            g_assert_cmpint(tinker_sparse_ldl_count_dependent(ldl, 1e-10, NULL), ==, deficient);
            tinker_sparse_ldl_left_out(ldl, products);
            g_assert_true(tinker_eigen_symmetric(border, products, values));
            for (int k = 0; k < border; k++)
                rank += values[k] > 1e-10;
            g_assert_cmpint(rank, ==, MIN(deficient, border));
            continue;
        }
        for (int i = 0; i < n; i++) {
            b[i] = truth[i] = g_rand_double_range(random, -1, 1);
            if (i < rows) problem.dense[i * n + i] += shift;
        }
        g_assert_true(tinker_sparse_ldl_factor(ldl, shift, 0));
        tinker_sparse_ldl_solve(ldl, b);
        g_assert_true(dense_solve(n, problem.dense, truth));
        for (int i = 0; i < n; i++)
            g_assert_cmpfloat(fabs(b[i] - truth[i]), <=, 1e-9 * (1 + fabs(truth[i])));
    }
    tinker_sparse_ldl_free(ldl);
    problem_clear(&problem);
}

static void test_border(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(23);
    for (int rows = 8; rows < 20; rows++)
        for (int deficient = 0; deficient < 5; deficient++)
            for (int border = 1; border < 6; border++)
                try_border(random, rows, deficient, border);
}

/* Nothing, one, and matrices that are not positive: no crash, and a refusal. */
static void test_edges(void)
{
    TinkerSparseLdl *none = tinker_sparse_ldl_new(0, NULL, NULL, 0);
    g_assert_nonnull(none);
    tinker_sparse_ldl_clear(none);
    g_assert_true(tinker_sparse_ldl_factor(none, 0, 1e-10));
    tinker_sparse_ldl_solve(none, NULL);
    g_assert_cmpint(tinker_sparse_ldl_count_dependent(none, 1e-10, NULL), ==, 0);
    tinker_sparse_ldl_free(none);

    static const int row[] = {1}, column[] = {0};
    static const struct {
        double diagonal[2], off;
        gboolean good;
    } cases[] = {{{2, 2}, 1, TRUE},   {{1, 1}, 1, FALSE},   {{1, 1}, 2, FALSE},  {{0, 1}, 0, FALSE},
                 {{-1, 1}, 0, FALSE}, {{NAN, 1}, 0, FALSE}, {{1, 1}, NAN, FALSE}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        TinkerSparseLdl *ldl = tinker_sparse_ldl_new(2, row, column, 1);
        double *values = tinker_sparse_ldl_values(ldl);
        tinker_sparse_ldl_clear(ldl);
        values[tinker_sparse_ldl_slot(ldl, 0, 0)] = cases[i].diagonal[0];
        values[tinker_sparse_ldl_slot(ldl, 1, 1)] = cases[i].diagonal[1];
        values[tinker_sparse_ldl_slot(ldl, 1, 0)] = cases[i].off;
        g_assert_true(tinker_sparse_ldl_factor(ldl, 0, 1e-10) == cases[i].good);
        tinker_sparse_ldl_free(ldl);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/sparse-ldl/random-patterns", test_random_patterns);
    g_test_add_func("/numerics/sparse-ldl/shapes", test_shapes);
    g_test_add_func("/numerics/sparse-ldl/rank", test_rank);
    g_test_add_func("/numerics/sparse-ldl/border", test_border);
    g_test_add_func("/numerics/sparse-ldl/edges", test_edges);
    g_test_add_func("/numerics/sparse-ldl/vanishing-pivot", test_vanishing_pivot);
    return g_test_run();
}
