/* Modes of bodies that turn, against closed forms. */
#include <math.h>
#include <string.h>

#include "modes-fixture.h"

/* A straight bar of three masses on rods in one line, from 1 rad off: it swings as a whole, sqrt(g sum m x / sum m
 * x^2). */
/* Bars on pins: one swings with omega^2 = 3 g / 2 L, two equal ones with (3 -+ 6 / sqrt 7) g / L. */
static void test_bars(void)
{
    g_autoptr(ModesFixture) one =
        modes_about_rest("{'type': 'gravity', 'acceleration': 9.75}, {'type': 'support'},"
                         "{'type': 'bar', 'length': 1.5, 'position': [0.75, 0]},"
                         "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.75, 0]}]}");
    modes_assert_frequencies(one, (const double[]){sqrt(9.75)}, 1);
    g_autoptr(ModesFixture) two = modes_about_rest(
        "{'type': 'gravity', 'acceleration': 9.75}, {'type': 'support'},"
        "{'type': 'bar', 'length': 1.5, 'position': [0, -0.75], 'orientation': '-90 deg'},"
        "{'type': 'bar', 'length': 1.5, 'position': [0, -2.25], 'orientation': '-90 deg'},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.75, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.75, 0]}, {'block': 'Bar 1', 'at': [-0.75, 0]}]}");
    modes_assert_frequencies(two, (const double[]){sqrt((3 - 6 / sqrt(7)) * 6.5), sqrt((3 + 6 / sqrt(7)) * 6.5)}, 2);
}

/* A bar on an upright spring at each end bounces with 2 k / m and pitches with 6 k / m; sideways nothing holds it. */
static void test_bar_on_springs(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support', 'position': [-1, -1], 'solid': false}, {'type': 'support', 'position': [1, -1], "
        "'solid': false},"
        "{'type': 'bar', 'position': [0, 0], 'mass': 4, 'length': 2},"
        "{'type': 'spring', 'stiffness': 50, 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]},"
        "{'type': 'spring', 'stiffness': 50, 'ends': [{'block': 'Bar 0', 'at': [1, 0]}, 'Support 1']}");
    modes_assert_frequencies(a, (const double[]){5, sqrt(75)}, 2);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 1);
}

/* A bar on a pin in its middle, with a stretched spring at its end, is brought back by T r (1 + r / L), whatever else
 * acts: as the arm turns the pull's moment changes once, beside a block that is made linear by differences, too. */
static void test_turned_arm(void)
{
    static const char *const beside[] = {
        "", ", {'type': 'torsional-damper', 'damping': 0.2, 'ends': ['Support 0', 'Bar 0']}",
        ", {'type': 'wind', 'drag_quadratic': 0.3}",
        ", {'type': 'law-force', 'force_x': '-0.1*vx', 'ends': ['Bar 0']}"};
    for (gsize i = 0; i < G_N_ELEMENTS(beside); i++) {
        g_autofree char *blocks = g_strconcat(
            "{'type': 'support', 'solid': false}, {'type': 'support', 'position': [2, 0], 'solid': false},"
            "{'type': 'bar', 'position': [0, 0], 'length': 1, 'orientation': 0.4},"
            "{'type': 'pin', 'ends': ['Support 0', 'Bar 0']},"
            "{'type': 'spring', 'stiffness': 10, 'rest_length': 1, 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, "
            "'Support 1']}",
            beside[i], NULL);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        modes_assert_frequencies(a, (const double[]){sqrt(5 * 0.5 * (1 + 0.5 / 1.5) * 12)}, 1);
        modes_assert_relative("decay", modes_at(a, 0)->decay, i == 1 ? 0.1 * 12 : 0, 1e-9);
    }
}

/* A mass at the end of a rod on which nothing pulls turns freely about the other: rounding of the search for the rest
 * holds nothing. */
static void test_idle_rod(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support', 'position': [-1.8380624872768896, 0.9309297727238344], 'solid': false},"
        "{'type': 'box', 'position': [1.6807485283952834, 0.8502893120890106], 'orientation': -2.1615252901999265},"
        "{'type': 'mass', 'position': [1.8872462977319824, 0.2062791440126516]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Box 0']},"
        "{'type': 'spring', 'stiffness': 171.78791080449355, 'rest_length': 0.8354082727169947,"
        " 'ends': [{'block': 'Box 0', 'at': [-0.1279398069189268, -0.329518226291715]}, 'Support 0']}");
    g_assert_true(a->analysis->about_rest);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 3);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_OSCILLATION), ==, 1);
}

/* Rounding holds nothing where the scene has a block that is asked for all its derivatives at once, either: the damper
 * of a disc beside such a rod, which turns freely but for it. */
static void test_idle_rod_and_damper(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support', 'name': 'S', 'position': [-1.6660886291220398, 2.782730502334992], 'solid': false},"
        "{'type': 'box', 'name': 'B', 'position': [-1.965822168426633, 1.7386057492876867], 'orientation': "
        "1.2401418795091264},"
        "{'type': 'mass', 'name': 'M', 'position': [2.2003071879029976, -1.0221386380768287]},"
        "{'type': 'rod', 'ends': ['M', 'B']},"
        "{'type': 'spring', 'stiffness': 253.29399405115262, 'rest_length': 0.15801550238107862, 'ends': [{'block': "
        "'B', 'at': [0.3195146493222194, 0.0979616487181093]}, 'S']},"
        "{'type': 'disc', 'name': 'D', 'position': [9, 0], 'solid': false},"
        "{'type': 'support', 'name': 'U', 'position': [9, 0], 'solid': false},"
        "{'type': 'pin', 'ends': ['U', 'D']}, {'type': 'torsional-damper', 'ends': ['U', 'D']}");
    g_assert_true(a->analysis->about_rest);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 4);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_OSCILLATION), ==, 1);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_DECAY), ==, 1);
}

static void test_straight_bar(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'gravity', 'acceleration': 9.81},"
                                                 "{'type': 'support', 'position': [0, 0], 'solid': false},"
                                                 "{'type': 'mass', 'mass': 1, 'position': [0.3, -0.4]},"
                                                 "{'type': 'mass', 'mass': 4, 'position': [0.6, -0.8]},"
                                                 "{'type': 'mass', 'mass': 2, 'position': [0.9, -1.2]},"
                                                 "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                                                 "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                                                 "{'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
                                                 "{'type': 'rod', 'ends': ['Support 0', 'Mass 2']}");
    modes_assert_frequencies(a, (double[]){sqrt(9.81 * (0.5 + 4 + 3) / (0.25 + 4 + 4.5))}, 1);
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
}

/* Two wheels with a spring and a damper between them turn freely together, which no damping takes: one such motion, and
 * against each other with k (1 / I1 + 1 / I2). */
static void test_free_shaft(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support', 'solid': false}, {'type': 'support', 'position': [1, 0], 'solid': false},"
        "{'type': 'disc', 'position': [0, 0], 'inertia': 1, 'solid': false},"
        "{'type': 'disc', 'inertia': 0.7, 'position': [1, 0], 'solid': false},"
        "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'pin', 'ends': ['Support 1', 'Disc 1']},"
        "{'type': 'torsional-spring', 'stiffness': 100, 'ends': ['Disc 0', 'Disc 1']},"
        "{'type': 'torsional-damper', 'damping': 0.5, 'ends': ['Disc 0', 'Disc 1']}");
    modes_assert_frequencies(a, (const double[]){sqrt(100 * (1 + 1 / 0.7))}, 1);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 1);
    g_assert_cmpuint(a->analysis->modes->len, ==, 2);
}

/* Two geared wheels that a torque drives turn freely, whatever force is in their teeth: the gear's row is linear. */
static void test_driven_gears(void)
{
    g_autoptr(ModesFixture) a = modes_fixture_new(
        FALSE, "{'type': 'support', 'solid': false}, {'type': 'support', 'position': [1.2, 0], 'solid': false},"
               "{'type': 'disc', 'position': [0, 0], 'radius': 0.3, 'solid': false},"
               "{'type': 'disc', 'mass': 6, 'radius': 0.9, 'position': [1.2, 0], 'solid': false},"
               "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'pin', 'ends': ['Support 1', 'Disc 1']},"
               "{'type': 'gear', 'ends': ['Disc 0', 'Disc 1'], 'ratio': 0.3333333333333333},"
               "{'type': 'torque', 'ends': ['Disc 0'], 'amplitude': 2}");
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 1);
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
}

/* 401 discs have 1203 coordinates: the refusal counts what there is, and says how many there may be. */
static void test_too_many(void)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}");
    for (int i = 0; i < 401; i++)
        g_string_append_printf(blocks, ", {'type': 'disc', 'solid': false, 'position': [%d, 0]}", i);
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks->str);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_mode_analysis_new(scene, FALSE, &error));
    g_assert_nonnull(strstr(error->message, "1203 coordinates"));
    g_assert_nonnull(strstr(error->message, "400 bodies that turn"));
}

/* Ziegler's column: two bars of length 1 and inertia 0.001 upright on torsional springs of 1 N m/rad, pushed along the
 * upper one by a force P that turns with it. With M = [1.251, 0.5; 0.5, 0.251] and K = [2 - P, P - 1; -1, 1] it is
 * det(K - w M) = 0, w = omega^2. While both roots are real and positive it stands, without any damping. */
static char *column_pushed_by(double force)
{
    return g_strdup_printf(
        "{'type': 'support', 'solid': false},"
        "{'type': 'bar', 'name': 'A', 'position': [0, 0.5], 'orientation': '90 deg', 'inertia': 0.001},"
        "{'type': 'bar', 'name': 'B', 'position': [0, 1.5], 'orientation': '90 deg', 'inertia': 0.001},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'A', 'at': [-0.5, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'A', 'at': [0.5, 0]}, {'block': 'B', 'at': [-0.5, 0]}]},"
        "{'type': 'torsional-spring', 'ends': ['Support 0', 'A']}, {'type': 'torsional-spring', 'ends': ['A', 'B']},"
        "{'type': 'motor', 'ends': [{'block': 'B', 'at': [0.5, 0]}], 'waveform': {'expression': '%g'},"
        "'angle': '180 deg', 'follows': true}",
        force);
}

static void test_pushed_column(void)
{
    const double m[3] = {1.251, 0.5, 0.251}, a = m[0] * m[2] - m[1] * m[1];
    for (double force = 0.25; force < 3.1; force += 0.25) {
        g_autofree char *blocks = column_pushed_by(force);
        g_autoptr(ModesFixture) fixture = modes_about_rest(blocks);
        /* (2 - P - m0 w)(1 - m2 w) - (P - 1 - m1 w)(-1 - m1 w) */
        const double b = -m[0] - (2 - force) * m[2] + (force - 1) * m[1] - m[1], c = 1;
        const double under = b * b - 4 * a * c, growth = tinker_modes_growth(fixture->analysis->modes);
        if (under > 0) {
            const double far = (-b + sqrt(under)) / (2 * a);
            modes_assert_relative("lower", modes_at(fixture, 0)->natural, sqrt(c / (a * far)), 1e-8);
            modes_assert_relative("upper", modes_at(fixture, 1)->natural, sqrt(far), 1e-8);
            g_assert_cmpfloat(growth, ==, 0);
        } else { /* w = u +- i v: omega = x + i y with y^2 = (|w| - u) / 2 */
            const double u = -b / (2 * a), size = sqrt(c / a);
            modes_assert_relative("growth", growth, sqrt((size - u) / 2), 1e-7);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/modes/bars", test_bars);
    g_test_add_func("/modes/bar-on-springs", test_bar_on_springs);
    g_test_add_func("/modes/free-shaft", test_free_shaft);
    g_test_add_func("/modes/driven-gears", test_driven_gears);
    g_test_add_func("/modes/turned-arm", test_turned_arm);
    g_test_add_func("/modes/idle-rod", test_idle_rod);
    g_test_add_func("/modes/idle-rod-and-damper", test_idle_rod_and_damper);
    g_test_add_func("/modes/straight-bar", test_straight_bar);
    g_test_add_func("/modes/pushed-column", test_pushed_column);
    g_test_add_func("/modes/too-many", test_too_many);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
