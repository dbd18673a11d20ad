/* Contact as impulses on bodies that rods hold, against contact by events, which runs to 1e-11. */
#include "contact-checks.h"
#include "physics/model/model.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* One end rests on a slope, the other in a corner with a wall; it slides down. */
static void test_dumbbell_in_a_corner(void)
{
    g_autofree char *floor = contact_plate(0, 0, 0, 20, "'static_friction': 0.2, 'dynamic_friction': 0.1");
    g_autofree char *wall = contact_plate(-1, 0, -G_PI / 2, 20, CONTACT_SMOOTH);
    g_autofree char *blocks =
        g_strdup_printf(CONTACT_WEIGHT "%s, %s, " CONTACT_POINT ", 'position': [-1, 1.5]}, " CONTACT_POINT
                                       ", 'position': [-0.2, 0]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                        floor, wall);
    contact_check_converges(blocks, "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y", 0.4, 4e-3, 10);
}

/* A dumbbell falls askew: one end strikes, then the other. */
static void test_dumbbell_falls(void)
{
    contact_check_converges(CONTACT_WEIGHT CONTACT_FLOOR
                            ", 'width': 20}, " CONTACT_POINT ", 'position': [0, 1]}, " CONTACT_POINT
                            ", 'position': [0.8, 1.6]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                            "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y", 1.5, 4e-3, 10);
}

/* A dumbbell lies at the end, without moving by a bit. */
static void test_dumbbell_rests(void)
{
    PhysicsOptions options = {.impulses = TRUE,
                              .step = 1e-3,
                              .duration = 60,
                              .interval = 0.1,
                              .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 0.normal force, Rod 0.tension"};
    g_autofree char *slope = contact_plate(0, 0, 0.3, 20, "'static_friction': 0.5, 'dynamic_friction': 0.4");
    g_autoptr(PhysicsRun) run =
        physics_run(&options,
                    CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'position': [0, 0.5]}, " CONTACT_POINT
                                   ", 'position': [0.8, 0.9]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                    slope);
    for (gsize k = physics_samples(run) - 500; k < physics_samples(run); k++)
        for (gsize c = 0; c < 4; c++)
            physics_assert_near("a place", physics_value(run, k, c), physics_last(run, c), 0);
    physics_assert_near("what presses", physics_last(run, 4), g * cos(0.3), 1e-9);
    physics_assert_near("what the rod holds", physics_last(run, 5), 0, 10);
}

/* A chain of twenty falls onto the floor: many contacts of one group. */
static PhysicsRun *chain_on_the_floor(const char *friction, double duration, const char *columns)
{
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 100, ");
    g_string_append_printf(blocks, "%s}", friction);
    for (int i = 0; i < 20; i++)
        g_string_append_printf(blocks, ", " CONTACT_POINT ", 'position': [%d, %g], 'velocity': [2, 0]}", i,
                               i % 2 * 0.3);
    for (int i = 1; i < 20; i++)
        g_string_append_printf(blocks, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - 1, i);
    PhysicsOptions options = {.impulses = TRUE, .step = 1e-3, .duration = duration, .columns = columns};
    return physics_run(&options, "%s", blocks->str);
}

static void test_chain_comes_to_rest(void)
{
    g_autoptr(PhysicsRun) run =
        chain_on_the_floor("'static_friction': 0.5, 'dynamic_friction': 0.4", 3,
                           "Mass 0.y, Mass 7.y, Mass 19.y, Mass 0.x, Mass 19.x, Mass 0.vx, Mass 9.vy");
    for (gsize k = 0; k < physics_samples(run); k++)
        for (gsize c = 0; c < 3; c++)
            g_assert_cmpfloat(physics_value(run, k, c), >=, -1e-5);
    for (gsize c = 3; c < 5; c++)
        physics_assert_near("x", physics_last(run, c), physics_value(run, physics_samples(run) - 2, c), 1e-12);
    for (gsize c = 5; c < 7; c++)
        physics_assert_near("a speed", physics_last(run, c), 0, 1e-9);
}

/* Without friction nothing changes what moves along, and no impact adds energy. */
static void test_chain_keeps_its_momentum(void)
{
    g_autoptr(PhysicsRun) run = chain_on_the_floor(CONTACT_SMOOTH, 1, NULL);
    double sum = 0, state[4];
    for (int i = 0; i < 20; i++) {
        g_autofree char *name = g_strdup_printf("Mass %d", i);
        physics_state(run, name, state);
        g_assert_cmpfloat(state[1], >=, -1e-5);
        sum += state[2];
    }
    physics_assert_near("momentum along", sum, 40, 1e-9);
    g_assert_cmpfloat(run->summary->kinetic_end + run->summary->potential_end, <,
                      run->summary->kinetic_start + run->summary->potential_start);
    g_assert_cmpfloat(run->summary->books[TINKER_BOOK_CONTACTS], <, 0);
}

/* A pendulum that strikes a floor with its bob, with a bounce. */
static void test_pendulum_bounces(void)
{
    contact_check_converges(
        CONTACT_WEIGHT
        "{'type': 'support', 'position': [0, 0], 'solid': false}, {'type': 'support', 'position': [0, -1.1], 'width': "
        "5, 'restitution': 0.5, " CONTACT_SMOOTH "}, " CONTACT_POINT
        ", 'position': [1, 0]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
        "Mass 0.x, Mass 0.y", 0.7, 2e-3, 20);
}

/* A pendulum comes down on a rough slope that its rod drives it into: no impulses of contact, friction and rod push it
 * back out of what the last step went too far. It wedges, slides down and comes to rest there as by events. */
static void test_pendulum_wedges(void)
{
    contact_check_converges(
        CONTACT_WEIGHT
        "{'type': 'support', 'position': [0, 1.5], 'solid': false}, {'type': 'support', 'position': "
        "[-0.4, 0.2], 'orientation': -0.7447562021318057, 'width': 6, 'height': 0.1, 'static_friction': 0.57, "
        "'dynamic_friction': 0.57}, {'type': 'mass', 'mass': 2, 'position': [0.75456346601292, "
        "0.5669223099020271], 'width': 0.2, 'height': 0.2}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
        "Mass 0.x, Mass 0.y", 1.4, 1e-2, 20);
}

/* No rods: a mass slides down one side of a rough V, up the other and back, ever less, and rests at the bottom. */
static void test_free_mass_in_a_corner(void)
{
    g_autofree char *left = contact_plate(-1, 1, -G_PI / 4, 4, "'static_friction': 0.3, 'dynamic_friction': 0.3");
    g_autofree char *right = contact_plate(2, 1, atan(0.5), 8, "'static_friction': 0.1, 'dynamic_friction': 0.1");
    g_autofree char *blocks =
        g_strdup_printf(CONTACT_WEIGHT "%s, %s, " CONTACT_POINT ", 'position': [1, 2]}", left, right);
    contact_check_converges(blocks, "Mass 0.x, Mass 0.y", 0.98, 4e-3, 30);
    PhysicsOptions options = {.impulses = TRUE, .step = 1e-3, .duration = 2};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-14);
}

static void add_tests(void)
{
    g_test_add_func("/physics/impulse-rods/free-mass-in-a-corner", test_free_mass_in_a_corner);
    g_test_add_func("/physics/impulse-rods/dumbbell-in-a-corner", test_dumbbell_in_a_corner);
    g_test_add_func("/physics/impulse-rods/dumbbell-falls", test_dumbbell_falls);
    g_test_add_func("/physics/impulse-rods/dumbbell-rests", test_dumbbell_rests);
    g_test_add_func("/physics/impulse-rods/chain-comes-to-rest", test_chain_comes_to_rest);
    g_test_add_func("/physics/impulse-rods/chain-keeps-its-momentum", test_chain_keeps_its_momentum);
    g_test_add_func("/physics/impulse-rods/pendulum-bounces", test_pendulum_bounces);
    g_test_add_func("/physics/impulse-rods/pendulum-wedges", test_pendulum_wedges);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
