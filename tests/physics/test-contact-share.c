/* A load that statics does not divide: how it is shared is of where things lie, not of how they came there. */
#include "contact-checks.h"

#include <math.h>

/* A box and a mass on a rod are thrown onto a rough slope and come to rest. Both corners of the box rub, and the rod
 * may pull or push: by other tolerances the last of hundreds of events is another one, and all is held alike. */
static void test_tied_on_a_slope(void)
{
    static const double tolerances[] = {1e-9, 1e-10, 1e-11, 1e-12};
    double first[2];
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "dop853",
                              .tolerance = tolerances[i],
                              .duration = 1.5,
                              .columns = "Rod 0.tension, Mass 0.friction force, Box 0.vx"},
            CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 60, 'height': 0.2, 'orientation': 0.15,"
                           " 'restitution': 0.4, 'static_friction': 0.24, 'dynamic_friction': 0.2},"
                           "{'type': 'box', 'mass': 2, 'width': 0.6, 'height': 0.2, 'position': [0, 0.25],"
                           " 'velocity': [-0.5279095475713476, 0]},"
                           "{'type': 'mass', 'position': [0.5, 0.863989428866474]},"
                           "{'type': 'rod', 'ends': ['Box 0', 'Mass 0']}");
        physics_assert_near("the speed", physics_last(run, 2), 0, 1e-12);
        for (gsize k = 0; i == 0 && k < 2; k++)
            first[k] = physics_last(run, k);
        for (gsize k = 0; k < 2; k++)
            physics_assert_near("as with another tolerance", physics_last(run, k), first[k], 1e-6);
    }
}

static void add_tests(void)
{
    g_test_add_func("/contact-share/tied-on-a-slope", test_tied_on_a_slope);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
