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

static void add_tests(void)
{
    g_test_add_func("/contact-flush/central", test_central);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
