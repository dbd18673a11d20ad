/* Spectra under forces across velocities: closed forms, and the limit that is observed. */
#include <math.h>

#include "numerics/methods/integrators.h"
#include "spectrum-checks.h"

/* A mass that a spring of rest length 0 holds at its support: x'' = -k x - c x' + W J x'. */
static char *turned(double stiffness, double rate, double drag)
{
    return g_strdup_printf("{'type': 'turned', 'rate': %.17g, 'drag': %.17g}, {'type': 'support', 'solid': false},"
                           "{'type': 'mass', 'mass': 3, 'velocity': [0.3, 0.1]},"
                           "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': %.17g, 'rest_length': 0}",
                           rate, drag, 3 * stiffness);
}

/* With z = x + iy and no drag, z = exp(i s t): s = -W/2 +- sqrt(W^2/4 + k). Of the fastest, rk4 is stable up to 2 sqrt
 * 2 / s. Semi-implicit Euler's map has the determinant |1 + i h W|^2 at every step: it grows at all of them. Verlet's
 * multipliers are the roots of (1 + z) m^2 - (2 - h^2 k) m + (1 - z), z = i h W / 2: on the unit circle while h^2 k <=
 * 2 + 2 |1 + z|. */
static void test_turned(void)
{
    static const double cases[][2] = {{0, 1}, {4, 100}, {4, 1}, {1e-4, 1}, {1e6, 3}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double k = cases[i][0], w = cases[i][1], fastest = 0.5 * w + sqrt(0.25 * w * w + k);
        g_autofree char *text = turned(k, w, 0);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        physics_assert_near("fastest", spectrum->omega_max / fastest, 1, 1e-9);
        g_assert_cmpfloat(spectrum->growth_max, ==, 0);
        g_assert_cmpfloat(spectrum->damping_max, ==, 0);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4");
        physics_assert_near("rk4", spectrum_limit(spectrum, rk4) * fastest, 2 * G_SQRT2, 1e-5);
        g_assert_cmpfloat(spectrum_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler")), ==, 0);
        double verlet = spectrum_limit(spectrum, tinker_integrator_builtin("verlet"));
        /* (h^2 k - 2)^2 = 4 + h^2 W^2: h^2 = (4 k + W^2) / k^2 */
        double h = k > 0 ? sqrt(4 * k + w * w) / k : INFINITY;
        if (h * fmax(w, sqrt(k)) < 1e6)
            physics_assert_near("verlet", verlet / h, 1, h * w > 1000 ? 5e-3 : 1e-5); /* rounding of long steps */
        else
            g_assert_cmpfloat(verlet, ==, INFINITY);
        spectrum_assert_limit(spectrum_case_island(&compiled), spectrum, rk4, fastest, "turned");
        if (isfinite(verlet))
            spectrum_assert_limit(spectrum_case_island(&compiled), spectrum, tinker_integrator_builtin("verlet"),
                                  fastest, "turned");
        if (k == 0 || k >= 1)
            spectrum_assert_limit(spectrum_case_island(&compiled), spectrum, tinker_integrator_builtin("verlet6"),
                                  fastest, "turned");
    }
}

/* Semi-implicit Euler with drag on a free body: v becomes (1 - h c + i h W) v, stable up to h = 2 c / (c^2 + W^2). */
static void test_turned_with_drag(void)
{
    static const double cases[][2] = {{1, 2}, {10, 2}, {1, 0.1}, {30, 0.7}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double w = cases[i][0], c = cases[i][1];
        g_autofree char *text = turned(0, w, c);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        double limit = spectrum_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler"));
        physics_assert_near("limit", limit * (c * c + w * w) / (2 * c), 1, 1e-4);
        physics_assert_near("decay", spectrum->damping_max, c, 1e-6 * (c + w));
        g_assert_cmpfloat(spectrum_limit(spectrum, tinker_integrator_builtin("verlet")), ==, INFINITY);
    }
}

/* A rod leaves nothing of it: theta'' = -k (L - L0) L'' = -1.5 k theta, as without the field. */
static void test_turned_on_a_rod(void)
{
    g_auto(SpectrumCase) compiled =
        spectrum_case("{'type': 'turned', 'rate': 3}, {'type': 'support', 'solid': false},"
                      "{'type': 'support', 'solid': false, 'position': [3, 0]}, {'type': 'mass', 'position': [1, 0]},"
                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                      "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 1e4, 'rest_length': 1}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
    const double limit = spectrum_limit(spectrum, tinker_integrator_builtin("verlet"));
    physics_assert_near("limit", limit * sqrt(1.5e4), 2, 1e-4);
}

/* Two springs of different stiffness across each other, so that no shapes are common to K and C: the limit is that
 * observed. */
static void test_turned_askew(void)
{
    g_auto(SpectrumCase) compiled =
        spectrum_case("{'type': 'turned', 'rate': 7, 'drag': 0.9},"
                      "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
                      "{'type': 'support', 'solid': false, 'position': [0, -1]}, {'type': 'mass', 'mass': 3},"
                      "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 90, 'rest_length': 1},"
                      "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 12, 'rest_length': 1}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
    spectrum_assert_limits(spectrum_case_island(&compiled), spectrum, 10, "turned, two springs");
}

/* A chain along x has no stiffness across: a mode of frequency w becomes one of sqrt(w^2 + W^2). Of many bodies, or by
 * extreme values alone, no limit is claimed of methods that split; of few, the forces across leave that of Verlet at
 * least as it was. */
static void test_turned_chains(void)
{
    static const int counts[] = {5, 20, 120};
    for (gsize i = 0; i < G_N_ELEMENTS(counts); i++) {
        const int n = counts[i];
        g_autofree char *links = spectrum_chain(n, 1, 1e4, 0, 1);
        g_autofree char *text = g_strdup_printf("{'type': 'turned', 'rate': 150}, %s", links);
        g_auto(SpectrumCase) compiled = spectrum_case(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(spectrum_case_island(&compiled));
        const double fastest = hypot(200 * sin(n * G_PI / (2 * (n + 1))), 150);
        physics_assert_near("fastest", spectrum->omega_max / fastest, 1, n <= 20 ? 1e-9 : 5e-3);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4"), *verlet = tinker_integrator_builtin("verlet");
        physics_assert_near("rk4", spectrum_limit(spectrum, rk4) * fastest / (2 * G_SQRT2), 1, 1e-2);
        if (n == 5)
            g_assert_cmpfloat(spectrum_limit(spectrum, verlet), >=,
                              (1 - 1e-6) * 2 / (200 * sin(n * G_PI / (2 * (n + 1)))));
        else
            g_assert_true(isnan(spectrum_limit(spectrum, verlet)));
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/spectrum/turned", test_turned);
    g_test_add_func("/physics/spectrum/turned-with-drag", test_turned_with_drag);
    g_test_add_func("/physics/spectrum/turned-askew", test_turned_askew);
    g_test_add_func("/physics/spectrum/turned-on-a-rod", test_turned_on_a_rod);
    g_test_add_func("/physics/spectrum/turned-chains", test_turned_chains);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
