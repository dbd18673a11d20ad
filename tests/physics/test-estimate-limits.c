/* How an estimate meets chaos, and what it must not do: change the run, be lost with a companion, or claim too much of
 * what rests. */
#include "physics-fixture.h"

#include "estimate-case.h"
#include "physics/system/summary.h"

#include <math.h>
#include <string.h>

#define DOUBLE_PENDULUM                                                                                                \
    "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [1, 0]},"                  \
    "{'type': 'mass', 'position': [2, 0.1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"                        \
    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}"

static int count_warnings(const PhysicsRun *run, const char *words)
{
    int count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        if (strstr(tinker_warnings_text(run->summary->warnings, i), words) != NULL) count++;
    return count;
}

static PhysicsRun *run_chaos(const char *method, double tolerance, gboolean estimate)
{
    return physics_run(&(PhysicsOptions){.method = method,
                                         .tolerance = tolerance,
                                         .step = tolerance,
                                         .duration = 60,
                                         .interval = 0.1,
                                         .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y",
                                         .estimate = estimate},
                       DOUBLE_PENDULUM);
}

/* The first time at which the two runs are a tenth of 4 m apart. */
static double parted_at(const PhysicsRun *left, const PhysicsRun *right)
{
    for (gsize i = 0; i < physics_samples(left); i++)
        for (gsize k = 0; k < 4; k++)
            if (fabs(physics_value(left, i, k) - physics_value(right, i, k)) > 0.1 * 4) return physics_time(left, i);
    return INFINITY;
}

/* It says so before the truth is lost, and not much earlier: errors grow tenfold in one or two seconds here. */
static void test_chaos(void)
{
    static const struct {
        const char *method;
        double tolerance;
    } cases[] = {{"dop853", 1e-6}, {"dop853", 1e-9}, {"dopri5", 1e-7}, {"rk4", 1e-3}};
    g_autoptr(PhysicsRun) finest = run_chaos("dop853", 1e-13, FALSE);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = run_chaos(cases[i].method, cases[i].tolerance, TRUE);
        double parted = parted_at(run, finest), said = run->summary->predictable_until;
        g_test_message("%s at %g: predictable until %g s, parted at %g s", cases[i].method, cases[i].tolerance, said,
                       parted);
        g_assert_cmpfloat(said, <=, parted + 1e-9);
        g_assert_cmpfloat(said, >, parted - 5);
        g_assert_cmpfloat(run->summary->error_estimate, >, 0.1);
        g_assert_cmpint(count_warnings(run, "not predictable beyond t = "), ==, 1);
    }
}

/* When predictability ends is that of the motion, not that of who looks when. */
static void test_end_whatever_is_sampled(void)
{
    static const double intervals[] = {0.1, 1, 60};
    double said[G_N_ELEMENTS(intervals)];
    g_autoptr(PhysicsRun) finest = run_chaos("dop853", 1e-13, FALSE), close = run_chaos("dop853", 1e-6, FALSE);
    const double parted = parted_at(close, finest);
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = "dop853",
                                                                  .tolerance = 1e-6,
                                                                  .duration = 60,
                                                                  .interval = intervals[i],
                                                                  .columns = "Mass 0.x, Mass 1.x",
                                                                  .estimate = TRUE},
                                                DOUBLE_PENDULUM);
        said[i] = run->summary->predictable_until;
        physics_assert_near("predictable until", said[i], said[0], 0.2);
        g_assert_cmpfloat(said[i], <=, parted + 1e-9);
    }
}

/* A double pendulum, an oscillator that swings on a moving support, one along a line. */
#define BUSY_SCENE                                                                                                     \
    DOUBLE_PENDULUM                                                                                                    \
    ", {'type': 'support', 'solid': false, 'position': [5, 0]}, {'type': 'mass', 'position': [5, -1.2]},"              \
    "{'type': 'spring', 'ends': ['Support 1', 'Mass 2'], 'rest_length': 1},"                                           \
    "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.1, 'frequency': 3},"                             \
    "{'type': 'motor', 'ends': ['Mass 2'], 'waveform': {'expression': 'step(t-0.7)'}},"                                \
    "{'type': 'support', 'solid': false, 'position': [9, 0]}, {'type': 'mass', 'position': [9, -1.5]},"                \
    "{'type': 'spring', 'ends': ['Support 2', 'Mass 3'], 'rest_length': 1, 'stiffness': 1000},"                        \
    "{'type': 'motor', 'ends': ['Mass 3'], 'angle': '90 deg', 'waveform': {'expression': 'step(t-0.7)'}}"

static void assert_same_record(const PhysicsRun *left, const PhysicsRun *right)
{
    g_assert_cmpmem(left->samples->data, left->samples->len * sizeof(double), right->samples->data,
                    right->samples->len * sizeof(double));
    physics_assert_same_bits(left, right);
    const TinkerSummary *l = left->summary, *r = right->summary;
    g_assert_cmpint(l->steps, ==, r->steps);
    g_assert_cmpint(l->evaluations, ==, r->evaluations);
    g_assert_cmpfloat(l->energy_balance_error, ==, r->energy_balance_error);
    g_assert_cmpfloat(l->kinetic_end, ==, r->kinetic_end);
    g_assert_cmpfloat(l->constraint_position_error, ==, r->constraint_position_error);
    g_assert_cmpmem(l->books, sizeof(l->books), r->books, sizeof(r->books));
    g_assert_cmpuint(l->events->len, ==, r->events->len);
}

static const char *const methods[] = ESTIMATE_METHODS;

static void test_no_bit_changes(void)
{
    for (gsize m = 0; m <= G_N_ELEMENTS(methods); m++) {
        PhysicsOptions options = {
            .method = m < G_N_ELEMENTS(methods) ? methods[m] : "auto",
            .duration = 2,
            .interval = 0.03,
            .step = 2e-3,
            .tolerance = 1e-8,
            .columns =
                "Mass 0.x, Mass 1.y, Mass 2.y, Mass 2.vy, Mass 3.y, Rod 0.tension, Spring 0.tension, Support 1.y"};
        g_autoptr(PhysicsRun) without = physics_run(&options, BUSY_SCENE);
        options.estimate = options.bands = TRUE;
        g_autoptr(PhysicsRun) with = physics_run(&options, BUSY_SCENE);
        assert_same_record(with, without);
        g_assert_true(isnan(without->summary->error_estimate));
        g_assert_true(isinf(without->summary->predictable_until));
        g_assert_cmpfloat(with->summary->error_estimate, >, ESTIMATE_FLOOR);
        g_assert_cmpfloat(with->summary->error_estimate, <, 0.1);
        g_assert_cmpuint(with->summary->warnings->len, ==, without->summary->warnings->len);
    }
}

/* A wall that a coarse step happens to stop short of and a finer one runs into: the run does as without a companion. */
static void test_failing_companion(void)
{
    int lost = 0;
    for (int i = 0; i < 40; i++) {
        PhysicsOptions options = {
            .method = "semi-implicit-euler", .step = 0.2, .duration = 1, .columns = "Mass 0.x, Mass 0.vx"};
        g_autofree char *scene = g_strdup_printf(
            "{'type': 'mass', 'velocity': [%g, 0]}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': 4}", 4.5 + 0.02 * i);
        g_autoptr(PhysicsRun) without = physics_try(&options, "%s", scene);
        options.estimate = TRUE;
        g_autoptr(PhysicsRun) with = physics_try(&options, "%s", scene);
        g_assert_true((with->error == NULL) == (without->error == NULL));
        if (with->error != NULL) g_assert_cmpstr(with->error->message, ==, without->error->message);
        g_assert_cmpmem(with->samples->data, with->samples->len * sizeof(double), without->samples->data,
                        without->samples->len * sizeof(double));
        int warnings = count_warnings(with, "there is no error estimate beyond t = ");
        g_assert_cmpint(warnings, <=, 1);
        lost += with->error == NULL && warnings == 1;
    }
    g_test_message("%d of 40 companions failed in a run that did not", lost);
    g_assert_cmpint(lost, >, 0);
}

/* A mass that is pinned to a support goes nowhere: it has no size to measure rounding against, wherever that is; the
 * last one hangs at its support's centre, where nothing else has a size either. */
static void test_held(void)
{
    static const struct {
        double x, y, along, across; /* of the support, and of the pin from there in its axes */
    } cases[] = {
        {-1.878825084592886, -0.025195845169835973, -0.4419457365688787, -0.265580805455889},
        {0.3, 0.2, -0.31, -0.19},
        {1e5 / 3, -7e4 / 3, 0.1, 0.7},
        {-1.7848609144669205, 0.8353865532377398, 0, 0},
    };
    static const char *const all[] = {"auto", "verlet", "verlet6"};
    const double turn = 0.4387495454652983;
    for (gsize k = 0; k < G_N_ELEMENTS(cases) * G_N_ELEMENTS(all); k++) {
        const gsize i = k / G_N_ELEMENTS(all);
        const double x = cases[i].x + cos(turn) * cases[i].along - sin(turn) * cases[i].across;
        const double y = cases[i].y + sin(turn) * cases[i].along + cos(turn) * cases[i].across;
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = all[k % G_N_ELEMENTS(all)],
                                          .step = 0.01,
                                          .duration = 1,
                                          .interval = 0.01,
                                          .tolerance = 1e-9,
                                          .estimate = TRUE},
                        "{'type': 'gravity', 'angle': -2.2},"
                        "{'type': 'support', 'solid': false, 'position': [%.17g, %.17g], 'orientation': %.17g},"
                        "{'type': 'mass', 'position': [%.17g, %.17g], 'velocity': [0.63, -0.23]},"
                        "{'type': 'pin', 'ends': ['Mass 0', {'block': 'Support 0', 'at': [%.17g, %.17g]}]}",
                        cases[i].x, cases[i].y, turn, x, y, cases[i].along, cases[i].across);
        g_test_message("at (%g, %g): error %.3g", cases[i].x, cases[i].y, run->summary->error_estimate);
        g_assert_cmpfloat(run->summary->error_estimate, <=, ESTIMATE_FLOOR);
        g_assert_cmpint(count_warnings(run, "not predictable"), ==, 0);
    }
}

/* A mass that a weld holds and that a rope just reaches: a companion that rounding put off both would be met by the
 * rope at once, with no way out, and there would be no estimate. */
static void test_held_on_a_rope(void)
{
    static const char *const all[] = {"verlet", "newmark", "generalized-alpha"};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = all[i], .step = 0.01, .duration = 1, .interval = 0.01, .estimate = TRUE},
            "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [-0.9123891260556678, "
            "-0.41238160677434244]},"
            "{'type': 'rope', 'ends': ['Mass 0', {'block': 'Support 0', 'at': [-0.12837099888456327, "
            "0.4528085030956127]}]},"
            "{'type': 'mass', 'mass': 0.752, 'position': [1.722780797556081, 0.4234001272414003]},"
            "{'type': 'support', 'solid': false, 'position': [1.722780797556081, 0.4234001272414003]},"
            "{'type': 'law-field', 'force_x': '0.69*y*m-0.84*vx'}, {'type': 'weld', 'ends': ['Mass 0', 'Support 1']}");
        g_assert_cmpint(count_warnings(run, "there is no error estimate"), ==, 0);
        g_assert_cmpfloat(run->summary->error_estimate, <=, ESTIMATE_FLOOR);
    }
}

/* What hangs at rest stays there: its speeds are rounding, and so is what two runs of them differ by. */
static void test_rest(void)
{
    const char *const all[] = {"rk4", "verlet6", "newmark", "dop853"};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        PhysicsOptions options = {.method = all[i], .step = 1e-3, .duration = 3, .tolerance = 1e-13, .estimate = TRUE};
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "{'type': 'mass', 'position': [-1.6828098921791184, -0.2876739612022381]},"
                                  "{'type': 'mass', 'position': [-0.9875696021116536, 1.2445711576479659]},"
                                  "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1000},"
                                  "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 2}");
        g_assert_cmpfloat(run->summary->error_estimate, <, 1e-9);
        g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    }
}

/* One step takes a loose run to its end, and its companion too: that they agree says nothing. Against x = (t - sin t).
 */
static void test_equal_steps(void)
{
    PhysicsOptions options = {
        .method = "dop853", .duration = 1.5, .tolerance = 1e-3, .columns = "Mass 0.x", .estimate = TRUE};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'], 'waveform': 'sine', 'frequency': 1}");
    double error = fabs(physics_last(run, 0) - (1.5 - sin(1.5))) / (1.5 - sin(1.5));
    g_assert_cmpint(run->summary->steps, ==, 1);
    g_assert_cmpfloat(run->summary->error_estimate, >=, error);
}

static void add_tests(void)
{
    g_test_add_func("/physics/estimate/chaos", test_chaos);
    g_test_add_func("/physics/estimate/end-whatever-is-sampled", test_end_whatever_is_sampled);
    g_test_add_func("/physics/estimate/no-bit-changes", test_no_bit_changes);
    g_test_add_func("/physics/estimate/failing-companion", test_failing_companion);
    g_test_add_func("/physics/estimate/held", test_held);
    g_test_add_func("/physics/estimate/held-on-a-rope", test_held_on_a_rope);
    g_test_add_func("/physics/estimate/rest", test_rest);
    g_test_add_func("/physics/estimate/equal-steps", test_equal_steps);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
