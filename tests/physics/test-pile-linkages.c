/* Joints of every kind on bodies that meet others, with contact as impulses, against contact by events. */
#include "contact-checks.h"

#define SURFACE          "'static_friction': 0.3, 'dynamic_friction': 0.3, 'restitution': "
#define FLOOR            CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 100, " SURFACE "0.2}, "
#define NAIL(name, x, y) "{'type': 'support', 'name': '" name "', 'position': [" #x ", " #y "], 'solid': false}, "

/* Two bars, pinned end to end, fall onto the floor, slide and come to rest on it. */
static void test_pins(void)
{
    contact_check_converges(
        CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 100, " SURFACE "0},"
        "{'type': 'bar', 'solid': true, 'position': [0, 1], 'orientation': 0.4, 'velocity': [1, 0]},"
        "{'type': 'bar', 'solid': true, 'position': [0.95056378592206, 1.0953745054564612],"
        " 'orientation': -0.2, 'velocity': [1, 0]},"
        "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, {'block': 'Bar 1', 'at': "
        "[-0.5, 0]}]}",
        "Bar 0.x, Bar 0.y, Bar 0.angle, Bar 1.x, Bar 1.y, Bar 1.angle", 0.8, 4e-3, 4);
}

/* A disc falls onto one of two wheels that are geared. */
static void test_gears(void)
{
    contact_check_converges(
        CONTACT_WEIGHT NAIL("Axle 0", 0, 1) NAIL(
            "Axle 1", 1,
            1) "{'type': 'disc', 'radius': 0.5, 'position': [0, 1]}, "
               "{'type': 'disc', 'radius': 0.5, 'position': [1, 1]}, {'type': 'pin', 'ends': ['Axle 0', 'Disc 0']},"
               "{'type': 'pin', 'ends': ['Axle 1', 'Disc 1']}, {'type': 'gear', 'ends': ['Disc 0', 'Disc 1']},"
               "{'type': 'disc', 'mass': 2, 'radius': 0.2, 'position': [-0.45, 2.2]}",
        "Disc 0.angle, Disc 1.angle, Disc 2.x, Disc 2.y", 0.6, 2e-3, 5);
}

/* A bar that is driven at 2 rad/s takes a box along. */
static void test_drive(void)
{
    contact_check_converges(
        FLOOR NAIL("Axle 0", 0,
                   1) "{'type': 'bar', 'solid': true, 'length': 1.6, 'width': 0.1, "
                      "'position': [0, 1], 'orientation': 1.5707963267948966}, {'type': 'pin', 'ends': ['Axle 0', "
                      "'Bar 0']}, {'type': 'drive', 'ends': ['Bar 0', 'Axle 0'], 'speed': 2}, {'type': 'box', "
                      "'position': [0.75, 0.4]}",
        "Bar 0.angle, Box 0.x, Box 0.y, Box 0.angle", 1.5, 2e-3, 2);
}

/* A box falls onto one that slides along a line. */
static void test_slider(void)
{
    contact_check_converges(
        FLOOR NAIL("Rail 0", 0, 2) "{'type': 'box', 'width': 0.6, 'height': 0.6, 'position': [0, 2], 'velocity': "
                                   "[1, 0]}, {'type': 'slider', 'ends': ['Rail 0', 'Box 0']}, {'type': 'box', 'width': "
                                   "0.5, 'height': 0.5, 'position': [0.9, 2.6], 'orientation': 0.3}",
        "Box 0.x, Box 0.y, Box 1.x, Box 1.y, Box 1.angle", 0.6, 2e-3, 8);
}

/* A box on two welds, of which either would do, is hit by another. */
static void test_redundant(void)
{
    contact_check_converges(
        CONTACT_WEIGHT NAIL("Nail 0", -1, 1) NAIL(
            "Nail 1", 1, 1) "{'type': 'box', 'width': 2, 'height': 0.4, 'position': [0, 1]},"
                            "{'type': 'weld', 'ends': ['Nail 0', {'block': 'Box 0', 'at': [-1, 0]}]},"
                            "{'type': 'weld', 'ends': ['Nail 1', {'block': 'Box 0', 'at': [1, 0]}]},"
                            "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0.1, 1.9], 'orientation': 0.2, "
                            "'restitution': 0.3}",
        "Box 0.x, Box 0.y, Box 1.x, Box 1.y, Box 1.angle", 0.6, 2e-3, 30);
}

/* A mass and a box on a rod and a spring fall and slide. */
static void test_rod_and_spring(void)
{
    contact_check_converges(
        FLOOR "{'type': 'mass', 'collides': true, 'width': 0.4, 'height': 0.4, 'position': [0, 1]},"
              "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [1.2, 1.3], 'orientation': 0.2},"
              "{'type': 'rod', 'ends': ['Mass 0', {'block': 'Box 0', 'at': [-0.25, 0.25]}]},"
              "{'type': 'spring', 'ends': ['Mass 0', {'block': 'Box 0', 'at': [0, -0.25]}], 'stiffness': 50}",
        "Mass 0.x, Mass 0.y, Box 0.x, Box 0.y, Box 0.angle", 0.7, 2e-3, 5);
}

/* A cart drives off by the torque on a wheel. */
static void test_cart_drives(void)
{
    contact_check_converges(FLOOR "{'type': 'box', 'mass': 3, 'width': 2, 'height': 0.4, 'position': [0, 1]},"
                                  "{'type': 'disc', 'radius': 0.3, 'position': [-0.8, 0.8]},"
                                  "{'type': 'disc', 'radius': 0.3, 'position': [0.8, 0.8]},"
                                  "{'type': 'pin', 'ends': [{'block': 'Box 0', 'at': [-0.8, -0.2]}, 'Disc 0']},"
                                  "{'type': 'pin', 'ends': [{'block': 'Box 0', 'at': [0.8, -0.2]}, 'Disc 1']},"
                                  "{'type': 'torque', 'ends': ['Disc 0', 'Box 0'], 'amplitude': -2}",
                            "Box 0.x, Box 0.y, Box 0.angle, Disc 0.angle", 1.2, 2e-3, 15);
}

#define SHAKEN                                                                                                         \
    CONTACT_WEIGHT NAIL("Nail 0", 0, 2) "{'type': 'support-motion', 'ends': ['Nail 0'], 'waveform': {'expression': "   \
                                        "'0.3*sin(3*t)'}}, {'type': 'box', 'width': 0.4, 'height': 0.4, 'position': "  \
                                        "[0, 1], 'mass': 2}, {'type': 'pin', 'ends': ['Nail 0', {'block': 'Box 0', "   \
                                        "'at': [0, 1]}]}, {'type': 'support', 'position': [0.7, 1], 'orientation': "   \
                                        "1.5707963267948966, 'width': 4, 'height': 0.4, " SURFACE "0.3}"

/* A pendulum on a nail that is moved strikes a wall; its books close, to first order. */
static void test_moved(void)
{
    static const double steps[] = {2e-3, 5e-4};
    contact_check_converges(SHAKEN, "Box 0.x, Box 0.y, Box 0.angle", 2, 2e-3, 1);
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const PhysicsOptions options = {.impulses = TRUE, .duration = 2, .step = steps[i]};
        g_autoptr(PhysicsRun) run = physics_run(&options, SHAKEN);
        physics_assert_near("balance", run->summary->energy_balance_error, 0, 3 * steps[i]);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/pile-linkages/pins", test_pins);
    g_test_add_func("/physics/pile-linkages/gears", test_gears);
    g_test_add_func("/physics/pile-linkages/drive", test_drive);
    g_test_add_func("/physics/pile-linkages/slider", test_slider);
    g_test_add_func("/physics/pile-linkages/redundant", test_redundant);
    g_test_add_func("/physics/pile-linkages/rod-and-spring", test_rod_and_spring);
    g_test_add_func("/physics/pile-linkages/cart-drives", test_cart_drives);
    g_test_add_func("/physics/pile-linkages/moved", test_moved);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
