/* Constraint rows that hold in one direction only: a rope falls slack where it would have to push, and comes taut with
 * a jerk that takes what parts its ends, without a bounce. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

static const char *const pivot = "{'type': 'support', 'solid': false}, ";

/* Dropped beside its rope's end: free until the rope is taut, then at rest for good. */
static void test_catches(void)
{
    const double drop = 0.75, taut = sqrt(2 * drop / g);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.3, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'gravity'}, %s{'type': 'mass', 'mass': 2, 'position': [0, -0.25]},"
                        "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 1}",
                        pivot);
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){0, -1, 0, 0}, 1e-12);
        contact_assert_event(run, "taut", "Rope 0", taut, bound);
        contact_assert_taken(run, 0, 2 * g * drop, 50 * bound);
    }
}

/* On its way up a circle the rope goes slack where gravity alone bends the path as much: with v0^2 = 3.5 g L at the
 * bottom at cos(angle from the top) = (v0^2 / (g L) - 2) / 3; from there it is a parabola. */
static void test_leaves_the_circle(void)
{
    const double v0 = sqrt(3.5 * g), c = (3.5 - 2) / 3, s = sqrt(1 - c * c), v = sqrt(g * c), later = 0.1;
    double y[2] = {0, v0}, time = 0;
    /* the time up the circle, by an independent integration of the angle from the bottom */
    for (double step = 1e-5; G_PI - y[0] > acos(c); time += step) {
        double middle = y[1] - 0.5 * step * g * sin(y[0]), angle = y[0] + step * middle;
        y[1] = middle - 0.5 * step * g * sin(angle);
        y[0] = angle;
    }
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        double smooth = 10 * contact_methods[i].smooth + 2e-5;
        PhysicsOptions options = contact_options(&contact_methods[i], time + later, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'gravity'}, %s{'type': 'mass', 'position': [0, -1], 'velocity': [%.17g, 0]},"
                        "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 1}",
                        pivot, v0);
        contact_assert_event(run, "slack", "Rope 0", time, smooth);
        contact_assert_state(
            run, "Mass 0",
            (double[]){s - v * c * later, c + v * s * later - 0.5 * g * later * later, -v * c, v * s - g * later},
            10 * smooth);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* Two masses that part: when the rope is taut their speeds along it become one, and nobody else is there to push. */
static void test_pulls_together(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, "{'type': 'mass', 'mass': 3}, {'type': 'mass', 'position': [1, 0], 'velocity': [2, 0]},"
                      "{'type': 'rope', 'ends': ['Mass 0', 'Mass 1'], 'length': 1.5}");
        contact_assert_event(run, "taut", "Rope 0", 0.25, 1e-11);
        contact_assert_state(run, "Mass 0", (double[]){0.5 * 0.75, 0, 0.5, 0}, 1e-11);
        contact_assert_state(run, "Mass 1", (double[]){0.5 * 0.75 + 1.5, 0, 0.5, 0}, 1e-11);
        contact_assert_taken(run, 0, 0.5 * 4 - 0.5 * 4 * 0.25, 1e-11);
    }
}

/* A mass on the floor that a rope holds back, and whose rope is let go by the other end landing beside it. */
static void test_with_a_plate(void)
{
    const double land = sqrt(2 * 0.5 / g);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                        "}, " CONTACT_POINT "}, " CONTACT_POINT
                        ", 'position': [0, 0.5]}, {'type': 'rope', 'ends': ['Mass 0', 'Mass 1'], 'length': 0.5}");
        contact_assert_event(run, "rest", "Mass 1, Support 0", land, contact_methods[i].polynomial);
        contact_assert_state(run, "Mass 1", (double[]){0, 0, 0, 0}, 1e-12);
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/ropes/catches", test_catches);
    g_test_add_func("/physics/ropes/leaves-the-circle", test_leaves_the_circle);
    g_test_add_func("/physics/ropes/pulls-together", test_pulls_together);
    g_test_add_func("/physics/ropes/with-a-plate", test_with_a_plate);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
