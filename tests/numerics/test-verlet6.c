/* The composed Verlet's own promises: order 6 with rods and dampers, bounded energy over very long runs, reversibility,
 * dense output that keeps up. */
#include <math.h>

#include "numerics/methods/integrators.h"
#include "test-systems.h"

static const TinkerIntegrator *method(void)
{
    return tinker_integrator_builtin("verlet6");
}

static void step_equally(void *stepper, TestState *test, double h, int steps)
{
    TinkerStepReport report = {.struct_size = sizeof report};
    for (int i = 0; i < steps; i++)
        g_assert_cmpint(method()->step(stepper, &test->state, test->state.t + h, &report), ==, TINKER_OK);
}

static double pendulum_error(int steps)
{
    Pendulum p;
    TestState test;
    double q[TEST_SIZE], v[TEST_SIZE];
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.0, test.q, test.v);
    run_equal_steps(method(), &p.system, &test, 2.0, steps);
    pendulum_exact(&p, 2.0, q, v);
    return fmax(distance(TEST_SIZE, q, test.q), distance(TEST_SIZE, v, test.v));
}

static double oscillator_error(double gamma, int steps)
{
    Oscillator o;
    TestState test;
    double q[TEST_SIZE], v[TEST_SIZE];
    oscillator_init(&o, 2.0, gamma, 1.3, 1.1);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    run_equal_steps(method(), &o.system, &test, 3.0, steps);
    oscillator_exact(&o, 3.0, q, v);
    return fmax(distance(TEST_SIZE, q, test.q), distance(TEST_SIZE, v, test.v));
}

static void test_orders(void)
{
    double orders[] = {log2(pendulum_error(64) / pendulum_error(128)),
                       log2(oscillator_error(0.0, 32) / oscillator_error(0.0, 64)),
                       log2(oscillator_error(0.7, 32) / oscillator_error(0.7, 64))};
    for (gsize i = 0; i < G_N_ELEMENTS(orders); i++) {
        g_test_message("order %.3f", orders[i]);
        g_assert_cmpfloat(fabs(orders[i] - 6.0), <, 0.1);
    }
}

/* 100 000 periods, 5 steps each: the energy swings by what the first hundred show, and no more. */
static void test_energy_stays(void)
{
    Oscillator o;
    TestState test;
    oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
    o.system.books = 0;
    TinkerIntegratorOptions options = equal_step_options(0.0);
    void *stepper = method()->create(&o.system, &options);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    double start = oscillator_energy(&o, test.q, test.v), early = 0.0, late = 0.0, h = 2.0 * G_PI / 5.0;
    for (int i = 0; i < 500000; i++) {
        step_equally(stepper, &test, h, 1);
        double error = fabs(oscillator_energy(&o, test.q, test.v) - start);
        early = i < 500 ? fmax(early, error) : early;
        late = i >= 499500 ? fmax(late, error) : late;
    }
    method()->destroy(stepper);
    g_test_message("energy error %g at first, %g at last", early / start, late / start);
    g_assert_cmpfloat(late, <, 1.0001 * early + 1e-10 * start);
}

/* With the velocity turned round it finds its way back; with rods too. */
static void test_reversible(void)
{
    for (int constrained = 0; constrained < 2; constrained++) {
        Pendulum p;
        Oscillator o;
        TestState test, start;
        pendulum_init(&p, 1.3, 9.81, 2.5, 0.0);
        oscillator_init(&o, 2.0, 0.0, 0.0, 0.0);
        TinkerIntegratorOptions options = equal_step_options(0.0);
        void *stepper = method()->create(constrained ? &p.system : &o.system, &options);
        test_state_init(&test, 0.0);
        constrained ? pendulum_exact(&p, 0.0, test.q, test.v) : oscillator_exact(&o, 0.0, test.q, test.v);
        start = test;
        step_equally(stepper, &test, 0.1, 200);
        g_assert_cmpfloat(distance(TEST_SIZE, test.q, start.q), >, 0.1);
        for (int i = 0; i < TEST_SIZE; i++)
            test.v[i] = -test.v[i];
        method()->restart(stepper);
        step_equally(stepper, &test, 0.1, 200);
        g_assert_cmpfloat(distance(TEST_SIZE, test.q, start.q), <, 1e-11);
        for (int i = 0; i < TEST_SIZE; i++)
            g_assert_cmpfloat(fabs(test.v[i] + start.v[i]), <, 1e-11);
        method()->destroy(stepper);
    }
}

/* A step back undoes one forth: also with dampers, and the books with it. */
static void test_adjoint_of_itself(void)
{
    Oscillator o;
    TestState test, start;
    oscillator_init(&o, 2.0, 0.6, 1.3, 1.1);
    TinkerIntegratorOptions options = equal_step_options(0.0);
    void *stepper = method()->create(&o.system, &options);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    start = test;
    step_equally(stepper, &test, 0.4, 1);
    g_assert_cmpfloat(test.books[0], >, 0.01);
    step_equally(stepper, &test, -0.4, 1);
    g_assert_cmpfloat(distance(TEST_SIZE, test.q, start.q), <, 1e-14);
    g_assert_cmpfloat(distance(TEST_SIZE, test.v, start.v), <, 1e-14);
    g_assert_cmpfloat(distance(TEST_BOOKS, test.books, start.books), <, 1e-14);
    method()->destroy(stepper);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/verlet6/orders", test_orders);
    g_test_add_func("/numerics/verlet6/energy-stays", test_energy_stays);
    g_test_add_func("/numerics/verlet6/reversible", test_reversible);
    g_test_add_func("/numerics/verlet6/adjoint-of-itself", test_adjoint_of_itself);
    return g_test_run();
}
