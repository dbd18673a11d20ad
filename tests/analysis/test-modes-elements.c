/* Modes by dampers, springs under pressure and elements of other laws, against closed forms. */
#include <math.h>

#include "modes-fixture.h"

/* Masses of 1 kg on 1 N/m to a wall each and 1 N/m between, a damper of 0.5 N s/m on the first alone: the roots of
 * (s^2 + s/2 + 2)(s^2 + 2) = 1, the quartic s^4 + s^3/2 + 4 s^2 + s + 3 = 0, checked by putting them in. Likewise an
 * absorber: the product of all |s| is that of all undamped omega. */
static void test_damped_two_masses(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
                         "{'type': 'support', 'position': [3, 0]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1},"
                         "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.5},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1},"
                         "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'stiffness': 1}");
    g_assert_cmpuint(modes_count(a, TINKER_MODE_OSCILLATION), ==, 2);
    double sum = 0, product = 1;
    for (guint i = 2; i < 4; i++) {
        const TinkerMode *mode = modes_at(a, i);
        /* of s^2 + 2 d s + n^2, divided out of the quartic: the rest is 0 */
        double p = 2 * mode->decay, n = mode->natural * mode->natural;
        double first = 0.5 - p, second = 4 - n - p * first;
        g_assert_cmpfloat_with_epsilon(1 - n * first - p * second, 0, 1e-12);
        g_assert_cmpfloat_with_epsilon(3 - n * second, 0, 1e-12);
        sum += p;
        product *= n;
        g_assert_false(tinker_mode_is_standing(mode, a->analysis->basis->size));
    }
    g_assert_cmpfloat_with_epsilon(sum, 0.5, 1e-13);
    g_assert_cmpfloat_with_epsilon(product, 3, 1e-12);
}

/* A damper between two masses alone in space: both drift, and their distance decays as c (1/m1 + 1/m2). */
static void test_free_damper(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'mass', 'mass': 2, 'position': [0, 0]}, {'type': 'mass', 'mass': 3, 'position': [1, 0]},"
        "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 6}");
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 4);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_DECAY), ==, 1);
    modes_assert_relative("decay", modes_at(a, 4)->decay, 6 * (1 / 2.0 + 1 / 3.0), 1e-13);
}

/* A mass pressed between two springs, 0.2 m each over the straight place: along it 2 k, across it -2 T / L = -2 k 0.2
 * / 1. */
static void test_pressed_springs(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'support', 'position': [-1, 0]}, {'type': 'support', 'position': [1, 0]},"
                         "{'type': 'mass', 'position': [0, 0]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 100, 'rest_length': 1.2},"
                         "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 100, 'rest_length': 1.2}");
    modes_assert_relative("growth", tinker_modes_growth(a->analysis->modes), sqrt(40), 1e-12);
    modes_assert_frequencies(a, (double[]){sqrt(200)}, 1);
}

/* A stretched spring beside a rod pulls against it, and moves nothing: the pair drifts and turns. */
static void test_spring_beside_rod(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'mass', 'mass': 0.07, 'position': [5.48, -0.11]},"
                         "{'type': 'mass', 'mass': 0.11, 'position': [2.1, 3.08]},"
                         "{'type': 'spring', 'ends': ['Mass 1', 'Mass 0'], 'stiffness': 4191.9, 'rest_length': 2.94},"
                         "{'type': 'damper', 'ends': ['Mass 1', 'Mass 0'], 'damping': 11.8},"
                         "{'type': 'rod', 'ends': ['Mass 1', 'Mass 0']}");
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 3);
    g_assert_cmpuint(a->analysis->modes->len, ==, 3);
}

/* Blocks that are no lines, by differences. */
static void assert_roughly(const ModesFixture *a, guint place, double truth)
{
    modes_assert_relative("frequency", modes_at(a, place)->natural, truth, 1e-8);
}

/* A torsional spring of 10 N m at the foot of a rod of 2 m with 3 kg: omega^2 = k / (m L^2). */
static void test_torsion(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'support', 'position': [0, 0]}, {'type': 'support', 'position': [1, 0]},"
                         "{'type': 'mass', 'mass': 3, 'position': [2, 0]},"
                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                         "{'type': 'torsion', 'ends': ['Support 1', 'Support 0', 'Mass 0'], 'stiffness': 10}");
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
    assert_roughly(a, 0, sqrt(10.0 / 12));
}

/* A mass on a cubic spring hangs where k s^3 = m g: it bounces as 3 k s^2 / m and swings as g / (l + s). */
static void test_cubic(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'gravity', 'acceleration': 8}, {'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'mass': 10, 'position': [0, -1.5]},"
                         "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 10, 'length': 1}");
    assert_roughly(a, 0, sqrt(8.0 / 3));
    assert_roughly(a, 1, sqrt(3 * 10 * 4.0 / 10));
}

/* Two masses that attract each other, held apart by a spring: G m^2 / r^2 = k (l - r). Their distance swings with the
 * reduced mass on k - 2 G m^2 / r^3; all else is free. */
static void test_attraction(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'mass', 'mass': 2, 'position': [0, 0]},"
                         "{'type': 'mass', 'mass': 2, 'position': [1, 0]}, {'type': 'attraction', 'strength': 1},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 20, 'rest_length': 1.2}");
    g_assert_cmpuint(modes_count(a, TINKER_MODE_OSCILLATION), ==, 1);
    assert_roughly(a, 3, sqrt(20 - 8));
}

/* A force across the velocity, as of a charge in a magnetic field, does no work: what is held by a spring of k per mass
 * on all sides circles at sqrt(c^2 / 4 + k) -+ c / 2, and neither circle grows or dies away. */
static void test_across_velocity(void)
{
    static const double turns[] = {2, 0.37, 1e-3, 30};
    for (gsize i = 0; i < G_N_ELEMENTS(turns); i++) {
        const double c = turns[i], k = 4, middle = sqrt(0.25 * c * c + k);
        g_autofree char *blocks = g_strdup_printf("{'type': 'mass'}, {'type': 'law-force', 'ends': ['Mass 0'],"
                                                  "'force_x': '%g*vy-4*x', 'force_y': '-%g*vx-4*y'}",
                                                  c, c);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        modes_assert_relative("slow", modes_at(a, 0)->natural, k / (middle + 0.5 * c), 1e-9);
        modes_assert_relative("fast", modes_at(a, 1)->natural, middle + 0.5 * c, 1e-9);
        g_assert_cmpfloat(tinker_modes_growth(a->analysis->modes), ==, 0);
        g_assert_cmpfloat(modes_at(a, 1)->decay, ==, 0);
    }
}

static void add_tests(void)
{
    g_test_add_func("/modes/across-velocity", test_across_velocity);
    g_test_add_func("/modes/damped-two-masses", test_damped_two_masses);
    g_test_add_func("/modes/free-damper", test_free_damper);
    g_test_add_func("/modes/pressed-springs", test_pressed_springs);
    g_test_add_func("/modes/spring-beside-rod", test_spring_beside_rod);
    g_test_add_func("/modes/torsion", test_torsion);
    g_test_add_func("/modes/cubic", test_cubic);
    g_test_add_func("/modes/attraction", test_attraction);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
