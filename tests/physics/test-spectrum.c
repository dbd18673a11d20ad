/* Spectra and stable steps: closed forms, and the limit that is observed when the method itself steps the scene. */
#include "physics-fixture.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "numerics/stability/amplification.h"
#include "physics/compile/compile.h"
#include "physics/force/forces.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* A compiled scene of one island. */
typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    GPtrArray *islands;
} Compiled;

static Compiled compile(const char *blocks)
{
    g_autoptr(GError) error = NULL;
    Compiled compiled = {.scene = physics_scene(NULL, blocks)};
    compiled.model = tinker_model_new(compiled.scene, &error);
    if (compiled.model != NULL) compiled.islands = tinker_islands_new(compiled.model, &error);
    if (compiled.islands == NULL) g_error("%s", error->message);
    return compiled;
}

static void compiled_clear(Compiled *compiled)
{
    g_ptr_array_unref(compiled->islands);
    tinker_model_free(compiled->model);
    tinker_scene_free(compiled->scene);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Compiled, compiled_clear)

static const TinkerIsland *first_island(const Compiled *compiled)
{
    return g_ptr_array_index(compiled->islands, 0);
}

static double forecast_limit(const TinkerSpectrum *spectrum, const TinkerIntegrator *method)
{
    return tinker_spectrum_stable_step(spectrum, method, 0.8);
}

/* Observed limits ---------------------------------------------------------------------------------------------------
 */

/* The largest departure from the start, in some steps of h from step number `from` on. */
static double largest_departure(const TinkerIntegrator *method, void *stepper, TinkerState *state, const double *start,
                                int32_t n, double h, double rate, int from)
{
    double largest = 0;
    for (int i = from + 1; i <= from + 1000; i++) {
        TinkerStepReport report = {.struct_size = sizeof report};
        if (method->step(stepper, state, i * h, &report) != TINKER_OK) return INFINITY;
        double size = 0;
        for (int32_t k = 0; k < n; k++)
            size = fmax(size, fmax(rate * fabs(state->q[k] - start[k]), fabs(state->v[k])));
        if (!isfinite(size) || size > 1e-3 * rate) return INFINITY;
        if (size < 1e-12 * rate) return 0; /* died down to rounding of the places */
        largest = fmax(largest, size);
    }
    return largest;
}

/* Whether the motion that begins with small velocities of every shape still grows after some hundred steps of h. The
 * start is at rest and in balance. */
static gboolean grows(const TinkerIsland *island, const TinkerIntegrator *method, double h, double rate)
{
    TinkerModelSystem system;
    tinker_model_system_init(&system, island->model, island->linear);
    int32_t n = system.system.size;
    g_autofree double *start = g_new0(double, n), *q = g_new0(double, n), *v = g_new0(double, n);
    g_autofree double *books = g_new0(double, TINKER_BOOK_COUNT), *room = g_new0(double, n);
    if (island->linear != NULL)
        tinker_linear_form_reduce(island->linear, island->model->q_start, island->model->v_start, start, room);
    else
        memcpy(start, island->model->q_start, (gsize)n * sizeof(double));
    memcpy(q, start, (gsize)n * sizeof(double));
    for (int32_t i = 0; i < n; i++)
        v[i] = 1e-7 * rate * sin(1.7 * i + 0.3);
    TinkerIntegratorOptions options = {.struct_size = sizeof options, .tolerance = 1e-9, .spectral_radius = 0.8};
    void *stepper = method->create(&system.system, &options);
    g_assert_nonnull(stepper);
    TinkerState state = {0, q, v, books};
    /* the first steps are left out: what was not in balance settles there */
    double sizes[4] = {largest_departure(method, stepper, &state, start, n, h, rate, 0)};
    for (int part = 1; part < 4; part++) {
        gboolean over = sizes[part - 1] == 0 || !isfinite(sizes[part - 1]);
        sizes[part] =
            over ? sizes[part - 1] : largest_departure(method, stepper, &state, start, n, h, rate, 1000 * part);
    }
    method->destroy(stepper);
    tinker_model_system_clear(&system);
    return !isfinite(sizes[3]) || sizes[3] > 1.15 * sizes[1];
}

/* The forecast is within 5 % of the limit: 5 % below it nothing grows, 5 % above it does. */
static void assert_limit(const TinkerIsland *island, const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                         double rate, const char *what)
{
    double limit = forecast_limit(spectrum, method);
    g_assert_cmpfloat(limit, >, 0);
    if (grows(island, method, 0.95 * fmin(limit, 1e3 / rate), rate))
        g_test_fail_printf("%s: %s grows at 0.95 of the forecast limit %g s", what, method->id, limit);
    if (isfinite(limit) && !grows(island, method, 1.05 * limit, rate))
        g_test_fail_printf("%s: %s does not grow at 1.05 of the forecast limit %g s", what, method->id, limit);
}

static void assert_limits(const TinkerIsland *island, const TinkerSpectrum *spectrum, double rate, const char *what)
{
    int seen = 0;
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++) {
        if (!tinker_method_is_fixed_explicit(*each)) continue;
        assert_limit(island, spectrum, *each, rate, what);
        seen++;
    }
    g_assert_cmpint(seen, >=, 3);
}

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
            g_auto(Compiled) compiled = compile(text);
            g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
            physics_assert_near("omega_max", spectrum->omega_max / omega, 1, 1e-12);
            g_autofree char *what = g_strdup_printf("omega %g, damping ratio %g", omega, dampings[i]);
            assert_limits(first_island(&compiled), spectrum, omega * fmax(1, 2 * dampings[i]), what);
        }
    }
}

/* A chain of `count` masses from wall to wall, at rest; dampers where `damping` is not 0, all of them or every third.
 */
static char *chain(int count, double mass, double stiffness, double damping, int every)
{
    GString *text = g_string_new("{'type': 'support'}");
    for (int i = 0; i < count; i++)
        g_string_append_printf(text, ",{'type': 'mass', 'mass': %.17g, 'position': [%d, 0]}", mass, i + 1);
    g_string_append_printf(text, ",{'type': 'support', 'position': [%d, 0]}", count + 1);
    for (int i = 0; i <= count; i++) {
        g_autofree char *a = i == 0 ? g_strdup("Support 0") : g_strdup_printf("Mass %d", i - 1);
        g_autofree char *b = i == count ? g_strdup("Support 1") : g_strdup_printf("Mass %d", i);
        g_string_append_printf(text, ",{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g, 'rest_length': 1}",
                               a, b, stiffness);
        if (damping > 0 && i % every == 0)
            g_string_append_printf(text, ",{'type': 'damper', 'ends': ['%s', '%s'], 'damping': %.17g}", a, b, damping);
    }
    return g_string_free(text, FALSE);
}

/* 2 sqrt(k/m) sin(n pi / (2 (n + 1))), dense and by Lanczos iterations. */
static void test_chains(void)
{
    static const struct {
        int count;
        double bound;
    } cases[] = {{1, 1e-12}, {10, 1e-12}, {60, 1e-12}, {400, 5e-3}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = chain(cases[i].count, 0.25, 1e4, 0, 1);
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        double omega = 2 * 200 * sin(cases[i].count * G_PI / (2 * (cases[i].count + 1)));
        physics_assert_near("omega_max", spectrum->omega_max / omega, 1, cases[i].bound);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4");
        physics_assert_near("rk4", forecast_limit(spectrum, rk4) * omega / (2 * G_SQRT2), 1, 5e-3 + cases[i].bound);
        g_assert_true(spectrum->complete == (cases[i].count <= TINKER_DENSE_SPECTRUM));
        g_assert_cmpfloat(spectrum->damping_max, ==, 0);
    }
}

/* Dampers at every third spring: no modes in common. */
static void test_damped_chains(void)
{
    static const double dampings[] = {1, 30, 1000};
    for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++) {
        g_autofree char *text = chain(9, 1, 1e4, dampings[i], 3);
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        g_autofree char *what = g_strdup_printf("chain with dampers of %g N s/m", dampings[i]);
        assert_limits(first_island(&compiled), spectrum, fmax(200, 2 * dampings[i]), what);
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
        g_autofree char *text = chain(300, 1, 1e4, dampings[i], 1);
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        double top = 4 * pow(sin(300 * G_PI / 602), 2), k = 1e4 * top, c = dampings[i] * top;
        double euler = (sqrt(4 * c * c + 16 * k) - 2 * c) / (2 * k);
        g_assert_false(spectrum->complete);
        physics_assert_near("rk4", forecast_limit(spectrum, tinker_integrator_builtin("rk4")) / rk4_limit(k, c), 1,
                            0.05);
        physics_assert_near("semi-implicit Euler",
                            forecast_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler")) / euler, 1,
                            0.05);
        physics_assert_near("verlet", forecast_limit(spectrum, tinker_integrator_builtin("verlet")) * sqrt(k) / 2, 1,
                            0.05);
    }
}

/* Tensions of rods make the stiffness: sqrt(g/L) of a pendulum, g/L (2 +- sqrt 2) of two equal ones in a row. */
static void test_pendulums(void)
{
    g_auto(Compiled) one = compile("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, -2]},"
                                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_autoptr(TinkerSpectrum) single = tinker_spectrum_new(first_island(&one));
    physics_assert_near("single", single->omega_max, sqrt(9.81 / 2), 1e-6);
    g_auto(Compiled) two = compile("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, -1]},"
                                   "{'type': 'mass', 'position': [0, -2]},"
                                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                                   "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}");
    g_autoptr(TinkerSpectrum) pair = tinker_spectrum_new(first_island(&two));
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
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        physics_assert_near("omega_max", spectrum->omega_max / sqrt(3125), 1, 1e-7);
        g_assert_cmpfloat(spectrum->growth_max, ==, 0);
        g_assert_cmpuint(spectrum->oscillators->len, ==, 2);
        TinkerModel *model = first_island(&compiled)->model;
        double product[2];
        g_assert_cmpint(tinker_model_set_time(model, 0), ==, TINKER_OK);
        tinker_model_set_state(model, model->q_start, model->v_start);
        g_assert_cmpint(tinker_model_stiffness_product(model, (double[]){3, 4}, product), ==, TINKER_OK);
        physics_assert_near("x of the product", product[0], -3125 * 3, 1e-3);
        physics_assert_near("y of the product", product[1], -3125 * 4, 1e-3);
        assert_limit(first_island(&compiled), spectrum, tinker_integrator_builtin("verlet"), sqrt(3125), types[i]);
    }
}

/* Held upright, it falls at sqrt(g/L): growth, and no limit. */
static void test_growth(void)
{
    g_auto(Compiled) compiled =
        compile("{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0, 2]},"
                "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
    physics_assert_near("growth", spectrum->growth_max, sqrt(9.81 / 2), 1e-6);
    g_assert_cmpfloat(spectrum->omega_max, ==, 0);
    g_assert_cmpfloat(spectrum->damping_max, ==, 0);
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

/* Forces across velocities
 * --------------------------------------------------------------------------------------------- */

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
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        physics_assert_near("fastest", spectrum->omega_max / fastest, 1, 1e-9);
        g_assert_cmpfloat(spectrum->growth_max, ==, 0);
        g_assert_cmpfloat(spectrum->damping_max, ==, 0);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4");
        physics_assert_near("rk4", forecast_limit(spectrum, rk4) * fastest, 2 * G_SQRT2, 1e-5);
        g_assert_cmpfloat(forecast_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler")), ==, 0);
        double verlet = forecast_limit(spectrum, tinker_integrator_builtin("verlet"));
        /* (h^2 k - 2)^2 = 4 + h^2 W^2: h^2 = (4 k + W^2) / k^2 */
        double h = k > 0 ? sqrt(4 * k + w * w) / k : INFINITY;
        if (h * fmax(w, sqrt(k)) < 1e6)
            physics_assert_near("verlet", verlet / h, 1, h * w > 1000 ? 5e-3 : 1e-5); /* rounding of long steps */
        else
            g_assert_cmpfloat(verlet, ==, INFINITY);
        assert_limit(first_island(&compiled), spectrum, rk4, fastest, "turned");
        if (isfinite(verlet))
            assert_limit(first_island(&compiled), spectrum, tinker_integrator_builtin("verlet"), fastest, "turned");
        if (k == 0 || k >= 1)
            assert_limit(first_island(&compiled), spectrum, tinker_integrator_builtin("verlet6"), fastest, "turned");
    }
}

/* Semi-implicit Euler with drag on a free body: v becomes (1 - h c + i h W) v, stable up to h = 2 c / (c^2 + W^2). */
static void test_turned_with_drag(void)
{
    static const double cases[][2] = {{1, 2}, {10, 2}, {1, 0.1}, {30, 0.7}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double w = cases[i][0], c = cases[i][1];
        g_autofree char *text = turned(0, w, c);
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        double limit = forecast_limit(spectrum, tinker_integrator_builtin("semi-implicit-euler"));
        physics_assert_near("limit", limit * (c * c + w * w) / (2 * c), 1, 1e-4);
        physics_assert_near("decay", spectrum->damping_max, c, 1e-6 * (c + w));
        g_assert_cmpfloat(forecast_limit(spectrum, tinker_integrator_builtin("verlet")), ==, INFINITY);
    }
}

/* A rod leaves nothing of it: theta'' = -k (L - L0) L'' = -1.5 k theta, as without the field. */
static void test_turned_on_a_rod(void)
{
    g_auto(Compiled) compiled =
        compile("{'type': 'turned', 'rate': 3}, {'type': 'support', 'solid': false},"
                "{'type': 'support', 'solid': false, 'position': [3, 0]}, {'type': 'mass', 'position': [1, 0]},"
                "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 1e4, 'rest_length': 1}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
    const double limit = forecast_limit(spectrum, tinker_integrator_builtin("verlet"));
    physics_assert_near("limit", limit * sqrt(1.5e4), 2, 1e-4);
}

/* Two springs of different stiffness across each other, so that no shapes are common to K and C: the limit is that
 * observed. */
static void test_turned_askew(void)
{
    g_auto(Compiled) compiled =
        compile("{'type': 'turned', 'rate': 7, 'drag': 0.9},"
                "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
                "{'type': 'support', 'solid': false, 'position': [0, -1]}, {'type': 'mass', 'mass': 3},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 90, 'rest_length': 1},"
                "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 12, 'rest_length': 1}");
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
    assert_limits(first_island(&compiled), spectrum, 10, "turned, two springs");
}

/* A chain along x has no stiffness across: a mode of frequency w becomes one of sqrt(w^2 + W^2). Of many bodies, or by
 * extreme values alone, no limit is claimed of methods that split; of few, the forces across leave that of Verlet at
 * least as it was. */
static void test_turned_chains(void)
{
    static const int counts[] = {5, 20, 120};
    for (gsize i = 0; i < G_N_ELEMENTS(counts); i++) {
        const int n = counts[i];
        g_autofree char *links = chain(n, 1, 1e4, 0, 1);
        g_autofree char *text = g_strdup_printf("{'type': 'turned', 'rate': 150}, %s", links);
        g_auto(Compiled) compiled = compile(text);
        g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(first_island(&compiled));
        const double fastest = hypot(200 * sin(n * G_PI / (2 * (n + 1))), 150);
        physics_assert_near("fastest", spectrum->omega_max / fastest, 1, n <= 20 ? 1e-9 : 5e-3);
        const TinkerIntegrator *rk4 = tinker_integrator_builtin("rk4"), *verlet = tinker_integrator_builtin("verlet");
        physics_assert_near("rk4", forecast_limit(spectrum, rk4) * fastest / (2 * G_SQRT2), 1, 1e-2);
        if (n == 5)
            g_assert_cmpfloat(forecast_limit(spectrum, verlet), >=,
                              (1 - 1e-6) * 2 / (200 * sin(n * G_PI / (2 * (n + 1)))));
        else
            g_assert_true(isnan(forecast_limit(spectrum, verlet)));
    }
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
    g_test_add_func("/physics/spectrum/turned", test_turned);
    g_test_add_func("/physics/spectrum/turned-with-drag", test_turned_with_drag);
    g_test_add_func("/physics/spectrum/turned-askew", test_turned_askew);
    g_test_add_func("/physics/spectrum/turned-on-a-rod", test_turned_on_a_rod);
    g_test_add_func("/physics/spectrum/turned-chains", test_turned_chains);
    g_test_add_func("/physics/spectrum/amplification", test_amplification);
    g_test_add_func("/physics/spectrum/step-error", test_step_error);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
