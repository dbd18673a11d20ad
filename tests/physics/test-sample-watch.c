/* What samples do not show of a motion, by oscillators whose period is known. */
#include <math.h>

#include "physics-fixture.h"

#define STIFFNESS "39.47841760435743" /* N/m: 1 kg on it swings once in a second */
#define SAMPLES   40

static const char *const methods[] = {"exact", "dopri5", "dop853", "rk4", "verlet", "newmark"};

/* A swing of 0.2 m, once a second. */
#define SWING                                                                                                          \
    "{'type': 'support', 'name': 'Wall', 'solid': false}, {'type': 'mass', 'name': 'Fast', 'position': [1.2, 0]},"     \
    "{'type': 'spring', 'ends': ['Wall', 'Fast'], 'stiffness': " STIFFNESS ", 'rest_length': 1}"

/* The interval (s) that a run asks for, and whose motion it is that samples do not show; 0 where they show all. */
static double asked(const PhysicsRun *run, const char *name)
{
    double interval = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++) {
        const TinkerWarning *warning = g_ptr_array_index(run->summary->warnings, i);
        if (warning->kind != TINKER_WARNING_SAMPLES) continue;
        g_assert_true(g_str_has_prefix(warning->brief, name));
        g_assert_true(g_str_has_prefix(warning->text, warning->brief));
        g_assert_cmpfloat(interval, ==, 0); /* once */
        interval = warning->number;
    }
    return interval;
}

static PhysicsRun *run_at(const char *method, double interval, const char *blocks)
{
    const PhysicsOptions options = {
        .method = method, .interval = interval, .duration = SAMPLES * interval, .step = 0.002, .tolerance = 1e-9};
    return physics_run(&options, "%s", blocks);
}

/* Of a swing once a second an interval that has 14 to 33 samples to a period. */
static void assert_asked(double interval)
{
    g_assert_cmpfloat(interval, >=, 0.03);
    g_assert_cmpfloat(interval, <=, 0.07);
}

static void test_swings(void)
{
    static const double too_long[] = {1, 2, 1.02, 0.75, 3.1}, short_enough[] = {0.01, 0.05, 0.125, 0.2};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        for (gsize i = 0; i < G_N_ELEMENTS(too_long); i++) {
            g_autoptr(PhysicsRun) run = run_at(methods[m], too_long[i], SWING);
            assert_asked(asked(run, "Fast"));
        }
        for (gsize i = 0; i < G_N_ELEMENTS(short_enough); i++) {
            g_autoptr(PhysicsRun) run = run_at(methods[m], short_enough[i], SWING);
            g_assert_cmpfloat(asked(run, "Fast"), ==, 0);
        }
    }
}

/* At whole periods all samples are of one phase. */
static void test_phases(void)
{
    for (int i = 0; i < 8; i++) {
        const double phase = i * G_PI / 4;
        const PhysicsOptions options = {.interval = 1, .duration = SAMPLES, .tolerance = 1e-9};
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'support', 'name': 'Wall', 'solid': false},"
                        "{'type': 'mass', 'name': 'Fast', 'position': [%.17g, 0], 'velocity': [%.17g, 0]},"
                        "{'type': 'spring', 'ends': ['Wall', 'Fast'], 'stiffness': " STIFFNESS ", 'rest_length': 1}",
                        1 + 0.2 * cos(phase), 0.2 * 2 * G_PI * sin(phase));
        assert_asked(asked(run, "Fast"));
    }
}

/* Beside what moves farther and slower, in an island of its own or on what moves. */
static void test_beside_what_is_slow(void)
{
    static const char *const others[] = {
        "{'type': 'mass', 'name': 'Slow', 'position': [-5, 3], 'velocity': [0.1, 0.2]}," SWING,
        "{'type': 'mass', 'name': 'Slow', 'mass': 1e4, 'velocity': [0.5, 0]},"
        "{'type': 'mass', 'name': 'Fast', 'position': [1.2, 0]},"
        "{'type': 'spring', 'ends': ['Slow', 'Fast'], 'stiffness': " STIFFNESS ", 'rest_length': 1}"};
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++) {
        g_autoptr(PhysicsRun) coarse = run_at("dopri5", 1, others[i]);
        assert_asked(asked(coarse, "Fast"));
        g_autoptr(PhysicsRun) fine = run_at("dopri5", 0.1, others[i]);
        g_assert_cmpfloat(asked(fine, "Fast"), ==, 0);
    }
}

/* A bar turns there and back. */
static void test_turning(void)
{
    const char *blocks = "{'type': 'bar', 'name': 'Bar', 'position': [0, 0], 'length': 1, 'mass': 1},"
                         "{'type': 'support', 'name': 'Wall', 'solid': false},"
                         "{'type': 'pin', 'ends': ['Wall', 'Bar']},"
                         "{'type': 'torsional-spring', 'ends': ['Wall', 'Bar'], 'stiffness': 3.289868133696453,"
                         " 'rest_angle': 0.1}"; /* m l^2 / 12 times (2 pi / 1 s)^2 */
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) coarse = run_at(methods[m], 1, blocks);
        assert_asked(asked(coarse, "Bar"));
        g_autoptr(PhysicsRun) fine = run_at(methods[m], 0.1, blocks);
        g_assert_cmpfloat(asked(fine, "Bar"), ==, 0);
    }
}

/* What is smooth between samples, what rests, what bounces now and then, and what is asked for one by one. */
static void test_says_nothing(void)
{
    const char *const bounces_now_and_then =
        "{'type': 'gravity'}, {'type': 'support', 'width': 20, 'height': 1, 'restitution': 0.5},"
        "{'type': 'mass', 'name': 'Fast', 'position': [0, 3], 'restitution': 0.5}";
    const char *const quiet[] = {"{'type': 'gravity'}, {'type': 'mass', 'name': 'Fast', 'velocity': [3, 9]}",
                                 bounces_now_and_then, "{'type': 'mass', 'name': 'Fast'}"};
    static const double at[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    for (gsize i = 0; i < G_N_ELEMENTS(quiet); i++) {
        g_autoptr(PhysicsRun) run = run_at("dopri5", 0.5, quiet[i]);
        g_assert_cmpfloat(asked(run, "Fast"), ==, 0);
    }
    const PhysicsOptions options = {.duration = 10, .at = at, .at_count = G_N_ELEMENTS(at)};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", SWING);
    g_assert_cmpfloat(asked(run, "Fast"), ==, 0);
}

/* A ball that bounces more often than it is recorded. */
static void test_bounces(void)
{
    g_autoptr(PhysicsRun) run = run_at("dopri5", 0.5,
                                       "{'type': 'gravity'},"
                                       "{'type': 'support', 'width': 20, 'height': 1, 'restitution': 1},"
                                       "{'type': 'mass', 'name': 'Fast', 'position': [0, 1.5], 'restitution': 1}");
    const double interval = asked(run, "Fast");
    g_assert_cmpfloat(interval, >, 0);
    g_assert_cmpfloat(interval, <, 0.2);
}

static void add_tests(void)
{
    g_test_add_func("/physics/sample-watch/swings", test_swings);
    g_test_add_func("/physics/sample-watch/phases", test_phases);
    g_test_add_func("/physics/sample-watch/bounces", test_bounces);
    g_test_add_func("/physics/sample-watch/beside-what-is-slow", test_beside_what_is_slow);
    g_test_add_func("/physics/sample-watch/turning", test_turning);
    g_test_add_func("/physics/sample-watch/says-nothing", test_says_nothing);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
