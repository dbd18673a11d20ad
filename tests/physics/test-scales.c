/* Physics does not know where the origin lies, or how long a metre is. */
#include "physics-fixture.h"

#include <math.h>

static PhysicsRun *pendulum_and_spring(const char *method, double x, double y, double unit)
{
    return physics_run(
        &(PhysicsOptions){.method = method,
                          .duration = 5,
                          .interval = 0.25,
                          .tolerance = 1e-11,
                          .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Rod 0.tension, Spring 0.tension"},
        "{'type': 'gravity', 'acceleration': %.17g}, {'type': 'support', 'position': [%.17g, %.17g]},"
        "{'type': 'mass', 'position': [%.17g, %.17g]}, {'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 100},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': %.17g, 'frequency': 2}",
        9.8125 * unit, x, y, x + 1.5 * unit, y + 0.25 * unit, x + 2 * unit, y - 0.75 * unit, 0.125 * unit);
}

/* A thousand kilometres away, with the same differences to the bit: what is seen there differs by the rounding of the
 * absolute places alone. */
static void test_far_from_the_origin(gconstpointer method)
{
    const double away[2] = {1e6, -1e6};
    g_autoptr(PhysicsRun) here = pendulum_and_spring(method, 0, 0, 1),
                          there = pendulum_and_spring(method, away[0], away[1], 1);
    for (gsize i = 0; i < physics_samples(here); i++) {
        for (gsize k = 0; k < 4; k++)
            physics_assert_near("place", physics_value(there, i, k) - away[k % 2], physics_value(here, i, k), 1e-9);
        physics_assert_near("rod's tension", physics_value(there, i, 4), physics_value(here, i, 4), 1e-9);
        /* 100 N/m on the distance of two places that are each rounded to 1.2e-10 m. */
        physics_assert_near("spring's tension", physics_value(there, i, 5), physics_value(here, i, 5), 100 * 2.4e-10);
    }
    g_assert_cmpint(here->summary->steps, ==, there->summary->steps);
}

/* In millimetres, metres and kilometres the same numbers come out. */
static void test_unit_of_length(gconstpointer method)
{
    static const double units[] = {1e-3, 1e3};
    g_autoptr(PhysicsRun) metres = pendulum_and_spring(method, 0, 0, 1);
    for (gsize u = 0; u < G_N_ELEMENTS(units); u++) {
        g_autoptr(PhysicsRun) run = pendulum_and_spring(method, 0, 0, units[u]);
        for (gsize i = 0; i < physics_samples(run); i++) {
            for (gsize k = 0; k < 4; k++)
                physics_assert_near("place", physics_value(run, i, k) / units[u], physics_value(metres, i, k), 1e-9);
            for (gsize k = 4; k < 6; k++)
                physics_assert_near("tension", physics_value(run, i, k) / units[u], physics_value(metres, i, k), 2e-8);
        }
    }
}

static void add_tests(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dopri5", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autofree char *far_name = g_strdup_printf("/physics/scales/far-from-the-origin/%s", methods[m]);
        g_autofree char *unit_name = g_strdup_printf("/physics/scales/unit-of-length/%s", methods[m]);
        g_test_add_data_func(far_name, methods[m], test_far_from_the_origin);
        g_test_add_data_func(unit_name, methods[m], test_unit_of_length);
    }
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
