/* When conditions come to hold, against closed forms, to 1e-9 s. */
#include <math.h>
#include <string.h>

#include "measure/until.h"
#include "physics-fixture.h"
#include "physics/compile/compile.h"

/* The time at which the first of the conditions (ended by NULL) holds in a scene of these blocks. */
static double find(const char *method, double duration, const char *blocks, const char *const *conditions, int *number)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(TinkerUntil) until = tinker_until_new(scene, 0);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.duration = duration;
    options.method = method;
    options.tolerance = 1e-12;
    for (; *conditions != NULL; conditions++) {
        tinker_until_add(until, *conditions, &error);
        g_assert_no_error(error);
    }
    double time;
    tinker_until_find(until, model, &options, &time, number, &error);
    g_assert_no_error(error);
    return time;
}

static void check(const char *method, const char *blocks, const char *condition, double truth)
{
    const char *const conditions[] = {condition, NULL};
    int number;
    physics_assert_near(condition, find(method, 10, blocks, conditions, &number), truth, 1e-9);
    g_assert_cmpint(number, ==, 0);
}

#define OSCILLATOR                                                                                                     \
    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [3, 0]},"                                       \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2}"

/* x = 2 + cos 5t */
static void test_roots(void)
{
    static const char *const methods[] = {"exact", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        check(methods[m], OSCILLATOR, "{Mass 0.x} = 2", G_PI / 10);
        check(methods[m], OSCILLATOR, "{Mass 0.x} = {Spring 0.rest_length} + 0.5", G_PI / 15);
        /* 0 at the start is no root: it comes back to rest after half a period */
        check(methods[m], OSCILLATOR, "{Mass 0.vx} = 0", G_PI / 5);
        check(methods[m], OSCILLATOR, "{Mass 0.path length} = 3", (G_PI + G_PI / 2) / 5);
    }
}

static void test_comparisons(void)
{
    check("dop853", OSCILLATOR, "{Mass 0.x} < 1.5", 2 * G_PI / 15);
    /* true at the start: it has to become false first */
    check("dop853", OSCILLATOR, "{Mass 0.x} >= 2.5", (2 * G_PI - G_PI / 3) / 5);
    check("dop853", OSCILLATOR, "t > 3.25", 3.25);
    check("dop853", OSCILLATOR, "({Mass 0.x} < 2)*({Mass 0.vx} > 0) == 1", G_PI / 5);
}

#define DROP                                                                                                           \
    "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'width': 9, 'position': [0, -0.2], 'restitution': "  \
    "0.5}, {'type': 'mass', 'position': [0, 1.25], 'width': 0, 'height': 0}"

/* A run is asked again and again, each time from a rope that is slack: it falls 0.8 m, and the rope leaves 2.4 of 4
 * m/s.
 */
static void test_slack(void)
{
    static const char rope[] =
        "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'solid': false},"
        "{'type': 'mass', 'position': [0.6, 0]}, {'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 1}";
    check("dop853", rope, "{Mass 0.y} = -0.45", 0.3);
    check("dop853", rope, "{Rope 0.tension} > 1", 0.4);
    check("dop853", rope, "{Mass 0.vx} < -1.91", 0.4);
}

static void test_events(void)
{
    check("dop853", DROP, "event(impact)", 0.5);
    check("dop853", DROP, "event(impact, Mass 0)", 0.5);
    /* what does not bounce off has landed with an impact, too */
    check("dop853",
          "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'width': 9, 'position': [0, -0.2], "
          "'restitution': "
          "0}, {'type': 'mass', 'position': [0, 1.25], 'width': 0, 'height': 0}",
          "event(impact)", 0.5);
    /* a jump has no root in between, and is found as exactly */
    check("dop853", DROP, "{Mass 0.vy} > 2", 0.5);
    /* upwards at 2.5 m/s from 0.5 s on */
    check("dop853", DROP, "{Mass 0.vy} = 0", 0.5);
    check("dop853", DROP, "{Mass 0.y}*step(t - 0.55) = 0.3", 0.7);
}

/* What slides to a stop stays there, at 0 but for rounding on whichever side: at v / (mu g). */
static void test_stop(void)
{
    static const char *const methods[] = {"dop853", "dopri5", "cvode-bdf"};
    static const double speeds[] = {2, 3, -1.7, 0.9};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++)
        for (gsize i = 0; i < G_N_ELEMENTS(speeds); i++) {
            g_autofree char *blocks = g_strdup_printf(
                "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'width': 99, 'position': [0, -0.2],"
                " 'static_friction': 0.3, 'dynamic_friction': 0.3}, {'type': 'box', 'position': [0, 0.1],"
                " 'height': 0.2, 'width': 2, 'velocity': [%.17g, 0]}",
                speeds[i]);
            check(methods[m], blocks, "{Box 0.vx} = 0", fabs(speeds[i]) / 3);
        }
}

/* Of several the first that holds, in time and not in order; none is infinitely late. */
static void test_several(void)
{
    int number;
    const char *const two[] = {"{Mass 0.y} = 0.2", "event(impact)", "{Mass 0.y} < 0.45", NULL};
    physics_assert_near("first", find("dop853", 10, DROP, two, &number), 0.4, 1e-9);
    g_assert_cmpint(number, ==, 2);
    const char *const never[] = {"{Mass 0.y} > 2", "event(slip)", NULL};
    g_assert_cmpfloat(find("dop853", 1, DROP, never, &number), ==, INFINITY);
    g_assert_cmpint(number, ==, -1);
}

static void test_mistakes(void)
{
    const struct {
        const char *text, *says;
    } bad[] = {
        {"{Mass 0.y}", "it is no condition"},
        {"{Mass 0.x} =", "column 13: a number"},
        {"{Mass 0.x} = 1 + )", "column 18: "},
        {"{Mass 0.z} = 1", "column 1: {Mass 0.z}: Mass 0 has no quantity"},
        {"event(impct)", "did you mean \"impact\"?"},
        {"event(impact, Mass 9)", "the scene has no block \"Mass 9\""},
        {"event(impact", "must end with"},
    };
    g_autoptr(TinkerScene) scene = physics_scene(NULL, DROP);
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(TinkerUntil) until = tinker_until_new(scene, 0);
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_until_add(until, bad[i].text, &error));
        if (strstr(error->message, bad[i].says) == NULL) g_error("%s", error->message);
    }
}

static void add_tests(void)
{
    g_test_add_func("/measure/until/roots", test_roots);
    g_test_add_func("/measure/until/comparisons", test_comparisons);
    g_test_add_func("/measure/until/slack", test_slack);
    g_test_add_func("/measure/until/events", test_events);
    g_test_add_func("/measure/until/stop", test_stop);
    g_test_add_func("/measure/until/several", test_several);
    g_test_add_func("/measure/until/mistakes", test_mistakes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
