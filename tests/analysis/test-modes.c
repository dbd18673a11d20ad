/* Natural frequencies, damping ratios and shapes against closed forms. Lengths, masses and stiffnesses are chosen so
 * that rounding in the text of a scene plays no part. */
#include <math.h>
#include <string.h>

#include "modes-fixture.h"

/* A mass of 2 kg on 50 N/m and 4 N s/m: omega = 5, zeta = 4 / (2 * 2 * 5) = 0.2. Across the line nothing holds it. */
static void test_single_oscillator(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'support', 'position': [0, 0]},"
                                                 "{'type': 'mass', 'mass': 2, 'position': [1, 0]},"
                                                 "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50},"
                                                 "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 4}");
    g_assert_cmpuint(a->analysis->modes->len, ==, 2);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 1);
    const TinkerMode *mode = modes_at(a, 1);
    modes_assert_relative("frequency", mode->natural, 5, 1e-14);
    modes_assert_relative("damped frequency", mode->frequency, 5 * sqrt(1 - 0.04), 1e-14);
    modes_assert_relative("damping ratio", mode->damping_ratio, 0.2, 1e-14);
    modes_assert_relative("decay", mode->decay, 1, 1e-14);
    g_assert_cmpfloat(mode->real[0], ==, 1);
    g_assert_cmpfloat_with_epsilon(mode->real[1], 0, 1e-14);
}

/* s^2 + 12 s + 4 = 0 has the roots -6 +- sqrt(32); with 4 s both are -2. */
static void test_overdamped_oscillator(void)
{
    static const struct {
        double damping, slow, fast;
    } rows[] = {{12, 4 / (6 + 5.656854249492380195), 6 + 5.656854249492380195}, {4, 2, 2}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [1, 0]},"
                            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 4},"
                            "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': %g}",
                            rows[i].damping);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        g_assert_cmpuint(modes_count(a, TINKER_MODE_DECAY), ==, 2);
        modes_assert_relative("slow decay", modes_at(a, 1)->decay, rows[i].slow, 1e-14);
        modes_assert_relative("fast decay", modes_at(a, 2)->decay, rows[i].fast, 1e-14);
        modes_assert_relative("damping ratio", modes_at(a, 1)->damping_ratio, rows[i].damping / 4, 1e-14);
    }
}

/* Wall, 1 kg, 1 kg on springs of 3, 2 and 3 N/m between two walls: 3 and 7 s^-2, in step and in counterstep. */
static void test_two_masses(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
                         "{'type': 'support', 'position': [3, 0]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2},"
                         "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'stiffness': 3}");
    modes_assert_frequencies(a, (double[]){sqrt(3), sqrt(7)}, 2);
    const TinkerMode *together = modes_at(a, 2), *against = modes_at(a, 3);
    g_assert_cmpfloat_with_epsilon(together->real[2], 1, 1e-12);
    g_assert_cmpfloat_with_epsilon(against->real[2], -1, 1e-12);
}

static void add_format(GString *blocks, const char *format, ...) G_GNUC_PRINTF(2, 3);
static void add_format(GString *blocks, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (blocks->len > 0) g_string_append(blocks, ", ");
    g_string_append_vprintf(blocks, format, arguments);
    va_end(arguments);
}

/* n masses in a row. Both ends held: 2 sqrt(k/m) sin(j pi / (2 (n + 1))), j = 1..n. Both free: 2 sqrt(k/m) sin(j pi /
 * (2 n)), j = 0..n-1. */
static void test_chain(gconstpointer data)
{
    const gboolean is_free = GPOINTER_TO_INT(data);
    enum { N = 12 };
    g_autoptr(GString) blocks = g_string_new(NULL);
    double truth[N];
    for (int i = 1; i <= N; i++)
        add_format(blocks, "{'type': 'mass', 'name': 'M%d', 'mass': 0.5, 'position': [%d, 0]}", i, i);
    for (int i = 1; i < N; i++)
        add_format(blocks, "{'type': 'spring', 'ends': ['M%d', 'M%d'], 'stiffness': 200}", i, i + 1);
    if (!is_free) {
        add_format(blocks, "{'type': 'support', 'name': 'A', 'position': [0, 0]}");
        add_format(blocks, "{'type': 'support', 'name': 'B', 'position': [%d, 0]}", N + 1);
        add_format(blocks, "{'type': 'spring', 'ends': ['A', 'M1'], 'stiffness': 200}");
        add_format(blocks, "{'type': 'spring', 'ends': ['M%d', 'B'], 'stiffness': 200}", N);
    }
    for (int j = 1; j <= N; j++)
        truth[j - 1] = 2 * 20 * sin(j * G_PI / (2.0 * (is_free ? N : N + 1)));
    g_autoptr(ModesFixture) a = modes_about_rest(blocks->str);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, is_free ? N + 1 : N);
    modes_assert_frequencies(a, truth, is_free ? N - 1 : N);
}

/* From 30 degrees it is brought to hang: sqrt(g / L). Above its support it falls over: the growth rate is the same. */
static void test_pendulum(void)
{
    g_autoptr(ModesFixture) hangs =
        modes_about_rest("{'type': 'gravity', 'acceleration': 9},"
                         "{'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'mass': 3, 'position': [2, -3.4641016151377544]},"
                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    modes_assert_frequencies(hangs, (double[]){1.5}, 1);
    g_assert_cmpuint(hangs->analysis->modes->len, ==, 1);
    g_assert_cmpfloat_with_epsilon(fabs(modes_at(hangs, 0)->real[1]), 0, 1e-10);
    g_autoptr(ModesFixture) stands = modes_about_rest("{'type': 'gravity', 'acceleration': 9},"
                                                      "{'type': 'support', 'position': [0, 0]},"
                                                      "{'type': 'mass', 'mass': 3, 'position': [0, 4]},"
                                                      "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    g_assert_cmpuint(modes_count(stands, TINKER_MODE_GROWTH), ==, 1);
    modes_assert_relative("growth", tinker_modes_growth(stands->analysis->modes), 1.5, 1e-10);
}

/* Equal masses on equal rods: omega^2 = g / L (2 +- sqrt 2). From a bent start. */
static void test_double_pendulum(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'gravity', 'acceleration': 9.81},"
                         "{'type': 'support', 'position': [0, 0], 'solid': false},"
                         "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [1, 1]},"
                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1},"
                         "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1'], 'length': 1}");
    modes_assert_frequencies(a, (double[]){sqrt(9.81 * (2 - G_SQRT2)), sqrt(9.81 * (2 + G_SQRT2))}, 2);
    g_assert_cmpfloat_with_epsilon(a->analysis->q[1] - a->analysis->q[3], 1, 1e-10);
}

/* Two pendulums and a spring between them: g / L, and g / L + 2 k / m. */
static void test_coupled_pendulums(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest("{'type': 'gravity', 'acceleration': 9.81},"
                         "{'type': 'support', 'position': [0, 0], 'width': 3},"
                         "{'type': 'mass', 'mass': 2, 'position': [-1, -2]},"
                         "{'type': 'mass', 'mass': 2, 'position': [1, -2]},"
                         "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [-1, 0]}, 'Mass 0']},"
                         "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [1, 0]}, 'Mass 1']},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 7}");
    modes_assert_frequencies(a, (double[]){sqrt(9.81 / 2), sqrt(9.81 / 2 + 7)}, 2);
}

/* A bar of two masses on two parallel rods (bifilar: it stays level) swings as sqrt(g / L); a third rod changes
 * nothing. */
static void test_parallelogram(gconstpointer data)
{
    const char *blocks = "{'type': 'gravity', 'acceleration': 9.81},"
                         "{'type': 'support', 'position': [0, 0], 'width': 3},"
                         "{'type': 'mass', 'mass': 2, 'position': [-0.4, -2.3]},"
                         "{'type': 'mass', 'mass': 5, 'position': [1.6, -2.3]},"
                         "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [-1, 0]}, 'Mass 0']},"
                         "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [1, 0]}, 'Mass 1']},"
                         "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}";
    g_autofree char *redundant = g_strconcat(blocks, ", {'type': 'rod', 'ends': ['Mass 1', 'Mass 0']}", NULL);
    g_autoptr(ModesFixture) a = modes_about_rest(data == NULL ? blocks : redundant);
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
    modes_assert_frequencies(a, (double[]){sqrt(9.81 / hypot(0.6, 2.3))}, 1);
}

/* A mass hung on a spring: bounces as sqrt(k / m), swings as sqrt(g / L) with the length that it hangs at. */
static void test_hanging_spring(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'gravity', 'acceleration': 9.81},"
                                                 "{'type': 'support', 'position': [0, 0]},"
                                                 "{'type': 'mass', 'mass': 2, 'position': [0.3, -1]},"
                                                 "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80,"
                                                 " 'rest_length': 1}");
    double length = 1 + 2 * 9.81 / 80;
    modes_assert_frequencies(a, (double[]){sqrt(9.81 / length), sqrt(40)}, 2);
    const TinkerMode *swing = modes_at(a, 0), *bounce = modes_at(a, 1);
    g_assert_cmpfloat_with_epsilon(swing->real[0], 1, 1e-12);
    g_assert_cmpfloat_with_epsilon(bounce->real[1], 1, 1e-12);
}

/* Springs of 1 and 1e12 N/m, 1 kg each: with r = 1e-12, omega^2 / 1e12 = 1 + r/2 -+ sqrt(1 + r^2/4), whose lesser root
 * is r / (1 + r/2 + sqrt(1 + r^2/4)). Masses of 1e9 and 1 kg as well. */
static void test_extreme_ratios(void)
{
    const char *format = "{'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'mass': %g, 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': %g}";
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    g_autofree char *stiff = g_strdup_printf(format, 1.0, 1e12), *heavy = g_strdup_printf(format, 1e9, 1e-6);
#pragma GCC diagnostic pop
    double r = 1e-12, root = sqrt(1 + r * r / 4);
    g_autoptr(ModesFixture) a = modes_about_rest(stiff);
    modes_assert_frequencies(a, (double[]){sqrt(1e12 * r / (1 + r / 2 + root)), sqrt(1e12 * (1 + r / 2 + root))}, 2);
    /* lambda^2 - ((k1 + k2) / m1 + k2 / m2) lambda + k1 k2 / (m1 m2) = 0 */
    double b = (1 + 1e-6) / 1e9 + 1e-6, c = 1e-6 / 1e9, greater = (b + sqrt(b * b - 4 * c)) / 2;
    g_autoptr(ModesFixture) h = modes_about_rest(heavy);
    modes_assert_frequencies(h, (double[]){sqrt(c / greater), sqrt(greater)}, 2);
}

/* The same in millimetres, in kilometres, and far from the origin, with gravity to scale: the same frequencies. */
static void test_scales(void)
{
    static const double scales[][2] = {{1e-3, 0}, {1, 0}, {1e3, 0}, {1, 1e6}};
    for (gsize i = 0; i < G_N_ELEMENTS(scales); i++) {
        double u = scales[i][0], x = scales[i][1];
        g_autofree char *blocks = g_strdup_printf(
            "{'type': 'gravity', 'acceleration': %.17g}, {'type': 'support', 'position': [%.17g, 0], 'solid': false},"
            "{'type': 'mass', 'position': [%.17g, 0]}, {'type': 'mass', 'position': [%.17g, %.17g]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
            9.81 * u, x, x + u, x + u, u);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        modes_assert_frequencies(a, (double[]){sqrt(9.81 * (2 - G_SQRT2)), sqrt(9.81 * (2 + G_SQRT2))}, 2);
    }
}

/* In free fall there is no rest, and it says so; the modes are those of the start. */
static void test_no_rest(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'gravity'}, {'type': 'mass'}");
    g_assert_false(a->analysis->about_rest);
    g_assert_nonnull(strstr(a->analysis->rest.why, "nothing holds it"));
    g_assert_cmpfloat(a->analysis->rest.unbalanced, >, 9);
    g_assert_cmpuint(modes_count(a, TINKER_MODE_RIGID), ==, 2);
}

/* Held 60 degrees aside, a pendulum's rod pulls with m g cos 60: omega^2 = g cos 60 / L. */
static void test_given_state(void)
{
    g_autoptr(ModesFixture) a = modes_fixture_new(FALSE, "{'type': 'gravity', 'acceleration': 8},"
                                                         "{'type': 'support', 'position': [0, 0]},"
                                                         "{'type': 'mass', 'position': [0.8660254037844386, -0.5]},"
                                                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    modes_assert_frequencies(a, (double[]){2}, 1);
    g_assert_false(a->analysis->about_rest);
}

static void add_tests(void)
{
    g_test_add_func("/modes/single-oscillator", test_single_oscillator);
    g_test_add_func("/modes/overdamped-oscillator", test_overdamped_oscillator);
    g_test_add_func("/modes/two-masses", test_two_masses);
    g_test_add_data_func("/modes/chain/held", GINT_TO_POINTER(FALSE), test_chain);
    g_test_add_data_func("/modes/chain/free", GINT_TO_POINTER(TRUE), test_chain);
    g_test_add_func("/modes/pendulum", test_pendulum);
    g_test_add_func("/modes/double-pendulum", test_double_pendulum);
    g_test_add_func("/modes/coupled-pendulums", test_coupled_pendulums);
    g_test_add_data_func("/modes/parallelogram/plain", NULL, test_parallelogram);
    g_test_add_data_func("/modes/parallelogram/redundant", "redundant", test_parallelogram);
    g_test_add_func("/modes/hanging-spring", test_hanging_spring);
    g_test_add_func("/modes/extreme-ratios", test_extreme_ratios);
    g_test_add_func("/modes/no-rest", test_no_rest);
    g_test_add_func("/modes/given-state", test_given_state);
    g_test_add_func("/modes/scales", test_scales);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
