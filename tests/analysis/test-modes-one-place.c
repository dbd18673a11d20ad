/* Modes where the ends of a line are at one place, or fall into one.
 *
 * A softened magnet, T = c L / (L^2 + s^2)^(5/2), has T(0) = 0 and dT/dL(0) = c / s^5: near L = 0 it is a spring of
 * that stiffness without length, the same in every direction. */
#include <math.h>
#include <string.h>

#include "modes-fixture.h"

static const char *const magnets[] = {"magnet", "plain-magnet"}; /* with derivatives and without */

/* All its modes are oscillations with these natural frequencies (rad/s), without damping. */
static void assert_swings(const ModesFixture *a, const double *truth, guint count, double bound)
{
    g_assert_cmpuint(a->analysis->modes->len, ==, count);
    for (guint i = 0; i < count && i < a->analysis->modes->len; i++) {
        g_assert_cmpint(modes_at(a, i)->kind, ==, TINKER_MODE_OSCILLATION);
        g_assert_cmpfloat(modes_at(a, i)->decay, ==, 0);
        physics_assert_near("frequency", modes_at(a, i)->natural / truth[i], 1, bound);
    }
}

static double fastest_swing(const ModesFixture *a)
{
    double most = 0;
    for (guint i = 0; i < a->analysis->modes->len; i++)
        if (modes_at(a, i)->kind == TINKER_MODE_OSCILLATION) most = fmax(most, modes_at(a, i)->natural);
    return most;
}

/* A mass on a magnet, placed `apart` from it along 3-4-5. (transfer full) */
static ModesFixture *magnet_at(const char *type, double x, double apart, double mass, double c, double s)
{
    g_autofree char *blocks =
        g_strdup_printf("{'type': 'support', 'position': [%.17g, 0.4], 'solid': false},"
                        "{'type': 'mass', 'mass': %.17g, 'position': [%.17g, %.17g]},"
                        "{'type': '%s', 'ends': ['Support 0', 'Mass 0'], 'strength': %.17g, 'softening': %.17g}",
                        x, mass, x + 0.6 * apart, 0.4 + 0.8 * apart, type, c, s);
    return modes_fixture_new(TRUE, blocks);
}

/* In both directions, over scales of length and strength; a micrometre off it is the same to (L / s)^2. */
static void test_magnet(gconstpointer type)
{
    static const double cases[][3] = {{0.5, 0.5, 0.2}, {3, 1e-9, 1e-2}, {0.25, 1e20, 1e3}, {1e6, 7, 0.05}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double mass = cases[i][0], c = cases[i][1], s = cases[i][2], omega = sqrt(c / pow(s, 5) / mass);
        static const double offsets[] = {0, 2, -70};
        for (gsize k = 0; k < G_N_ELEMENTS(offsets); k++) {
            g_autoptr(ModesFixture) there = magnet_at(type, offsets[k], 0, mass, c, s);
            assert_swings(there, (double[]){omega, omega}, 2, 1e-7);
            g_assert_true(there->analysis->about_rest);
            g_autoptr(ModesFixture) near = magnet_at(type, offsets[k], 1e-5 * s, mass, c, s);
            assert_swings(near, (double[]){omega, omega}, 2, 1e-7);
        }
    }
}

/* With derivatives of its own the frequency keeps its digits. */
static void test_digits(void)
{
    g_autoptr(ModesFixture) a = magnet_at("magnet", 2, 0, 0.5, 0.5, 0.2);
    assert_swings(a, (double[]){sqrt(3125), sqrt(3125)}, 2, 1e-14);
}

/* From a metre away, beyond the greatest pull at s / 2, the search walks there of itself. */
static void test_trap(gconstpointer type)
{
    static const double distances[] = {1, 0.37, 0.15, 0.05};
    for (gsize i = 0; i < G_N_ELEMENTS(distances); i++) {
        g_autoptr(ModesFixture) a = magnet_at(type, 2, distances[i], 0.5, 0.5, 0.2);
        g_assert_true(a->analysis->about_rest);
        assert_swings(a, (double[]){sqrt(3125), sqrt(3125)}, 2, 1e-9);
        double origin[2];
        tinker_model_origin(a->analysis->model, origin);
        physics_assert_near("x", a->analysis->q[0] + origin[0], 2, 1e-12);
        physics_assert_near("y", a->analysis->q[1] + origin[1], 0.4, 1e-12);
    }
    /* softened so little that the pull grows by 16 decades on the way */
    g_autoptr(ModesFixture) narrow = magnet_at(type, 0, 1, 1, 1, 1e-4);
    g_assert_true(narrow->analysis->about_rest);
    assert_swings(narrow, (double[]){1e10, 1e10}, 2, 1e-7);
}

/* 0.1 + 0.2 is not 0.3: ends that are one place but for rounding are one place, for a spring without length too. */
static void test_rounding(void)
{
    static const char *const laws[] = {"'magnet', 'strength': 32e-5, 'softening': 0.2",
                                       "'plain-magnet', 'strength': 32e-5, 'softening': 0.2",
                                       "'spring', 'stiffness': 1, 'rest_length': 0"};
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autofree char *blocks = g_strdup_printf("{'type': 'support', 'position': [%.17g, 5], 'solid': false},"
                                                  "{'type': 'mass', 'mass': 0.25, 'position': [0.3, 5]},"
                                                  "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 3},"
                                                  "{'type': %s, 'ends': ['Support 0', 'Mass 0']}",
                                                  0.1 + 0.2, laws[i]);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        assert_swings(a, (double[]){2, 2}, 2, 1e-7);
        g_assert_cmpint(a->analysis->linear->undefined_dampers, ==, 1);
    }
}

/* Beside springs, K is the sum of both: 1 kg between two springs of 50 N/m, 1 m long and 0.2 m longer when relaxed, is
 * pushed out with 2 * 10 N/m, held along with 100 N/m; a magnet in the middle adds 32 N/m to both. */
static void test_sum(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(magnets); i++) {
        g_autofree char *blocks = g_strdup_printf(
            "{'type': 'support', 'position': [-1, 0]}, {'type': 'support', 'position': [1, 0]},"
            "{'type': 'support', 'position': [0, 0], 'solid': false}, {'type': 'mass', 'position': [0, 0]},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50, 'rest_length': 1.2},"
            "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'stiffness': 50, 'rest_length': 1.2},"
            "{'type': '%s', 'ends': ['Support 2', 'Mass 0'], 'strength': 1, 'softening': 0.5}",
            magnets[i]);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        assert_swings(a, (double[]){sqrt(12), sqrt(132)}, 2, 1e-7);
    }
}

/* What resists has no direction there: it is left out and counted, of a damper and of a law alike. */
static void test_dampers(void)
{
    static const char *const laws[] = {
        ("{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 9, 'rest_length': 0},"
         "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 2}"),
        "{'type': 'magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 9, 'softening': 1, 'resistance': 2}",
        "{'type': 'plain-magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 9, 'softening': 1, 'resistance': 2}"};
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autofree char *blocks = g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'mass'}, %s", laws[i]);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        assert_swings(a, (double[]){3, 3}, 2, 1e-7);
        g_assert_cmpint(a->analysis->linear->undefined_dampers, ==, 1);
        g_assert_cmpint(a->analysis->linear->undefined_pulls, ==, 0);
    }
}

/* T = k L^3 has no stiffness where its ends meet, and is at rest there: rigid, and nothing is left out. */
static void test_cubic(void)
{
    g_autoptr(ModesFixture) a =
        modes_fixture_new(TRUE, "{'type': 'support', 'solid': false}, {'type': 'mass'},"
                                "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 5, 'length': 0}");
    g_assert_true(a->analysis->about_rest);
    g_assert_cmpuint(a->analysis->modes->len, ==, 2);
    for (guint i = 0; i < a->analysis->modes->len; i++)
        g_assert_cmpint(modes_at(a, i)->kind, ==, TINKER_MODE_RIGID);
    g_assert_cmpint(a->analysis->linear->undefined_pulls, ==, 0);
}

/* A pull that is not 0 where its ends meet has no derivative there: no rest, wherever the search comes from. */
static void test_pull_without_direction(void)
{
    static const char *const laws[] = {"'spring', 'stiffness': 9, 'rest_length': 1",
                                       "'magnet', 'strength': 9, 'softening': 1, 'pull': 2",
                                       "'plain-magnet', 'strength': 9, 'softening': 1, 'pull': 2"};
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autofree char *blocks = g_strdup_printf("{'type': 'support', 'solid': false}, {'type': 'mass'},"
                                                  "{'type': %s, 'ends': ['Support 0', 'Mass 0']}",
                                                  laws[i]);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        g_assert_false(a->analysis->about_rest);
        g_assert_nonnull(strstr(a->analysis->rest.why, "no direction"));
        g_assert_cmpint(a->analysis->linear->undefined_pulls, ==, 1);
        const GPtrArray *warnings = tinker_model_warnings(a->analysis->model);
        g_assert_cmpuint(warnings->len, ==, 1);
        g_assert_nonnull(strstr(tinker_warnings_text(warnings, 0), "its ends are at one place"));
    }
    g_autoptr(ModesFixture) walked = modes_fixture_new(
        TRUE, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0]},"
              "{'type': 'magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 9, 'softening': 1, 'pull': 2}");
    g_assert_false(walked->analysis->about_rest);
}

/* Nothing holds what attracts without bound: the modes are those of the start. Two masses of 2 kg with c / L^4 have the
 * reduced mass 1 kg, so along the line they grow as sqrt(4 c / L^5), and across it they swing as sqrt(T / L) = sqrt(c /
 * L^5). */
static void test_collapse(void)
{
    static const double places[][2] = {{0, 0}, {-3, 0}, {40, -7}};
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(places); i++) {
        g_autofree char *blocks = g_strdup_printf(
            "{'type': 'mass', 'mass': 2, 'position': [%g, %g]}, {'type': 'mass', 'mass': 2, 'position': [%g, %g]},"
            "{'type': '%s', 'ends': ['Mass 0', 'Mass 1'], 'strength': 0.25}",
            places[i / 2][0], places[i / 2][1], places[i / 2][0] + 0.6, places[i / 2][1] + 0.8, magnets[i % 2]);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        g_assert_false(a->analysis->about_rest);
        g_assert_nonnull(strstr(a->analysis->rest.why, "grow without bound"));
        physics_assert_near("growth", tinker_modes_growth(a->analysis->modes), 1, 1e-7);
        physics_assert_near("across", fastest_swing(a), 0.5, 1e-7);
        physics_assert_near("unbalanced",
                            fmax(fabs(a->analysis->linear->force[0]), fabs(a->analysis->linear->force[1])), 0.25 * 0.8,
                            1e-12);
    }
}

/* Nor what falls onto a support, beside a spring that is at rest, or under gravity; fields as lines. */
static void test_other_collapses(void)
{
    static const char *const scenes[] = {
        "{'type': 'support', 'position': [2, 0], 'solid': false}, {'type': 'mass', 'position': [3, 0]},"
        "{'type': 'magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 1}",
        "{'type': 'support', 'position': [2, 0]}, {'type': 'mass', 'position': [3, 0]},"
        "{'type': 'mass', 'position': [3, 1]}, {'type': 'magnet', 'ends': ['Mass 0', 'Mass 1'], 'strength': 1},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1e4, 'rest_length': 1}",
        "{'type': 'gravity'}, {'type': 'support', 'position': [2, 0], 'solid': false},"
        "{'type': 'mass', 'position': [2, -0.2]}, {'type': 'magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 1}",
        "{'type': 'mass', 'mass': 2}, {'type': 'mass', 'mass': 2, 'position': [1, 0.3]},"
        "{'type': 'attraction', 'strength': 1}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, scenes[i]);
        g_assert_false(a->analysis->about_rest);
        g_assert_nonnull(strstr(a->analysis->rest.why, "grow without bound"));
    }
}

/* Forces that are far larger at rest than at the start, and cancel out there, are a rest: cores hold the magnets apart
 * where c / L^4 = b / L^13, with the stiffness (13 - 4) c / L^5. From a hundred times as far. */
static void test_core(gconstpointer type)
{
    static const double starts[] = {0.11, 0.5, 3, 10};
    for (gsize i = 0; i < G_N_ELEMENTS(starts); i++) {
        g_autofree char *blocks =
            g_strdup_printf("{'type': 'mass', 'mass': 2}, {'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g]},"
                            "{'type': '%s', 'ends': ['Mass 0', 'Mass 1'], 'strength': 1, 'core': 1e-9}",
                            0.6 * starts[i], 0.8 * starts[i], (const char *)type);
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        const double *q = a->analysis->q;
        g_assert_true(a->analysis->about_rest);
        physics_assert_near("distance", hypot(q[2] - q[0], q[3] - q[1]), 0.1, 1e-9);
        physics_assert_near("frequency", fastest_swing(a) / sqrt(9e5), 1, 1e-7);
    }
}

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(magnets); i++) {
        static const struct {
            const char *name;
            void (*test)(gconstpointer type);
        } tests[] = {{"magnet", test_magnet}, {"trap", test_trap}, {"core", test_core}};
        for (gsize k = 0; k < G_N_ELEMENTS(tests); k++) {
            g_autofree char *path = g_strdup_printf("/modes/one-place/%s/%s", tests[k].name, magnets[i]);
            g_test_add_data_func(path, magnets[i], tests[k].test);
        }
    }
    g_test_add_func("/modes/one-place/digits", test_digits);
    g_test_add_func("/modes/one-place/rounding", test_rounding);
    g_test_add_func("/modes/one-place/sum", test_sum);
    g_test_add_func("/modes/one-place/dampers", test_dampers);
    g_test_add_func("/modes/one-place/cubic", test_cubic);
    g_test_add_func("/modes/one-place/pull-without-direction", test_pull_without_direction);
    g_test_add_func("/modes/one-place/collapse", test_collapse);
    g_test_add_func("/modes/one-place/other-collapses", test_other_collapses);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
