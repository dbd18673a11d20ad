/* Steps that are far shorter than a method's own: few evaluations, as accurate, at their ends as inside. */
#include <math.h>

#include "numerics/methods/integrators.h"
#include "test-systems.h"

/* Where events or breaks cut steps far shorter than the method's own, each takes few evaluations and is as accurate,
 * inside of it as well. */
static void test_restarted(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("dop853");
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    double q[TEST_SIZE], v[TEST_SIZE], books[TEST_BOOKS], within_q[TEST_SIZE], within_v[TEST_SIZE];
    oscillator_init(&o, 3.0, 0.2, 0.8, 1.1);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    for (int i = 0; i < 4; i++)
        g_assert_cmpint(method->step(stepper, &test.state, 100.0, &report), ==, TINKER_OK);
    oscillator_exact(&o, test.state.t, q, v);
    const double off = distance(TEST_SIZE, q, test.q) + distance(TEST_SIZE, v, test.v), brief = 1e-4 * report.step;
    for (int i = 0; i < 50; i++) {
        const double t = test.state.t, limit = t + brief * (1 + i % 3);
        const int before = o.evaluations;
        method->restart(stepper);
        g_assert_cmpint(method->step(stepper, &test.state, limit, &report), ==, TINKER_OK);
        g_assert_cmpfloat(test.state.t, ==, limit);
        g_assert_cmpint(method->interpolate(stepper, 0.5 * (t + limit), within_q, within_v, books), ==, TINKER_OK);
        g_assert_cmpint(o.evaluations - before, <=, 5);
        oscillator_exact(&o, 0.5 * (t + limit), q, v);
        g_assert_cmpfloat(distance(TEST_SIZE, q, within_q) + distance(TEST_SIZE, v, within_v), <, 2 * off);
    }
    oscillator_exact(&o, test.state.t, q, v);
    g_assert_cmpfloat(distance(TEST_SIZE, q, test.q) + distance(TEST_SIZE, v, test.v), <, 2 * off);
    /* a motion that has become faster in the meantime is not followed so */
    o.omega = 100.0 / brief;
    method->restart(stepper);
    g_assert_cmpint(method->step(stepper, &test.state, test.state.t + brief, &report), ==, TINKER_OK);
    g_assert_cmpfloat(report.step, <, 0.1 * brief);
    method->destroy(stepper);
}

/* What the books of a damped and driven oscillator leave unexplained. */
static double imbalance(const Oscillator *o, double start, const double *q, const double *v, const double *books)
{
    return fabs(oscillator_energy(o, q, v) + books[0] - books[1] - start);
}

/* Brief steps one behind the other, each of which begins with what the last one ended on, and a whole one behind them:
 * energy balances at their ends and inside. */
static void test_on_end(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("dop853");
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    double q[TEST_SIZE], v[TEST_SIZE], books[TEST_BOOKS];
    oscillator_init(&o, 3.0, 0.2, 0.8, 1.1);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    const double start = oscillator_energy(&o, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    for (int i = 0; i < 4; i++)
        g_assert_cmpint(method->step(stepper, &test.state, 100.0, &report), ==, TINKER_OK);
    const double whole = report.step;
    for (int i = 0; i < 60; i++) {
        const double t = test.state.t, h = i % 10 == 9 ? whole : 1e-4 * whole * (1 + i % 3);
        g_assert_cmpint(method->step(stepper, &test.state, t + h, &report), ==, TINKER_OK);
        g_assert_cmpfloat(imbalance(&o, start, test.q, test.v, test.books), <, 1e-8 * start);
        const double middle = 0.5 * (t + test.state.t);
        g_assert_cmpint(method->interpolate(stepper, middle, q, v, books), ==, TINKER_OK);
        g_assert_cmpfloat(imbalance(&o, start, q, v, books), <, 1e-8 * start);
    }
    oscillator_exact(&o, test.state.t, q, v);
    g_assert_cmpfloat(distance(TEST_SIZE, q, test.q) + distance(TEST_SIZE, v, test.v), <, 1e-7);
    method->destroy(stepper);
}

/* A free mass that a fast force shakes at a far place: the velocity within a brief step is as good as it is said to be,
 * though Kutta's two methods are the same for a force of time alone. */
static void test_force_in_time(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("dop853");
    const double tolerance = 1e-9, rate = 300.0, swing = 0.1;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(tolerance);
    TinkerStepReport report = {.struct_size = sizeof report};
    double q[TEST_SIZE], v[TEST_SIZE], whole = 0.0;
    int brief = 0;
    oscillator_init(&o, 0.0, 0.0, swing * rate, rate);
    o.system.books = 0; /* which tell of such steps, but only of small ones */
    test_state_init(&test, 0.0);
    for (int i = 0; i < TEST_SIZE; i++)
        test.q[i] = 10.0;
    void *stepper = method->create(&o.system, &options);
    for (int i = 0; i < 200; i++) {
        const double t = test.state.t, v0 = test.v[0];
        const double limit = t + (i < 20 ? 1.0 : 1e-5 * whole * exp(0.05 * (i - 20)));
        const int before = o.evaluations;
        g_assert_cmpint(method->step(stepper, &test.state, limit, &report), ==, TINKER_OK);
        if (i < 20) whole = report.step;
        if (o.evaluations - before > 4 || report.error > 1e-3) continue;
        brief++;
        const double within = t + 0.25 * (test.state.t - t);
        g_assert_cmpint(method->interpolate(stepper, within, q, v, NULL), ==, TINKER_OK);
        const double off = fabs(v[0] - v0 - swing * (sin(rate * within) - sin(rate * t)));
        g_assert_cmpfloat(off, <, 0.01 * tolerance * swing);
    }
    g_assert_cmpint(brief, >, 20);
    method->destroy(stepper);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/brief-steps/restarted", test_restarted);
    g_test_add_func("/numerics/brief-steps/on-end", test_on_end);
    g_test_add_func("/numerics/brief-steps/force-in-time", test_force_in_time);
    return g_test_run();
}
