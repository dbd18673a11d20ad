/* Verlet's own promises: bounded energy of RATTLE over long runs, reversibility, symmetry with damping, and dampers of
 * any stiffness. */
#include <complex.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "test-systems.h"

static void step_equally(const TinkerIntegrator *method, void *stepper, TestState *test, double h, int steps)
{
    TinkerStepReport report = {.struct_size = sizeof report};
    for (int i = 0; i < steps; i++)
        g_assert_cmpint(method->step(stepper, &test->state, test->state.t + h, &report), ==, TINKER_OK);
}

/* The largest energy error over the next `steps` steps. */
static double energy_error(const TinkerIntegrator *method, void *stepper, const Pendulum *p, TestState *test, double h,
                           int steps, double energy)
{
    double largest = 0.0;
    for (int i = 0; i < steps; i++) {
        step_equally(method, stepper, test, h, 1);
        largest = fmax(largest, fabs(pendulum_energy(p, test->q, test->v) - energy));
    }
    return largest;
}

static void test_energy_stays(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    Pendulum p;
    TestState test;
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    p.system.books = 0;
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.0, test.q, test.v);
    double energy = pendulum_energy(&p, test.q, test.v), h = pendulum_period(&p) / 100.0;
    void *stepper = method->create(&p.system, &options);
    double early = energy_error(method, stepper, &p, &test, h, 100 * 100, energy);
    step_equally(method, stepper, &test, h, 100 * 9800);
    double late = energy_error(method, stepper, &p, &test, h, 100 * 100, energy);
    g_test_message("energy error %.4e in the first 100 periods, %.4e in the last of 10000", early, late);
    g_assert_cmpfloat(early, <, 0.02 * 9.81 * 1.3);
    g_assert_cmpfloat(late, <, 1.01 * early);
    g_assert_cmpfloat(fabs(hypot(test.q[0], test.q[1]) - 1.3), <, 1e-15);
    method->destroy(stepper);
}

/* Forwards, then with turned velocities forwards again, is the start with turned velocities. */
static void test_reversible(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    Pendulum p;
    TestState test;
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.2, test.q, test.v);
    TestState start = test;
    run_equal_steps(method, &p.system, &test, 4.0, 200);
    g_assert_cmpfloat(distance(TEST_SIZE, test.q, start.q), >, 0.1);
    for (int i = 0; i < TEST_SIZE; i++)
        test.v[i] = -test.v[i];
    run_equal_steps(method, &p.system, &test, 8.0, 200);
    for (int i = 0; i < TEST_SIZE; i++)
        test.v[i] = -test.v[i];
    g_assert_cmpfloat(distance(TEST_SIZE, test.q, start.q), <, 1e-11);
    g_assert_cmpfloat(distance(TEST_SIZE, test.v, start.v), <, 1e-11);
}

/* A symmetric method undoes a step by one of the opposite length, damped, driven and constrained as it may be. */
static void assert_symmetric(TinkerSystem *system, TestState *test)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    TestState start = *test;
    run_equal_steps(method, system, test, 0.4, 10);
    g_assert_cmpfloat(distance(TEST_SIZE, test->q, start.q), >, 0.01);
    run_equal_steps(method, system, test, 0.0, 10);
    g_assert_cmpfloat(distance(TEST_SIZE, test->q, start.q), <, 1e-13);
    g_assert_cmpfloat(distance(TEST_SIZE, test->v, start.v), <, 1e-13);
    g_assert_cmpfloat(distance(TEST_BOOKS, test->books, start.books), <, 1e-13);
}

static void test_symmetric(void)
{
    Oscillator o;
    Pendulum p;
    TestState test;
    oscillator_init(&o, 2.0, 0.9, 0.8, 1.1);
    test_state_init(&test, 0.0);
    oscillator_exact(&o, 0.0, test.q, test.v);
    assert_symmetric(&o.system, &test);
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.9);
    test_state_init(&test, 0.0);
    pendulum_exact(&p, 0.2, test.q, test.v);
    assert_symmetric(&p.system, &test);
}

/* Dampers far too stiff for an explicit method: the speed never grows, and each step costs three evaluations: two for
 * the implicit half, as linear damping takes one Newton step and its check, one for the explicit half. */
static void test_stiff_damper(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    for (double gamma = 1.0; gamma < 1e9; gamma *= 100.0) {
        Oscillator o;
        TestState test;
        oscillator_init(&o, 1.0, 0.0, 0.0, 0.0);
        oscillator_init(&o, 1.0, gamma, 0.0, 0.0);
        test_state_init(&test, 0.0);
        test.q[0] = 1.0;
        test.v[1] = 1.0;
        run_equal_steps(method, &o.system, &test, 20.0, 200);
        g_assert_cmpint(o.evaluations, ==, 3 * 200);
        g_assert_cmpfloat(oscillator_energy(&o, test.q, test.v), <=, 1.0);
        /* an overdamped spring creeps back as exp(-omega^2 t / gamma), up to terms of 1 / gamma^2; the rest is the
         * first velocity error, omega^2 x / gamma, which alternates: its drift is that over gamma h / 2 */
        if (gamma > 50.0) g_assert_cmpfloat(fabs(test.q[0] - exp(-20.0 / gamma)), <, 4.0 / (gamma * gamma) + 1e-13);
    }
}

/* Damping that grows with the square of the speed, x'' = -k |v| v: v = v0 / (1 + k v0 t). */
static TinkerStatus square_drag(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    Oscillator *o = context;
    o->evaluations++;
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = -o->gamma * fabs(v[i]) * v[i];
    if (power) power[0] = power[1] = 0.0;
    return TINKER_OK;
}

static TinkerStatus square_drag_product(void *context, double t, const double *q, const double *v, const double *dv,
                                        double *out)
{
    const Oscillator *o = context;
    for (int i = 0; i < TEST_SIZE; i++)
        out[i] = -2.0 * o->gamma * fabs(v[i]) * dv[i];
    return TINKER_OK;
}

static void test_nonlinear_damping(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    double errors[2];
    for (int finer = 0; finer < 2; finer++) {
        Oscillator o;
        TestState test;
        oscillator_init(&o, 0.0, 1.5, 0.0, 0.0);
        o.system.applied = o.system.acceleration = square_drag;
        o.system.damping_product = square_drag_product;
        test_state_init(&test, 0.0);
        test.v[0] = 2.0;
        run_equal_steps(method, &o.system, &test, 1.0, finer ? 200 : 100);
        errors[finer] = fmax(fabs(test.v[0] - 2.0 / 4.0), fabs(test.q[0] - log(4.0) / 1.5));
        g_assert_cmpint(o.evaluations, <, (finer ? 200 : 100) * 7);
    }
    g_assert_cmpfloat(fabs(log2(errors[0] / errors[1]) - 2.0), <, 0.15);
}

/* Forces across the velocity beside drag, of each pair of coordinates its own: z' = -(c + i g) z. */
#define TURNED 8
static const double turned_drag[] = {0.0, 0.0, 0.7, 30.0}, turned_rate[] = {1.0, 200.0, -40.0, 9.0};

static TinkerStatus turned_product(void *context, double t, const double *q, const double *v, const double *dv,
                                   double *out)
{
    for (int i = 0; i < TURNED / 2; i++) {
        const double complex z = -(turned_drag[i] + I * turned_rate[i]) * (dv[2 * i] + I * dv[2 * i + 1]);
        out[2 * i] = creal(z);
        out[2 * i + 1] = cimag(z);
    }
    return TINKER_OK;
}

static TinkerStatus turned(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    return turned_product(context, t, q, v, v, a);
}

/* The implicit and the explicit half together multiply by (1 - z) / (1 + z), z = h (c + i g) / 2: a circle stays one at
 * any step. */
static void test_turned(void)
{
    const TinkerIntegrator *method = tinker_integrator_builtin("verlet");
    const double mass[TURNED] = {1, 1, 1, 1, 1, 1, 1, 1};
    TinkerIntegratorOptions options = tolerance_options(1e-9);
    for (double h = 1e-3; h < 20; h *= 7) {
        Oscillator o;
        double q[TURNED] = {0}, v[TURNED] = {1, 2, 3, -4, 0.5, 6, -7, 8};
        const double before[TURNED] = {1, 2, 3, -4, 0.5, 6, -7, 8};
        oscillator_init(&o, 1.0, 1.0, 0.0, 0.0);
        o.system.size = TURNED;
        o.system.books = 0;
        o.system.mass = mass;
        o.system.acceleration = o.system.applied = turned;
        o.system.damping_product = turned_product;
        TinkerState state = {0.0, q, v, NULL};
        TinkerStepReport report = {.struct_size = sizeof report};
        void *stepper = method->create(&o.system, &options);
        for (int step = 0; step < 50; step++)
            g_assert_cmpint(method->step(stepper, &state, state.t + h, &report), ==, TINKER_OK);
        method->destroy(stepper);
        for (int i = 0; i < TURNED / 2; i++) {
            const double complex z = 0.5 * h * (turned_drag[i] + I * turned_rate[i]);
            const double complex start = before[2 * i] + I * before[2 * i + 1];
            const double complex end = cpow((1 - z) / (1 + z), 50) * start;
            g_assert_cmpfloat(cabs(v[2 * i] + I * v[2 * i + 1] - end), <, 1e-9 * cabs(start));
        }
    }
}

/* The elliptic functions that judge the pendulum, against Abramowitz and Stegun's tables 17.1 and example 16.7. */
static void test_elliptic_functions(void)
{
    double sn, cn, dn;
    g_assert_cmpfloat(fabs(elliptic_period(sqrt(0.5)) - 1.854074677301372), <, 1e-14);
    jacobi(elliptic_period(0.8), 0.8, &sn, &cn, &dn);
    g_assert_cmpfloat(fabs(sn - 1.0) + fabs(cn) + fabs(dn - 0.6), <, 1e-14);
    jacobi(0.2, sqrt(0.81), &sn, &cn, &dn);
    g_assert_cmpfloat(fabs(sn - 0.19762), <, 5e-6);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/verlet/elliptic-functions", test_elliptic_functions);
    g_test_add_func("/numerics/verlet/energy-stays", test_energy_stays);
    g_test_add_func("/numerics/verlet/reversible", test_reversible);
    g_test_add_func("/numerics/verlet/symmetric", test_symmetric);
    g_test_add_func("/numerics/verlet/stiff-damper", test_stiff_damper);
    g_test_add_func("/numerics/verlet/nonlinear-damping", test_nonlinear_damping);
    g_test_add_func("/numerics/verlet/turned", test_turned);
    return g_test_run();
}
