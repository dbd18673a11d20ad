/* Jacobi's rotations against matrices whose eigenvalues are known. */
#include <math.h>

#include <glib.h>

#include "numerics/solve/symmetric-eigen.h"

static int compare(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* The second difference of n points: 2 - 2 cos(k pi / (n + 1)). */
static void test_second_difference(void)
{
    enum { N = 20 };
    double a[N * N] = {0}, original[N * N], vectors[N * N] = {0}, values[N];
    for (int i = 0; i < N; i++) {
        a[i + N * i] = 2;
        vectors[i + N * i] = 1;
        if (i > 0) a[i + N * (i - 1)] = a[i - 1 + N * i] = -1;
    }
    for (int i = 0; i < N * N; i++)
        original[i] = a[i];
    g_assert_true(tinker_symmetric_eigen(N, a, N, vectors));
    for (int k = 0; k < N; k++) {
        values[k] = a[k + N * k];
        for (int i = 0; i < N; i++) {
            double product = 0;
            for (int j = 0; j < N; j++)
                product += original[i + N * j] * vectors[j + N * k];
            g_assert_cmpfloat_with_epsilon(product, values[k] * vectors[i + N * k], 1e-14);
        }
    }
    qsort(values, N, sizeof(double), compare);
    for (int k = 0; k < N; k++)
        g_assert_cmpfloat_with_epsilon(values[k], 2 - 2 * cos((k + 1) * G_PI / (N + 1)), 1e-14);
}

/* [1e20 1e9; 1e9 1] has the eigenvalues 1e20 and 0.99 up to parts of 1e-22: both keep their digits. */
static void test_graded(void)
{
    double a[4] = {1e20, 1e9, 1e9, 1}, vectors[4] = {1, 0, 0, 1};
    g_assert_true(tinker_symmetric_eigen(2, a, 2, vectors));
    g_assert_cmpfloat_with_epsilon(a[0] / 1e20, 1, 1e-15);
    g_assert_cmpfloat_with_epsilon(a[3], 0.99, 1e-15);
}

static void test_not_a_number(void)
{
    double a[4] = {1, NAN, NAN, 1}, vectors[4] = {1, 0, 0, 1};
    g_assert_false(tinker_symmetric_eigen(2, a, 2, vectors));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/symmetric-eigen/second-difference", test_second_difference);
    g_test_add_func("/symmetric-eigen/graded", test_graded);
    g_test_add_func("/symmetric-eigen/not-a-number", test_not_a_number);
    return g_test_run();
}
