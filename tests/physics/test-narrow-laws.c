/* Typed laws that are large in a narrow band of time or place alone, against what pulses and barriers do in closed
 * form: the impulse of a Gaussian force A exp(-((t - t0) / w)^2) is A w pi^(1/2), and behind or before a barrier the
 * energy says the speed. */
#include "physics-fixture.h"

#include <math.h>
#include <string.h>

#define FLIES "{'type': 'mass', 'mass': 2, 'velocity': [1, 0]},"
#define RESTS "{'type': 'mass', 'mass': 2},"

static const char *const adaptive[] = {"dop853", "dopri5"};

static PhysicsRun *run_law(const char *method, const char *blocks)
{
    return physics_run(
        &(PhysicsOptions){.duration = 2, .method = method, .tolerance = 1e-9, .columns = "Mass 0.x, Mass 0.vx"}, "%s",
        blocks);
}

/* Widths over six decades; each is as narrow beside a step as no method meets by itself. */
static void test_pulses(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(adaptive); i++)
        for (double width = 1e-2; width > 0.9e-7; width *= 0.1) {
            const double gain = 0.1, strength = gain * 2 / (width * sqrt(G_PI));
            g_autofree char *flies = g_strdup_printf(
                FLIES "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '%.17g*exp(-((t - 1.37)/%.17g)^2)'}",
                strength, width);
            g_autoptr(PhysicsRun) run = run_law(adaptive[i], flies);
            physics_assert_near("speed", physics_last(run, 1), 1 + gain, 2e-8);
            physics_assert_near("place", physics_last(run, 0), 2 + gain * 0.63, 2e-8);
        }
}

/* What rests at first has no speed to measure a pulse against. */
static void test_from_rest(void)
{
    static const char *const laws[] = {"'law-force', 'ends': ['Mass 0']", "'law-field'"};
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autofree char *rests =
            g_strdup_printf(RESTS "{'type': %s, 'force_x': '100*exp(-((t - 1)/0.001)^2)'}", laws[i]);
        g_autoptr(PhysicsRun) run = run_law("dop853", rests);
        physics_assert_near("speed", physics_last(run, 1), 0.1 * sqrt(G_PI) / 2, 1e-9);
    }
    /* between the stages of a loose tolerance */
    g_autoptr(PhysicsRun) loose = physics_run(
        &(PhysicsOptions){.duration = 3, .method = "dopri5", .tolerance = 1e-4, .columns = "Mass 0.vx"},
        "{'type': 'mass'}, {'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '5e3*pulse(t,1.0007,1.0014)'}");
    physics_assert_near("speed", physics_last(loose, 0), 3.5, 1e-2);
}

/* A wall that throws a mass back within 3e-5 s, after a long flight. */
static void test_wall(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 25, .tolerance = 1e-9, .estimate = TRUE, .columns = "Mass 0.x, Mass 0.vx"},
        "{'type': 'mass', 'velocity': [1, 0]},"
        "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '-1e10*max(x-10,0)'}");
    physics_assert_near("speed", physics_last(run, 1), -1, 1e-8);
    physics_assert_near("place", physics_last(run, 0), G_PI / 1e5 - 5, 1e-7);
}

/* The energy of the mass is 1 J: a barrier of 2 J throws it back, one of 0.9 J lets it pass as fast as it came. */
static void test_barriers(void)
{
    static const char *const walls[] = {"exp(-((x - 0.53)/%.17g)^2)", "(1 - tanh((x - 0.53)/%.17g)^2)",
                                        "1/(1 + ((x - 0.53)/%.17g)^8)"};
    for (gsize i = 0; i < G_N_ELEMENTS(adaptive) * G_N_ELEMENTS(walls); i++)
        for (double width = 1e-2; width > 0.9e-5; width *= 0.1)
            for (int high = 0; high < 2; high++) {
                g_autoptr(GString) text = g_string_new(FLIES "{'type': 'law-field', 'potential': '");
                g_string_append(text, high ? "2*" : "0.9*");
                g_autofree char *wall = g_strdup_printf("%.17g", width);
                g_string_append(text, walls[i / G_N_ELEMENTS(adaptive)]);
                g_string_replace(text, "%.17g", wall, 1);
                g_string_append(text, "'}");
                g_autoptr(PhysicsRun) run = run_law(adaptive[i % G_N_ELEMENTS(adaptive)], text->str);
                physics_assert_near("speed", physics_last(run, 1), high ? -1 : 1, 1e-6);
            }
}

/* Through a ditch between two steep slopes it goes at (1 + 2 V / m)^(1/2), and is so much ahead. Steps of force that
 * last for 1 mm take F s of its energy. */
static void test_steps(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(adaptive); i++) {
        g_autoptr(PhysicsRun) ditch =
            run_law(adaptive[i], FLIES "{'type': 'law-field', 'potential':"
                                       " '-0.2*(tanh((x - 0.5)/1e-4) - tanh((x - 0.6)/1e-4))'}");
        const double faster = sqrt(1 + 0.4);
        physics_assert_near("speed", physics_last(ditch, 1), 1, 1e-8);
        physics_assert_near("place", physics_last(ditch, 0), 2 + 0.1 * (1 - 1 / faster), 1e-4);
        g_autoptr(PhysicsRun) band = run_law(adaptive[i], FLIES "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x':"
                                                                " '-500*(step(x - 0.5) - step(x - 0.501))'}");
        physics_assert_near("speed", physics_last(band, 1), sqrt(0.5), 1e-7);
    }
}

/* A wall across the way of what swings, and turns about it with a bar: the energy alone is known. */
static void test_curved_ways(void)
{
    g_autoptr(PhysicsRun) swings =
        run_law("dop853", "{'type': 'mass', 'mass': 2, 'position': [1, 0], 'velocity': [0, 0]},"
                          "{'type': 'support', 'solid': false}, {'type': 'spring', 'ends': ['Support 0', 'Mass 0'],"
                          " 'rest_length': 0, 'stiffness': 200},"
                          "{'type': 'law-field', 'potential': '150*exp(-((x - 0.21)/1e-5)^2)'}");
    /* it turns round at 0.21 again and again: 2 t = 4.5 or so half swings of acos(0.21) / 10 */
    const double half = acos(0.21) / 10, left = fmod(2, 2 * half);
    physics_assert_near("place", physics_last(swings, 0), cos(10 * fmin(left, 2 * half - left)), 1e-3);
    g_autoptr(PhysicsRun) turns =
        run_law("dop853", "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [1, 0],"
                          " 'velocity': [0, 5]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                          "{'type': 'law-force', 'ends': ['Mass 0'], 'potential': '200*exp(-((y - 0.613)/1e-5)^2)'}");
    physics_assert_near("speed", fabs(physics_last(turns, 1)) / fabs(sin(acos(physics_last(turns, 0)))), 5, 1e-5);
    g_assert_cmpfloat(physics_last(turns, 0) * physics_last(turns, 0), >, 1 - 0.613 * 0.613 - 1e-3);
}

static gboolean tells(const PhysicsRun *run, const char *what)
{
    for (guint i = 0; i < run->summary->warnings->len; i++)
        if (strstr(tinker_warnings_text(run->summary->warnings, i), what) != NULL) return TRUE;
    return FALSE;
}

/* A fixed step goes over it, and the run says so; of a law that the steps resolve it says nothing. */
static void test_fixed_steps(void)
{
    static const char *const methods[] = {"verlet", "rk4"};
    static const char *const walls[] = {"2*exp(-((x - 0.505)/1e-4)^2)", "0.2*exp(-((x - 0.505)/0.2)^2)",
                                        "0.5*x^2 + 0.1/(1 + x^2)"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods) * G_N_ELEMENTS(walls); i++) {
        const gsize wall = i / G_N_ELEMENTS(methods);
        g_autofree char *blocks = g_strdup_printf(FLIES "{'type': 'law-field', 'potential': '%s'}", walls[wall]);
        g_autoptr(PhysicsRun) run = run_law(methods[i % G_N_ELEMENTS(methods)], blocks);
        g_assert_cmpint(tells(run, "does not resolve"), ==, wall == 0);
        if (wall == 0) g_assert_true(tells(run, "Typed Field 0: at about t = 0.50"));
    }
}

/* 1 N, though intervals do not see that, until just behind the end of the run: what comes then was not missed. */
static void test_behind_the_end(void)
{
    static const char *const methods[] = {"verlet", "rk4"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run =
            run_law(methods[i], FLIES "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '1000*step(t - 2.000001) + "
                                      "1000*(sin(2e4*t)^2 + cos(2e4*t)^2) - 999'}");
        physics_assert_near("speed", physics_last(run, 1), 2, 1e-9);
        g_assert_false(tells(run, "does not resolve"));
    }
}

/* What is resolved anyway is stepped as before. */
static void test_no_cost(void)
{
    g_autoptr(PhysicsRun) run = run_law("dop853", "{'type': 'mass', 'position': [1, 0], 'velocity': [0, 1]},"
                                                  "{'type': 'law-field', 'potential': '-m/sqrt(x^2 + y^2)'}");
    physics_assert_near("x", physics_last(run, 0), cos(2), 1e-8);
    g_assert_cmpint(run->summary->steps, <, 20);
}

/* Two runs that both pass over a pulse of 5 N s agree, and are off by 5 of 6 m/s. */
static void test_estimate_of_missed(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "rk4", .step = 0.01, .duration = 2, .estimate = TRUE, .columns = "Mass 0.vx"},
        "{'type': 'mass', 'velocity': [1, 0]},"
        "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '28209.479*exp(-((t - 1.0008)/1e-4)^2)'}");
    physics_assert_near("speed", physics_last(run, 0), 1, 1e-12);
    g_assert_cmpfloat(tinker_simulation_summary(run->simulation)->error_estimate, >=, 5.0 / 6);
}

static void add_tests(void)
{
    g_test_add_func("/physics/narrow-laws/estimate-of-missed", test_estimate_of_missed);
    g_test_add_func("/physics/narrow-laws/pulses", test_pulses);
    g_test_add_func("/physics/narrow-laws/from-rest", test_from_rest);
    g_test_add_func("/physics/narrow-laws/wall", test_wall);
    g_test_add_func("/physics/narrow-laws/barriers", test_barriers);
    g_test_add_func("/physics/narrow-laws/steps", test_steps);
    g_test_add_func("/physics/narrow-laws/curved-ways", test_curved_ways);
    g_test_add_func("/physics/narrow-laws/fixed-steps", test_fixed_steps);
    g_test_add_func("/physics/narrow-laws/behind-the-end", test_behind_the_end);
    g_test_add_func("/physics/narrow-laws/no-cost", test_no_cost);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
