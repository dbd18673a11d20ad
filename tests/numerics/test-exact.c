/* The exact method on single masses, against closed forms: free and damped motion over many decades, forces at and
 * near resonance, moving supports, rounding that stays in bounds over a million periods. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "linear-case.h"
#include "numerics/exact/exact.h"
#include "numerics/methods/integrators.h"

/* Rounding of a motion of the given size after omega T. */
static double rounding(double size, double turns)
{
    return 8.0 * DBL_EPSILON * size * (2.0 + turns);
}

/* x'' + c x' + k x = 0 in extended precision; for near-critical damping the even series of both functions. */
static void oscillator(long double k, long double c, long double x0, long double v0, long double t, double out[2])
{
    long double delta = c / 2, gap = delta * delta - k, middle, slope;
    if (fabsl(gap) * t * t < 1.0L) {
        long double term = 1, odd = 1;
        middle = slope = 0;
        for (int i = 0; i < 30; i++) {
            middle += term;
            slope += odd;
            term *= gap * t * t / ((2 * i + 1) * (2 * i + 2));
            odd *= gap * t * t / ((2 * i + 2) * (2 * i + 3));
        }
        middle *= expl(-delta * t);
        slope *= t * expl(-delta * t);
    } else if (gap < 0) {
        long double rate = sqrtl(-gap);
        middle = expl(-delta * t) * cosl(rate * t);
        slope = expl(-delta * t) * sinl(rate * t) / rate;
    } else {
        long double root = sqrtl(gap), fast = -(delta + root), slow = -k / (delta + root);
        out[0] =
            (double)((x0 * (slow * expl(fast * t) - fast * expl(slow * t)) + v0 * (expl(slow * t) - expl(fast * t))) /
                     (slow - fast));
        out[1] = (double)((x0 * slow * fast * (expl(fast * t) - expl(slow * t)) +
                           v0 * (slow * expl(slow * t) - fast * expl(fast * t))) /
                          (slow - fast));
        return;
    }
    out[0] = (double)(x0 * (middle + delta * slope) + v0 * slope);
    out[1] = (double)(v0 * (middle - delta * slope) - x0 * k * slope);
}

static void assert_free_oscillator(double k, double c, double T, int steps)
{
    LinearCase test;
    double truth[2], omega = sqrt(k);
    case_init(&test, 1);
    case_edge(&test, -1, 0, k, c);
    test.q[0] = 1.0;
    test.v[0] = 0.5 * omega;
    oscillator(k, c, 1.0L, test.v[0], T, truth);
    case_run(&test, T, steps);
    double turns = omega * T;
    assert_near(test.q[0], truth[0], rounding(1.5, turns));
    assert_near(test.v[0], truth[1], rounding(1.5 * omega, turns));
}

/* k and c of twelve decades and more, times from a tenth of the fastest to a thousand of the slowest motion. */
static void test_free(void)
{
    for (double k = 1e-6; k < 2e12; k *= 1e3) {
        for (double zeta = 1e-6; zeta < 2e6; zeta *= 10.0) {
            double omega = sqrt(k), c = 2.0 * zeta * omega, slow = zeta > 1.0 ? omega / zeta : omega;
            assert_free_oscillator(k, c, 0.1 / fmax(omega, c), 1);
            assert_free_oscillator(k, c, 3.0 / slow, 1);
            assert_free_oscillator(k, c, 3.0 / slow, 100);
            assert_free_oscillator(k, c, 1000.0 / omega, 7);
        }
        assert_free_oscillator(k, 0.0, 1234.5 / sqrt(k), 1);
        assert_free_oscillator(k, 0.0, 1234.5 / sqrt(k), 1000);
    }
}

static void test_critical(void)
{
    for (double off = 1e-16; off < 1e-2; off *= 10.0)
        for (double T = 0.01; T < 20.0; T *= 3.0)
            for (int side = -1; side <= 1; side++)
                assert_free_oscillator(9.0, 6.0 * (1.0 + side * off), T, 1);
}

/* Slow roots keep their relative accuracy: what an overdamped oscillator creeps in a short time. */
static void test_creep(void)
{
    for (double c = 1e2; c < 1e13; c *= 10.0) {
        LinearCase test;
        double truth[2];
        case_init(&test, 1);
        case_edge(&test, -1, 0, 1.0, c);
        test.q[0] = 1.0;
        oscillator(1.0L, c, 1.0L, 0.0L, c * 0.01, truth);
        test.v[0] = 0.0;
        case_run(&test, c * 0.01, 50);
        assert_near(test.q[0], truth[0], 64.0 * DBL_EPSILON);
        assert_near(test.v[0] / truth[1], 1.0, 256.0 * DBL_EPSILON);
    }
}

static void test_free_fall(void)
{
    for (double drag = 0.0; drag < 2e6; drag = drag == 0.0 ? 1e-6 : drag * 10.0) {
        LinearCase test;
        case_init(&test, 1);
        test.mass[0] = 2.0;
        test.drag[0] = 2.0 * drag;
        test.q[0] = 3.0;
        test.v[0] = 5.0;
        case_load(&test, 0, -1, -2.0 * 9.81);
        double T = 4.0;
        long double r = drag, x = r * T, way, lag; /* (1 - exp(-x)) / r and (T - that) / r */
        way = drag == 0.0 ? T : -expm1l(-x) / r;
        lag = 0;
        if (x > 0.5L)
            lag = (T - way) / r;
        else
            for (int i = 25; i >= 2; i--)
                lag = (1.0L - x * lag) / i;
        if (x <= 0.5L) lag *= (long double)T * T;
        case_run(&test, T, 3);
        assert_near(test.q[0], (double)(3.0L + 5.0L * way - (long double)9.81 * lag), rounding(100.0, 0.0));
        assert_near(test.v[0], (double)(5.0L - (5.0L * r + (long double)9.81) * way), rounding(45.0, 0.0));
    }
}

/* A spring so weak that its place of rest lies far outside everything. */
static void test_weak_spring_under_load(void)
{
    for (double k = 1e-12; k < 1e3; k *= 10.0) {
        LinearCase test;
        case_init(&test, 1);
        case_edge(&test, -1, 0, k, 0.0);
        case_load(&test, 0, -1, 9.81);
        double T = 2.0;
        long double half = sinl(0.5L * sqrtl(k) * T);
        case_run(&test, T, 5);
        assert_near(test.q[0], (double)(2.0L * (long double)9.81 * half * half / k), rounding(20.0, sqrt(k) * T));
    }
}

static void test_resonance(void)
{
    double omega = 3.0, force = 0.7, T = 200.0;
    for (int steps = 1; steps <= 1000; steps *= 10) {
        LinearCase test;
        case_init(&test, 1);
        case_edge(&test, -1, 0, omega * omega, 0.0);
        case_force(&test, 0, case_harmonic(&test, force, omega, 0.0), -1, 1.0);
        long double angle = (long double)omega * T;
        case_run(&test, T, steps);
        double largest = force * T / (2.0 * omega);
        assert_near(test.q[0], (double)(force / (2.0L * omega * omega) * (sinl(angle) - angle * cosl(angle))),
                    rounding(largest, omega * T));
    }
}

/* Off resonance by the closed form, near it (where that cancels) by series in quadruple precision. */
static void test_harmonic_force(void)
{
    static const double ratios[] = {1e-4,        0.3,        0.99, 1.0 - 1e-6, 1.0 - 1e-10, 1.0,
                                    1.0 + 1e-13, 1.0 + 1e-8, 1.1,  7.0,        40.0};
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        for (int damped = 0; damped < 2; damped++) {
            LinearCase test, truth;
            case_init(&test, 1);
            case_edge(&test, -1, 0, 4.0, damped * 0.3);
            case_force(&test, 0, case_harmonic(&test, 1.5, 2.0 * ratios[i], 0.4), -1, 2.0);
            test.q[0] = 0.1;
            truth = test;
            truth.system.context = &truth;
            truth.system.linear = &truth.linear;
            double T = 40.0, turns = 2.0 * fmax(1.0, ratios[i]) * T;
            case_run_by_series(&truth, T, (int)(3.0 * turns));
            case_run(&test, T, i % 2 ? 1 : 37);
            double size = 3.0 * (damped ? 3.0 : T);
            assert_near(test.q[0], truth.q[0], rounding(size, turns));
            assert_near(test.v[0], truth.v[0], rounding(2.0 * size, turns));
        }
    }
}

/* The anchor goes as t^3: x = t^3 - 6 t / omega^2 + 6 sin(omega t) / omega^3. */
static void test_cubic_base(void)
{
    for (double omega = 1e-3; omega < 2e4; omega *= 10.0) {
        LinearCase test;
        case_init(&test, 1);
        case_edge(&test, -1, 0, omega * omega, 0.0);
        case_motion(&test, -1, case_polynomial(&test, 0.0, 0.0, 0.0, 1.0), 1.0);
        double T = 2.5;
        long double w = omega, angle = w * T, truth = 0.0L;
        if (angle > 1.0L) {
            truth = (long double)T * T * T - 6.0L * T / (w * w) + 6.0L * sinl(angle) / (w * w * w);
        } else { /* 6 / omega^3 times the sine less its first two terms */
            long double term = 6.0L * w * w * powl(T, 5) / 120.0L;
            for (int k = 2; k < 20; k++, term *= -angle * angle / ((2 * k) * (2 * k + 1)))
                truth += term;
        }
        case_run(&test, T, 4);
        assert_near(test.q[0], (double)truth, rounding(fmin(15.0, 5.0 * omega * omega), omega * T));
    }
}

static void test_damped_base(void)
{
    LinearCase test;
    case_init(&test, 1);
    test.mass[0] = 2.0;
    case_edge(&test, -1, 0, 50.0, 3.0)->length = 0.5;
    case_motion(&test, -1, case_harmonic(&test, 0.02, 6.0, 0.3), 1.0);
    case_motion(&test, -1, case_polynomial(&test, 0.01, -0.02, 0.003, 0.0004), 1.0);
    case_load(&test, 0, -1, -2.0);
    test.q[0] = 0.6;
    test.v[0] = -0.1;
    LinearCase truth = test;
    truth.system.context = &truth;
    truth.system.linear = &truth.linear;
    case_run_by_series(&truth, 8.0, 200);
    case_run(&test, 8.0, 5);
    assert_near(test.q[0], truth.q[0], rounding(1.0, 48.0));
    assert_near(test.v[0], truth.v[0], rounding(5.0, 48.0));
}

static void test_million_periods(void)
{
    double omega = 5.0, T = 2.0 * G_PI / omega * 1e6;
    for (int steps = 1; steps <= 1000000; steps *= 1000) {
        LinearCase test;
        case_init(&test, 1);
        case_edge(&test, -1, 0, omega * omega, 0.0);
        test.q[0] = 1.0;
        case_run(&test, T, steps);
        assert_near(test.q[0], (double)cosl((long double)omega * T), DBL_EPSILON * omega * T);
        assert_near(test.v[0] / omega, (double)-sinl((long double)omega * T), DBL_EPSILON * omega * T);
        g_assert_cmpfloat(tinker_exact_claimed_error(&test.linear, T), >=, DBL_EPSILON * omega * T);
        g_assert_cmpfloat(tinker_exact_claimed_error(&test.linear, T), <, 4.0 * DBL_EPSILON * omega * T);
    }
}

static void test_one_step_or_many(void)
{
    LinearCase one, many;
    for (int k = 0; k < 2; k++) {
        LinearCase *test = k == 0 ? &one : &many;
        case_init(test, 1);
        case_edge(test, -1, 0, 25.0, 0.05);
        case_force(test, 0, case_harmonic(test, 1.0, 4.9, 0.0), -1, 1.0);
        test->q[0] = 1.0;
        case_run(test, 100.0, k == 0 ? 1 : 10000);
    }
    assert_near(one.q[0], many.q[0], rounding(1.0, 500.0));
    assert_near(one.v[0], many.v[0], rounding(5.0, 500.0));
}

/* Long after t = 0 the lengths of equal steps differ by rounding of t, and the result must not drift. */
static void test_late_start(void)
{
    LinearCase test;
    case_init(&test, 1);
    case_edge(&test, -1, 0, 9.0, 0.0);
    test.q[0] = 1.0;
    test.t = 12345.678;
    double from = test.t, T = 500.0;
    case_run(&test, from + T, 30000);
    long double angle = 3.0L * ((long double)test.t - from);
    assert_near(test.q[0], (double)cosl(angle), 4.0 * DBL_EPSILON * 3.0 * (from + T));
    assert_near(test.v[0], (double)(-3.0L * sinl(angle)), 12.0 * DBL_EPSILON * 3.0 * (from + T));
}

/* A force in straight pieces, f = 1 - |t - 2k - 1|: the host restarts the method at every kink and the signal has
 * a new form; the propagator of the steps serves all pieces. Each piece by its closed form. */
static void test_pieces(void)
{
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    LinearCase test;
    case_init(&test, 1);
    case_edge(&test, -1, 0, 4.0, 0.0);
    case_force(&test, 0, case_polynomial(&test, 0.0, 1.0, 0.0, 0.0), -1, 1.0);
    TinkerState state = {0.0, test.q, test.v, test.books};
    void *stepper = exact->create(&test.system, &options);
    long double x = 0.0L, v = 0.0L;
    for (int piece = 0; piece < 40; piece++) {
        double slope = piece % 2 ? -1.0 : 1.0, level = piece % 2 ? 1.0 : 0.0;
        test.signals[0].origin = piece;
        test.signals[0].coefficient[0] = level;
        test.signals[0].coefficient[1] = slope;
        exact->restart(stepper);
        for (int k = 1; k <= 4; k++)
            g_assert_cmpint(exact->step(stepper, &state, piece + 0.25 * k, &report), ==, TINKER_OK);
        long double a = x - level / 4.0L, b = (v - slope / 4.0L) / 2.0L;
        x = (level + slope) / 4.0L + a * cosl(2.0L) + b * sinl(2.0L);
        v = slope / 4.0L + 2.0L * (b * cosl(2.0L) - a * sinl(2.0L));
        assert_near(state.q[0], (double)x, rounding(1.0, 80.0));
        assert_near(state.v[0], (double)v, rounding(2.0, 80.0));
    }
    exact->destroy(stepper);
}

/* --- the method --- */

static void test_interpolation(void)
{
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    LinearCase test;
    case_init(&test, 1);
    case_keep_books(&test);
    case_edge(&test, -1, 0, 25.0, 0.4);
    test.q[0] = 1.0;
    void *stepper = exact->create(&test.system, &options);
    TinkerState state = {0.0, test.q, test.v, test.books};
    double q, v, books[CASE_BOOKS], truth[2], from = 0.0;
    g_assert_cmpint(exact->interpolate(stepper, 0.0, &q, &v, NULL), ==, TINKER_FAILED);
    g_assert_cmpint(exact->step(stepper, &state, 7.0, &report), ==, TINKER_OK);
    from = state.t;
    g_assert_cmpint(exact->step(stepper, &state, 12.0, &report), ==, TINKER_OK);
    for (int i = 0; i <= 20; i++) {
        double t = from + (state.t - from) * i / 20;
        g_assert_cmpint(exact->interpolate(stepper, t, &q, &v, books), ==, TINKER_OK);
        oscillator(25.0L, (long double)0.4, 1.0L, 0.0L, t, truth);
        assert_near(q, truth[0], rounding(1.0, 60.0));
        assert_near(v, truth[1], rounding(5.0, 60.0));
        assert_near(books[0], 0.5 * v * v + 12.5 * q * q - 12.5, rounding(12.5, 60.0));
    }
    exact->destroy(stepper);
}

static void test_refusals(void)
{
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    LinearCase test;
    case_init(&test, 1);
    TinkerLinearEdge *edge = case_edge(&test, -1, 0, -1.0, 0.0);
    g_assert_null(exact->create(&test.system, &options));
    g_assert_false(tinker_exact_suits(&test.linear));
    edge->stiffness = 1.0;
    g_assert_true(tinker_exact_suits(&test.linear));
    void *stepper = exact->create(&test.system, &options);
    g_assert_nonnull(stepper);
    TinkerState state = {1.0, test.q, test.v, test.books};
    g_assert_cmpint(exact->step(stepper, &state, 1.0, &report), ==, TINKER_FAILED);
    g_assert_cmpint(exact->step(stepper, &state, NAN, &report), ==, TINKER_FAILED);
    g_assert_nonnull(report.failure);
    test.q[0] = NAN;
    g_assert_cmpint(exact->step(stepper, &state, 2.0, &report), ==, TINKER_FAILED);
    exact->destroy(stepper);
    test.system.linear = NULL;
    g_assert_null(exact->create(&test.system, &options));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/exact/free", test_free);
    g_test_add_func("/numerics/exact/critical", test_critical);
    g_test_add_func("/numerics/exact/creep", test_creep);
    g_test_add_func("/numerics/exact/free-fall", test_free_fall);
    g_test_add_func("/numerics/exact/weak-spring-under-load", test_weak_spring_under_load);
    g_test_add_func("/numerics/exact/resonance", test_resonance);
    g_test_add_func("/numerics/exact/harmonic-force", test_harmonic_force);
    g_test_add_func("/numerics/exact/cubic-base", test_cubic_base);
    g_test_add_func("/numerics/exact/damped-base", test_damped_base);
    g_test_add_func("/numerics/exact/million-periods", test_million_periods);
    g_test_add_func("/numerics/exact/one-step-or-many", test_one_step_or_many);
    g_test_add_func("/numerics/exact/late-start", test_late_start);
    g_test_add_func("/numerics/exact/pieces", test_pieces);
    g_test_add_func("/numerics/exact/interpolation", test_interpolation);
    g_test_add_func("/numerics/exact/refusals", test_refusals);
    return g_test_run();
}
