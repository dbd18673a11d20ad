/* Spectra and stable steps: closed forms, and the limit that is observed when the method itself steps the scene. */
#include <complex.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "numerics/stability/amplification.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "spectrum-checks.h"

/* k/m over 16 decades, dampings from none to 200 times critical: c/m over 12. */
static void test_oscillators(void)
{
    static const double dampings[] = {0, 0.01, 0.7, 2, 30, 200};
    for (int decade = -8; decade <= 8; decade += 2) {
        for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++) {
            double omega = pow(10, 0.5 * decade), mass = 3;
            g_autofree char *text = g_strdup_printf(
                "{'type': 'support'}, {'type': 'mass', 'mass': %g, 'position': [2, 0]},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': %.17g, 'rest_length': 2},"
                "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': %.17g}",
                mass, mass * omega * omega, 2 * dampings[i] * mass * omega);
            g_auto(SpectrumCase) compiled = spectrum_case(text);
            g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
            physics_assert_near("omega_max", spectrum->omega_max / omega, 1, 1e-12);
            g_autofree char *what = g_strdup_printf("omega %g, damping ratio %g", omega, dampings[i]);
            spectrum_assert_limits(spectrum_case_island(&compiled), spectrum, omega * fmax(1, 2 * dampings[i]), what);
        }
    }
}

/* 2 sqrt(k/m) sin(n pi / (2 (n + 1))), dense and by Lanczos iterations. */
static void test_chains(void)
{
    static const struct {
        int count;
        double bound;
    } cases[] = {{1, 1e-12}, {10, 1e-12}, {60, 1e-12}, {400, 5e-3}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = spectrum_chain(cases[i].count, 0.25, 1e4, 0, 1);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        double omega = 2 * 200 * sin(cases[i].count * G_PI / (2 * (cases[i].count + 1)));
        physics_assert_near("omega_max", spectrum->omega_max / omega, 1, cases[i].bound);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4");
        physics_assert_near("rk4", spectrum_limit(spectrum, rk4) * omega / (2 * G_SQRT2), 1, 5e-3 + cases[i].bound);
        g_assert_true(spectrum->complete == (cases[i].count <= TINKER_DENSE_SPECTRUM));
        g_assert_cmpfloat(spectrum->damping_max, ==, 0);
    }
}

/* Dampers at every third spring: no modes in common. */
static void test_damped_chains(void)
{
    static const double dampings[] = {1, 30, 1000};
    for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++) {
        g_autofree char *text = spectrum_chain(9, 1, 1e4, dampings[i], 3);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        g_autofree char *what = g_strdup_printf("chain with dampers of %g N s/m", dampings[i]);
        spectrum_assert_limits(spectrum_case_island(&compiled), spectrum, fmax(200, 2 * dampings[i]), what);
    }
}

/* |R(h lambda)| <= 1 for the root lambda of a mode: where it first fails. */
static double rk4_limit(double stiffness, double damping)
{
    double complex lambda = -0.5 * damping + csqrt(0.25 * damping * damping - stiffness);
    double complex other = -0.5 * damping - csqrt(0.25 * damping * damping - stiffness);
    if (cabs(other) > cabs(lambda)) lambda = other;
    double low = 1e-3 / cabs(lambda), high = 10 / cabs(lambda);
    for (int i = 0; i < 60; i++) {
        double complex z = 0.5 * (low + high) * lambda;
        if (cabs(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)))) <= 1)
            low = 0.5 * (low + high);
        else
            high = 0.5 * (low + high);
    }
    return low;
}

/* Large, with a damper beside every spring: each mode is an oscillator whose damping is in proportion, and the stiffest
 * mode is the most damped one, so that it alone limits. Semi-implicit Euler: h^2 k + 2 h c = 4. */
static void test_large_damped_chain(void)
{
    static const double dampings[] = {2, 60, 2000};
    for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++) {
        g_autofree char *text = spectrum_chain(300, 1, 1e4, dampings[i], 1);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        double top = 4 * pow(sin(300 * G_PI / 602), 2), k = 1e4 * top, c = dampings[i] * top;
        double euler = (sqrt(4 * c * c + 16 * k) - 2 * c) / (2 * k);
        g_assert_false(spectrum->complete);
        physics_assert_near("rk4", spectrum_limit(spectrum, tinker_integrator_builtin("rk4")) / rk4_limit(k, c), 1,
                            0.05);
        physics_assert_near("semi-implicit Euler",
                            spectrum_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler")) / euler, 1,
                            0.05);
        physics_assert_near("verlet", spectrum_limit(spectrum, tinker_integrator_builtin("verlet")) * sqrt(k) / 2, 1,
                            0.05);
    }
}

/* Tensions of rods make the stiffness: sqrt(g/L) of a pendulum, g/L (2 +- sqrt 2) of two equal ones in a row. */
static void test_pendulums(void)
{
    g_auto(SpectrumCase) one =
        spectrum_case("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, -2]},"
                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_autoptr(TinkerSpectrum) single = tinker_spectrum_new(spectrum_case_island(&one));
    physics_assert_near("single", single->omega_max, sqrt(9.81 / 2), 1e-6);
    g_auto(SpectrumCase) two =
        spectrum_case("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, -1]},"
                      "{'type': 'mass', 'position': [0, -2]},"
                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                      "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}");
    g_autoptr(TinkerSpectrum) pair = tinker_spectrum_new(spectrum_case_island(&two));
    g_assert_cmpuint(pair->eigenvalues->len, ==, 2);
    physics_assert_near("double", pair->omega_max, sqrt(9.81 * (2 + G_SQRT2)), 1e-5);
    double slow = INFINITY;
    for (guint i = 0; i < 2; i++)
        slow = fmin(slow, g_array_index(pair->eigenvalues, TinkerEigenvalue, i).im);
    physics_assert_near("slow mode", slow, sqrt(9.81 * (2 - G_SQRT2)), 1e-5);
}

/* On a softened magnet that it starts in the middle of, a mass swings as sqrt(c / s^5 / m): exactly, and by products.
 */
static void test_magnet(void)
{
    static const char *const types[] = {"magnet", "plain-magnet"};
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *text =
            g_strdup_printf("{'type': 'support', 'position': [2, 1], 'solid': false},"
                            "{'type': 'mass', 'mass': 0.5, 'position': [2, 1], 'velocity': [0.1, 0]},"
                            "{'type': '%s', 'ends': ['Support 0', 'Mass 0'], 'strength': 0.5, 'softening': 0.2}",
                            types[i]);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        physics_assert_near("omega_max", spectrum->omega_max / sqrt(3125), 1, 1e-7);
        g_assert_cmpfloat(spectrum->growth_max, ==, 0);
        g_assert_cmpuint(spectrum->oscillators->len, ==, 2);
        TinkerModel *model = spectrum_case_island(&compiled)->model;
        double product[2];
        g_assert_cmpint(tinker_model_set_time(model, 0), ==, TINKER_OK);
        tinker_model_set_state(model, model->q_start, model->v_start);
        g_assert_cmpint(tinker_model_stiffness_product(model, (double[]){3, 4}, product), ==, TINKER_OK);
        physics_assert_near("x of the product", product[0], -3125 * 3, 1e-3);
        physics_assert_near("y of the product", product[1], -3125 * 4, 1e-3);
        spectrum_assert_limit(spectrum_case_island(&compiled), spectrum, tinker_integrator_builtin("verlet"),
                              sqrt(3125), types[i]);
    }
}

/* Held upright, it falls at sqrt(g/L): growth, and no limit. */
static void test_growth(void)
{
    g_auto(SpectrumCase) compiled =
        spectrum_case("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, 2]},"
                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
    physics_assert_near("growth", spectrum->growth_max, sqrt(9.81 / 2), 1e-6);
    g_assert_cmpfloat(spectrum->omega_max, ==, 0);
    g_assert_cmpfloat(spectrum->damping_max, ==, 0);
}

/* A double pendulum without weight, of masses alike, that turns evenly, its second rod of length l folded back along
 * the first one of 1 m: with e the angle off that, the equations of both angles give e'' = W^2 ((2 - l) / l - (1 - l))
 * e. Stretched out it stays so; and so does a linkage of one freedom. */
static void test_growth_in_motion(void)
{
    static const double lengths[] = {0.3, 0.5, 0.8, 1.3}, rates[] = {0.01, 3, 200};
    for (gsize i = 0; i < G_N_ELEMENTS(lengths) * G_N_ELEMENTS(rates); i++)
        for (int side = -1; side <= 1; side += 2) {
            const double l = lengths[i % G_N_ELEMENTS(lengths)], rate = rates[i / G_N_ELEMENTS(lengths)];
            g_autofree char *text = g_strdup_printf(
                "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0], 'velocity': [0, %.17g]},"
                "{'type': 'mass', 'position': [%.17g, 0], 'velocity': [0, %.17g]},"
                "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                rate, 1 + side * l, rate * (1 + side * l));
            g_auto(SpectrumCase) compiled = spectrum_case(text);
            g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
            const double growth = side > 0 ? 0 : sqrt((2 - l) / l - (1 - l));
            physics_assert_near("growth", spectrum->growth_max / rate, growth, 1e-6);
        }
    g_auto(SpectrumCase) linkage =
        spectrum_case("{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [4, 0]},"
                      "{'type': 'mass', 'position': [0, 1], 'velocity': [3, 0]}, {'type': 'mass', 'position': [4, 3]},"
                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                      "{'type': 'rod', 'ends': ['Support 1', 'Mass 1']}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&linkage));
    g_assert_cmpfloat(spectrum->growth_max, ==, 0);
}

/* An upright double pendulum, of masses and lengths alike, that hardly moves: ((2 + sqrt(2)) g / l)^(1/2). Its upper
 * rod is a spring whose frequency is nearly 2e4 rad/s. */
static void test_growth_beside_stiffness(void)
{
    static const double speeds[] = {0, 1e-6, 1e-3};
    for (gsize i = 0; i < G_N_ELEMENTS(speeds); i++) {
        g_autofree char *text = g_strdup_printf(
            "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1],"
            " 'velocity': [%g, 0]}, {'type': 'mass', 'position': [0, 2]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
            "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1e8, 'rest_length': %.17g}",
            speeds[i], 1 + 9.81 / 1e8);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        physics_assert_near("growth", spectrum->growth_max, sqrt((2 + G_SQRT2) * 9.81), 1e-4);
    }
}

/* One step of rk4 is the Taylor polynomial of degree 4 of the oscillator's matrix. */
static void test_amplification(void)
{
    double k = 7, c = 0.9, h = 0.31, map[4];
    g_assert_true(tinker_amplification(tinker_integrator_builtin("rk4"), 0.8, (TinkerOscillator){k, c}, h, map));
    double power[4] = {1, 0, 0, 1}, sum[4] = {1, 0, 0, 1};
    for (int i = 1; i <= 4; i++) {
        double next[4] = {-k * power[1], power[0] - c * power[1], -k * power[3], power[2] - c * power[3]};
        for (int j = 0; j < 4; j++) {
            power[j] = next[j] * h / i;
            sum[j] += power[j];
        }
    }
    for (int j = 0; j < 4; j++)
        physics_assert_near("entry", map[j], sum[j], 1e-14);
}

/* Verlet is late by the same angle every step. */
static void test_step_error(void)
{
    const TinkerIntegrator *verlet = tinker_integrator_builtin("verlet");
    double omega = 3, h = 0.01, t = 400;
    /* the cosine of its angle is 1 - (h omega)^2 / 2 */
    double late = t / h * (acos(1 - 0.5 * h * h * omega * omega) - h * omega);
    double error = tinker_step_error(verlet, 0.8, (TinkerOscillator){omega * omega, 0}, h, t);
    physics_assert_near("error", error, 2 * fabs(sin(0.5 * late)), 2e-4);
    g_assert_cmpfloat(tinker_step_error(verlet, 0.8, (TinkerOscillator){omega * omega, 0}, 2.1 / omega, t), >, 1e6);
}

static void add_tests(void)
{
    g_test_add_func("/physics/spectrum/oscillators", test_oscillators);
    g_test_add_func("/physics/spectrum/chains", test_chains);
    g_test_add_func("/physics/spectrum/damped-chains", test_damped_chains);
    g_test_add_func("/physics/spectrum/large-damped-chain", test_large_damped_chain);
    g_test_add_func("/physics/spectrum/pendulums", test_pendulums);
    g_test_add_func("/physics/spectrum/magnet", test_magnet);
    g_test_add_func("/physics/spectrum/growth", test_growth);
    g_test_add_func("/physics/spectrum/growth-in-motion", test_growth_in_motion);
    g_test_add_func("/physics/spectrum/growth-beside-stiffness", test_growth_beside_stiffness);
    g_test_add_func("/physics/spectrum/amplification", test_amplification);
    g_test_add_func("/physics/spectrum/step-error", test_step_error);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
