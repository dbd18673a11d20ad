/* Sides that meet flush: rounding of places and angles says nothing of which corner is first. */
#include "contact-checks.h"

#include <math.h>

#define SIDE   0.2
#define RATHER 1e-15

/* Two boxes of one height slide towards each other on a smooth floor, each out of place and askew by rounding. The blow
 * is along the line of their centres: by Newton's law of impact they go on straight, and neither lifts off. */
static void check_central(double rebound, GRand *random)
{
    const double m[2] = {2, 1.3}, v[2] = {0.5, -0.4}, common = (m[0] * v[0] + m[1] * v[1]) / (m[0] + m[1]);
    double off[4];
    for (gsize i = 0; i < G_N_ELEMENTS(off); i++)
        off[i] = g_rand_double_range(random, -RATHER, RATHER);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1,
                          .columns = "Box 0.vx, Box 1.vx, Box 0.vy, Box 1.vy, Box 0.angular velocity,"
                                     "Box 1.angular velocity"},
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20, " CONTACT_SMOOTH ", 'restitution': 0},"
                                     "{'type': 'box', 'mass': %g, 'width': 0.4, 'height': %g, 'position': [0, %.17g],"
                                     " 'orientation': %.17g, 'velocity': [%g, 0], 'restitution': %g},"
                                     "{'type': 'box', 'mass': %g, 'width': 0.6, 'height': %g, 'position': [0.7, %.17g],"
                                     " 'orientation': %.17g, 'velocity': [%g, 0], 'restitution': %g}",
        m[0], SIDE, SIDE / 2 + off[0], off[1], v[0], rebound, m[1], SIDE, SIDE / 2 + off[2], off[3], v[1], rebound);
    contact_assert_count(run, "take-off", 0);
    for (gsize k = 0; k < 2; k++)
        physics_assert_near("along", physics_last(run, k), common - rebound * (v[k] - common), 1e-9);
    for (gsize sample = 0; sample < physics_samples(run); sample++)
        for (gsize k = 2; k < 6; k++)
            physics_assert_near("nothing lifts or turns", physics_value(run, sample, k), 0, 1e-9);
}

static void test_central(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    for (int i = 0; i < 60; i++)
        check_central(i % 3 * 0.5, random);
}

/* A crank, at this angle at the start, that a drive turns at 6 rad/s, and how far its piston is. */
#define CRANK    0.25
#define COUPLER  0.85
#define TURNING  6.0
#define STRUCK_X 1.25

static double short_of_struck(double t, const void *data)
{
    const double angle = *(const double *)data + TURNING * t, up = CRANK * sin(angle);
    return STRUCK_X - 2 * 0.1 - CRANK * cos(angle) - sqrt(COUPLER * COUPLER - up * up);
}

static double piston_speed(double t, double start)
{
    const double angle = start + TURNING * t, up = CRANK * sin(angle);
    return -TURNING * up * (1 + CRANK * cos(angle) / sqrt(COUPLER * COUPLER - up * up));
}

/* Its piston comes, in its slider, along the top of a smooth table that it just touches, and strikes a box while it
 * slows down: the box goes on with its speed. Nothing can move the piston, so that its corners part from the table and
 * close on it by rounding. */
static void check_guided_blow(double start, double tolerance)
{
    const double x = CRANK * cos(start), y = CRANK * sin(start), slope = asin(-y / COUPLER);
    const double piston = x + COUPLER * cos(slope);
    const double met = contact_bisect(1.2 / TURNING, 2.6 / TURNING, short_of_struck, &start);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "dop853", .tolerance = tolerance, .duration = 0.6, .columns = "Box 1.x, Box 1.vx"},
        CONTACT_WEIGHT "{'type': 'support', 'position': [0, 0.5], 'solid': false},"
                       "{'type': 'bar', 'length': 0.25, 'position': [%.17g, %.17g], 'orientation': %.17g},"
                       "{'type': 'bar', 'length': 0.85, 'position': [%.17g, %.17g], 'orientation': %.17g},"
                       "{'type': 'box', 'width': 0.2, 'height': 0.2, 'position': [%.17g, 0.5]},"
                       "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.125, 0]}]},"
                       "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.125, 0]},"
                       " {'block': 'Bar 1', 'at': [-0.425, 0]}]},"
                       "{'type': 'pin', 'ends': [{'block': 'Bar 1', 'at': [0.425, 0]}, 'Box 0']},"
                       "{'type': 'slider', 'ends': ['Support 0', 'Box 0']},"
                       "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 6},"
                       "{'type': 'support', 'position': [1.25, 0.35], 'width': 1, 'height': 0.1, " CONTACT_SMOOTH "},"
                       "{'type': 'box', 'mass': 0.9, 'width': 0.2, 'height': 0.2, 'position': [1.25, 0.5]}",
        x / 2, 0.5 + y / 2, start, (x + piston) / 2, 0.5 + y / 2, slope, piston);
    const double speed = piston_speed(met, start);
    physics_assert_near("its speed", physics_last(run, 1), speed, 1e-7);
    physics_assert_near("its place", physics_last(run, 0), STRUCK_X + speed * (0.6 - met), 1e-7);
}

static void test_guided_blow(void)
{
    for (int i = 0; i <= 20; i++)
        for (int digits = 9; digits <= 12; digits++)
            check_guided_blow(3.6 + 0.02 * i, pow(10, -digits));
}

/* Nothing but what rounding makes of their turns presses on boxes that have met and go on together where no force acts:
 * they go on as one, and what may be off is told to the end. */
static void test_free(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    for (int i = 0; i < 100; i++) {
        const double rather = pow(10, -g_rand_double_range(random, 12, 16));
        double off[8];
        for (gsize k = 0; k < G_N_ELEMENTS(off); k++)
            off[k] = g_rand_boolean(random) ? rather : -rather;
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 3, .estimate = TRUE, .columns = "Box 0.vx, Box 1.vx, Box 0.angular velocity"},
            "{'type': 'box', 'position': [%.17g, %.17g], 'orientation': %.17g, 'angular_velocity': %.17g,"
            " 'velocity': [2, 0]},"
            "{'type': 'box', 'position': [%.17g, %.17g], 'orientation': %.17g, 'angular_velocity': %.17g}",
            off[0], off[1], off[2], off[3], 3 + off[4], off[5], off[6], off[7]);
        physics_assert_near("one", physics_last(run, 0), 1, 1e-9);
        physics_assert_near("other", physics_last(run, 1), 1, 1e-9);
        physics_assert_near("turn", physics_last(run, 2), 0, 1e-9);
        g_assert_true(isfinite(run->summary->error_estimate));
        g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    }
}

static void add_tests(void)
{
    g_test_add_func("/contact-flush/free", test_free);
    g_test_add_func("/contact-flush/guided-blow", test_guided_blow);
    g_test_add_func("/contact-flush/central", test_central);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
