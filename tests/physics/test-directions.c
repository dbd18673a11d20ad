/* Springs whose ends meet: at rest that is an event and the end of what is determined, with a velocity it is a passage,
 * which turns the force round and nothing else. The truth is the oscillation x = 1 + A cos(w t) about the rest length,
 * in closed form. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

#define OMEGA  5.0 /* rad/s: 25 N/m and 1 kg */
#define ANCHOR "{'type': 'support', 'solid': false, 'position': [0, 0]}"
#define SPRING "{'type': 'spring', 'name': 'k', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 25, 'rest_length': 1}"

/* All methods, and what their instants may be off within a second. Ends that are slow are as good as closest for a
 * while: within 1e-5 s the mass gets 1e-9 m away from the anchor. */
typedef struct {
    const char *method;
    double instant;
} Method;
static const Method methods[] = {
    {"auto", 1e-5},    {"exact", 1e-5},
    {"dop853", 1e-5},  {"dopri5", 1e-5},
    {"rk4", 1e-2},     {"verlet", 1e-3},
    {"verlet6", 1e-5}, {"semi-implicit-euler", 2e-2},
    {"newmark", 1e-3}, {"generalized-alpha", 1e-3},
};

static PhysicsOptions options_of(const char *method, double duration, const char *columns)
{
    return (PhysicsOptions){
        .method = method, .duration = duration, .interval = 0.1, .tolerance = 1e-9, .columns = columns};
}

/* Once, with a warning that names the spring; the summary says the same time. */
static void assert_lost(const PhysicsRun *run, double time, double bound)
{
    contact_assert_count(run, "direction lost", 1);
    contact_assert_event(run, "direction lost", "k", time, bound);
    physics_assert_near("determined until", run->summary->determined_until, time, bound);
    const GPtrArray *warnings = run->summary->warnings;
    gboolean warned = FALSE;
    for (guint i = 0; i < warnings->len; i++)
        warned |= g_str_has_prefix(tinker_warnings_text(warnings, i), "k: its ends meet at t = ");
    g_assert_true(warned);
}

static void assert_kept(const PhysicsRun *run)
{
    contact_assert_count(run, "direction lost", 0);
    g_assert_true(isinf(run->summary->determined_until));
}

static double distance_of_touch(double t, G_GNUC_UNUSED const void *data)
{
    return 1 + cos(OMEGA * t);
}

/* Released at twice the rest length the mass comes to the anchor at rest. On either side it goes on alike. */
static void test_touch(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        PhysicsOptions options = options_of(methods[i].method, 3, "k.length");
        g_autoptr(PhysicsRun) run = physics_run(&options, ANCHOR ", {'type': 'mass', 'position': [2, 0]}, " SPRING);
        assert_lost(run, G_PI / OMEGA, methods[i].instant);
        g_assert_cmpfloat(run->summary->simulated_s, ==, 3);
        if (methods[i].instant <= 1e-5) physics_assert_follows(run, 0, distance_of_touch, NULL, 1e-6);
    }
}

/* Along no axis, and in a plane in which both ends move on: there the moment of the relative motion is rounding. */
static void test_touch_in_the_plane(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        if (g_str_equal(methods[i].method, "exact")) continue; /* which is no method for the plane */
        PhysicsOptions options = options_of(methods[i].method, 2, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            "{'type': 'mass', 'position': [-0.6, 0.9], 'velocity': [0.3, 0.4]}, {'type': 'mass', 'position': "
            "[0.6, -0.7], 'velocity': [0.3, 0.4]}, {'type': 'spring', 'name': 'k', 'ends': ['Mass 0', 'Mass 1'], "
            "'stiffness': 12.5, 'rest_length': 1}");
        assert_lost(run, G_PI / OMEGA, methods[i].instant);
    }
}

/* How often one looks changes neither the event nor what is claimed of the error. */
static void test_samples_change_nothing(void)
{
    static const double intervals[] = {0.1, 0.7, 0.0313};
    double first = NAN;
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        PhysicsOptions options = options_of("auto", 9.1, NULL);
        options.interval = intervals[i];
        options.estimate = TRUE;
        g_autoptr(PhysicsRun) run = physics_run(&options, ANCHOR ", {'type': 'mass', 'position': [2, 0]}, " SPRING);
        assert_lost(run, G_PI / OMEGA, 1e-5);
        g_assert_cmpfloat(run->summary->error_estimate, <, 1e-12);
        if (i == 0) first = run->summary->determined_until;
        g_assert_cmpfloat(run->summary->determined_until, ==, first);
    }
}

/* With a velocity the ends pass: the distance swings on as if it were one-sided, from passage to passage. */
typedef struct {
    double swing, phase; /* m, rad: x = 1 + swing cos(OMEGA t + phase) before the first passage */
} Passing;

static double passing_x(double t, const void *data)
{
    const Passing *is = data;
    double turn = acos(-1 / is->swing), angle = OMEGA * t + is->phase; /* x = 0 at +-turn */
    double side = fmod(floor((angle + turn) / (2 * turn)), 2) == 0 ? 1 : -1;
    return side * (1 + is->swing * cos(remainder(angle, 2 * turn)));
}

static void test_passage(void)
{
    const double velocity = 2;
    const Passing passing = {hypot(1, velocity / OMEGA), -atan(velocity / OMEGA)};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        PhysicsOptions options = options_of(methods[i].method, 3, "Mass 0.x");
        g_autoptr(PhysicsRun) run = physics_run(
            &options, ANCHOR ", {'type': 'mass', 'position': [2, 0], 'velocity': [%.17g, 0]}, " SPRING, velocity);
        assert_kept(run);
        if (i < 2) physics_assert_follows(run, 0, passing_x, &passing, 1e-11);
    }
}

/* The force jumps in a passage: adaptive methods find the jump to their tolerance, with steps however short. */
static void test_passage_to_the_tolerance(void)
{
    static const char *const adaptive[] = {"dop853", "dopri5"};
    const double velocity = 2;
    const Passing passing = {hypot(1, velocity / OMEGA), -atan(velocity / OMEGA)};
    for (gsize i = 0; i < G_N_ELEMENTS(adaptive); i++) {
        PhysicsOptions options = options_of(adaptive[i], 3, "Mass 0.x");
        options.tolerance = 1e-12;
        g_autoptr(PhysicsRun) run = physics_run(
            &options, ANCHOR ", {'type': 'mass', 'position': [2, 0], 'velocity': [%.17g, 0]}, " SPRING, velocity);
        assert_kept(run);
        physics_assert_follows(run, 0, passing_x, &passing, 1e-10);
    }
}

/* Nor is a near miss one: of a mass that turns before it is there, and of one that goes round. */
static void test_near_misses(void)
{
    static const char *const starts[] = {"'position': [1.99, 0]", "'position': [2, 0], 'velocity': [0, 0.05]"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        if (g_str_equal(methods[i].method, "semi-implicit-euler")) continue; /* whose energy is off by more than that */
        for (gsize k = 0; k < G_N_ELEMENTS(starts); k++) {
            if (k == 1 && g_str_equal(methods[i].method, "exact")) continue;
            PhysicsOptions options = options_of(methods[i].method, 3, NULL);
            g_autoptr(PhysicsRun) run = physics_run(&options, ANCHOR ", {'type': 'mass', %s}, " SPRING, starts[k]);
            assert_kept(run);
        }
    }
}

/* Of a law that the host does not know: T = k (L - l)^3 has the potential k (L - l)^4 / 4, and takes a mass from 2 l to
 * the anchor, where it comes to rest after half a period: t = 2 sqrt(2 m / k) / l int_0^1 du / sqrt(1 - u^4). */
static void test_law_of_a_plugin(void)
{
    static const char *const some[] = {"auto", "dopri5", "rk4", "verlet"};
    const double lemniscate = 1.31102877714605990523, time = 2 * sqrt(2 / 5.0) * lemniscate;
    for (gsize i = 0; i < G_N_ELEMENTS(some); i++) {
        PhysicsOptions options = options_of(some[i], 3, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, ANCHOR ", {'type': 'mass', 'position': [2, 0]}, {'type': 'cubic', 'name': 'k', "
                                         "'ends': ['Support 0', 'Mass 0'], 'stiffness': 5, 'length': 1}");
        assert_lost(run, time, 1e-2);
    }
}

/* Two masses fall one above the other; the lower one lands, the upper one is slowed by the spring between them and
 * lands on the same place. s is its height over that: s = e + (1 - e) cos(w t) + v / w sin(w t), with e = 1 - g / w^2.
 */
static double upper_height(double t, const void *omega)
{
    const double w = *(const double *)omega, rest = 1 - CONTACT_GRAVITY / (w * w), speed = sqrt(2 * CONTACT_GRAVITY);
    return rest + (1 - rest) * cos(w * t) - speed / w * sin(w * t);
}

static void test_landing_on_one_place(void)
{
    const double omega = sqrt(5.0), fall = sqrt(2 / CONTACT_GRAVITY);
    double time = fall + contact_bisect(0, 0.5, upper_height, &omega);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 2, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR ", " CONTACT_SMOOTH "}, " CONTACT_POINT
                                                               ", 'position': [0, 2]}, " CONTACT_POINT
                                                               ", 'position': [0, 1]}, {'type': 'spring', 'name': 'k', "
                                                               "'ends': ['Mass 0', 'Mass 1'], 'stiffness': 5}");
        assert_lost(run, time, fmax(contact_methods[i].smooth, 1e-7));
    }
    PhysicsOptions options = {.duration = 2, .step = 1e-3, .impulses = TRUE};
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                    ", " CONTACT_SMOOTH "}, " CONTACT_POINT ", 'position': [0, 2]}, " CONTACT_POINT
                    ", 'position': [0, 1]}, {'type': 'spring', 'name': 'k', 'ends': ['Mass 0', "
                    "'Mass 1'], 'stiffness': 5}");
    assert_lost(run, time, 5e-3);
}

/* A mass at rest on its anchor: with nothing else it stays, under gravity it is pushed down by spring and weight. */
static double fallen(double t, G_GNUC_UNUSED const void *data)
{
    return -(1 + CONTACT_GRAVITY / (OMEGA * OMEGA)) * (1 - cos(OMEGA * t));
}

static void test_start_at_one_place(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        if (g_str_equal(methods[i].method, "exact")) continue;
        PhysicsOptions options = options_of(methods[i].method, 1.2, "Mass 0.y");
        g_autoptr(PhysicsRun) alone = physics_run(&options, ANCHOR ", {'type': 'mass'}, " SPRING);
        assert_lost(alone, 0, 0);
        physics_assert_near("y", physics_last(alone, 0), 0, 1e-12);
        g_autoptr(PhysicsRun) heavy = physics_run(&options, CONTACT_WEIGHT ANCHOR ", {'type': 'mass'}, " SPRING);
        assert_lost(heavy, 0, 0);
        if (methods[i].instant <= 1e-5) physics_assert_follows(heavy, 0, fallen, NULL, 1e-6);
    }
}

/* Two masses that a spring joins land on one place, and lose their direction; a pendulum far away, which has nothing to
 * do with them, is estimated on to the end: at this tolerance it is off by far more than rounding. */
static void test_others_are_estimated(void)
{
    const PhysicsOptions options = {
        .method = "dop853", .duration = 4, .interval = 0.1, .tolerance = 1e-6, .estimate = TRUE};
    static const char *const blocks =
        "{'type': 'gravity'}, {'type': 'support', 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'mass', 'name': 'a', 'position': [0, 2], 'width': 0, 'height': 0},"
        "{'type': 'mass', 'name': 'b', 'position': [0, 1], 'width': 0, 'height': 0},"
        "{'type': 'spring', 'ends': ['a', 'b'], 'stiffness': 5}";
    static const char *const pendulum =
        "{'type': 'support', 'name': 'Far', 'position': [100, 50], 'solid': false},"
        "{'type': 'mass', 'name': 'Bob', 'position': [101, 50]}, {'type': 'rod', 'ends': ['Far', 'Bob']}";
    g_autoptr(PhysicsRun) alone = physics_run(&options, "{'type': 'gravity'}, %s", pendulum);
    g_autoptr(PhysicsRun) both = physics_run(&options, "%s, %s", blocks, pendulum);
    g_assert_cmpfloat(both->summary->determined_until, <, 1);
    g_assert_cmpfloat(alone->summary->error_estimate, >, 1e-10);
    g_assert_cmpfloat(both->summary->error_estimate, >=, 0.99 * alone->summary->error_estimate);
}

static void add_tests(void)
{
    g_test_add_func("/physics/directions/others-are-estimated", test_others_are_estimated);
    g_test_add_func("/physics/directions/touch", test_touch);
    g_test_add_func("/physics/directions/touch-in-the-plane", test_touch_in_the_plane);
    g_test_add_func("/physics/directions/samples-change-nothing", test_samples_change_nothing);
    g_test_add_func("/physics/directions/passage", test_passage);
    g_test_add_func("/physics/directions/passage-to-the-tolerance", test_passage_to_the_tolerance);
    g_test_add_func("/physics/directions/near-misses", test_near_misses);
    g_test_add_func("/physics/directions/law-of-a-plugin", test_law_of_a_plugin);
    g_test_add_func("/physics/directions/landing-on-one-place", test_landing_on_one_place);
    g_test_add_func("/physics/directions/start-at-one-place", test_start_at_one_place);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
