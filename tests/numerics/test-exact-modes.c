/* Modes of graded systems: frequencies against closed forms, each to rounding of its own; shapes by what they are. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "linear-case.h"
#include "numerics/exact/linear-modes.h"

static int ascending(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* The frequencies of a line of masses, spring i before mass i, spring n behind the last one; checks that shapes
 * are modes and normalised. Sorted. */
static void line_modes(int32_t n, const double *mass, const double *springs, double *omega)
{
    g_autofree double *weights = g_new0(double, n *n), *ground = g_new0(double, n), *shape = g_new0(double, n *n);
    g_autofree double *work = g_new0(double, tinker_linear_modes_work(n));
    ground[0] += springs[0];
    ground[n - 1] += springs[n];
    for (int32_t i = 1; i < n; i++)
        weights[i * n + i - 1] = weights[(i - 1) * n + i] = springs[i];
    g_assert_true(tinker_linear_modes(n, mass, weights, ground, omega, shape, work));
    for (int32_t j = 0; j < n; j++) {
        for (int32_t k = 0; k <= j; k++) {
            double product = 0.0;
            for (int32_t i = 0; i < n; i++)
                product += shape[i * n + j] * mass[i] * shape[i * n + k];
            assert_near(product, j == k ? 1.0 : 0.0, 4.0 * n * DBL_EPSILON);
        }
    }
    qsort(omega, (size_t)n, sizeof *omega, ascending);
}

/* Fixed at one end: omega = 2 sqrt(k/m) sin((2j - 1) pi / (4n + 2)); free at both: 2 sqrt(k/m) sin(j pi / 2n). */
static void test_uniform_chains(void)
{
    static const int32_t sizes[] = {1, 2, 10, 50, 200};
    for (gsize s = 0; s < G_N_ELEMENTS(sizes); s++) {
        int32_t n = sizes[s];
        g_autofree double *mass = g_new0(double, n), *springs = g_new0(double, n + 1), *omega = g_new0(double, n);
        for (int32_t i = 0; i < n; i++) {
            mass[i] = 2.0;
            springs[i] = 800.0;
        }
        line_modes(n, mass, springs, omega);
        for (int32_t j = 0; j < n; j++) {
            double truth = (double)(40.0L * sinl((2 * j + 1) * acosl(-1.0L) / (4 * n + 2)));
            assert_near(omega[j] / truth, 1.0, (8.0 + n) * DBL_EPSILON);
        }
        springs[0] = 0.0;
        line_modes(n, mass, springs, omega);
        g_assert_cmpfloat(omega[0], ==, 0.0);
        for (int32_t j = 1; j < n; j++) {
            double truth = (double)(40.0L * sinl(j * acosl(-1.0L) / (2 * n)));
            assert_near(omega[j] / truth, 1.0, (8.0 + n) * DBL_EPSILON);
        }
    }
}

/* Two masses, anything but alike: both frequencies to rounding of their own. With springs k1 to the ground and k2
 * between, their product is sqrt(k1 k2 / (m1 m2)), the larger one has nothing that cancels. */
static void test_graded_pairs(void)
{
    for (double k1 = 1e-6; k1 < 2e12; k1 *= 1e3) {
        for (double k2 = 1e-6; k2 < 2e12; k2 *= 1e3) {
            for (double m2 = 1e-9; m2 < 2e9; m2 *= 1e3) {
                double mass[2] = {1.0, m2}, springs[3] = {k1, k2, 0.0}, omega[2];
                long double a = (long double)k1 + k2, b = (long double)k2 / m2;
                long double large = (a + b + sqrtl((a - b) * (a - b) + 4.0L * k2 * b)) / 2.0L;
                line_modes(2, mass, springs, omega);
                assert_near(omega[1] / (double)sqrtl(large), 1.0, 16.0 * DBL_EPSILON);
                assert_near(omega[0] / (double)sqrtl((long double)k1 * k2 / m2 / large), 1.0, 16.0 * DBL_EPSILON);
                springs[0] = 0.0;
                line_modes(2, mass, springs, omega);
                g_assert_cmpfloat(omega[0], ==, 0.0);
                assert_near(omega[1] / (double)sqrtl(k2 * (1.0L + 1.0L / m2)), 1.0, 16.0 * DBL_EPSILON);
            }
        }
    }
}

/* Stiff and soft springs in turn: pairs that move as one are a chain of their own; its frequencies to first order
 * in the ratio of stiffness. */
static void test_graded_chain(void)
{
    int32_t n = 10;
    double mass[10], springs[11] = {0}, omega[10], ratio = 1e-13;
    for (int32_t i = 0; i < n; i++) {
        mass[i] = 1.0;
        springs[i] = i % 2 ? 1.0 / ratio : 1.0;
    }
    line_modes(n, mass, springs, omega);
    for (int32_t j = 0; j < n / 2; j++) {
        double truth = sqrt(0.5) * 2.0 * sin((2 * j + 1) * G_PI / (2 * n + 2));
        assert_near(omega[j] / truth, 1.0, 10.0 * ratio + 32.0 * DBL_EPSILON);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/exact-modes/uniform-chains", test_uniform_chains);
    g_test_add_func("/numerics/exact-modes/graded-pairs", test_graded_pairs);
    g_test_add_func("/numerics/exact-modes/graded-chain", test_graded_chain);
    return g_test_run();
}
