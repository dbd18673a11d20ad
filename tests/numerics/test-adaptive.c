/* What only the adaptive methods do: error control, landing, step sizes without units, and giving up in time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/integrate/step-control.h"
#include "numerics/methods/integrators.h"
#include "numerics/solve/largest.h"
#include "test-systems.h"

static double error_of_tolerance(const TinkerIntegrator *method, Oscillator *o, double tolerance)
{
    TestState test;
    double q[TEST_SIZE], v[TEST_SIZE];
    test_state_init(&test, 0.0);
    oscillator_exact(o, 0.0, test.q, test.v);
    run_to(method, &o->system, &test, 5.0, tolerance);
    oscillator_exact(o, 5.0, q, v);
    return fmax(distance(TEST_SIZE, q, test.q), distance(TEST_SIZE, v, test.v));
}

static void test_error_follows_tolerance(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    oscillator_init(&o, 3.0, 0.2, 0.8, 1.1);
    for (double tolerance = 1e-4; tolerance > 1e-11; tolerance *= 1e-2) {
        double error = error_of_tolerance(method, &o, tolerance);
        g_test_message("%s: tolerance %.0e, error %.2e", method->id, tolerance, error);
        g_assert_cmpfloat(error, <, 100.0 * tolerance);
        g_assert_cmpfloat(error, >, 1e-4 * tolerance);
    }
    /* what cannot be met is not asked for */
    g_assert_cmpfloat(error_of_tolerance(method, &o, 0.0), <, 1e-13);
}

static void test_pendulum_accuracy(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Pendulum p;
    TestState test;
    double q[TEST_SIZE], v[TEST_SIZE];
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.0, test.q, test.v);
    double end = 3.0 * pendulum_period(&p);
    run_to(method, &p.system, &test, end, 1e-11);
    pendulum_exact(&p, end, q, v);
    g_assert_cmpfloat(distance(TEST_SIZE, test.q, q), <, 1e-8);
    g_assert_cmpfloat(distance(TEST_SIZE, test.v, v), <, 1e-8);
    g_assert_cmpfloat(fabs(hypot(test.q[0], test.q[1]) - 1.3), <, 4e-16);
}

/* Every limit is met to the bit, by steps of which none is a crumb. */
static void test_landing(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 3.0, 0.0, 0.0, 0.0);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    double usual = 0.0;
    for (int i = 1; i < 20; i++) {
        double limit = 0.7 * i;
        while (test.state.t < limit) {
            double t = test.state.t;
            g_assert_cmpint(method->step(stepper, &test.state, limit, &report), ==, TINKER_OK);
            g_assert_cmpfloat(report.t_from, ==, t);
            g_assert_cmpfloat(fabs(report.step - (test.state.t - t)), <, 1e-15);
            g_assert_cmpfloat(test.state.t, <=, limit);
            g_assert_cmpfloat(report.error, <=, 1.0);
            if (i > 1) g_assert_cmpfloat(report.step, >, 0.25 * fmin(usual, 0.7));
            usual = fmax(usual, report.step);
        }
        g_assert_cmpfloat(test.state.t, ==, limit);
    }
    method->destroy(stepper);
}

/* A run's steps, of a problem whose lengths are all `unit` times as large. */
static int record_steps(const TinkerIntegrator *method, double unit, double *steps, int cap)
{
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-8);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 3.0, 0.2, 0.8, 1.1);
    o.unit = unit;
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    int count = 0;
    while (test.state.t < 5.0 && count < cap) {
        g_assert_cmpint(method->step(stepper, &test.state, 5.0, &report), ==, TINKER_OK);
        steps[count++] = report.step;
    }
    method->destroy(stepper);
    return count;
}

static void test_no_units(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    double plain[1000], scaled[1000];
    int count = record_steps(method, 1.0, plain, 1000);
    g_assert_cmpint(count, <, 1000);
    /* a power of 2 changes no bit */
    g_assert_cmpint(record_steps(method, 0x1p-40, scaled, 1000), ==, count);
    g_assert_cmpmem(plain, (gsize)count * sizeof *plain, scaled, (gsize)count * sizeof *scaled);
    /* another factor rounds the error estimates differently, each in its seventh digit or so; the last steps are left
     * out, as landing splits them by a comparison */
    int other = record_steps(method, 1000.0, scaled, 1000);
    g_assert_cmpint(abs(other - count), <=, 1);
    g_assert_cmpfloat(distance(count - 3, plain, scaled), <, 1e-5);
}

/* A derivative that stops existing: bounded work, then a failure that leaves the state at the end of the last step. */
static void test_gives_up(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 3.0, 0.0, 0.0, 0.0);
    o.break_time = 1.0;
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    TinkerStatus status = TINKER_OK;
    for (int steps = 0; steps < 5000 && status == TINKER_OK; steps++)
        status = method->step(stepper, &test.state, 2.0, &report);
    g_assert_cmpint(status, ==, TINKER_FAILED);
    g_assert_nonnull(report.failure);
    g_assert_cmpfloat(fabs(test.state.t - 1.0), <, 1e-12);
    double q[TEST_SIZE], v[TEST_SIZE];
    oscillator_exact(&o, test.state.t, q, v);
    g_assert_cmpfloat(distance(TEST_SIZE, q, test.q), <, 1e-7);
    method->destroy(stepper);
    g_assert_cmpint(o.evaluations, <, 20000);
}

/* x'' = 6 x^2 from (1, 2) is x = (1 - t)^-2, which ends at t = 1. */
static TinkerStatus blow_up_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                         double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = 6.0 * q[i] * q[i];
    return TINKER_OK;
}

static void test_blow_up(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
    o.system.acceleration = blow_up_acceleration;
    o.system.books = 0;
    test_state_init(&test, 0.0);
    test.q[0] = 1.0;
    test.v[0] = 2.0;
    void *stepper = method->create(&o.system, &options);
    TinkerStatus status = TINKER_OK;
    for (int steps = 0; steps < 20000 && status == TINKER_OK; steps++)
        status = method->step(stepper, &test.state, 2.0, &report);
    g_assert_cmpint(status, ==, TINKER_FAILED);
    g_assert_cmpfloat(fabs(test.state.t - 1.0), <, 1e-6);
    method->destroy(stepper);
}

/* A system that refuses far-off stages is stepped around them. */
static void test_smaller_steps_on_request(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 3.0, 0.0, 0.0, 0.0);
    o.refuse_speed = 3.2; /* sqrt(0.3^2 + 3^2) = 3.015 is the largest of the motion */
    options.first_step = 5.0;
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    void *stepper = method->create(&o.system, &options);
    g_assert_cmpint(method->step(stepper, &test.state, 5.0, &report), ==, TINKER_OK);
    g_assert_cmpint(report.rejected, >, 0);
    while (test.state.t < 5.0)
        g_assert_cmpint(method->step(stepper, &test.state, 5.0, &report), ==, TINKER_OK);
    double q[TEST_SIZE], v[TEST_SIZE];
    oscillator_exact(&o, 5.0, q, v);
    g_assert_cmpfloat(distance(TEST_SIZE, q, test.q), <, 1e-7);
    method->destroy(stepper);
}

/* Evaluations of `steps` equal steps; the first of an unconstrained run needs one more. */
static int count_evaluations(const TinkerIntegrator *method, TinkerSystem *system, const int *evaluations, int steps,
                             int interpolations, int restarts)
{
    TestState test, at;
    TinkerStepReport report = {.struct_size = sizeof report};
    TinkerIntegratorOptions options = equal_step_options(0.01);
    void *stepper = method->create(system, &options);
    int before = *evaluations;
    test_state_init(&test, 0.0);
    test_state_init(&at, 0.0);
    test.q[1] = -1.3;
    test.v[0] = 1.0;
    for (int i = 1; i <= steps; i++) {
        g_assert_cmpint(method->step(stepper, &test.state, 0.01 * i, &report), ==, TINKER_OK);
        for (int j = 0; j < interpolations; j++)
            method->interpolate(stepper, report.t_from + 0.001 * j, at.q, at.v, NULL);
        if (restarts) method->restart(stepper);
    }
    method->destroy(stepper);
    return *evaluations - before;
}

static void test_first_stage_is_reused(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    Pendulum p;
    int per_step = method->evaluations_per_step, dense = method->order == 8 ? 3 : 0;
    int at_end = method->order == 8;
    oscillator_init(&o, 3.0, 0.0, 0.0, 0.0);
    g_assert_cmpint(count_evaluations(method, &o.system, &o.evaluations, 10, 0, 0), ==, 10 * per_step + !at_end);
    /* what dense output finds at the end saves the next step nothing: looking changes no count */
    g_assert_cmpint(count_evaluations(method, &o.system, &o.evaluations, 10, 3, 0), ==,
                    10 * (per_step + dense + at_end) + !at_end);
    g_assert_cmpint(count_evaluations(method, &o.system, &o.evaluations, 10, 0, 1), ==, 10 * (per_step + !at_end));
    /* a projection that moved the state invalidates what was carried over */
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    p.always_moved = 1;
    g_assert_cmpint(count_evaluations(method, &p.system, &p.evaluations, 10, 0, 0), ==, 10 * (per_step + !at_end));
}

static void metre_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = 1.0;
    *speed = fmax(fabs(v[0]), fabs(v[1]));
}

/* At rest in balance, with forces that cancel up to their last bit only, steps grow as long as they may. */
static TinkerStatus noisy_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                       double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = -9.81 * (1.0 + 0x1p-52 * sin(1e17 * t)) + 9.81 - 100.0 * q[i];
    return TINKER_OK;
}

static void test_rest_with_rounding(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
    o.system.acceleration = noisy_acceleration;
    o.system.scales = metre_scales;
    o.system.books = 0;
    test_state_init(&test, 0.0);
    g_assert_cmpint(run_to(method, &o.system, &test, 10.0, 1e-9), <, 20000);
    g_assert_cmpfloat(fabs(test.q[0]), <, 1e-9); /* the tolerance times the extent */
}

/* Nothing moves and nothing pushes: one step. */
static void test_nothing_happens(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    oscillator_init(&o, 2.0, 0.0, 0.0, 0.0);
    test_state_init(&test, 0.0);
    g_assert_cmpint(run_to(method, &o.system, &test, 10.0, 1e-9), ==, 1);
    g_assert_cmpfloat(test.q[0], ==, 0.0);
}

/* Where the start itself cannot be evaluated no shorter step helps. */
static void test_start_refused(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    options.first_step = 0.01;
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 3.0, 0.2, 0.8, 1.1);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    o.refuse_speed = 0.5 * fabs(test.v[0]);
    g_assert_cmpfloat(o.refuse_speed, >, 0.0);
    void *stepper = method->create(&o.system, &options);
    g_assert_cmpint(method->step(stepper, &test.state, 1.0, &report), ==, TINKER_FAILED);
    g_assert_cmpint(o.evaluations, ==, 1);
    method->destroy(stepper);
}

static void test_largest(void)
{
    const double plain[] = {-3.0, 2.0, -0.0}, broken[] = {1.0, NAN, 2.0}, infinite[] = {-INFINITY, 1.0};
    g_assert_cmpfloat(tinker_largest(3, plain), ==, 3.0);
    g_assert_cmpfloat(tinker_largest(0, plain), ==, 0.0);
    g_assert_true(isnan(tinker_largest(3, broken)));
    g_assert_true(isinf(tinker_largest(2, infinite)));
    g_assert_cmpfloat(tinker_relative(0.0, 0.0), ==, 0.0);
    g_assert_true(isinf(tinker_relative(1.0, 0.0)));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    const struct {
        const char *name;
        GTestDataFunc test;
    } tests[] = {{"error-follows-tolerance", test_error_follows_tolerance},
                 {"pendulum-accuracy", test_pendulum_accuracy},
                 {"landing", test_landing},
                 {"no-units", test_no_units},
                 {"gives-up", test_gives_up},
                 {"blow-up", test_blow_up},
                 {"smaller-steps-on-request", test_smaller_steps_on_request},
                 {"first-stage-is-reused", test_first_stage_is_reused},
                 {"rest-with-rounding", test_rest_with_rounding},
                 {"nothing-happens", test_nothing_happens},
                 {"start-refused", test_start_refused}};
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each; each++)
        for (gsize i = 0; i < G_N_ELEMENTS(tests); i++) {
            if (!((*each)->flags & TINKER_INTEGRATOR_ADAPTIVE)) continue;
            g_autofree char *path = g_strdup_printf("/numerics/adaptive/%s/%s", (*each)->id, tests[i].name);
            g_test_add_data_func(path, *each, tests[i].test);
        }
    g_test_add_func("/numerics/adaptive/largest", test_largest);
    return g_test_run();
}
