/* The integrator on CVODE, as a host calls it: against closed forms. */
#include <math.h>

#include "plugin-fixture.h"
#include "test-systems.h"

static const TinkerIntegrator *cvode(void)
{
    static const TinkerIntegrator *method = NULL;
    if (method == NULL) method = integrator_open("cvode-bdf");
    return method;
}

/* --- the oscillators, with and without their derivatives --- */

static const int32_t diagonal_starts[] = {0, 1, 2}, diagonal_columns[] = {0, 1};
static const TinkerPattern diagonal = {2, 2, diagonal_starts, diagonal_columns};

static TinkerStatus oscillator_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                        double *damping)
{
    const Oscillator *o = context;
    stiffness[0] = stiffness[1] = o->omega * o->omega;
    damping[0] = damping[1] = o->gamma;
    return TINKER_OK;
}

static void driven_oscillator(Oscillator *o, gboolean with_jacobian, TestState *test)
{
    oscillator_init(o, 3.0, 0.2, 0.8, 1.1);
    if (with_jacobian) {
        o->system.pattern = &diagonal;
        o->system.jacobian = oscillator_jacobian;
    }
    test_state_init(test, 0.0);
    oscillator_exact(o, 0.0, test->q, test->v);
}

static double error_of(const Oscillator *o, double t, const double *q, const double *v)
{
    double exact_q[TEST_SIZE], exact_v[TEST_SIZE];
    oscillator_exact(o, t, exact_q, exact_v);
    return fmax(distance(TEST_SIZE, exact_q, q), distance(TEST_SIZE, exact_v, v));
}

static void test_descriptor(void)
{
    const TinkerIntegrator *method = cvode();
    g_assert_cmpuint(method->struct_size, ==, sizeof(TinkerIntegrator));
    g_assert_cmpstr(method->id, ==, "cvode-bdf");
    g_assert_cmpuint(method->flags, ==,
                     TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_IMPLICIT | TINKER_INTEGRATOR_DISSIPATES);
}

/* The error falls with the tolerance, which every one of some hundred steps may spend a tenth of; so does what is
 * missing in the books: energy = energy at the start - what the dampers took + what the drive gave. */
static void test_tolerance(gconstpointer with_jacobian)
{
    double last = INFINITY;
    for (double tolerance = 1e-4; tolerance > 1e-11; tolerance *= 1e-2) {
        Oscillator o;
        TestState test;
        driven_oscillator(&o, with_jacobian != NULL, &test);
        double energy = oscillator_energy(&o, test.q, test.v);
        run_to(cvode(), &o.system, &test, 5.0, tolerance);
        double error = error_of(&o, 5.0, test.q, test.v);
        double missing = oscillator_energy(&o, test.q, test.v) - energy + test.books[0] - test.books[1];
        g_test_message("tolerance %.0e: error %.2e, energy missing %.2e", tolerance, error, missing);
        g_assert_cmpfloat(error, <, 100.0 * tolerance);
        g_assert_cmpfloat(error, <, 0.2 * last);
        g_assert_cmpfloat(fabs(missing), <, 1000.0 * tolerance * energy);
        last = error;
    }
}

/* Between steps, too; and the books with the state: at the end of a step they are those of the state. */
static void test_dense_output(void)
{
    const double tolerance = 1e-8;
    Oscillator o;
    TestState test, at;
    TinkerIntegratorOptions options = tolerance_options(tolerance);
    TinkerStepReport report = {.struct_size = sizeof report};
    driven_oscillator(&o, TRUE, &test);
    test_state_init(&at, 0.0);
    void *stepper = cvode()->create(&o.system, &options);
    g_assert_cmpint(cvode()->interpolate(stepper, 0.0, at.q, at.v, NULL), ==, TINKER_FAILED);
    double energy = oscillator_energy(&o, test.q, test.v);
    while (test.state.t < 5.0) {
        g_assert_cmpint(cvode()->step(stepper, &test.state, 5.0, &report), ==, TINKER_OK);
        g_assert_cmpfloat(report.error, <=, 1.0);
        g_assert_cmpfloat(report.t_from + report.step, ==, test.state.t);
        for (int i = 0; i <= 4; i++) {
            double t = fmin(report.t_from + 0.25 * i * report.step, test.state.t);
            g_assert_cmpint(cvode()->interpolate(stepper, t, at.q, at.v, at.books), ==, TINKER_OK);
            g_assert_cmpfloat(error_of(&o, t, at.q, at.v), <, 100.0 * tolerance);
            double missing = oscillator_energy(&o, at.q, at.v) - energy + at.books[0] - at.books[1];
            g_assert_cmpfloat(fabs(missing), <, 1000.0 * tolerance * energy);
        }
    }
    cvode()->destroy(stepper);
}

/* Limits are met to the bit, and what is set between steps counts after a restart. */
static void test_landing_and_restart(void)
{
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    driven_oscillator(&o, TRUE, &test);
    void *stepper = cvode()->create(&o.system, &options);
    for (int i = 1; i < 12; i++) {
        while (test.state.t < 0.7 * i) {
            g_assert_cmpint(cvode()->step(stepper, &test.state, 0.7 * i, &report), ==, TINKER_OK);
            g_assert_cmpfloat(test.state.t, <=, 0.7 * i);
        }
        if (i % 3 != 0) continue;
        g_assert_cmpfloat(error_of(&o, test.state.t, test.q, test.v), <, 1e-7);
        oscillator_exact(&o, 0.0, test.q, test.v);
        test.state.t = 0.0;
        cvode()->restart(stepper);
        g_assert_cmpint(cvode()->step(stepper, &test.state, 0.7 * i, &report), ==, TINKER_OK);
        g_assert_cmpfloat(error_of(&o, test.state.t, test.q, test.v), <, 1e-9);
    }
    g_assert_cmpint(cvode()->step(stepper, &test.state, test.state.t, &report), ==, TINKER_FAILED);
    g_assert_cmpint(cvode()->step(stepper, &test.state, INFINITY, &report), ==, TINKER_FAILED);
    g_assert_nonnull(report.failure);
    cvode()->destroy(stepper);
}

/* Lengths in another unit change no step. */
static void test_no_units(void)
{
    int steps[2];
    for (int i = 0; i < 2; i++) {
        Oscillator o;
        TestState test;
        driven_oscillator(&o, TRUE, &test);
        o.unit = i == 0 ? 1.0 : 0x1p-40;
        oscillator_exact(&o, 0.0, test.q, test.v);
        steps[i] = run_to(cvode(), &o.system, &test, 5.0, 1e-8);
    }
    g_assert_cmpint(steps[0], ==, steps[1]);
}

/* --- what cannot be stepped --- */

/* Accelerations that stop being numbers: bounded work, and the state stays where the last step ended. */
static void test_gives_up(void)
{
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    driven_oscillator(&o, FALSE, &test);
    o.break_time = 1.0;
    void *stepper = cvode()->create(&o.system, &options);
    TinkerStatus status = TINKER_OK;
    for (int steps = 0; steps < 5000 && status == TINKER_OK; steps++)
        status = cvode()->step(stepper, &test.state, 2.0, &report);
    g_assert_cmpint(status, ==, TINKER_FAILED);
    g_assert_nonnull(report.failure);
    g_assert_cmpfloat(test.state.t, <=, 1.0);
    g_assert_cmpfloat(test.state.t, >, 0.9);
    g_assert_cmpfloat(error_of(&o, test.state.t, test.q, test.v), <, 1e-7);
    g_assert_cmpint(o.evaluations, <, 20000);
    cvode()->destroy(stepper);
}

/* x'' = 6 x^2 from (1, 2) is x = (1 - t)^-2, which ends at t = 1. */
static TinkerStatus blow_up(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = 6.0 * q[i] * q[i];
    return TINKER_OK;
}

static void test_blow_up(void)
{
    Oscillator o;
    TestState test;
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
    o.system.acceleration = blow_up;
    o.system.books = 0;
    test_state_init(&test, 0.0);
    test.q[0] = 1.0;
    test.v[0] = 2.0;
    void *stepper = cvode()->create(&o.system, &options);
    TinkerStatus status = TINKER_OK;
    for (int steps = 0; steps < 20000 && status == TINKER_OK; steps++)
        status = cvode()->step(stepper, &test.state, 2.0, &report);
    g_assert_cmpint(status, ==, TINKER_FAILED);
    g_assert_cmpfloat(fabs(test.state.t - 1.0), <, 1e-6);
    cvode()->destroy(stepper);
}

/* A system that refuses far-off states is stepped around them: 3.015 is the largest speed of the motion. */
static void test_smaller_steps_on_request(void)
{
    Oscillator o;
    TestState test;
    oscillator_init(&o, 3.0, 0.0, 0.0, 0.0);
    o.refuse_speed = 3.2;
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    run_to(cvode(), &o.system, &test, 5.0, 1e-9);
    g_assert_cmpfloat(error_of(&o, 5.0, test.q, test.v), <, 1e-7);
}

/* Nothing moves and nothing pushes. */
static void test_nothing_happens(void)
{
    Oscillator o;
    TestState test;
    oscillator_init(&o, 2.0, 0.0, 0.0, 0.0);
    test_state_init(&test, 0.0);
    g_assert_cmpint(run_to(cvode(), &o.system, &test, 10.0, 1e-9), <, 20);
    g_assert_cmpfloat(test.q[0], ==, 0.0);
}

/* --- a motion that has no scales yet --- */

#define GRAVITY 9.81
#define DRAG    0.1

static TinkerStatus fall(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = GRAVITY - DRAG * v[i] * fabs(v[i]);
    return TINKER_OK;
}

/* A fall from rest at the origin, with drag: u being the final speed, q = u^2 / g log cosh(g t / u), v = u tanh(g t /
 * u). */
static void test_from_rest(void)
{
    const double final_speed = sqrt(GRAVITY / DRAG), end = 3.0, tolerance = 1e-8;
    Oscillator o;
    TestState test;
    oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
    o.system.acceleration = fall;
    o.system.books = 0;
    test_state_init(&test, 0.0);
    g_assert_cmpint(run_to(cvode(), &o.system, &test, end, tolerance), <, 1000);
    const double q = final_speed * final_speed / GRAVITY * log(cosh(GRAVITY * end / final_speed));
    const double v = final_speed * tanh(GRAVITY * end / final_speed);
    g_assert_cmpfloat_with_epsilon(test.q[0], q, 100.0 * tolerance * q);
    g_assert_cmpfloat_with_epsilon(test.v[1], v, 100.0 * tolerance * v);
}

/* --- a rod --- */

static void test_pendulum(void)
{
    Pendulum p;
    TestState test;
    double q[TEST_SIZE], v[TEST_SIZE];
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.0, test.q, test.v);
    double end = 3.0 * pendulum_period(&p);
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    TinkerStepReport report = {.struct_size = sizeof report};
    void *stepper = cvode()->create(&p.system, &options);
    while (test.state.t < end) {
        g_assert_cmpint(cvode()->step(stepper, &test.state, end, &report), ==, TINKER_OK);
        g_assert_cmpfloat(fabs(hypot(test.q[0], test.q[1]) - 1.3), <, 4e-16);
        g_assert_cmpfloat(fabs(test.q[0] * test.v[0] + test.q[1] * test.v[1]), <, 1e-14);
        pendulum_exact(&p, test.state.t, q, v);
        g_assert_cmpfloat(distance(TEST_SIZE, test.q, q), <, 1e-6);
        g_assert_cmpfloat(distance(TEST_SIZE, test.v, v), <, 1e-6);
    }
    cvode()->destroy(stepper);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/cvode/descriptor", test_descriptor);
    g_test_add_data_func("/plugins/cvode/tolerance/differences", NULL, test_tolerance);
    g_test_add_data_func("/plugins/cvode/tolerance/jacobian", "jacobian", test_tolerance);
    g_test_add_func("/plugins/cvode/dense-output", test_dense_output);
    g_test_add_func("/plugins/cvode/landing-and-restart", test_landing_and_restart);
    g_test_add_func("/plugins/cvode/no-units", test_no_units);
    g_test_add_func("/plugins/cvode/gives-up", test_gives_up);
    g_test_add_func("/plugins/cvode/blow-up", test_blow_up);
    g_test_add_func("/plugins/cvode/smaller-steps-on-request", test_smaller_steps_on_request);
    g_test_add_func("/plugins/cvode/nothing-happens", test_nothing_happens);
    g_test_add_func("/plugins/cvode/from-rest", test_from_rest);
    g_test_add_func("/plugins/cvode/pendulum", test_pendulum);
    return g_test_run();
}
