/* Estimates of exact runs: where ends pass each other or the motion is stiff, where exactness ends at a contact, and
 * what is claimed between samples. */
#include "physics-fixture.h"

#include "closed-form-motions.h"
#include "estimate-case.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#include <math.h>

/* Masses on a line whose ends pass each other again and again: what rounding starts grows there by far more than the
 * time. Runs that meet other samples round otherwise, and part by no more than both claim. */
static void test_passing(void)
{
    const char *scene = "{'type': 'support', 'solid': false},"
                        "{'type': 'mass', 'position': [1, 0], 'mass': 0.12, 'velocity': [-0.7, 0]},"
                        "{'type': 'mass', 'position': [2, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 20000, 'rest_length': 0},"
                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 5000, 'rest_length': 1}";
    PhysicsOptions options = {.method = "exact", .duration = 3, .interval = 0.1, .columns = "Mass 0.x, Mass 1.x"};
    options.estimate = TRUE;
    g_autoptr(PhysicsRun) coarse = physics_run(&options, "%s", scene);
    options.interval = 0.01;
    g_autoptr(PhysicsRun) fine = physics_run(&options, "%s", scene);
    double claimed = coarse->summary->error_estimate + fine->summary->error_estimate;
    for (gsize i = 0; i < 2; i++) /* the extent is about 2.5 m */
        physics_assert_near("x", physics_last(coarse, i), physics_last(fine, i), 2.5 * claimed);
    g_assert_cmpfloat(claimed, >, 1e-8);
}

/* A mass on a stiff spring of some length, which is pushed slowly: its ends come nowhere near each other, so the exact
 * solution is off by rounding alone, of which speeds have more than places. Of m x'' = F (1 - cos W t) - k x from rest,
 * with w^2 = k / m, x = F / k (1 - cos w t) - F / (m (w^2 - W^2)) (cos W t - cos w t). Velocities are compared: places
 * are so near to the rest length that what is recorded of them is that. */
static void test_stiff_apart(void)
{
    enum { TIMES = 10 };
    const double force = 1000, k = 1e12, slow = 2 * G_PI, fast = 1e6, between = 0.05;
    PhysicsOptions options = {
        .method = "exact", .duration = TIMES * between, .interval = between, .columns = "Mass 0.vx", .estimate = TRUE};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0]},"
                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1e12, 'rest_length': 1},"
                  "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '1000*(1-cos(2*pi*t))'}}");
    const double speed = force * slow / k, claimed = run->summary->error_estimate;
    g_assert_true(isinf(run->summary->predictable_until));
    g_assert_cmpfloat(claimed, <, 1e-6);
    for (int i = 1; i <= TIMES; i++) {
        const double t = i * between, rings = force * (fast / k - fast / (fast * fast - slow * slow));
        const double v = rings * sin(fast * t) + force * slow / (fast * fast - slow * slow) * sin(slow * t);
        physics_assert_near("vx", physics_value(run, i, 0), v, claimed * speed);
    }
}

/* A mass on a spring and a damper that is let go comes to rest within a second of 1000 s: x = 1 + e^(-n t) (cos w t +
 * n/w sin w t) / 2 with n = c / 2 m, w^2 = k / m - n^2. The exact steps are as long as what follows, and see nothing of
 * it. */
static void test_comes_to_rest(void)
{
    static const double intervals[] = {10, 0.5};
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        const double c = 9, n = c / 2, w = sqrt(25 - n * n);
        PhysicsOptions options = {
            .method = "exact", .duration = 1000, .interval = intervals[i], .columns = "Mass 0.x", .estimate = TRUE};
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.5, 0]},"
                                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1},"
                                  "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 9}");
        const double claimed = run->summary->error_estimate;
        g_assert_true(isinf(run->summary->predictable_until));
        g_assert_cmpfloat(claimed, <, 1e-8);
        for (gsize k = 0; k < physics_samples(run); k++) {
            const double t = physics_time(run, k);
            physics_assert_near("x", physics_value(run, k, 0), 1 + exp(-n * t) * (cos(w * t) + n / w * sin(w * t)) / 2,
                                claimed / 2);
        }
    }
}

/* What a run claims, sample by sample. */
static gboolean keep_claim(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    GArray *claims = data;
    double claim = tinker_simulation_error(simulation);
    if (time > 0) g_array_append_val(claims, claim);
    return TRUE;
}

static GArray *claims_of(const PhysicsOptions *options, const char *blocks)
{
    GArray *claims = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GError) error = NULL;
    g_autoptr(PhysicsRun) run = physics_prepare(options, "%s", blocks);
    tinker_simulation_run(run->simulation, NULL, keep_claim, claims, &error);
    g_assert_no_error(error);
    return claims;
}

/* Pushed along by 6 sin 5t while it falls onto a smooth floor and after: x = 6 (5t - sin 5t) / 25. The fall and its end
 * are exact, what follows is not. */
static void test_exact_then_contact(void)
{
    static const double tolerances[] = {1e-3, 1e-6, 1e-9};
    const char *scene = "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 100,"
                        "'static_friction': 0, 'dynamic_friction': 0},"
                        "{'type': 'mass', 'position': [0, 0.7]},"
                        "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': 'sine', 'amplitude': 6, 'frequency': 5}";
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        PhysicsOptions options = {.method = "auto",
                                  .tolerance = tolerances[i],
                                  .duration = 6,
                                  .interval = 0.25,
                                  .columns = "Mass 0.x, Mass 0.vx",
                                  .estimate = TRUE};
        g_autoptr(GArray) claims = claims_of(&options, scene);
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", scene);
        double apart = 0, faster = 0;
        for (guint k = 0; k < claims->len; k++) {
            double t = physics_time(run, k + 1), extent = 6 * (5 * t - sin(5 * t)) / 25, speed = 12.0 / 5;
            apart = fmax(apart, fabs(physics_value(run, k + 1, 0) - extent));
            faster = fmax(faster, fabs(physics_value(run, k + 1, 1) - 6 * (1 - cos(5 * t)) / 5));
            double error = fmax(apart / extent, faster / speed);
            g_assert_cmpfloat(fmax(error, ESTIMATE_FLOOR), <=, g_array_index(claims, double, k));
        }
        g_assert_cmpfloat(apart, >, 0);
    }
}

/* x'' + 1000 x' + 20000 x = 0 from x = 1 at 300 m/s: what is fast is over within some milliseconds. */
static void strongly_damped(double t, Motion *motion)
{
    double root = sqrt(500.0 * 500.0 - 20000.0), slow = -20000.0 / (500 + root), fast = -500 - root;
    double c = (300 - fast) / (slow - fast), d = 1 - c;
    motion->q[0] = c * exp(slow * t) + d * exp(fast * t);
    motion->v[0] = slow * c * exp(slow * t) + fast * d * exp(fast * t);
}

/* A few samples late in the motion claim what it was off by early, too. */
static void test_between_samples(void)
{
    static const double tolerances[] = {1e-4, 1e-6, 1e-9};
    const char *scene = "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
                        "{'type': 'mass', 'position': [1, 0], 'velocity': [300, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 20000, 'rest_length': 1},"
                        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 1000}";
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        PhysicsOptions options = {.tolerance = tolerances[i], .duration = 0.6, .interval = 0.3, .estimate = TRUE};
        g_autoptr(GArray) claims = claims_of(&options, scene);
        options.interval = 1e-4;
        options.columns = "Mass 0.x, Mass 0.vx";
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", scene);
        double reach = 0, apart = 0, faster = 0;
        for (gsize k = 0; k < physics_samples(run); k++) {
            Motion truth = {0};
            strongly_damped(physics_time(run, k), &truth);
            reach = fmax(reach, truth.q[0]);
            apart = fmax(apart, fabs(physics_value(run, k, 0) - truth.q[0]));
            faster = fmax(faster, fabs(physics_value(run, k, 1) - truth.v[0]));
        }
        double error = fmax(apart / (reach + 1), faster / 300), claimed = g_array_index(claims, double, 1);
        g_test_message("tolerance %g: error %.2g, claimed %.2g", tolerances[i], error, claimed);
        g_assert_cmpfloat(error, <=, 2 * claimed); /* where stability makes the steps, errors are spikes */
        g_assert_cmpfloat(claimed, <, 10 * error);
    }
}

/* Thrown from side to side of a smooth elastic wedge, a ball loses the last bit first and everything in the end. Two
 * methods, both right to rounding between blows, are within what each claims for as long as it claims to know. */
static void test_wedge(void)
{
    const char *scene =
        "{'type': 'gravity'}, {'type': 'support', 'position': [-2, 2], 'orientation': -0.7854, 'width': 8,"
        "'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0}, {'type': 'support', 'position': [2, 2],"
        "'orientation': 0.9, 'width': 8, 'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'mass', 'position': [0.3, 4], 'width': 0, 'height': 0}";
    PhysicsOptions options = {.method = "auto",
                              .tolerance = 1e-9,
                              .duration = 200,
                              .interval = 0.5,
                              .columns = "Mass 0.x, Mass 0.y",
                              .estimate = TRUE};
    g_autoptr(GArray) claims = claims_of(&options, scene);
    g_autoptr(PhysicsRun) exact = physics_run(&options, "%s", scene);
    options.method = "dopri5";
    g_autoptr(PhysicsRun) other = physics_run(&options, "%s", scene);
    double known = fmin(exact->summary->predictable_until, other->summary->predictable_until);
    gboolean parted = FALSE;
    for (guint k = 0; k < claims->len; k++) {
        double apart = hypot(physics_value(exact, k + 1, 0) - physics_value(other, k + 1, 0),
                             physics_value(exact, k + 1, 1) - physics_value(other, k + 1, 1));
        parted |= apart > 0.1;
        /* the extent is about 3 m */
        if (physics_time(exact, k + 1) < known) g_assert_cmpfloat(apart, <=, 2 * 3 * g_array_index(claims, double, k));
    }
    g_test_message("predictable until %g s", known);
    g_assert_true(parted);
    g_assert_cmpfloat(known, <, 200);
    g_assert_cmpfloat(known, >, 5);
}

static void add_tests(void)
{
    g_test_add_func("/physics/estimate/passing", test_passing);
    g_test_add_func("/physics/estimate/stiff-apart", test_stiff_apart);
    g_test_add_func("/physics/estimate/comes-to-rest", test_comes_to_rest);
    g_test_add_func("/physics/estimate/exact-then-contact", test_exact_then_contact);
    g_test_add_func("/physics/estimate/between-samples", test_between_samples);
    g_test_add_func("/physics/estimate/wedge", test_wedge);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
