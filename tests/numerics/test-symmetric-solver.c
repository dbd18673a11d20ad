/* Banded and sparse solves against elimination of the full matrix, on chains, shuffled chains, ladders, lattices and
 * loose parts; the order of reverse Cuthill and McKee. */
#include <math.h>
#include <string.h>

#include "numerics/solve/narrow-band.h"
#include "numerics/solve/symmetric-solver.h"

#include <glib.h>

#define MOST 144

/* A dense matrix and its pattern. */
typedef struct {
    int32_t n;
    double full[MOST][MOST];
    int32_t row_starts[MOST + 1], columns[MOST * MOST];
    double values[MOST * MOST];
    TinkerPattern pattern;
} Matrix;

static void matrix_finish(Matrix *this)
{
    int32_t entries = 0;
    for (int32_t i = 0; i < this->n; i++) {
        this->row_starts[i] = entries;
        for (int32_t j = 0; j < this->n; j++) {
            if (this->full[i][j] == 0 && i != j) continue;
            this->columns[entries] = j;
            this->values[entries++] = this->full[i][j];
        }
    }
    this->row_starts[this->n] = entries;
    this->pattern = (TinkerPattern){this->n, entries, this->row_starts, this->columns};
}

/* Ties i and j with a random spring; the values of the two triangles differ, but not their mean. */
static void tie(Matrix *this, GRand *random, int32_t i, int32_t j)
{
    double k = g_rand_double_range(random, 0.1, 10), skew = g_rand_double_range(random, -0.05, 0.05);
    this->full[i][i] += k;
    this->full[j][j] += k;
    this->full[i][j] -= k + skew;
    this->full[j][i] -= k - skew;
}

/* Rows in rows of `across`, each tied to those beside it, numbered at random where shuffled. */
static void make(Matrix *this, GRand *random, int32_t n, int32_t across, gboolean shuffled)
{
    int32_t number[MOST];
    memset(this, 0, sizeof *this);
    this->n = n;
    for (int32_t i = 0; i < n; i++) {
        number[i] = i;
        this->full[i][i] = g_rand_double_range(random, 0.1, 1);
    }
    for (int32_t i = n - 1; i > 0 && shuffled; i--) {
        int32_t k = g_rand_int_range(random, 0, i + 1), kept = number[i];
        number[i] = number[k];
        number[k] = kept;
    }
    for (int32_t i = 0; i < n; i++) {
        if (i % 50 == 49) continue; /* parts that nothing ties */
        if (i % across != across - 1 && i + 1 < n) tie(this, random, number[i], number[i + 1]);
        if (across == 1 ? i + 1 < n : i + across < n) tie(this, random, number[i], number[i + across]);
    }
    matrix_finish(this);
}

/* Gauss with pivoting on the symmetric part. */
static void eliminate(const Matrix *this, double *b)
{
    static double a[MOST][MOST];
    int32_t n = this->n;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            a[i][j] = 0.5 * (this->full[i][j] + this->full[j][i]);
    for (int32_t k = 0; k < n; k++) {
        int32_t best = k;
        for (int32_t i = k; i < n; i++)
            if (fabs(a[i][k]) > fabs(a[best][k])) best = i;
        for (int32_t j = 0; j < n; j++) {
            double kept = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = kept;
        }
        double kept = b[k];
        b[k] = b[best];
        b[best] = kept;
        for (int32_t i = k + 1; i < n; i++) {
            double factor = a[i][k] / a[k][k];
            for (int32_t j = k; j < n; j++)
                a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (int32_t k = n - 1; k >= 0; k--) {
        for (int32_t j = k + 1; j < n; j++)
            b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
}

static void assert_solves(const Matrix *this, TinkerSolverKind kind, const double *b, const double *truth)
{
    TinkerSymmetricSolver *solver = tinker_symmetric_solver_new(&this->pattern, kind);
    double x[MOST], largest = 0;
    if (kind != TINKER_SOLVER_FITTING) g_assert_cmpint(tinker_symmetric_solver_kind(solver), ==, kind);
    for (int again = 0; again < 2; again++) {
        g_assert_true(tinker_symmetric_solver_factor(solver, this->values));
        memcpy(x, b, sizeof(double) * (gsize)this->n);
        tinker_symmetric_solver_solve(solver, x);
        for (int32_t i = 0; i < this->n; i++)
            largest = fmax(largest, fabs(x[i] - truth[i]));
    }
    g_assert_cmpfloat(largest, <, 1e-11);
    tinker_symmetric_solver_free(solver);
}

static void test_all_agree(void)
{
    static const struct {
        int32_t n, across;
    } shapes[] = {{1, 1}, {2, 1}, {3, 1}, {50, 1}, {51, 1}, {40, 2}, {60, 3}, {60, 4}, {144, 12}};
    g_autoptr(GRand) random = g_rand_new_with_seed(31);
    Matrix *matrix = g_new0(Matrix, 1);
    for (gsize s = 0; s < G_N_ELEMENTS(shapes); s++) {
        for (int shuffled = 0; shuffled < 2; shuffled++) {
            double b[MOST], truth[MOST];
            make(matrix, random, shapes[s].n, shapes[s].across, shuffled);
            for (int32_t i = 0; i < matrix->n; i++)
                truth[i] = b[i] = g_rand_double_range(random, -1, 1);
            eliminate(matrix, truth);
            assert_solves(matrix, TINKER_SOLVER_BANDED, b, truth);
            assert_solves(matrix, TINKER_SOLVER_SPARSE, b, truth);
            assert_solves(matrix, TINKER_SOLVER_FITTING, b, truth);
        }
    }
    g_free(matrix);
}

/* A ladder of any numbering has a narrow band; a loose grid has not and is left to the sparse factor. */
static void test_band_is_found(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(32);
    Matrix *matrix = g_new0(Matrix, 1);
    int32_t place[MOST];
    make(matrix, random, 100, 1, TRUE);
    g_assert_cmpint(tinker_narrow_band(&matrix->pattern, place), ==, 1);
    make(matrix, random, 100, 1, FALSE);
    g_assert_cmpint(tinker_narrow_band(&matrix->pattern, place), ==, 1);
    for (int32_t i = 0; i < 100; i++)
        g_assert_cmpint(place[i], ==, i);
    make(matrix, random, 100, 2, TRUE);
    g_assert_cmpint(tinker_narrow_band(&matrix->pattern, place), <=, 4);
    gboolean taken[MOST] = {FALSE};
    for (int32_t i = 0; i < 100; i++) {
        g_assert_false(taken[place[i]]);
        taken[place[i]] = TRUE;
    }
    g_free(matrix);
}

static void test_singular(void)
{
    Matrix *matrix = g_new0(Matrix, 1);
    matrix->n = 2;
    matrix->full[0][0] = matrix->full[1][1] = 1;
    matrix->full[0][1] = matrix->full[1][0] = -1;
    matrix_finish(matrix);
    TinkerSymmetricSolver *solver = tinker_symmetric_solver_new(&matrix->pattern, TINKER_SOLVER_BANDED);
    g_assert_false(tinker_symmetric_solver_factor(solver, matrix->values));
    tinker_symmetric_solver_free(solver);
    g_free(matrix);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/symmetric-solver/all-agree", test_all_agree);
    g_test_add_func("/numerics/symmetric-solver/band-is-found", test_band_is_found);
    g_test_add_func("/numerics/symmetric-solver/singular", test_singular);
    return g_test_run();
}
