/* Natural frequencies, damping ratios and shapes against closed forms. Lengths, masses and stiffnesses are chosen so
 * that rounding in the text of a scene plays no part. */
#include <math.h>
#include <string.h>

#include "modes-fixture.h"

/* About rest. (transfer full) */
static ModesFixture *analyse(const char *blocks)
{
    return modes_fixture_new(TRUE, blocks);
}

static const TinkerMode *mode_at(const ModesFixture *a, guint place)
{
    g_assert_cmpuint(place, <, a->analysis->modes->len);
    return g_ptr_array_index(a->analysis->modes, place);
}

static guint count_kind(const ModesFixture *a, TinkerModeKind kind)
{
    guint count = 0;
    for (guint i = 0; i < a->analysis->modes->len; i++)
        count += mode_at(a, i)->kind == kind;
    return count;
}

static void assert_relative(const char *what, double value, double truth, double bound)
{
    if (fabs(value - truth) <= bound * fabs(truth)) return;
    g_test_message("%s: %.17g instead of %.17g, off by %.2e", what, value, truth, value / truth - 1);
    g_test_fail();
}

/* The oscillations, in order, have these natural frequencies (rad/s). */
static void assert_frequencies(const ModesFixture *a, const double *truth, guint count)
{
    guint place = 0;
    g_assert_cmpuint(count_kind(a, TINKER_MODE_OSCILLATION), ==, count);
    for (guint i = 0; i < a->analysis->modes->len && place < count; i++) {
        if (mode_at(a, i)->kind != TINKER_MODE_OSCILLATION) continue;
        g_autofree char *what = g_strdup_printf("frequency %u", place);
        assert_relative(what, mode_at(a, i)->natural, truth[place++], 1e-10);
    }
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

/* A mass of 2 kg on 50 N/m and 4 N s/m: omega = 5, zeta = 4 / (2 * 2 * 5) = 0.2. Across the line nothing holds it. */
static void test_single_oscillator(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'support', 'position': [0, 0]},"
                                        "{'type': 'mass', 'mass': 2, 'position': [1, 0]},"
                                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50},"
                                        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 4}");
    g_assert_cmpuint(a->analysis->modes->len, ==, 2);
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, 1);
    const TinkerMode *mode = mode_at(a, 1);
    assert_relative("frequency", mode->natural, 5, 1e-14);
    assert_relative("damped frequency", mode->frequency, 5 * sqrt(1 - 0.04), 1e-14);
    assert_relative("damping ratio", mode->damping_ratio, 0.2, 1e-14);
    assert_relative("decay", mode->decay, 1, 1e-14);
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
        g_autoptr(ModesFixture) a = analyse(blocks);
        g_assert_cmpuint(count_kind(a, TINKER_MODE_DECAY), ==, 2);
        assert_relative("slow decay", mode_at(a, 1)->decay, rows[i].slow, 1e-14);
        assert_relative("fast decay", mode_at(a, 2)->decay, rows[i].fast, 1e-14);
        assert_relative("damping ratio", mode_at(a, 1)->damping_ratio, rows[i].damping / 4, 1e-14);
    }
}

/* Wall, 1 kg, 1 kg on springs of 3, 2 and 3 N/m between two walls: 3 and 7 s^-2, in step and in counterstep. */
static void test_two_masses(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'support', 'position': [0, 0]},"
                                        "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
                                        "{'type': 'support', 'position': [3, 0]},"
                                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3},"
                                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2},"
                                        "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'stiffness': 3}");
    assert_frequencies(a, (double[]){sqrt(3), sqrt(7)}, 2);
    const TinkerMode *together = mode_at(a, 2), *against = mode_at(a, 3);
    g_assert_cmpfloat_with_epsilon(together->real[2], 1, 1e-12);
    g_assert_cmpfloat_with_epsilon(against->real[2], -1, 1e-12);
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
    g_autoptr(ModesFixture) a = analyse(blocks->str);
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, is_free ? N + 1 : N);
    assert_frequencies(a, truth, is_free ? N - 1 : N);
}

/* From 30 degrees it is brought to hang: sqrt(g / L). Above its support it falls over: the growth rate is the same. */
static void test_pendulum(void)
{
    g_autoptr(ModesFixture) hangs = analyse("{'type': 'gravity', 'acceleration': 9},"
                                            "{'type': 'support', 'position': [0, 0]},"
                                            "{'type': 'mass', 'mass': 3, 'position': [2, -3.4641016151377544]},"
                                            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    assert_frequencies(hangs, (double[]){1.5}, 1);
    g_assert_cmpuint(hangs->analysis->modes->len, ==, 1);
    g_assert_cmpfloat_with_epsilon(fabs(mode_at(hangs, 0)->real[1]), 0, 1e-10);
    g_autoptr(ModesFixture) stands = analyse("{'type': 'gravity', 'acceleration': 9},"
                                             "{'type': 'support', 'position': [0, 0]},"
                                             "{'type': 'mass', 'mass': 3, 'position': [0, 4]},"
                                             "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    g_assert_cmpuint(count_kind(stands, TINKER_MODE_GROWTH), ==, 1);
    assert_relative("growth", tinker_modes_growth(stands->analysis->modes), 1.5, 1e-10);
}

/* Equal masses on equal rods: omega^2 = g / L (2 +- sqrt 2). From a bent start. */
static void test_double_pendulum(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'gravity', 'acceleration': 9.81},"
                                        "{'type': 'support', 'position': [0, 0], 'solid': false},"
                                        "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [1, 1]},"
                                        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1},"
                                        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1'], 'length': 1}");
    assert_frequencies(a, (double[]){sqrt(9.81 * (2 - G_SQRT2)), sqrt(9.81 * (2 + G_SQRT2))}, 2);
    g_assert_cmpfloat_with_epsilon(a->analysis->q[1] - a->analysis->q[3], 1, 1e-10);
}

/* A straight bar of three masses on rods in one line, from 1 rad off: it swings as a whole, sqrt(g sum m x / sum m
 * x^2). */
/* Bars on pins: one swings with omega^2 = 3 g / 2 L, two equal ones with (3 -+ 6 / sqrt 7) g / L. */
static void test_bars(void)
{
    g_autoptr(ModesFixture) one =
        analyse("{'type': 'gravity', 'acceleration': 9.75}, {'type': 'support'},"
                "{'type': 'bar', 'length': 1.5, 'position': [0.75, 0]},"
                "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.75, 0]}]}");
    assert_frequencies(one, (const double[]){sqrt(9.75)}, 1);
    g_autoptr(ModesFixture) two =
        analyse("{'type': 'gravity', 'acceleration': 9.75}, {'type': 'support'},"
                "{'type': 'bar', 'length': 1.5, 'position': [0, -0.75], 'orientation': '-90 deg'},"
                "{'type': 'bar', 'length': 1.5, 'position': [0, -2.25], 'orientation': '-90 deg'},"
                "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.75, 0]}]},"
                "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.75, 0]}, {'block': 'Bar 1', 'at': [-0.75, 0]}]}");
    assert_frequencies(two, (const double[]){sqrt((3 - 6 / sqrt(7)) * 6.5), sqrt((3 + 6 / sqrt(7)) * 6.5)}, 2);
}

/* A bar on an upright spring at each end bounces with 2 k / m and pitches with 6 k / m; sideways nothing holds it. */
static void test_bar_on_springs(void)
{
    g_autoptr(ModesFixture) a =
        analyse("{'type': 'support', 'position': [-1, -1], 'solid': false}, {'type': 'support', 'position': [1, -1], "
                "'solid': false},"
                "{'type': 'bar', 'mass': 4, 'length': 2},"
                "{'type': 'spring', 'stiffness': 50, 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]},"
                "{'type': 'spring', 'stiffness': 50, 'ends': [{'block': 'Bar 0', 'at': [1, 0]}, 'Support 1']}");
    assert_frequencies(a, (const double[]){5, sqrt(75)}, 2);
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, 1);
}

static void test_straight_bar(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'gravity', 'acceleration': 9.81},"
                                        "{'type': 'support', 'position': [0, 0], 'solid': false},"
                                        "{'type': 'mass', 'mass': 1, 'position': [0.3, -0.4]},"
                                        "{'type': 'mass', 'mass': 4, 'position': [0.6, -0.8]},"
                                        "{'type': 'mass', 'mass': 2, 'position': [0.9, -1.2]},"
                                        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                                        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                                        "{'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
                                        "{'type': 'rod', 'ends': ['Support 0', 'Mass 2']}");
    assert_frequencies(a, (double[]){sqrt(9.81 * (0.5 + 4 + 3) / (0.25 + 4 + 4.5))}, 1);
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
}

/* Two pendulums and a spring between them: g / L, and g / L + 2 k / m. */
static void test_coupled_pendulums(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'gravity', 'acceleration': 9.81},"
                                        "{'type': 'support', 'position': [0, 0], 'width': 3},"
                                        "{'type': 'mass', 'mass': 2, 'position': [-1, -2]},"
                                        "{'type': 'mass', 'mass': 2, 'position': [1, -2]},"
                                        "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [-1, 0]}, 'Mass 0']},"
                                        "{'type': 'rod', 'ends': [{'block': 'Support 0', 'at': [1, 0]}, 'Mass 1']},"
                                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 7}");
    assert_frequencies(a, (double[]){sqrt(9.81 / 2), sqrt(9.81 / 2 + 7)}, 2);
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
    g_autoptr(ModesFixture) a = analyse(data == NULL ? blocks : redundant);
    g_assert_cmpuint(a->analysis->modes->len, ==, 1);
    assert_frequencies(a, (double[]){sqrt(9.81 / hypot(0.6, 2.3))}, 1);
}

/* A mass hung on a spring: bounces as sqrt(k / m), swings as sqrt(g / L) with the length that it hangs at. */
static void test_hanging_spring(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'gravity', 'acceleration': 9.81},"
                                        "{'type': 'support', 'position': [0, 0]},"
                                        "{'type': 'mass', 'mass': 2, 'position': [0.3, -1]},"
                                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80,"
                                        " 'rest_length': 1}");
    double length = 1 + 2 * 9.81 / 80;
    assert_frequencies(a, (double[]){sqrt(9.81 / length), sqrt(40)}, 2);
    const TinkerMode *swing = mode_at(a, 0), *bounce = mode_at(a, 1);
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
    g_autoptr(ModesFixture) a = analyse(stiff);
    assert_frequencies(a, (double[]){sqrt(1e12 * r / (1 + r / 2 + root)), sqrt(1e12 * (1 + r / 2 + root))}, 2);
    /* lambda^2 - ((k1 + k2) / m1 + k2 / m2) lambda + k1 k2 / (m1 m2) = 0 */
    double b = (1 + 1e-6) / 1e9 + 1e-6, c = 1e-6 / 1e9, greater = (b + sqrt(b * b - 4 * c)) / 2;
    g_autoptr(ModesFixture) h = analyse(heavy);
    assert_frequencies(h, (double[]){sqrt(c / greater), sqrt(greater)}, 2);
}

/* Masses of 1 kg on 1 N/m to a wall each and 1 N/m between, a damper of 0.5 N s/m on the first alone: the roots of
 * (s^2 + s/2 + 2)(s^2 + 2) = 1, the quartic s^4 + s^3/2 + 4 s^2 + s + 3 = 0, checked by putting them in. Likewise an
 * absorber: the product of all |s| is that of all undamped omega. */
static void test_damped_two_masses(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'support', 'position': [0, 0]},"
                                        "{'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
                                        "{'type': 'support', 'position': [3, 0]},"
                                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1},"
                                        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.5},"
                                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1},"
                                        "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'stiffness': 1}");
    g_assert_cmpuint(count_kind(a, TINKER_MODE_OSCILLATION), ==, 2);
    double sum = 0, product = 1;
    for (guint i = 2; i < 4; i++) {
        const TinkerMode *mode = mode_at(a, i);
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
    g_autoptr(ModesFixture) a =
        analyse("{'type': 'mass', 'mass': 2, 'position': [0, 0]}, {'type': 'mass', 'mass': 3, 'position': [1, 0]},"
                "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 6}");
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, 4);
    g_assert_cmpuint(count_kind(a, TINKER_MODE_DECAY), ==, 1);
    assert_relative("decay", mode_at(a, 4)->decay, 6 * (1 / 2.0 + 1 / 3.0), 1e-13);
}

/* A mass pressed between two springs, 0.2 m each over the straight place: along it 2 k, across it -2 T / L = -2 k 0.2
 * / 1. */
static void test_pressed_springs(void)
{
    g_autoptr(ModesFixture) a =
        analyse("{'type': 'support', 'position': [-1, 0]}, {'type': 'support', 'position': [1, 0]},"
                "{'type': 'mass', 'position': [0, 0]},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 100, 'rest_length': 1.2},"
                "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 100, 'rest_length': 1.2}");
    assert_relative("growth", tinker_modes_growth(a->analysis->modes), sqrt(40), 1e-12);
    assert_frequencies(a, (double[]){sqrt(200)}, 1);
}

/* A stretched spring beside a rod pulls against it, and moves nothing: the pair drifts and turns. */
static void test_spring_beside_rod(void)
{
    g_autoptr(ModesFixture) a =
        analyse("{'type': 'mass', 'mass': 0.07, 'position': [5.48, -0.11]},"
                "{'type': 'mass', 'mass': 0.11, 'position': [2.1, 3.08]},"
                "{'type': 'spring', 'ends': ['Mass 1', 'Mass 0'], 'stiffness': 4191.9, 'rest_length': 2.94},"
                "{'type': 'damper', 'ends': ['Mass 1', 'Mass 0'], 'damping': 11.8},"
                "{'type': 'rod', 'ends': ['Mass 1', 'Mass 0']}");
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, 3);
    g_assert_cmpuint(a->analysis->modes->len, ==, 3);
}

/* In free fall there is no rest, and it says so; the modes are those of the start. */
static void test_no_rest(void)
{
    g_autoptr(ModesFixture) a = analyse("{'type': 'gravity'}, {'type': 'mass'}");
    g_assert_false(a->analysis->about_rest);
    g_assert_nonnull(strstr(a->analysis->rest.why, "nothing holds it"));
    g_assert_cmpfloat(a->analysis->rest.unbalanced, >, 9);
    g_assert_cmpuint(count_kind(a, TINKER_MODE_RIGID), ==, 2);
}

/* Held 60 degrees aside, a pendulum's rod pulls with m g cos 60: omega^2 = g cos 60 / L. */
static void test_given_state(void)
{
    g_autoptr(ModesFixture) a = modes_fixture_new(FALSE, "{'type': 'gravity', 'acceleration': 8},"
                                                         "{'type': 'support', 'position': [0, 0]},"
                                                         "{'type': 'mass', 'position': [0.8660254037844386, -0.5]},"
                                                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    assert_frequencies(a, (double[]){2}, 1);
    g_assert_false(a->analysis->about_rest);
}

/* Blocks that are no lines, by differences. */
static void assert_roughly(const ModesFixture *a, guint place, double truth)
{
    assert_relative("frequency", mode_at(a, place)->natural, truth, 1e-8);
}

/* A torsional spring of 10 N m at the foot of a rod of 2 m with 3 kg: omega^2 = k / (m L^2). */
static void test_torsion(void)
{
    g_autoptr(ModesFixture) a =
        analyse("{'type': 'support', 'position': [0, 0]}, {'type': 'support', 'position': [1, 0]},"
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
        analyse("{'type': 'gravity', 'acceleration': 8}, {'type': 'support', 'position': [0, 0]},"
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
        analyse("{'type': 'mass', 'mass': 2, 'position': [0, 0]},"
                "{'type': 'mass', 'mass': 2, 'position': [1, 0]}, {'type': 'attraction', 'strength': 1},"
                "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 20, 'rest_length': 1.2}");
    g_assert_cmpuint(count_kind(a, TINKER_MODE_OSCILLATION), ==, 1);
    assert_roughly(a, 3, sqrt(20 - 8));
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
        g_autoptr(ModesFixture) a = analyse(blocks);
        assert_frequencies(a, (double[]){sqrt(9.81 * (2 - G_SQRT2)), sqrt(9.81 * (2 + G_SQRT2))}, 2);
    }
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
    g_test_add_func("/modes/bars", test_bars);
    g_test_add_func("/modes/bar-on-springs", test_bar_on_springs);
    g_test_add_func("/modes/straight-bar", test_straight_bar);
    g_test_add_func("/modes/coupled-pendulums", test_coupled_pendulums);
    g_test_add_data_func("/modes/parallelogram/plain", NULL, test_parallelogram);
    g_test_add_data_func("/modes/parallelogram/redundant", "redundant", test_parallelogram);
    g_test_add_func("/modes/hanging-spring", test_hanging_spring);
    g_test_add_func("/modes/extreme-ratios", test_extreme_ratios);
    g_test_add_func("/modes/damped-two-masses", test_damped_two_masses);
    g_test_add_func("/modes/free-damper", test_free_damper);
    g_test_add_func("/modes/pressed-springs", test_pressed_springs);
    g_test_add_func("/modes/spring-beside-rod", test_spring_beside_rod);
    g_test_add_func("/modes/no-rest", test_no_rest);
    g_test_add_func("/modes/given-state", test_given_state);
    g_test_add_func("/modes/scales", test_scales);
    g_test_add_func("/modes/torsion", test_torsion);
    g_test_add_func("/modes/cubic", test_cubic);
    g_test_add_func("/modes/attraction", test_attraction);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
