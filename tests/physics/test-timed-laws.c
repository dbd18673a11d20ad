/* Typed laws that t alone switches: no step crosses where they do, so that methods are as good between two switches as
 * without them. Held against closed forms. */
#include <math.h>

#include "physics-fixture.h"

#define RESTS      "{'type': 'mass', 'mass': 2},"
#define FORCE(law) RESTS "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '" law "'}"

static PhysicsRun *run_law(const char *method, double duration, const char *blocks)
{
    const PhysicsOptions options = {
        .duration = duration, .method = method, .tolerance = 1e-9, .columns = "Mass 0.x, Mass 0.vx"};
    return physics_run(&options, "%s", blocks);
}

static void assert_comes_to(const char *method, double duration, const char *blocks, double x, double v, double bound)
{
    g_test_message("%s: %s", method, blocks);
    g_autoptr(PhysicsRun) run = run_law(method, duration, blocks);
    physics_assert_near("place", physics_last(run, 0), x, bound);
    physics_assert_near("speed", physics_last(run, 1), v, bound);
    g_assert_cmpuint(run->summary->warnings->len, ==, 0);
}

/* Forces that are constant in pieces, whose ends are no multiples of any step: methods of second order and more are off
 * by rounding alone. Among them is a pulse of 1 us from rest. */
static void test_pieces(void)
{
    static const struct {
        const char *blocks;
        double x, v;
    } cases[] = {
        {FORCE("5*step(t - 0.777)"), 1.25 * 1.223 * 1.223, 2.5 * 1.223},
        {FORCE("4e6*pulse(t, 1.0003, 1.0003 + 1e-6)"), 2 * (0.9997 - 0.5e-6), 2},
        {FORCE("3*if(t < 0.7331, 1, -1)"), 1.5 * (0.5 * 0.7331 * 0.7331 + 0.7331 * 1.2669 - 0.5 * 1.2669 * 1.2669),
         1.5 * (0.7331 - 1.2669)},
        {FORCE("2*(t > 0.1234567)*(t < 1.7654321)"), 1.6419754 * 1.6419754 / 2 + 1.6419754 * 0.2345679, 1.6419754},
    };
    static const char *const methods[] = {"rk4",  "verlet",  "dopri5",   "dop853",
                                          "auto", "newmark", "midpoint", "verlet6"};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        for (gsize k = 0; k < G_N_ELEMENTS(methods); k++)
            assert_comes_to(methods[k], 2, cases[i].blocks, cases[i].x, cases[i].v, 1e-9);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) /* which is as good as its tolerance */
        assert_comes_to("cvode-bdf", 2, cases[i].blocks, cases[i].x, cases[i].v, 1e-8);
}

/* What it switches on may depend on places, too: a spring from 0.5 s on, a damper until then. */
static void test_with_places(void)
{
    const double w = 3, left = 1.5, speed = 2;
    assert_comes_to("dop853", 2,
                    "{'type': 'mass', 'velocity': [2, 0]},"
                    "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-9*(x - 1)*step(t - 0.5)'}",
                    1 + speed / w * sin(w * left), speed * cos(w * left), 1e-7);
    const double slowed = 2 * exp(-0.7), way = 2 * (1 - exp(-0.7));
    assert_comes_to("rk4", 2,
                    "{'type': 'mass', 'velocity': [2, 0]},"
                    "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-vx*(1 - step(t - 0.7))'}",
                    way + slowed * 1.3, slowed, 1e-9);
}

/* Where the argument of a switch is not linear in t: half waves of 4 N on 2 kg give 4/w each, and a way of 2/w half. */
static void test_half_waves(void)
{
    static const char *const methods[] = {"dopri5", "dop853", "auto"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        const double w = 7, half = G_PI / w;
        double x = 0, v = 0;
        for (int wave = 0; wave < 3; wave++) {
            x += v * half + 2 / w * half; /* pushed */
            v += 4 / w;
            x += v * half; /* left alone */
        }
        assert_comes_to(methods[i], 6 * half, FORCE("max(4*sin(7*t), 0)"), x, v, 1e-7);
    }
}

/* Roots of what a break ends, which is a negative number by rounding at some of the ends: two half waves of
 * sqrt(sin(5 t)), each of pi^(1/2) G(3/4) / G(5/4) / 5 N s. */
static void test_roots(void)
{
    static const char *const blocks[] = {
        FORCE("sqrt(max(sin(5*t), 0))"),
        RESTS "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': 'sqrt(max(sin(5*t), 0))'}}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++) {
        g_autoptr(PhysicsRun) run = run_law("auto", 2, blocks[i]);
        physics_assert_near("speed", physics_last(run, 1), sqrt(G_PI) * tgamma(0.75) / tgamma(1.25) / 5, 1e-7);
    }
}

/* Levels that are touched where they are crossed before and behind, or in the middle of a piece: as a motor's waveform
 * and as a law, against the times at which sines pass levels. */
static void test_touches(void)
{
    static const char *const blocks[] = {
        RESTS "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '%s'}",
        RESTS "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '%s'}}",
    };
    const struct {
        const char *law;
        double until, impulse;
    } cases[] = {
        {"floor(sin(t))", 4, G_PI - 4},
        {"floor(2*sin(t))", G_PI, 2 * G_PI / 3},
        {"floor(3*sin(t))", G_PI, 2 * (acos(1.0 / 3) + acos(2.0 / 3))},
        {"square(2*pi*t + 6.2)", 1, 0},
        {"floor(3*cos(t))", G_PI_2, acos(1.0 / 3) + acos(2.0 / 3)},
        {"square(pi*sin(t))", G_PI, G_PI},
        {"mod(floor(t),2)", 4, 2},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        for (gsize k = 0; k < G_N_ELEMENTS(blocks); k++) {
            g_autoptr(GString) text = g_string_new(blocks[k]);
            g_string_replace(text, "%s", cases[i].law, 1);
            g_autoptr(PhysicsRun) run = run_law("auto", cases[i].until, text->str);
            g_test_message("%s", text->str);
            physics_assert_near("speed", physics_last(run, 1), cases[i].impulse / 2, 1e-7);
        }
}

/* Breaks that are nearer to one another than the steps: what they leave of steps is not the same for the companion. */
static void test_dense_breaks(void)
{
    static const char *const methods[] = {"newmark", "generalized-alpha", "verlet", "rk4", "semi-implicit-euler"};
    const char *law = "{'type': 'mass', 'velocity': [1, 0]},"
                      "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-400*x + 10*square(2*pi*100*t)'}";
    g_autoptr(PhysicsRun) truth = physics_run(
        &(PhysicsOptions){.duration = 2, .method = "dop853", .tolerance = 1e-12, .columns = "Mass 0.vx"}, "%s", law);
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .duration = 2, .method = methods[i], .step = 0.02, .estimate = TRUE, .columns = "Mass 0.vx"},
            "%s", law);
        const double off = fabs(physics_last(run, 0) - physics_last(truth, 0));
        const double estimate = tinker_simulation_summary(run->simulation)->error_estimate;
        g_test_message("%s: off by %.3g, and says %.3g", methods[i], off, estimate);
        g_assert_cmpfloat(off, >, 1e-6);
        g_assert_cmpfloat(estimate, >, off / 1.5); /* of the largest speed, 1 to 1.5 m/s */
        g_assert_cmpfloat(estimate, <, 20 * off);
    }
}

static void add_tests(void)
{
    g_test_add_func("/timed-laws/touches", test_touches);
    g_test_add_func("/timed-laws/dense-breaks", test_dense_breaks);
    g_test_add_func("/timed-laws/roots", test_roots);
    g_test_add_func("/timed-laws/pieces", test_pieces);
    g_test_add_func("/timed-laws/with-places", test_with_places);
    g_test_add_func("/timed-laws/half-waves", test_half_waves);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
