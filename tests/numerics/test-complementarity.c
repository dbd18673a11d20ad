/* Lemke's method against a search through all 2^n bases, which are solved in long double. */
#include <math.h>
#include <string.h>

#include <glib.h>

#include "contact-case.h"
#include "numerics/contact/complementarity.h"

enum { MOST = 8 };

/* The solution of the basis whose members are the bits of `code`; FALSE where it is none. */
static gboolean solve_basis(int32_t n, const double *matrix, const double *q, int32_t code, double *z)
{
    int32_t chosen[MOST], count = 0;
    long double system[CASE_WIDTH][CASE_WIDTH + 1];
    for (int32_t i = 0; i < n; i++)
        if (code >> i & 1) chosen[count++] = i;
    for (int32_t i = 0; i < count; i++) {
        for (int32_t j = 0; j < count; j++)
            system[i][j] = matrix[chosen[i] * n + chosen[j]];
        system[i][count] = -(long double)q[chosen[i]];
    }
    if (!contact_case_eliminate(count, system)) return FALSE;
    memset(z, 0, (size_t)n * sizeof *z);
    for (int32_t i = 0; i < count; i++) {
        if (system[i][count] < -1e-12L) return FALSE;
        z[chosen[i]] = (double)system[i][count];
    }
    for (int32_t i = 0; i < n; i++) {
        long double w = q[i];
        for (int32_t j = 0; j < n; j++)
            w += (long double)matrix[i * n + j] * z[j];
        if (w < -1e-11L) return FALSE;
    }
    return TRUE;
}

static gboolean search(int32_t n, const double *matrix, const double *q, double *z)
{
    for (int32_t code = 0; code < 1 << n; code++)
        if (solve_basis(n, matrix, q, code, z)) return TRUE;
    return FALSE;
}

static TinkerLcpResult solve(int32_t n, const double *matrix, const double *q, double *z)
{
    g_autofree double *room = g_new(double, tinker_lcp_room(n));
    return tinker_lcp_solve(n, matrix, q, z, room);
}

static void assert_solution(int32_t n, const double *matrix, const double *q, const double *z, double tolerance)
{
    for (int32_t i = 0; i < n; i++) {
        double w = q[i], size = fabs(q[i]);
        for (int32_t j = 0; j < n; j++) {
            w += matrix[i * n + j] * z[j];
            size += fabs(matrix[i * n + j] * z[j]);
        }
        g_assert_cmpfloat(z[i], >=, 0);
        g_assert_cmpfloat(w, >=, -tolerance * size);
        if (z[i] > 0) g_assert_cmpfloat(w, <=, tolerance * size);
    }
}

/* Not symmetric, of diagonal dominance: a P-matrix, whose solution is unique; with scales that differ by 1e8. */
static void test_p_matrices(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    for (int32_t round = 0; round < 3000; round++) {
        int32_t n = g_rand_int_range(random, 1, MOST + 1);
        double matrix[MOST * MOST], q[MOST], z[MOST], truth[MOST], scale[MOST];
        for (int32_t i = 0; i < n; i++) {
            double sum = 0;
            for (int32_t j = 0; j < n; j++)
                sum += fabs(matrix[i * n + j] = g_rand_double_range(random, -1, 1));
            matrix[i * n + i] = sum;
            q[i] = g_rand_double_range(random, -2, 1);
            scale[i] = round % 2 ? 1 : exp2(g_rand_int_range(random, -13, 14));
        }
        g_assert_true(search(n, matrix, q, truth));
        for (int32_t i = 0; i < n; i++) {
            q[i] *= scale[i];
            for (int32_t j = 0; j < n; j++)
                matrix[i * n + j] *= scale[i] * scale[j];
        }
        g_assert_cmpint(solve(n, matrix, q, z), ==, TINKER_LCP_SOLVED);
        for (int32_t i = 0; i < n; i++)
            g_assert_cmpfloat_with_epsilon(z[i] * scale[i], truth[i], 1e-13 * (1 + truth[i]));
    }
}

/* Positive semidefinite of low rank, with whole numbers and many ties: solved if and only if a basis is. */
static void test_degenerate(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(2);
    int32_t solved = 0, rays = 0;
    for (int32_t round = 0; round < 6000; round++) {
        int32_t n = g_rand_int_range(random, 1, MOST + 1), rank = g_rand_int_range(random, 0, n + 1);
        double matrix[MOST * MOST] = {0}, q[MOST], z[MOST], truth[MOST];
        for (int32_t k = 0; k < rank; k++) {
            double row[MOST];
            for (int32_t i = 0; i < n; i++)
                row[i] = g_rand_int_range(random, -1, 2);
            for (int32_t i = 0; i < n * n; i++)
                matrix[i] += row[i / n] * row[i % n];
        }
        for (int32_t i = 0; i < n; i++)
            q[i] = g_rand_int_range(random, -1, 2);
        gboolean exists = search(n, matrix, q, truth);
        TinkerLcpResult result = solve(n, matrix, q, z);
        g_assert_cmpint(result, ==, exists ? TINKER_LCP_SOLVED : TINKER_LCP_RAY);
        if (exists) assert_solution(n, matrix, q, z, 1e-13);
        solved += exists;
        rays += !exists;
    }
    g_assert_cmpint(solved, >, 1000);
    g_assert_cmpint(rays, >, 300);
}

/* Strictly copositive (positive entries): always solvable. */
static void test_copositive(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    for (int32_t round = 0; round < 3000; round++) {
        int32_t n = g_rand_int_range(random, 1, MOST + 1);
        double matrix[MOST * MOST], q[MOST], z[MOST];
        for (int32_t i = 0; i < n * n; i++)
            matrix[i] = round % 2 ? g_rand_double_range(random, 0.01, 1) : g_rand_int_range(random, 0, 3);
        for (int32_t i = 0; i < n; i++) {
            matrix[i * n + i] += 1;
            q[i] = round % 2 ? g_rand_double_range(random, -1, 1) : g_rand_int_range(random, -2, 2);
        }
        g_assert_cmpint(solve(n, matrix, q, z), ==, TINKER_LCP_SOLVED);
        assert_solution(n, matrix, q, z, 1e-13);
    }
}

/* Murty's matrices make the path as long as it can be: 2 below the diagonal, 1 on it, q = -1. z is known. */
static void test_long_path(void)
{
    enum { N = 8 };
    double matrix[N * N] = {0}, q[N], z[N];
    for (int32_t i = 0; i < N; i++) {
        q[i] = -1;
        for (int32_t j = 0; j <= i; j++)
            matrix[i * N + j] = i == j ? 1 : 2;
    }
    g_assert_cmpint(solve(N, matrix, q, z), ==, TINKER_LCP_SOLVED);
    for (int32_t i = 0; i < N; i++)
        g_assert_cmpfloat_with_epsilon(z[i], i == 0 ? 1 : 0, 1e-15);
}

/* Nothing but one unknown, and what has no answer. */
static void test_simple(void)
{
    double z, one = 3, third = -1, minus = -1, odd = NAN;
    g_assert_cmpint(solve(1, &one, &third, &z), ==, TINKER_LCP_SOLVED);
    g_assert_cmpfloat(z, ==, 1.0 / 3);
    g_assert_cmpint(solve(1, &minus, &third, &z), ==, TINKER_LCP_RAY);
    g_assert_cmpint(solve(1, &one, &odd, &z), ==, TINKER_LCP_GAVE_UP);
    g_assert_cmpint(solve(1, &odd, &third, &z), !=, TINKER_LCP_SOLVED);
    double zero = 0;
    g_assert_cmpint(solve(1, &zero, &zero, &z), ==, TINKER_LCP_SOLVED);
    g_assert_cmpint(solve(1, &zero, &third, &z), ==, TINKER_LCP_RAY);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/complementarity/simple", test_simple);
    g_test_add_func("/complementarity/p-matrices", test_p_matrices);
    g_test_add_func("/complementarity/degenerate", test_degenerate);
    g_test_add_func("/complementarity/copositive", test_copositive);
    g_test_add_func("/complementarity/long-path", test_long_path);
    return g_test_run();
}
