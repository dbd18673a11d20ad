/* Joints, gears, drives, torques and what speaks of angles: by closed forms. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "physics/system/summary.h"

#include <math.h>

#define GRAVITY "{'type': 'gravity'}, "
#define GROUND  "{'type': 'support', 'solid': false}, "
#define DISC    "{'type': 'disc', 'mass': 2, 'radius': 0.5, 'solid': false, "
#define AXLE    "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, "
#define INERTIA 0.25
#define G       9.81

/* A disc of 0.25 kg m^2 on a spring of 4 N m: w = 4. */
static void test_torsional_spring(void)
{
    static const char *const methods[] = {"dop853", "cvode-bdf"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m],
                              .duration = 6,
                              .tolerance = 1e-10,
                              .columns = "Disc 0.angle, Disc 0.angular velocity, Torsional Spring 0.torque, "
                                         "Torsional Spring 0.energy"},
            GROUND DISC
            "'position': [0, 0], 'orientation': 7}, " AXLE
            "{'type': 'torsional-spring', 'ends': ['Support 0', 'Disc 0'], 'stiffness': 4, 'rest_angle': 5}");
        for (gsize i = 0; i < physics_samples(run); i++) {
            const double turn = 2 * cos(4 * physics_time(run, i));
            physics_assert_near("angle", physics_value(run, i, 0), 5 + turn, 1e-6);
            physics_assert_near("rate", physics_value(run, i, 1), -8 * sin(4 * physics_time(run, i)), 1e-6);
            physics_assert_near("torque", physics_value(run, i, 2), 4 * turn, 1e-6);
            physics_assert_near("energy", physics_value(run, i, 3), 2 * turn * turn, 1e-6);
        }
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-6);
    }
}

/* At rest as it is placed where no rest angle is given, whatever the support's orientation. */
static void test_as_placed(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1, .columns = "Disc 0.angle, Torsional Spring 0.torque"},
        "{'type': 'support', 'solid': false, 'orientation': 0.5}, " DISC "'position': [0, 0], 'orientation': 2}, " AXLE
        "{'type': 'torsional-spring', 'ends': ['Support 0', 'Disc 0']}");
    physics_assert_near("angle", physics_last(run, 0), 2, 0);
    physics_assert_near("torque", physics_last(run, 1), 0, 0);
}

/* w = w0 exp(-c t / I), and what it loses is what dampers took. */
static void test_torsional_damper(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 2, .tolerance = 1e-11, .columns = "Disc 0.angular velocity, Torsional Damper 0.power"},
        GROUND DISC "'position': [0, 0], 'angular_velocity': 3}, " AXLE
                    "{'type': 'torsional-damper', 'ends': ['Support 0', 'Disc 0'], 'damping': 0.5}");
    const double rate = 3 * exp(-4);
    physics_assert_near("rate", physics_last(run, 0), rate, 1e-9);
    physics_assert_near("power", physics_last(run, 1), 0.5 * rate * rate, 1e-9);
    physics_assert_near("taken", run->summary->books[TINKER_BOOK_DAMPERS], 0.5 * INERTIA * (rate * rate - 9), 1e-8);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-8);
}

/* A torque between two discs turns both, against each other; its work is that of motors. */
static void test_torque(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 2,
                          .tolerance = 1e-11,
                          .columns = "Disc 0.angle, Disc 1.angular velocity, Torque 0.power, Disc 0.angular velocity"},
        DISC "'position': [1, 1]}, {'type': 'disc', 'position': [0, 0], 'mass': 1, 'radius': 1, 'solid': false}, "
             "{'type': 'torque', 'ends': ['Disc 0', 'Disc 1'], 'amplitude': 0.75}");
    physics_assert_near("angle", physics_last(run, 0), 0.5 * 3 * 4, 1e-9);
    physics_assert_near("rate of the other", physics_last(run, 1), -1.5 * 2, 1e-9);
    physics_assert_near("power", physics_last(run, 2), 0.75 * (6 + 3), 1e-9);
    physics_assert_near("work", run->summary->books[TINKER_BOOK_MOTORS], 0.5 * INERTIA * 36 + 0.5 * 0.5 * 9, 1e-8);
}

/* alpha_1 = M / (I_1 + r^2 I_2); external gears turn against each other, internal ones alike. */
static void check_gear(const char *internal, double side)
{
    g_autofree char *blocks = g_strdup_printf(
        GROUND DISC
        "'position': [0, 0]}, {'type': 'disc', 'mass': 3, 'radius': 1, 'position': [3, 0], 'solid': false}, " AXLE
        "{'type': 'pin', 'ends': [{'block': 'Support 0', 'at': [3, 0]}, 'Disc 1']},"
        "{'type': 'gear', 'ends': ['Disc 0', 'Disc 1'], 'ratio': 0.5, 'internal': %s},"
        "{'type': 'torque', 'ends': ['Disc 0'], 'amplitude': 1.25}",
        internal);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4, .columns = "Disc 0.angle, Disc 1.angle, Gear 0.torque"}, "%s", blocks);
    const double alpha = 1.25 / (INERTIA + 0.25 * 1.5);
    physics_assert_near("first", physics_last(run, 0), 8 * alpha, 1e-8);
    physics_assert_near("second", physics_last(run, 1), side * 4 * alpha, 1e-8);
    physics_assert_near("torque", physics_last(run, 2), INERTIA * alpha - 1.25, 1e-9);
}

static void test_gears(void)
{
    check_gear("false", -1);
    check_gear("true", 1);
}

/* The arm turns at n about a sun that stands still: the planet turns at n (1 + ratio) (Willis). */
static void test_planetary(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .columns = "Disc 0.angle, Bar 0.angle, Disc 0.x"},
        GROUND "{'type': 'bar', 'length': 2, 'position': [1, 0], 'velocity': [0, 0.7], 'angular_velocity': 0.7}, " DISC
               "'position': [2, 0], 'velocity': [0, 1.4], 'angular_velocity': 2.1},"
               "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]},"
               "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [1, 0]}, 'Disc 0']},"
               "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 0.7},"
               "{'type': 'gear', 'ends': ['Support 0', 'Disc 0', 'Bar 0'], 'ratio': 2}");
    physics_assert_near("planet", physics_last(run, 0), 3 * 0.7 * 3, 1e-9);
    physics_assert_near("arm", physics_last(run, 1), 0.7 * 3, 1e-9);
    physics_assert_near("centre", physics_last(run, 2), 2 * cos(2.1), 1e-9);
}

/* A falling rack of m on a pinion of I = m' R^2 / 2: a = g / (1 + I / (m R^2)). */
static void test_rack(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.5, .columns = "Box 0.y, Disc 0.angle, Rack 0.torque"}, GRAVITY GROUND DISC
        "'position': [0, 0]}, {'type': 'box', 'mass': 4, 'position': [0.9, 0], 'solid': false}, " AXLE
        "{'type': 'slider', 'ends': [{'block': 'Support 0', 'at': [0.9, 0]}, 'Box 0'], 'angle': "
        "1.5707963267948966},"
        "{'type': 'rack', 'ends': ['Disc 0', 'Box 0'], 'radius': 0.5, 'angle': "
        "1.5707963267948966}");
    const double a = G / (1 + INERTIA / (4 * 0.25));
    physics_assert_near("fallen", physics_last(run, 0), -0.5 * a * 2.25, 1e-8);
    physics_assert_near("turned", physics_last(run, 1), -a * 2.25, 1e-8);
    physics_assert_near("torque", physics_last(run, 2), -INERTIA * a / 0.5, 1e-8);
}

/* theta = start + n t + u(t) - u(0); the torque is I theta'' + m g (L / 2) cos theta, and its work what motors gave. */
static void test_drive(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 2, .tolerance = 1e-11, .columns = "Bar 0.angle, Drive 0.torque, Bar 0.angular velocity"},
        GRAVITY GROUND
        "{'type': 'bar', 'mass': 3, 'length': 2, 'position': [1, 0]},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]},"
        "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 2, 'waveform': 'cosine', 'amplitude': 0.3,"
        " 'frequency': 5}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i), angle = 2 * t + 0.3 * (cos(5 * t) - 1);
        physics_assert_near("angle", physics_value(run, i, 0), angle, 1e-9);
        physics_assert_near("torque", physics_value(run, i, 1), -4 * 7.5 * cos(5 * t) + 3 * G * cos(angle), 1e-7);
        physics_assert_near("rate", physics_value(run, i, 2), 2 - 1.5 * sin(5 * t), 1e-9);
    }
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-7);
}

/* A bead in the slot of what turns evenly: r = r0 cosh w t, pressed by 2 m w r'. */
static void check_bead(const char *turning, const char *on)
{
    g_autofree char *blocks = g_strdup_printf(
        GROUND "%s {'type': 'mass', 'mass': 0.5, 'position': [0.2, 0], 'velocity': [0, 0.3], 'width': 0, 'height': 0},"
               "{'type': 'slot', 'ends': ['%s', 'Mass 0']}",
        turning, on);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2, .tolerance = 1e-11, .columns = "Mass 0.x, Mass 0.y, Slot 0.force"},
                    "%s", blocks);
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i), r = 0.2 * cosh(1.5 * t);
        physics_assert_near("x", physics_value(run, i, 0), r * cos(1.5 * t), 1e-8);
        physics_assert_near("y", physics_value(run, i, 1), r * sin(1.5 * t), 1e-8);
        physics_assert_near("force", physics_value(run, i, 2), 2 * 0.5 * 1.5 * 0.2 * 1.5 * sinh(1.5 * t), 1e-7);
    }
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-7);
}

static void test_slot(void)
{
    check_bead(
        "{'type': 'bar', 'position': [0, 0], 'angular_velocity': 1.5}, {'type': 'pin', 'ends': ['Support 0', 'Bar 0']},"
        "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 1.5},",
        "Bar 0");
    check_bead("{'type': 'support-turn', 'ends': ['Support 0'], 'waveform': {'expression': '1.5*t'}},", "Support 0");
}

/* A bead in the slot of a driven bar comes to 400 m from what turns, where an angle's last digit is a way of 1e-13 m,
 * far beyond what the row measured at first. */
static void test_flung_bead(void)
{
    static const char *const methods[] = {"dop853", "rk4", "verlet6", "newmark"};
    const double of_methods[] = {1e-8, 1e-7, 1e-9, 1e-2}, r = 0.1 * cosh(2 * 4.5);
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[i],
                              .duration = 4.5,
                              .step = 1e-3,
                              .tolerance = 1e-11,
                              .columns = "Mass 0.x, Mass 0.y"},
            GROUND "{'type': 'bar', 'position': [0, 0], 'length': 4, 'angular_velocity': 2},"
                   "{'type': 'pin', 'ends': ['Support 0', 'Bar 0']}, {'type': 'drive', 'ends': ['Bar 0', 'Support 0'], "
                   "'speed': 2}, {'type': 'mass', 'position': [0.1, 0], 'velocity': [0, 0.2], 'width': 0, 'height': 0},"
                   "{'type': 'slot', 'ends': ['Bar 0', 'Mass 0']}");
        physics_assert_near("x", physics_last(run, 0) / r, cos(9), of_methods[i]);
        physics_assert_near("y", physics_last(run, 1) / r, sin(9), of_methods[i]);
    }
}

/* x = r cos theta + (l^2 - r^2 sin^2 theta)^1/2, and the piston does not turn. */
static void test_slider_crank(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 5, .tolerance = 1e-11, .columns = "Box 0.x, Box 0.angle, Box 0.y"}, GRAVITY GROUND
        "{'type': 'bar', 'length': 1, 'position': [0.5, 0], 'velocity': [0, 1], 'angular_velocity': 2},"
        "{'type': 'bar', 'length': 3, 'position': [2.5, 0], 'velocity': [0, 1], 'angular_velocity': "
        "-0.6666666666666666},"
        "{'type': 'box', 'position': [4, 0], 'solid': false},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, {'block': 'Bar 1', 'at': [-1.5, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Bar 1', 'at': [1.5, 0]}, 'Box 0']},"
        "{'type': 'slider', 'ends': ['Support 0', 'Box 0']},"
        "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 2}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double angle = 2 * physics_time(run, i), s = sin(angle);
        physics_assert_near("x", physics_value(run, i, 0), cos(angle) + sqrt(9 - s * s), 1e-9);
        physics_assert_near("angle", physics_value(run, i, 1), 0, 1e-12);
        physics_assert_near("y", physics_value(run, i, 2), 0, 1e-12);
    }
}

/* Two bars welded end to end swing as the one of their length. */
static void test_weld(void)
{
    g_autoptr(PhysicsRun) two = physics_run(
        &(PhysicsOptions){.duration = 4, .tolerance = 1e-12, .columns = "Bar 0.angle, Weld 0.torque"}, GRAVITY GROUND
        "{'type': 'bar', 'length': 1, 'position': [0.5, 0]}, {'type': 'bar', 'length': 1, 'position': [1.5, 0]},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"
        "{'type': 'weld', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, {'block': 'Bar 1', 'at': [-0.5, 0]}]}");
    g_autoptr(PhysicsRun) one =
        physics_run(&(PhysicsOptions){.duration = 4, .tolerance = 1e-12, .columns = "Bar 0.angle"},
                    GRAVITY GROUND "{'type': 'bar', 'length': 2, 'mass': 2, 'position': [1, 0]},"
                                   "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]}");
    physics_assert_near("angle", physics_last(two, 0), physics_last(one, 0), 1e-9);
    /* bending at the middle of a bar that is let go level, m g L / 32: the outer half lags, as a chimney's does */
    physics_assert_near("bending", physics_value(two, 0, 1), 2 * G * 2 / 32, 1e-9);
}

/* With a mass, which has no angle, a weld is a pin. */
static void test_weld_to_a_mass(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 1, .columns = "Bar 0.angle, Weld 0.torque"},
                                            "{'type': 'bar', 'position': [0, 0], 'length': 2, 'angular_velocity': 2, "
                                            "'mass': 1}, {'type': 'mass', 'width': 0, 'height': 0},"
                                            "{'type': 'weld', 'ends': ['Bar 0', 'Mass 0']}");
    physics_assert_near("angle", physics_last(run, 0), 2, 1e-12);
    physics_assert_near("torque", physics_last(run, 1), 0, 0);
    TinkerModelSizes sizes = tinker_model_sizes(run->model);
    g_assert_cmpint(sizes.degrees_of_freedom, ==, 3);
    g_assert_cmpint(sizes.constraint_rows, ==, 2);
    g_assert_cmpint(sizes.redundant_rows, ==, 0);
}

/* A mass has no angle: what a slider holds of it is one row, not one of two that are redundant. */
static void test_slider_with_a_mass(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Mass 0.x, Slider 0.force y, Slider 0.torque"},
                    GRAVITY GROUND "{'type': 'mass', 'mass': 3, 'width': 0, 'height': 0, 'velocity': [2, 0]},"
                                   "{'type': 'slider', 'ends': ['Support 0', 'Mass 0']}");
    physics_assert_near("place", physics_last(run, 0), 2, 1e-12);
    physics_assert_near("force", fabs(physics_last(run, 1)), 3 * G, 1e-12);
    physics_assert_near("moment about the support", fabs(physics_last(run, 2)), 3 * G * 2, 1e-11);
    TinkerModelSizes sizes = tinker_model_sizes(run->model);
    g_assert_cmpint(sizes.degrees_of_freedom, ==, 1);
    g_assert_cmpint(sizes.constraint_rows, ==, 1);
    g_assert_cmpint(sizes.redundant_rows, ==, 0);
    g_autoptr(PhysicsRun) cart =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Mass 0.vx"}, GRAVITY GROUND
                    "{'type': 'mass', 'velocity': [1, 0]}, {'type': 'slider', 'ends': ['Support 0', 'Mass 0']},"
                    "{'type': 'bar', 'position': [0, -0.5], 'orientation': -1.5707963267948966, 'velocity': [1, 0]},"
                    "{'type': 'weld', 'ends': ['Mass 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    g_assert_cmpint(tinker_model_sizes(cart->model).degrees_of_freedom, ==, 2);
    physics_assert_near("speed of a cart below which a bar hangs", physics_last(cart, 0), 1, 1e-12);
}

/* A jet along a body that turns evenly: v = F / (m w) (sin w t, 1 - cos w t). */
static void test_follower(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 3, .tolerance = 1e-11, .columns = "Disc 0.vx, Disc 0.vy"},
                    DISC "'position': [0, 0], 'angular_velocity': 2}, {'type': 'motor', 'ends': ['Disc 0'], "
                         "'amplitude': 5, 'frequency': 0,"
                         " 'follows': true}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double turned = 2 * physics_time(run, i);
        physics_assert_near("vx", physics_value(run, i, 0), 5 / 4.0 * sin(turned), 1e-9);
        physics_assert_near("vy", physics_value(run, i, 1), 5 / 4.0 * (1 - cos(turned)), 1e-9);
    }
}

/* What nobody said of how fast bodies start, a drive may say without a word; what was said it changes with one. */
static void test_drive_starts(void)
{
    static const struct {
        const char *said;
        guint warnings;
    } rows[] = {{"", 0}, {", 'angular_velocity': 3", 0}, {", 'angular_velocity': 0", 1}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.columns = "Disc 0.angular velocity"},
            GROUND
            "{'type': 'disc', 'position': [0, 0], 'mass': 4%s}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
            "{'type': 'drive', 'ends': ['Disc 0', 'Support 0'], 'speed': 3}",
            rows[i].said);
        physics_assert_near("rate", physics_value(run, 0, 0), 3, 1e-14);
        g_assert_cmpuint(run->summary->warnings->len, ==, rows[i].warnings);
        g_assert_cmpuint(run->summary->events->len, ==, rows[i].warnings);
    }
}

/* Two drives that part at 0.5 s: what they miss is an angle. */
static void test_misses_in_radians(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){.duration = 1}, GROUND
                    "{'type': 'disc', 'position': [0, 0], 'mass': 4}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                    "{'type': 'drive', 'ends': ['Disc 0', 'Support 0'], 'speed': 3},"
                    "{'type': 'drive', 'ends': ['Disc 0', 'Support 0'], 'speed': 3, 'waveform': {'expression': "
                    "'0.1*max(t - 0.5, 0)^3'}}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Drive ", "it misses by ", " rad (", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/joints/torsional-spring", test_torsional_spring);
    g_test_add_func("/joints/as-placed", test_as_placed);
    g_test_add_func("/joints/torsional-damper", test_torsional_damper);
    g_test_add_func("/joints/torque", test_torque);
    g_test_add_func("/joints/gears", test_gears);
    g_test_add_func("/joints/planetary", test_planetary);
    g_test_add_func("/joints/rack", test_rack);
    g_test_add_func("/joints/drive", test_drive);
    g_test_add_func("/joints/drive-starts", test_drive_starts);
    g_test_add_func("/joints/misses-in-radians", test_misses_in_radians);
    g_test_add_func("/joints/slot", test_slot);
    g_test_add_func("/joints/flung-bead", test_flung_bead);
    g_test_add_func("/joints/slider-crank", test_slider_crank);
    g_test_add_func("/joints/weld", test_weld);
    g_test_add_func("/joints/weld-to-a-mass", test_weld_to_a_mass);
    g_test_add_func("/joints/slider-with-a-mass", test_slider_with_a_mass);
    g_test_add_func("/joints/follower", test_follower);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
