/* What a step does to an oscillator, against closed forms of the methods' factors. */
#include <float.h>
#include <glib.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "numerics/stability/amplification.h"

static double growth_of(const char *id, TinkerOscillator oscillator)
{
    double map[4];
    g_assert_true(tinker_amplification(tinker_integrator_builtin(id), 0, oscillator, 1.0, map));
    return tinker_map_growth(map);
}

/* R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 on the imaginary axis: |R|^2 = 1 - x^6/72 + x^8/576. */
static void test_runge_kutta(void)
{
    for (double x = 0.1; x < 4; x += 0.3) {
        const double x2 = x * x, x6 = x2 * x2 * x2;
        const double growth = growth_of("rk4", (TinkerOscillator){x2, 0});
        g_assert_cmpfloat_with_epsilon(growth, sqrt(1 - x6 / 72 + x6 * x2 / 576), 1e-12);
    }
}

/* Average acceleration is the trapezoidal rule, whose factor (1 + z/2) / (1 - z/2) has the size 1 on the imaginary
 * axis. The products of the map's entries, whose difference counts, are of the size x^2: so much larger is their
 * rounding. */
static void test_average_acceleration(void)
{
    for (double x = 0.01; x < 1e3; x *= 3)
        g_assert_cmpfloat_with_epsilon(growth_of("newmark", (TinkerOscillator){x * x, 0}), 1,
                                       8 * DBL_EPSILON * (1 + x * x));
}

/* A pair of real factors: the larger counts. Critically damped, exp(-t) and t exp(-t): that of rk4 is R(-1) = 0.375. */
static void test_real_factors(void)
{
    g_assert_cmpfloat_with_epsilon(growth_of("rk4", (TinkerOscillator){1, 2}), 0.375, 1e-7);
    const double slow = 0.25, fast = 2, r = 1 - slow + slow * slow / 2 - pow(slow, 3) / 6 + pow(slow, 4) / 24;
    g_assert_cmpfloat_with_epsilon(growth_of("rk4", (TinkerOscillator){slow * fast, slow + fast}), r, 1e-12);
}

/* The spectral radius at infinite frequency is what generalized-alpha is made for: J. Chung, G. M. Hulbert, J. Appl.
 * Mech. 60 (1993) 371-375. Slow motion keeps its size. */
static void test_long_run(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("generalized-alpha");
    for (double radius = 0.3; radius < 1; radius += 0.2) {
        double growth = tinker_long_run_growth(method, radius, (TinkerOscillator){1e10, 0}, 1.0);
        g_assert_cmpfloat_with_epsilon(growth, radius, 0.02);
        growth = tinker_long_run_growth(method, radius, (TinkerOscillator){0.01, 0}, 1.0);
        g_assert_cmpfloat_with_epsilon(growth, 1, 1e-3);
    }
}

/* Of a method that has no memory both measures are one. */
static void test_long_run_without_memory(void)
{
    const TinkerOscillator oscillator = {0.64, 0.3};
    const double growth = tinker_long_run_growth(tinker_integrator_builtin("rk4"), 0, oscillator, 1.0);
    g_assert_cmpfloat_with_epsilon(growth, growth_of("rk4", oscillator), 1e-3);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/amplification/runge-kutta", test_runge_kutta);
    g_test_add_func("/amplification/average-acceleration", test_average_acceleration);
    g_test_add_func("/amplification/real-factors", test_real_factors);
    g_test_add_func("/amplification/long-run", test_long_run);
    g_test_add_func("/amplification/long-run-without-memory", test_long_run_without_memory);
    return g_test_run();
}
