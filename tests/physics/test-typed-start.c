/* Typed laws that set in on what is at rest, after a while or from nothing on, against closed forms: nothing else tells
 * how far off a step is. Where they set in hangs on the place, too, by next to nothing, so that it is no break. And
 * laws that come to rest, or would. */
#include <math.h>

#include "physics-fixture.h"

#define FORCE(law) "{'type': 'mass'}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '" law "'}"

/* Where it is at 2 s, and how fast. */
static void assert_comes_to(const PhysicsOptions *options, const char *blocks, double x, double v, double bound)
{
    PhysicsOptions with = *options;
    with.duration = 2;
    with.estimate = TRUE;
    with.columns = "Mass 0.x, Mass 0.vx";
    g_autoptr(PhysicsRun) run = physics_run(&with, "%s", blocks);
    const double off = fmax(fabs(physics_last(run, 0) - x) / (1 + fabs(x)), fabs(physics_last(run, 1) - v) / (1 + v));
    const double estimate = tinker_simulation_summary(run->simulation)->error_estimate;
    g_test_message("%s: off by %.3g, and says %.3g", blocks, off, estimate);
    physics_assert_near("place", physics_last(run, 0), x, bound);
    physics_assert_near("speed", physics_last(run, 1), v, bound);
    g_assert_cmpfloat(estimate, <, 1e-8);
}

static void test_alone(void)
{
    static const struct {
        const char *blocks;
        double x, v;
    } cases[] = {
        {FORCE("5*step(t-1+x/1e20)"), 2.5, 5},
        {FORCE("5*pulse(t+x/1e20,1,1.5)"), 1.875, 2.5},
        {FORCE("if(t+x/1e20<1,0,1)"), 0.5, 1},
        {FORCE("ramp(t-1+x/1e20)"), 1.0 / 6, 0.5},
        {FORCE("5*(t+x/1e20>1)*(t+x/1e20<1.5)"), 1.875, 2.5},
        {FORCE("5*t^3"), 8, 20},
        {FORCE("5*t^6"), 5 * 256.0 / 56, 5 * 128.0 / 7},
    };
    static const char *const methods[] = {"auto", "dopri5", "dop853"};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        for (gsize k = 0; k < G_N_ELEMENTS(methods); k++)
            assert_comes_to(&(PhysicsOptions){.method = methods[k]}, cases[i].blocks, cases[i].x, cases[i].v, 1e-8);
}

/* Nearly at rest, or away from the origin, or between two ends. */
static void test_beside_others(void)
{
    assert_comes_to(&(PhysicsOptions){0},
                    "{'type': 'mass', 'velocity': [1e-9, 0]},"
                    "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '5*step(t-1+x/1e20)'}",
                    2.5 + 2e-9, 5 + 1e-9, 1e-8);
    assert_comes_to(&(PhysicsOptions){0},
                    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0]},"
                    "{'type': 'law-connector', 'ends': ['Support 0', 'Mass 0'], 'tension': '-5*step(t-1+L/1e20)'}",
                    3.5, 5, 1e-8);
    const double w = sqrt(50);
    assert_comes_to(&(PhysicsOptions){0},
                    "{'type': 'support', 'solid': false, 'position': [-2, 0]}, {'type': 'mass'},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50, 'rest_length': 2},"
                    "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '5*step(t-1+x/1e20)'}",
                    0.1 * (1 - cos(w)), 0.1 * w * sin(w), 1e-8);
}

#define RIDES_ON_BREAKS                                                                                                \
    "{'type': 'mass', 'velocity': [2, 0]}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-100-vx/abs(vx)'},"   \
    "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '100+1e-3*square(1e3*t)'}}"

/* At rest these have no motion: they would keep a run busy for hours. */
static void test_turns_against_motion(void)
{
    static const char *const blocks[] = {
        "{'type': 'mass', 'velocity': [2, 0]}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-vx/abs(vx)'}",
        "{'type': 'mass', 'velocity': [2, 0]}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '1-2*step(vx)'}",
        "{'type': 'mass', 'velocity': [4, 0]}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '1-3*(vx>0)'}",
        /* beside breaks, and small beside what it rides on */
        RIDES_ON_BREAKS,
    };
    static const char *const methods[] = {"auto", "dopri5", "dop853", "cvode-bdf"};
    for (gsize i = 0; i < G_N_ELEMENTS(blocks) * G_N_ELEMENTS(methods); i++) {
        PhysicsOptions options = {.method = methods[i / G_N_ELEMENTS(blocks)], .duration = 3};
        options.columns = "Mass 0.vx";
        g_autoptr(PhysicsRun) run = physics_try(&options, "%s", blocks[i % G_N_ELEMENTS(blocks)]);
        physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "the run stopped at t = 2", "back and forth", NULL);
    }
}

/* One jump is not against the next, however many there are. */
static void test_jumps_on_the_way(void)
{
    PhysicsOptions options = {.method = "dopri5", .duration = 1, .columns = "Mass 0.x, Mass 0.vx"};
    static const char blocks[] = "{'type': 'mass', 'mass': 1e6, 'velocity': [1, 0]},"
                                 "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '2*step(sin(1e4*x))'}";
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    physics_assert_near("speed", physics_last(run, 1), 1 + 1e-6, 1e-9);
    /* nor where most of the run is to come */
    options.duration = 1000;
    g_autoptr(PhysicsRun) begun = physics_prepare(&options, "%s", blocks);
    g_autoptr(GError) error = NULL;
    for (int step = 0; step < 20000; step++)
        g_assert_true(tinker_simulation_step(begun->simulation, &error));
}

static void add_tests(void)
{
    g_test_add_func("/physics/typed-start/turns-against-motion", test_turns_against_motion);
    g_test_add_func("/physics/typed-start/jumps-on-the-way", test_jumps_on_the_way);
    g_test_add_func("/physics/typed-start/alone", test_alone);
    g_test_add_func("/physics/typed-start/beside-others", test_beside_others);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
