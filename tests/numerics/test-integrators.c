/* The kit that every integrator goes through: orders on closed forms, dense output, books, limits of stability,
 * landing, refusals, and that steps allot no memory. A new method is covered by being in the list. */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "allotments.h"
#include "numerics/methods/integrators.h"
#include "test-systems.h"

#define ORDER_MARGIN 0.15
#define PARTS        8

/* --- orders --- */

/* Steps to T = 3 such that the error is far above rounding and far in the asymptotic range. */
static int coarse_steps(const TinkerIntegrator *method)
{
    if (method->order >= 8) return 16;
    if (method->order >= 6) return 48;
    if (method->order >= 4) return method->order == 4 ? 256 : 192;
    return method->order == 2 ? 256 : 4096;
}

/* The largest errors at PARTS times: at a single one the leading term may happen to vanish. The books' error is how far
 * what dampers took and the drive gave is from making up for the exact change of energy. */
static double oscillator_error(const TinkerIntegrator *method, Oscillator *o, int steps, double *books)
{
    double largest = 0.0;
    TestState test;
    test_state_init(&test, 0.0);
    oscillator_exact(o, 0.0, test.q, test.v);
    double before = oscillator_energy(o, test.q, test.v);
    *books = 0.0;
    for (int part = 1; part <= PARTS; part++) {
        double t = 3.0 * part / PARTS, q[TEST_SIZE], v[TEST_SIZE];
        run_equal_steps(method, &o->system, &test, t, steps / PARTS);
        oscillator_exact(o, t, q, v);
        largest = fmax(largest, fmax(distance(TEST_SIZE, q, test.q), distance(TEST_SIZE, v, test.v)));
        *books = fmax(*books, fabs(before - test.books[0] + test.books[1] - oscillator_energy(o, q, v)));
    }
    return largest;
}

static void assert_order_at_least(const TinkerIntegrator *method, const char *what, double coarse, double fine,
                                  double order)
{
    double observed = log2(coarse / fine);
    g_test_message("%s, %s: errors %.3e, %.3e, order %.3f", method->id, what, coarse, fine, observed);
    g_assert_cmpfloat(observed, >, order - ORDER_MARGIN);
}

static void assert_order(const TinkerIntegrator *method, const char *what, double coarse, double fine, double order)
{
    assert_order_at_least(method, what, coarse, fine, order);
    g_assert_cmpfloat(log2(coarse / fine), <, order + ORDER_MARGIN);
}

static void test_oscillator_orders(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    static const struct {
        const char *name, *books;
        double gamma, drive, rate;
    } cases[] = {{"undamped", NULL, 0, 0, 0},
                 {"damped", "work of damping", 0.7, 0, 0},
                 {"driven", "work of drive", 0, 1.3, 1.1},
                 {"damped and driven", "work of both", 0.7, 1.3, 1.1}};
    int steps = coarse_steps(method);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        Oscillator o;
        oscillator_init(&o, 2.0, cases[i].gamma, cases[i].drive, cases[i].rate);
        double books, finer_books, coarse = oscillator_error(method, &o, steps, &books);
        double fine = oscillator_error(method, &o, 2 * steps, &finer_books);
        assert_order(method, cases[i].name, coarse, fine, method->order);
        if (cases[i].books) assert_order_at_least(method, cases[i].books, books, finer_books, method->order);
    }
}

static double pendulum_error(const TinkerIntegrator *method, Pendulum *p, int steps)
{
    double largest = 0.0;
    TestState test;
    test_state_init(&test, 0.0);
    pendulum_exact(p, 0.0, test.q, test.v);
    for (int part = 1; part <= PARTS; part++) {
        double t = 2.0 * part / PARTS, q[TEST_SIZE], v[TEST_SIZE];
        run_equal_steps(method, &p->system, &test, t, steps / PARTS);
        pendulum_exact(p, t, q, v);
        g_assert_cmpfloat(fabs(hypot(test.q[0], test.q[1]) - p->length), <=, 4e-16 * p->length);
        largest = fmax(largest, fmax(distance(TEST_SIZE, q, test.q), distance(TEST_SIZE, v, test.v)));
    }
    return largest;
}

static void test_pendulum_order(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Pendulum p;
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    int steps = method->order >= 8 ? 32 : 2 * coarse_steps(method);
    assert_order_at_least(method, "pendulum", pendulum_error(method, &p, steps), pendulum_error(method, &p, 2 * steps),
                          method->order);
}

/* --- dense output --- */

/* The largest error inside one step of length h from the exact state, over several steps. */
static double dense_error(const TinkerIntegrator *method, Oscillator *o, double h, double *books)
{
    double largest = 0.0;
    *books = 0.0;
    for (int start = 0; start < 8; start++) {
        double t0 = 0.37 * start;
        TestState test;
        TinkerStepReport report = {.struct_size = sizeof report};
        TinkerIntegratorOptions options = equal_step_options(h);
        void *stepper = method->create(&o->system, &options);
        test_state_init(&test, t0);
        oscillator_exact(o, t0, test.q, test.v);
        double before = oscillator_energy(o, test.q, test.v);
        g_assert_cmpint(method->step(stepper, &test.state, t0 + h, &report), ==, TINKER_OK);
        for (int part = 1; part < 16; part++) {
            double t = t0 + h * part / 16.0, q[TEST_SIZE], v[TEST_SIZE], w[TEST_BOOKS], qe[TEST_SIZE], ve[TEST_SIZE];
            g_assert_cmpint(method->interpolate(stepper, t, q, v, w), ==, TINKER_OK);
            oscillator_exact(o, t, qe, ve);
            largest = fmax(largest, fmax(distance(TEST_SIZE, q, qe), distance(TEST_SIZE, v, ve)));
            *books = fmax(*books, fabs(before - w[0] + w[1] - oscillator_energy(o, qe, ve)));
        }
        method->destroy(stepper);
    }
    return largest;
}

static void test_dense_order(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    double h = method->order >= 8 ? 0.2 : method->order >= 4 ? 0.05 : 0.005, books, finer_books;
    Oscillator o;
    oscillator_init(&o, 2.0, 0.3, 0.8, 1.1);
    double coarse = dense_error(method, &o, h, &books), fine = dense_error(method, &o, 0.5 * h, &finer_books);
    /* where a step's own error is of that size at any h above rounding, the order shows as one more */
    if (method->dense_order == method->order - 1 && method->order == 6)
        assert_order_at_least(method, "dense output", coarse, fine, method->dense_order + 1);
    else
        assert_order(method, "dense output", coarse, fine, method->dense_order + 1);
    assert_order_at_least(method, "dense books", books, finer_books, method->dense_order + 1);
}

/* Dense output meets the states at both ends, and asking for it changes no bit of the run. */
static void test_recording_changes_nothing(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    TestState recorded, plain;
    Oscillator o;
    oscillator_init(&o, 2.0, 0.3, 0.8, 1.1);
    TinkerIntegratorOptions options = tolerance_options(1e-8);
    void *first = method->create(&o.system, &options), *second = method->create(&o.system, &options);
    test_state_init(&recorded, 0.0);
    oscillator_exact(&o, 0.0, recorded.q, recorded.v);
    test_state_init(&plain, 0.0);
    oscillator_exact(&o, 0.0, plain.q, plain.v);
    for (int i = 1; i < 60; i++) {
        TinkerStepReport report = {.struct_size = sizeof report};
        TestState at;
        test_state_init(&at, 0.0);
        TestState start = recorded;
        g_assert_cmpint(method->step(first, &recorded.state, 0.05 * i, &report), ==, TINKER_OK);
        g_assert_cmpint(method->interpolate(first, report.t_from, at.q, at.v, at.books), ==, TINKER_OK);
        g_assert_cmpfloat(distance(TEST_SIZE, at.q, start.q) + distance(TEST_SIZE, at.v, start.v), ==, 0.0);
        g_assert_cmpint(method->interpolate(first, recorded.state.t, at.q, at.v, at.books), ==, TINKER_OK);
        g_assert_cmpfloat(distance(TEST_SIZE, at.q, recorded.q) + distance(TEST_SIZE, at.v, recorded.v), <, 4e-15);
        g_assert_cmpfloat(distance(TEST_BOOKS, at.books, recorded.books), <, 4e-15);
        g_assert_cmpint(method->step(second, &plain.state, 0.05 * i, &report), ==, TINKER_OK);
        g_assert_cmpmem(recorded.q, sizeof recorded.q, plain.q, sizeof plain.q);
        g_assert_cmpmem(recorded.v, sizeof recorded.v, plain.v, sizeof plain.v);
        g_assert_cmpmem(recorded.books, sizeof recorded.books, plain.books, sizeof plain.books);
    }
    method->destroy(first);
    method->destroy(second);
}

/* What is carried from step to step must be what a fresh stepper finds. */
static void test_carried_over_is_right(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    for (int constrained = 0; constrained < 2; constrained++) {
        Oscillator o;
        Pendulum p;
        TestState carried, fresh;
        oscillator_init(&o, 2.0, 0.0, 0.8, 1.1);
        pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
        TinkerSystem *system = constrained ? &p.system : &o.system;
        system->books = 0;
        test_state_init(&carried, 0.0);
        constrained ? pendulum_exact(&p, 0.0, carried.q, carried.v) : oscillator_exact(&o, 0.0, carried.q, carried.v);
        test_state_init(&fresh, 0.0);
        memcpy(fresh.q, carried.q, sizeof fresh.q);
        memcpy(fresh.v, carried.v, sizeof fresh.v);
        run_equal_steps(method, system, &carried, 1.0, 32);
        for (int i = 1; i <= 32; i++)
            run_equal_steps(method, system, &fresh, i / 32.0, 1);
        g_assert_cmpmem(carried.q, sizeof carried.q, fresh.q, sizeof fresh.q);
        g_assert_cmpmem(carried.v, sizeof carried.v, fresh.v, sizeof fresh.v);
    }
}

/* --- limits of stability --- */

/* The spectral radius of one step of an oscillator, by stepping the two unit states. */
static double spectral_radius(const TinkerIntegrator *method, double omega, double gamma)
{
    Oscillator o;
    TestState test;
    oscillator_init(&o, omega, gamma, 0.0, 0.0);
    test_state_init(&test, 0.0);
    test.q[0] = test.v[1] = 1.0;
    run_equal_steps(method, &o.system, &test, 1.0, 1);
    double half_trace = 0.5 * (test.q[0] + test.v[1]), determinant = test.q[0] * test.v[1] - test.q[1] * test.v[0];
    double complex root = csqrt(half_trace * half_trace - determinant);
    return fmax(cabs(half_trace + root), cabs(half_trace - root));
}

static void test_stability_limits(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    double limit = method->imaginary_limit;
    for (int part = 1; part < 50; part++)
        g_assert_cmpfloat(spectral_radius(method, (limit < 0.0 ? 20.0 : limit) * part / 50.0, 0.0), <, 1.0 + 1e-13);
    if (limit > 0.0) {
        g_assert_cmpfloat(spectral_radius(method, limit * 0.9999, 0.0), <, 1.0 + 1e-13);
        g_assert_cmpfloat(spectral_radius(method, limit * 1.0001, 0.0), >, 1.0 + 1e-9);
    }
    /* a free mass moves on: one eigenvalue is 1 */
    limit = method->real_limit;
    for (int part = 1; part < 50; part++)
        g_assert_cmpfloat(spectral_radius(method, 0.0, (limit < 0.0 ? 1e6 : limit) * part / 50.0), <, 1.0 + 1e-12);
    if (limit > 0.0) g_assert_cmpfloat(spectral_radius(method, 0.0, limit * 1.0001), >, 1.0 + 1e-6);
}

/* --- refusals --- */

static void assert_refused(const TinkerIntegrator *method, Oscillator *o, double limit)
{
    TestState test;
    TinkerStepReport report = {.struct_size = sizeof report};
    TinkerIntegratorOptions options = tolerance_options(1e-8);
    void *stepper = method->create(&o->system, &options);
    test_state_init(&test, 0.5);
    test.q[0] = test.v[1] = test.books[0] = 1.0;
    g_assert_cmpint(method->step(stepper, &test.state, limit, &report), ==, TINKER_FAILED);
    g_assert_nonnull(report.failure);
    g_assert_cmpfloat(test.state.t, ==, 0.5);
    g_assert_true(test.q[0] == 1.0 && test.q[1] == 0.0 && test.v[0] == 0.0 && test.v[1] == 1.0);
    g_assert_true(test.books[0] == 1.0 && test.books[1] == 0.0);
    g_assert_cmpint(method->interpolate(stepper, 0.5, test.q, test.v, NULL), !=, TINKER_OK);
    method->destroy(stepper);
}

static void test_refusals(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    Oscillator o;
    oscillator_init(&o, 2.0, 0.3, 0.0, 0.0);
    assert_refused(method, &o, 0.5);
    assert_refused(method, &o, (double)NAN);
    assert_refused(method, &o, (double)INFINITY);
    o.refuse_speed = 1e-9;
    assert_refused(method, &o, 1.0);
}

static void test_no_allotment(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    for (int constrained = 0; constrained < 2; constrained++) {
        Oscillator o;
        Pendulum p;
        TestState test, at;
        TinkerStepReport report = {.struct_size = sizeof report};
        TinkerIntegratorOptions options = tolerance_options(1e-8);
        oscillator_init(&o, 2.0, 0.3, 0.8, 1.1);
        pendulum_init(&p, 1.3, 9.81, 2.0, 0.1);
        test_state_init(&test, 0.0);
        test_state_init(&at, 0.0);
        constrained ? pendulum_exact(&p, 0.0, test.q, test.v) : oscillator_exact(&o, 0.0, test.q, test.v);
        int before = allotments;
        void *stepper = method->create(constrained ? &p.system : &o.system, &options);
        g_assert_cmpint(allotments, >, before);
        before = allotments;
        TinkerStatus status = TINKER_OK;
        for (int i = 1; i < 50 && status == TINKER_OK; i++) {
            status = method->step(stepper, &test.state, 0.02 * i, &report);
            if (status == TINKER_OK) status = method->interpolate(stepper, report.t_from, at.q, at.v, at.books);
            if (i % 10 == 0) method->restart(stepper);
        }
        int after = allotments;
        g_assert_cmpint(status, ==, TINKER_OK);
        g_assert_cmpint(after, ==, before);
        method->destroy(stepper);
    }
}

static void test_table(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    g_assert_true(tinker_integrator_builtin(method->id) == method);
    g_assert_null(tinker_integrator_builtin("no such method"));
    g_assert_null(tinker_integrator_builtin(NULL));
    g_assert_cmpuint(method->struct_size, ==, sizeof *method);
    g_assert_true(method->title && method->summary && method->source);
    g_assert_cmpint(method->dense_order, >=, method->order - 1);
}

static void add(const TinkerIntegrator *method, const char *name, GTestDataFunc test)
{
    g_autofree char *path = g_strdup_printf("/numerics/%s/%s", method->id, name);
    g_test_add_data_func(path, method, test);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each; each++) {
        /* those for linear systems alone have tests of their own */
        if ((*each)->flags & TINKER_INTEGRATOR_LINEAR) continue;
        add(*each, "table", test_table);
        add(*each, "oscillator-orders", test_oscillator_orders);
        add(*each, "pendulum-order", test_pendulum_order);
        add(*each, "dense-order", test_dense_order);
        add(*each, "recording-changes-nothing", test_recording_changes_nothing);
        /* an implicit method carries over what its last iteration found */
        if (!((*each)->flags & TINKER_INTEGRATOR_IMPLICIT))
            add(*each, "carried-over-is-right", test_carried_over_is_right);
        add(*each, "stability-limits", test_stability_limits);
        add(*each, "refusals", test_refusals);
        add(*each, "no-allotment", test_no_allotment);
    }
    return g_test_run();
}
