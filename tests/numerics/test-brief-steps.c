/* Steps that are far shorter than a method's own: few evaluations, as accurate, at their ends as inside. */
#include <math.h>

#include "numerics/methods/integrators.h"
#include "test-systems.h"

/* A damped and driven oscillator behind some whole steps. */
typedef struct {
    const TinkerIntegrator *method;
    Oscillator o;
    TestState test;
    TinkerStepReport report;
    void *stepper;
    double start; /* its energy at first */
} Stepped;

static void step_to(Stepped *s, double limit)
{
    g_assert_cmpint(s->method->step(s->stepper, &s->test.state, limit, &s->report), ==, TINKER_OK);
}

static void stepped_init(Stepped *s)
{
    const TinkerIntegratorOptions options = tolerance_options(1e-9);
    s->method = tinker_integrator_builtin("dop853");
    s->report = (TinkerStepReport){.struct_size = sizeof s->report};
    oscillator_init(&s->o, 3.0, 0.2, 0.8, 1.1);
    test_state_init(&s->test, 0.0);
    oscillator_exact(&s->o, 0.0, s->test.q, s->test.v);
    s->start = oscillator_energy(&s->o, s->test.q, s->test.v);
    s->stepper = s->method->create(&s->o.system, &options);
    for (int i = 0; i < 4; i++)
        step_to(s, 100.0);
}

/* How far a state is from the exact one. */
static double miss(const Stepped *s, double t, const double *q, const double *v)
{
    double exact_q[TEST_SIZE], exact_v[TEST_SIZE];
    oscillator_exact(&s->o, t, exact_q, exact_v);
    return distance(TEST_SIZE, exact_q, q) + distance(TEST_SIZE, exact_v, v);
}

/* Where events or breaks cut steps far shorter than the method's own, each takes few evaluations and is as accurate,
 * inside of it as well. */
static void test_restarted(void)
{
    Stepped s;
    double within_q[TEST_SIZE], within_v[TEST_SIZE], books[TEST_BOOKS];
    stepped_init(&s);
    const TestState *test = &s.test;
    const double off = miss(&s, test->state.t, test->q, test->v), brief = 1e-4 * s.report.step;
    for (int i = 0; i < 50; i++) {
        const double t = test->state.t, limit = t + brief * (1 + i % 3), middle = 0.5 * (t + limit);
        const int before = s.o.evaluations;
        s.method->restart(s.stepper);
        step_to(&s, limit);
        g_assert_cmpfloat(test->state.t, ==, limit);
        g_assert_cmpint(s.method->interpolate(s.stepper, middle, within_q, within_v, books), ==, TINKER_OK);
        g_assert_cmpint(s.o.evaluations - before, <=, 5);
        g_assert_cmpfloat(miss(&s, middle, within_q, within_v), <, 2 * off);
    }
    g_assert_cmpfloat(miss(&s, test->state.t, test->q, test->v), <, 2 * off);
    /* a motion that has become faster in the meantime is not followed so */
    s.o.omega = 100.0 / brief;
    s.method->restart(s.stepper);
    step_to(&s, test->state.t + brief);
    g_assert_cmpfloat(s.report.step, <, 0.1 * brief);
    s.method->destroy(s.stepper);
}

/* What the books leave unexplained of a change of energy. */
static double imbalance(const Stepped *s, const double *q, const double *v, const double *books)
{
    return fabs(oscillator_energy(&s->o, q, v) + books[0] - books[1] - s->start);
}

/* Brief steps one behind the other, each of which begins with what the last one ended on, and a whole one behind them:
 * energy balances at their ends and inside. */
static void test_on_end(void)
{
    Stepped s;
    double q[TEST_SIZE], v[TEST_SIZE], books[TEST_BOOKS];
    stepped_init(&s);
    const TestState *test = &s.test;
    const double whole = s.report.step;
    for (int i = 0; i < 60; i++) {
        const double t = test->state.t, h = i % 10 == 9 ? whole : 1e-4 * whole * (1 + i % 3);
        step_to(&s, t + h);
        g_assert_cmpfloat(imbalance(&s, test->q, test->v, test->books), <, 1e-8 * s.start);
        const double middle = 0.5 * (t + test->state.t);
        g_assert_cmpint(s.method->interpolate(s.stepper, middle, q, v, books), ==, TINKER_OK);
        g_assert_cmpfloat(imbalance(&s, q, v, books), <, 1e-8 * s.start);
    }
    g_assert_cmpfloat(miss(&s, test->state.t, test->q, test->v), <, 1e-7);
    s.method->destroy(s.stepper);
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
