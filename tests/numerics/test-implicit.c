/* The implicit methods' own promises on one oscillator: closed-form recurrences, no limit of stability, the spectral
 * radius at infinity, refusals that say what to do. */
#include <math.h>
#include <string.h>

#include "implicit-case.h"
#include "test-systems.h"

/* The trapezoidal rule for x' = v, v' = -w^2 x - g v, solved by hand. */
static void trapezoid(double w, double g, double h, double *x, double *v)
{
    double k = 0.5 * h, a = 1 + k * g + k * k * w * w;
    double x0 = *x, v0 = *v;
    *v = ((1 - k * g - k * k * w * w) * v0 - h * w * w * x0) / a;
    *x = x0 + k * (v0 + *v);
}

static void test_closed_recurrence(void)
{
    for (int damped = 0; damped < 2; damped++) {
        Oscillator o;
        TestState test;
        double gamma = damped ? 0.01 : 0.0, x[TEST_SIZE], v[TEST_SIZE];
        oscillator_init(&o, 2.0, gamma, 0.0, 0.0);
        test_state_init(&test, 0.0);
        oscillator_exact(&o, 0.0, test.q, test.v);
        memcpy(x, test.q, sizeof x);
        memcpy(v, test.v, sizeof v);
        void *stepper = implicit_create(implicit_newmark(), &o.system, 0);
        for (int i = 0; i < 1000; i++) {
            implicit_step_equally(implicit_newmark(), stepper, &test.state, 0.125, 1);
            for (int k = 0; k < TEST_SIZE; k++)
                trapezoid(2.0, gamma, 0.125, &x[k], &v[k]);
            g_assert_cmpfloat(distance(TEST_SIZE, x, test.q) + distance(TEST_SIZE, v, test.v), <, 1e-12);
        }
        implicit_newmark()->destroy(stepper);
    }
}

/* h omega = 1000, ten thousand steps: average acceleration keeps the energy, the other loses it. */
static void test_no_limit_of_stability(void)
{
    const struct {
        const TinkerIntegrator *method;
        double radius;
    } cases[] = {{implicit_newmark(), 0}, {implicit_alpha(), 1}, {implicit_alpha(), 0.8}, {implicit_alpha(), 0.3}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        Oscillator o;
        TestState test;
        oscillator_init(&o, 1000.0, 0.0, 0.0, 0.0);
        o.system.books = 0;
        test_state_init(&test, 0.0);
        test.q[0] = 1.0;
        test.v[1] = 1000.0;
        double start = oscillator_energy(&o, test.q, test.v), greatest = 0.0;
        void *stepper = implicit_create(cases[i].method, &o.system, cases[i].radius);
        for (int k = 0; k < 10000; k++) {
            implicit_step_equally(cases[i].method, stepper, &test.state, 1.0, 1);
            greatest = fmax(greatest, oscillator_energy(&o, test.q, test.v));
        }
        g_test_message("%s, %g: energy up to %.12g, at last %g", cases[i].method->id, cases[i].radius, greatest / start,
                       oscillator_energy(&o, test.q, test.v) / start);
        if (cases[i].method == implicit_newmark()) {
            g_assert_cmpfloat(fabs(oscillator_energy(&o, test.q, test.v) / start - 1.0), <, 1e-9);
            g_assert_cmpfloat(greatest / start, <, 1.0 + 1e-9);
        } else if (cases[i].radius < 1) {
            g_assert_cmpfloat(oscillator_energy(&o, test.q, test.v), <, 1e-20 * start);
        }
        cases[i].method->destroy(stepper);
    }
}

/* At infinite frequency all three eigenvalues of a step are -r: (E + r)^3 x = 0, with E one step on. */
static void test_radius_at_infinity(void)
{
    static const double radii[] = {0.3, 0.5, 0.8, 0.95};
    for (gsize i = 0; i < G_N_ELEMENTS(radii); i++) {
        Oscillator o;
        TestState test;
        double r = radii[i], x[8];
        oscillator_init(&o, 1e4, 0.0, 0.0, 0.0);
        o.system.books = 0;
        test_state_init(&test, 0.0);
        test.q[0] = test.q[1] = 1.0;
        void *stepper = implicit_create(implicit_alpha(), &o.system, r);
        for (int k = 0; k < 8; k++) {
            implicit_step_equally(implicit_alpha(), stepper, &test.state, 1.0, 1);
            x[k] = test.q[0];
        }
        for (int k = 0; k + 3 < 8; k++) {
            double rest = x[k + 3] + 3 * r * x[k + 2] + 3 * r * r * x[k + 1] + r * r * r * x[k];
            g_assert_cmpfloat(fabs(rest), <, 1e-6 * fabs(x[k]));
        }
        implicit_step_equally(implicit_alpha(), stepper, &test.state, 1.0, 1000);
        g_assert_cmpfloat(fabs(test.q[0]), <, 1e-15);
        implicit_alpha()->destroy(stepper);
    }
    /* none given: 0.8 */
    Oscillator o;
    TestState given, left;
    oscillator_init(&o, 30.0, 0.0, 0.0, 0.0);
    test_state_init(&given, 0.0);
    given.q[0] = 1.0;
    test_state_init(&left, 0.0);
    left.q[0] = 1.0;
    void *first = implicit_create(implicit_alpha(), &o.system, 0.8),
         *second = implicit_create(implicit_alpha(), &o.system, 0.0);
    implicit_step_equally(implicit_alpha(), first, &given.state, 0.1, 20);
    implicit_step_equally(implicit_alpha(), second, &left.state, 0.1, 20);
    g_assert_cmpmem(given.q, sizeof given.q, left.q, sizeof left.q);
    implicit_alpha()->destroy(first);
    implicit_alpha()->destroy(second);
}

static void assert_refused(const TinkerIntegrator *method, const TinkerSystem *system, double radius, const char *why)
{
    TestState test;
    TinkerStepReport report = {.struct_size = sizeof report};
    test_state_init(&test, 0.0);
    test.q[0] = 1.0;
    test.q[1] = -0.5;
    void *stepper = implicit_create(method, system, radius);
    g_assert_cmpint(method->step(stepper, &test.state, 0.1, &report), ==, TINKER_FAILED);
    g_assert_nonnull(strstr(report.failure, why));
    g_assert_true(test.q[0] == 1.0 && test.q[1] == -0.5 && test.v[0] == 0.0 && test.state.t == 0.0);
    method->destroy(stepper);
}

/* A force that no end of the step meets: it points away from wherever the mass is. */
static TinkerStatus no_balance(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = q[i] > 0 ? -1e9 : 1e9;
    return TINKER_OK;
}

static void test_refusals(void)
{
    Oscillator o;
    Pendulum p;
    oscillator_init(&o, 2.0, 0.0, 0.0, 0.0);
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    assert_refused(implicit_alpha(), &p.system, 1.0, "0.95");
    assert_refused(implicit_alpha(), &o.system, 1.1, "from 0 to 1");
    assert_refused(implicit_alpha(), &o.system, -0.1, "from 0 to 1");
    assert_refused(implicit_alpha(), &o.system, (double)NAN, "from 0 to 1");
    o.system.acceleration = no_balance;
    o.system.books = 0;
    assert_refused(implicit_newmark(), &o.system, 0, "smaller step");
    o.system.jacobian = NULL;
    assert_refused(implicit_newmark(), &o.system, 0, "explicit");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/implicit/closed-recurrence", test_closed_recurrence);
    g_test_add_func("/numerics/implicit/no-limit-of-stability", test_no_limit_of_stability);
    g_test_add_func("/numerics/implicit/radius-at-infinity", test_radius_at_infinity);
    g_test_add_func("/numerics/implicit/refusals", test_refusals);
    return g_test_run();
}
