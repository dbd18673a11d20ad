/* The exact method on several masses: dampers that couple modes, energies, samples inside a step, memory and cost;
 * truth is closed forms and Taylor series in quadruple precision. */
#include <float.h>
#include <math.h>

#include "allotments.h"
#include "linear-recipe.h"
#include "numerics/exact/exact.h"
#include "numerics/methods/integrators.h"

/* Ten masses between two walls in their third mode: x_i = sin(3 pi i / 11) cos(omega t). */
static void test_chain_in_one_mode(void)
{
    LinearCase test;
    int32_t n = 10;
    case_init(&test, n);
    int32_t wall = case_anchor(&test, 0.0);
    for (int32_t i = 0; i <= n; i++)
        case_edge(&test, i == 0 ? -1 : i - 1, i == n ? wall : i, 100.0, 0.0);
    for (int32_t i = 0; i < n; i++)
        test.q[i] = sin(3.0 * G_PI * (i + 1) / (n + 1));
    long double omega = 20.0L * sinl(3.0L * acosl(-1.0L) / (2 * n + 2)), T = 50.0L;
    case_run(&test, 50.0, 7);
    for (int32_t i = 0; i < n; i++)
        assert_near(test.q[i], (double)(sinl(3.0L * acosl(-1.0L) * (i + 1) / (n + 1)) * cosl(omega * T)),
                    16.0 * DBL_EPSILON * (double)(omega * T));
}

/* Two free masses, 1 and 1e9, on a spring with a length, flying: centre of mass and vibration in closed form. */
static void test_unequal_pair(void)
{
    LinearCase test;
    case_init(&test, 2);
    test.mass[1] = 1e9;
    case_edge(&test, 0, 1, 50.0, 0.0)->length = 1.0;
    test.q[0] = 10.0;
    test.q[1] = 11.25;
    test.v[0] = 0.5;
    test.v[1] = 0.1;
    long double m = 1.0L + 1e9L, centre = (10.0L + 1e9L * 11.25L) / m,
                drift = (0.5L + 1e9L * (long double)test.v[1]) / m;
    long double omega = sqrtl(50.0L * m / 1e9L), rate = (long double)test.v[1] - 0.5L, T = 20.0L;
    long double d = 1.0L + 0.25L * cosl(omega * T) + rate / omega * sinl(omega * T);
    case_run(&test, 20.0, 11);
    assert_near(test.q[0], (double)(centre + drift * T - d * 1e9L / m), 16.0 * DBL_EPSILON * 150.0);
    assert_near(test.q[1], (double)(centre + drift * T + d / m), 16.0 * DBL_EPSILON * 15.0);
}

static double largest_energy(const LinearCase *test)
{
    double size = fabs(case_energy(test));
    for (int b = 0; b < CASE_BOOKS; b++)
        size = fmax(size, fabs(test->books[b]));
    return size;
}

/* The state against the series, books against the series, and the balance of the energies. */
static void assert_like(LinearCase *test, const LinearCase *truth, double T, int steps, double rate)
{
    int32_t n = test->linear.size;
    double before = case_energy(test), unit = DBL_EPSILON * (10.0 + rate * T), place = n, speed = n;
    case_run(test, T, steps);
    for (int32_t i = 0; i < n; i++) {
        place = fmax(place, fabs(truth->q[i]));
        speed = fmax(speed, fabs(truth->v[i]));
    }
    for (int32_t i = 0; i < n; i++) {
        assert_near(test->q[i], truth->q[i], 16.0 * unit * place);
        assert_near(test->v[i], truth->v[i], 16.0 * unit * (speed + place));
    }
    double size = largest_energy(truth), change = case_energy(test) - before;
    for (int b = 0; b < CASE_BOOKS; b++) {
        assert_near(test->books[b], truth->books[b], 32.0 * unit * size);
        change -= test->books[b];
    }
    assert_near(change, 0.0, 64.0 * unit * size);
}

static void assert_like_series(const Recipe *recipe, guint32 seed)
{
    LinearCase one, many, truth;
    recipe_cook(&one, recipe, seed);
    recipe_copy_case(&many, &one);
    recipe_copy_case(&truth, &one);
    double T = 3.0, rate = 20.0;
    case_run_by_series(&truth, T, 200);
    assert_like(&one, &truth, T, 1, rate);
    assert_like(&many, &truth, T, 25, rate);
}

static void test_like_series(void)
{
    static const Recipe recipes[] = {
        {1, FALSE, TRUE, TRUE, TRUE, 10.0},  {1, FALSE, FALSE, TRUE, TRUE, 10.0}, {1, FALSE, FALSE, FALSE, TRUE, 1.0},
        {2, TRUE, TRUE, FALSE, TRUE, 10.0},  {2, FALSE, TRUE, TRUE, FALSE, 30.0}, {3, FALSE, FALSE, FALSE, TRUE, 9.0},
        {4, TRUE, TRUE, TRUE, TRUE, 20.0},   {4, FALSE, TRUE, TRUE, TRUE, 20.0},  {4, TRUE, FALSE, TRUE, TRUE, 20.0},
        {5, FALSE, FALSE, TRUE, TRUE, 25.0}, {6, FALSE, TRUE, FALSE, TRUE, 15.0}, {5, FALSE, FALSE, FALSE, FALSE, 9.0},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(recipes); i++) {
        for (guint32 seed = 1; seed <= 2; seed++)
            assert_like_series(&recipes[i], seed);
    }
}

/* A stiff line whose dampers couple the modes: the soft motion does not feel the rounding of the stiff. */
static void test_stiff_line(void)
{
    LinearCase test, truth;
    case_init(&test, 8);
    for (int32_t i = 0; i < 8; i++) {
        double k = i % 2 ? 1e8 : 1e2;
        case_edge(&test, i - 1, i, k, 0.02 * sqrt(k));
        test.q[i] = (i / 2 + 1) / 4.0;
    }
    recipe_copy_case(&truth, &test);
    g_assert_false(tinker_exact_is_proportional(&test.linear));
    case_run_by_series(&truth, 0.25, 12000);
    case_run(&test, 0.25, 1);
    for (int32_t i = 0; i < 8; i++) {
        assert_near(test.q[i], truth.q[i], 64.0 * DBL_EPSILON);
        assert_near(test.v[i], truth.v[i], tinker_exact_claimed_error(&test.linear, 0.25) * 100.0);
    }
}

/* Samples inside an interval that the fastest mode turns through many times, against the series from its start. */
static void test_inside_a_stiff_interval(void)
{
    LinearCase test, truth;
    case_init(&test, 4);
    for (int32_t i = 0; i < 4; i++) {
        double k = i % 2 ? 1e8 : 1e2;
        case_edge(&test, i - 1, i, k, 0.02 * sqrt(k));
        test.q[i] = (i / 2 + 1) / 2.0;
    }
    const double T = tinker_exact_interval(&test.linear, 0.0, 10.0);
    assert_near(T, 10.0 / 257.0, 1e-15);
    g_assert_cmpfloat(T * tinker_exact_fastest(&test.linear), >, 500.0);
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    recipe_copy_case(&truth, &test);
    void *stepper = exact->create(&test.system, &options);
    TinkerState state = {0.0, test.q, test.v, test.books};
    g_assert_cmpint(exact->step(stepper, &state, T, &report), ==, TINKER_OK);
    for (int i = 1; i <= 9; i++) {
        double q[4], v[4], t = 0.103 * i * T;
        case_run_by_series(&truth, t, 400);
        g_assert_cmpint(exact->interpolate(stepper, t, q, v, NULL), ==, TINKER_OK);
        for (int k = 0; k < 4; k++) {
            assert_near(q[k], truth.q[k], 64.0 * DBL_EPSILON);
            assert_near(v[k], truth.v[k], tinker_exact_claimed_error(&test.linear, T) * 100.0);
        }
    }
    exact->destroy(stepper);
}

/* Proportional or not, the answers agree where both ways can go: dampers off Rayleigh's by a rounding that still
 * counts. */
static void test_coupled_like_apart(void)
{
    LinearCase apart, coupled;
    Recipe recipe = {5, TRUE, TRUE, TRUE, TRUE, 20.0};
    recipe_cook(&apart, &recipe, 7);
    recipe_copy_case(&coupled, &apart);
    coupled.edges[1].damping *= 1.0 + 1e-11;
    g_assert_true(tinker_exact_is_proportional(&apart.linear));
    g_assert_false(tinker_exact_is_proportional(&coupled.linear));
    case_run(&apart, 5.0, 10);
    case_run(&coupled, 5.0, 10);
    for (int32_t i = 0; i < 5; i++)
        assert_near(coupled.q[i], apart.q[i], 1e-11);
    for (int b = 0; b < CASE_BOOKS; b++)
        assert_near(coupled.books[b], apart.books[b], 2e-11);
}

/* Two free masses that a damper alone joins: the difference of speeds dies, the sum stays. */
static void test_damper_alone(void)
{
    LinearCase test;
    case_init(&test, 2);
    test.mass[1] = 3.0;
    case_edge(&test, 0, 1, 0.0, 0.6);
    test.v[0] = 1.0;
    double rate = 0.6 * (1.0 + 1.0 / 3.0), T = 5.0, mean = 0.25, way = -expm1(-rate * T) / rate;
    case_run(&test, T, 3);
    assert_near(test.v[0], mean + 0.75 * exp(-rate * T), 16.0 * DBL_EPSILON);
    assert_near(test.q[0], mean * T + 0.75 * way, 32.0 * DBL_EPSILON);
    assert_near(test.q[1], mean * T - 0.25 * way, 32.0 * DBL_EPSILON);
}

/* Inside a step, books too: as if a step had ended there. */
static void test_inside_a_step(void)
{
    static const Recipe recipes[] = {{4, TRUE, TRUE, TRUE, TRUE, 20.0}, {4, FALSE, TRUE, TRUE, TRUE, 20.0}};
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    for (gsize r = 0; r < G_N_ELEMENTS(recipes); r++) {
        LinearCase test, truth;
        recipe_cook(&test, &recipes[r], 11);
        recipe_copy_case(&truth, &test);
        case_run_by_series(&truth, 1.3, 90);
        void *stepper = exact->create(&test.system, &options);
        TinkerState state = {0.0, test.q, test.v, test.books};
        g_assert_cmpint(exact->step(stepper, &state, 1.3, &report), ==, TINKER_OK);
        g_assert_cmpint(exact->step(stepper, &state, 2.9, &report), ==, TINKER_OK);
        for (int i = 0; i <= 16; i++) {
            double q[4], v[4], books[CASE_BOOKS], t = fmin(1.3 + 0.1 * i, 2.9);
            if (i > 0) case_run_by_series(&truth, t, 7);
            g_assert_cmpint(exact->interpolate(stepper, t, q, v, books), ==, TINKER_OK);
            for (int k = 0; k < 4; k++) {
                assert_near(q[k], truth.q[k], 3e-14);
                assert_near(v[k], truth.v[k], 1e-13);
            }
            for (int b = 0; b < CASE_BOOKS; b++)
                assert_near(books[b], truth.books[b], 1e-13);
        }
        exact->destroy(stepper);
    }
}

static void test_no_allotment(void)
{
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    static const Recipe recipes[] = {{4, TRUE, TRUE, TRUE, TRUE, 20.0}, {4, FALSE, TRUE, TRUE, TRUE, 20.0}};
    for (gsize r = 0; r < G_N_ELEMENTS(recipes); r++) {
        LinearCase test;
        double q[4], v[4], books[CASE_BOOKS];
        recipe_cook(&test, &recipes[r], 5);
        void *stepper = exact->create(&test.system, &options);
        exact->restart(stepper);
        TinkerState state = {0.0, test.q, test.v, test.books};
        int before = allotments;
        TinkerStatus status = TINKER_OK;
        for (int i = 1; i < 50 && status == TINKER_OK; i++) {
            status = exact->step(stepper, &state, 0.02 * i, &report);
            if (status == TINKER_OK) status = exact->interpolate(stepper, report.t_from + 0.007, q, v, books);
            if (i % 10 == 0) exact->restart(stepper);
        }
        int after = allotments;
        g_assert_cmpint(status, ==, TINKER_OK);
        g_assert_cmpint(after, ==, before);
        exact->destroy(stepper);
    }
}

static void test_cost(void)
{
    LinearCase small, large;
    Recipe recipe = {3, FALSE, TRUE, TRUE, FALSE, 9.0};
    recipe_cook(&small, &recipe, 1);
    recipe.size = 30;
    recipe_cook(&large, &recipe, 1);
    double setup, larger;
    g_assert_cmpfloat(tinker_exact_operations(&small.linear, 10, &setup), >, 0.0);
    g_assert_cmpfloat(tinker_exact_operations(&large.linear, 10, &larger), >, 0.0);
    g_assert_cmpfloat(larger, >, 100.0 * setup);
    small.edges[0].stiffness = -1.0;
    tinker_exact_operations(&small.linear, 10, &setup);
    g_assert_true(isinf(setup));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/exact-systems/chain-in-one-mode", test_chain_in_one_mode);
    g_test_add_func("/numerics/exact-systems/unequal-pair", test_unequal_pair);
    g_test_add_func("/numerics/exact-systems/like-series", test_like_series);
    g_test_add_func("/numerics/exact-systems/stiff-line", test_stiff_line);
    g_test_add_func("/numerics/exact-systems/inside-a-stiff-interval", test_inside_a_stiff_interval);
    g_test_add_func("/numerics/exact-systems/coupled-like-apart", test_coupled_like_apart);
    g_test_add_func("/numerics/exact-systems/damper-alone", test_damper_alone);
    g_test_add_func("/numerics/exact-systems/inside-a-step", test_inside_a_step);
    g_test_add_func("/numerics/exact-systems/no-allotment", test_no_allotment);
    g_test_add_func("/numerics/exact-systems/cost", test_cost);
    return g_test_run();
}
