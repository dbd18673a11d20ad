/* Where a box touches: the gap n . (centre - top) - height / 2 at any angle, and the ends of a top. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* Shot without weight against the top of a turned plate, straight or obliquely, and thrown back. */
static void check_shot(double angle, double height, double along)
{
    const double away = 2, across = 3, duration = 1.5;
    double normal[2] = {-sin(angle), cos(angle)}, tangent[2] = {cos(angle), sin(angle)};
    double state[4], start[4], touch = (away - height / 2) / across, middle[2] = {0.7, -1.3};
    for (int k = 0; k < 2; k++) {
        double travelled = along * duration - 0.5;
        start[k] = middle[k] + away * normal[k] - 0.5 * tangent[k];
        start[2 + k] = -across * normal[k] + along * tangent[k];
        state[k] = middle[k] + (height / 2 + across * (duration - touch)) * normal[k] + travelled * tangent[k];
        state[2 + k] = across * normal[k] + along * tangent[k];
    }
    g_autofree char *plate = contact_plate(middle[0], middle[1], angle, 4, CONTACT_SMOOTH ", 'restitution': 1");
    for (gsize i = 0; i < CONTACT_METHODS; i += 2) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                "%s, {'type': 'mass', 'width': 9, 'height': %g, 'position': [%.17g, "
                                                "%.17g], 'velocity': [%.17g, %.17g], 'orientation': 0.3}",
                                                plate, height, start[0], start[1], start[2], start[3]);
        contact_assert_state(run, "Mass 0", state, 1e-10);
        contact_assert_event(run, "impact", "Mass 0, Support 0", touch, 1e-11);
        contact_assert_taken(run, 0, 0, 1e-11);
    }
}

static void test_any_angle(void)
{
    static const double heights[] = {0, 0.4, 1.5};
    for (int degrees = -180; degrees <= 180; degrees += 15) {
        for (gsize h = 0; h < G_N_ELEMENTS(heights); h++) {
            check_shot(degrees * G_PI / 180, heights[h], 0);
            check_shot(degrees * G_PI / 180, heights[h], 1.25);
        }
    }
}

/* Dropped on a frictionless slope it keeps its speed along it and stays height / 2 above it. */
static void check_slide(double degrees, double height)
{
    const double angle = degrees * G_PI / 180, fall = 0.5, duration = 1;
    double landing = sqrt(2 * fall / g), slid = duration - landing;
    double speed = -g * landing * sin(angle), way = speed * slid - g / 2 * sin(angle) * slid * slid;
    double normal[2] = {-sin(angle), cos(angle)}, tangent[2] = {cos(angle), sin(angle)};
    g_autofree char *plate = contact_plate(0, 0, angle, 40, CONTACT_SMOOTH);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, {'type': 'mass', 'height': %g, 'position': [%.17g, %.17g]}",
                        plate, height, height / 2 * normal[0], height / 2 * normal[1] + fall);
        double state[4], now = speed - g * sin(angle) * slid;
        for (int k = 0; k < 2; k++) {
            state[k] = height / 2 * normal[k] + way * tangent[k];
            state[2 + k] = now * tangent[k];
        }
        contact_assert_state(run, "Mass 0", state, contact_methods[i].polynomial);
        physics_state(run, "Mass 0", state);
        physics_assert_near("the gap", state[0] * normal[0] + state[1] * normal[1] - height / 2, 0, 1e-11);
        physics_assert_near("its rate", state[2] * normal[0] + state[3] * normal[1], 0, 1e-11);
        contact_assert_taken(run, 0, g * fall * cos(angle) * cos(angle), 10 * contact_methods[i].polynomial);
    }
}

static void test_slides_at_its_height(void)
{
    static const double degrees[] = {-80, -45, -7, 15, 30, 60, 85};
    for (gsize i = 0; i < G_N_ELEMENTS(degrees); i++) {
        check_slide(degrees[i], 0);
        check_slide(degrees[i], 0.8);
    }
}

/* At the end of the top the centre decides, whatever the mass's width. */
static void test_edges(void)
{
    static const double widths[] = {0, 0.8, 5}, heights[] = {0, 1};
    for (int side = -1; side <= 1; side += 2) {
        for (int inside = -1; inside <= 1; inside += 2) {
            for (gsize i = 0; i < 6; i++) {
                double x = side * (2 - inside * 1e-6), height = heights[i % 2];
                PhysicsOptions options = contact_options(&contact_methods[i % CONTACT_METHODS], 1, NULL);
                g_autoptr(PhysicsRun) run =
                    physics_run(&options,
                                CONTACT_WEIGHT CONTACT_FLOOR
                                "}, {'type': 'mass', 'width': %g, 'height': %g, 'position': [%.17g, 2]}",
                                widths[i / 2], height, x);
                double landed[4] = {x, height / 2, 0, 0}, passed[4] = {x, 2 - g / 2, 0, -g};
                contact_assert_state(run, "Mass 0", inside > 0 ? landed : passed, inside > 0 ? 1e-12 : 1e-10);
                contact_assert_count(run, "rest", inside > 0);
            }
        }
    }
}

/* The two boxes' heights: the plate's counts from its middle, the mass's from its own. */
static void test_heights(void)
{
    static const double plates[] = {0.05, 0.4, 3};
    for (gsize i = 0; i < G_N_ELEMENTS(plates); i++) {
        PhysicsOptions options = contact_options(&contact_methods[0], 2, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT "{'type': 'support', 'position': [1, -1], 'height': %g},"
                                       "{'type': 'mass', 'position': [1, 4], 'height': 0.3, 'width': 2}",
                        plates[i]);
        contact_assert_state(run, "Mass 0", (double[]){1, -1 + plates[i] / 2 + 0.15, 0, 0}, 1e-12);
        contact_assert_event(run, "rest", NULL, sqrt(2 * (5 - plates[i] / 2 - 0.15) / g), 1e-10);
    }
}

/* Two boxes of one height stand side by side on a floor, corner at corner, as rounding has it of a scene that is
 * turned; one is pushed against the other, which its friction holds, now above and now below, so that either corner
 * lets go at times. Nothing moves. */
static void test_corner_at_corner(void)
{
    for (int i = 0; i < 12; i++) {
        const double angle = 0.03 * (i + 1), c = cos(angle), s = sin(angle);
        const PhysicsOptions options = {.duration = 2, .tolerance = 1e-9, .columns = "Box 0.x, Box 0.y, Box 0.angle"};
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            "{'type': 'gravity', 'angle': %.17g}, {'type': 'support', 'position': [%.17g, %.17g], 'orientation': %.17g,"
            "'width': 20, 'height': 0.4, 'static_friction': 0.6, 'dynamic_friction': 0.6, 'restitution': 0.5},"
            "{'type': 'box', 'width': 1, 'height': 1, 'position': [%.17g, %.17g], 'orientation': %.17g},"
            "{'type': 'box', 'width': 1, 'height': 1, 'mass': 30, 'position': [%.17g, %.17g], 'orientation': %.17g},"
            "{'type': 'motor', 'ends': [{'block': 'Box 0', 'at': [-0.5, 0.4]}], 'amplitude': 5, 'frequency': 1.7,"
            "'angle': %.17g}, {'type': 'motor', 'ends': [{'block': 'Box 0', 'at': [-0.5, -0.3]}], 'waveform': "
            "{'expression': '8'}, 'angle': %.17g}",
            angle - G_PI / 2, 1.3 + 0.2 * s, 0.91 - 0.2 * c, angle, 1.3 - 0.5 * s, 0.91 + 0.5 * c, angle,
            1.3 + c - 0.5 * s, 0.91 + s + 0.5 * c, angle, angle, angle);
        physics_assert_near("x", physics_last(run, 0), 1.3 - 0.5 * s, 1e-9);
        physics_assert_near("y", physics_last(run, 1), 0.91 + 0.5 * c, 1e-9);
        physics_assert_near("angle", physics_last(run, 2), angle, 1e-9);
        g_assert_cmpuint(run->summary->events->len, <, 50);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-gap/any-angle", test_any_angle);
    g_test_add_func("/physics/contact-gap/slides-at-its-height", test_slides_at_its_height);
    g_test_add_func("/physics/contact-gap/edges", test_edges);
    g_test_add_func("/physics/contact-gap/heights", test_heights);
    g_test_add_func("/physics/contact-gap/corner-at-corner", test_corner_at_corner);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
