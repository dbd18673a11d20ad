/* Starts at equilibrium and displaced from it, against what statics says. */
#include <math.h>

#include "scene/frame/overlaps.h"
#include "start-offers.h"

#define HANGING                                                                                                        \
    GRAVITY "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 2, 'position': [0.3, -1.2], "           \
            "'velocity': [1, 2]}, {'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80"

/* It hangs m g / k below its rest length. */
static void test_equilibrium(void)
{
    const double sag = 2 * 9.81 / 80;
    g_autoptr(StartFixture) f = start_fixture_new(HANGING ", 'rest_length': 1}");
    start_apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    start_assert_at(f, "Mass 0", 0, -1 - sag);
    start_assert_moves(f, "Mass 0", 0, 0);
    for (double d = -0.25; d < 0.5; d += 0.5) {
        g_autoptr(StartFixture) g = start_fixture_new(HANGING ", 'rest_length': 1}");
        start_apply(g, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL, d);
        start_assert_at(g, "Mass 0", 0, -1 - sag - d);
        start_assert_moves(g, "Mass 0", 0, 0);
    }
}

/* A rest length that is left to the drawing is what it was drawn with, and stays that; else the spring would hang
 * unstretched with the mass at its start. */
static void test_rest_length_stays(void)
{
    const double drawn = hypot(0.3, 1.2);
    g_autoptr(StartFixture) f = start_fixture_new(HANGING "}");
    start_apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    physics_assert_near("rest length", start_fixture_get(f, "Spring 0", TINKER_MEANING_LENGTH, 0), drawn, 1e-15);
    start_assert_at(f, "Mass 0", 0, -drawn - 2 * 9.81 / 80);
    g_autoptr(StartFixture) g = start_fixture_new(HANGING "}");
    physics_assert_near("stretch", start_value_of(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0"), 0, 1e-15);
    start_apply(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", 0.2);
    physics_assert_near("rest length", start_fixture_get(g, "Spring 0", TINKER_MEANING_LENGTH, 0), drawn, 1e-15);
    start_assert_at(g, "Mass 0", 0.3 * (1 + 0.2 / drawn), -1.2 * (1 + 0.2 / drawn));
    start_assert_moves(g, "Mass 0", 1, 2);
    /* one that only takes another velocity is left to the drawing as it was */
    g_autoptr(StartFixture) h = start_fixture_new(HANGING "}");
    start_apply(h, "Mass 0", TINKER_START_AT_REST, NULL, 0);
    g_assert_true(isnan(start_fixture_get(h, "Spring 0", TINKER_MEANING_LENGTH, 0)));
}

/* Two masses of 2 and 3 kg below each other: the upper spring carries both. Both move, though one was asked about. */
static void test_equilibrium_of_chain(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        GRAVITY
        "{'type': 'support', 'position': [1, 2]}, {'type': 'mass', 'mass': 2, 'position': [1.5, 1]},"
        "{'type': 'mass', 'mass': 3, 'position': [1, 0]}, {'type': 'mass', 'name': 'Other', 'position': [5, 5]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 100, 'rest_length': 1},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 50, 'rest_length': 0.5}");
    const double first = 1 + 5 * 9.81 / 100, second = 0.5 + 3 * 9.81 / 50;
    start_apply(f, "Mass 1", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.1);
    start_assert_at(f, "Mass 0", 1, 2 - first);
    start_assert_at(f, "Mass 1", 1, 2 - first - second - 0.1);
    start_assert_at(f, "Other", 5, 5);
    /* and nothing holds the other */
    g_assert_false(start_is_offered(f, "Other", TINKER_START_AT_EQUILIBRIUM, NULL));
}

#define INCLINE                                                                                                        \
    GRAVITY "{'type': 'support', 'name': 'Ramp', 'position': [0, 0], 'width': 20, 'height': 0.2, 'orientation': '30 "  \
            "deg'},"                                                                                                   \
            "{'type': 'mass', 'mass': 2, 'height': 0.4, 'position': [%.17g, %.17g]}"

/* A place so far up the incline from its middle and so far above its top. */
static char *on_incline(double along, double gap, const char *more)
{
    const double c = sqrt(0.75), s = 0.5, off = 0.1 + 0.2 + gap;
    g_autofree char *blocks = g_strdup_printf(INCLINE, along * c - off * s, along * s + off * c);
    return g_strconcat(blocks, more, NULL);
}

static void test_incline(void)
{
    const double c = sqrt(0.75), s = 0.5;
    g_autofree char *blocks = on_incline(1, 0.7, "");
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    start_apply(f, "Mass 0", TINKER_START_ALONG_TOP, "Ramp", 3);
    start_assert_moves(f, "Mass 0", 3 * c, 3 * s);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Mass 0", TINKER_START_ON_TOP, "Ramp", 0);
    start_assert_at(g, "Mass 0", c - 0.3 * s, s + 0.3 * c);
    physics_assert_near("angle", start_fixture_get(g, "Mass 0", TINKER_MEANING_ORIENTATION, 0), G_PI / 6, 1e-14);
    /* falling to the other side: uphill is to the left; and a level top */
    g_autoptr(StartFixture) left = start_fixture_new("{'type': 'support', 'name': 'Ramp', 'orientation': '-30 deg'},"
                                                     "{'type': 'mass', 'position': [0, 2]}");
    start_apply(left, "Mass 0", TINKER_START_ALONG_TOP, "Ramp", 3);
    start_assert_moves(left, "Mass 0", -3 * c, 3 * s);
    g_autoptr(StartFixture) level = start_fixture_new("{'type': 'support', 'name': 'Floor'},"
                                                      "{'type': 'mass', 'position': [0, 2]}");
    start_apply(level, "Mass 0", TINKER_START_ALONG_TOP, "Floor", -3);
    start_assert_moves(level, "Mass 0", -3, 0);
}

/* Held by a spring along the incline from above: m g sin / k beyond its rest length, and it stays on the top. */
static void test_rest_on_incline(void)
{
    const double c = sqrt(0.75), s = 0.5, k = 100, sag = 2 * 9.81 * s / k;
    g_autofree char *spring =
        g_strdup_printf(", {'type': 'support', 'name': 'Wall', 'solid': false, 'position': [%.17g, "
                        "%.17g]}, {'type': 'spring', 'ends': ['Wall', 'Mass 0'], 'stiffness': %g, "
                        "'rest_length': 2}",
                        4 * c - 0.3 * s, 4 * s + 0.3 * c, k);
    g_autofree char *blocks = on_incline(0.5, 0, spring);
    const double along = 4 - 2 - sag;
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    start_apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    start_assert_at(f, "Mass 0", along * c - 0.3 * s, along * s + 0.3 * c);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.3);
    start_assert_at(g, "Mass 0", (along - 0.3) * c - 0.3 * s, (along - 0.3) * s + 0.3 * c);
}

/* Wall, two masses on a floor, springs of 30 and 10 N/m: nothing pulls, so both are at their rest lengths, in spite of
 * gravity; without the wall the distance alone is given, and the middle stays. */
static void test_rest_on_floor(void)
{
    const char *blocks =
        GRAVITY "{'type': 'support', 'name': 'Floor', 'position': [3, -0.6], 'width': 20, 'height': 0.4},"
                "{'type': 'mass', 'position': [1.5, 0]}, {'type': 'mass', 'position': [4, 0]},"
                "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 10, 'rest_length': 2}";
    g_autofree char *held = g_strconcat(blocks,
                                        ", {'type': 'support', 'name': 'Wall', 'solid': false, 'position': [0, 0]},"
                                        "{'type': 'spring', 'ends': ['Wall', 'Mass 0'], 'stiffness': 30, "
                                        "'rest_length': 1}",
                                        NULL);
    g_autoptr(StartFixture) f = start_fixture_new(held);
    start_apply(f, "Mass 1", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.25);
    start_assert_at(f, "Mass 0", 1, 0);
    start_assert_at(f, "Mass 1", 3.25, 0);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Mass 1", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    start_assert_at(g, "Mass 0", 1.75, 0);
    start_assert_at(g, "Mass 1", 3.75, 0);
}

/* A weight on a spring over a floor that is nearer than the spring would let it come rests on the floor; over one that
 * is farther it hangs m g / k below the spring's length. */
static void test_stopped_by_floor(void)
{
    const double depths[] = {1.2, 3}, sag = 1 + 9.81 / 20;
    for (gsize i = 0; i < G_N_ELEMENTS(depths); i++) {
        g_autofree char *blocks =
            g_strdup_printf(GRAVITY "{'type': 'support', 'name': 'Floor', 'position': [0, %g], 'height': 0.2},"
                                    "{'type': 'support', 'name': 'Nail', 'solid': false},"
                                    "{'type': 'mass', 'position': [0, -0.7], 'height': 0.2},"
                                    "{'type': 'spring', 'ends': ['Nail', 'Mass 0'], 'stiffness': 20, 'rest_length': 1}",
                            -depths[i] - 0.2);
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        start_apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
        start_assert_at(f, "Mass 0", 0, -fmin(depths[i], sag));
    }
}

/* A rod that leans against a wall lies down. From where it would come down elsewhere it is not displaced. */
static void test_lies_down(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        GRAVITY "{'type': 'support', 'name': 'Floor', 'position': [3, -0.1], 'width': 10, 'height': 0.2},"
                "{'type': 'support', 'name': 'Wall', 'position': [-0.1, 2], 'orientation': '-90 deg', "
                "'width': 5, 'height': 0.2},"
                "{'type': 'mass', 'name': 'Foot', 'position': [1.4, 0.2], 'height': 0.4},"
                "{'type': 'mass', 'name': 'Head', 'position': [0.2, 1.8], 'height': 0.4},"
                "{'type': 'rod', 'ends': ['Foot', 'Head'], 'length': 2}");
    g_assert_false(start_is_offered(f, "Foot", TINKER_START_FROM_EQUILIBRIUM, NULL));
    start_apply(f, "Foot", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    const double head = start_fixture_get(f, "Head", TINKER_MEANING_POSITION, 0);
    const char *const ends[] = {"Head", "Foot"};
    for (int i = 0; i < 2; i++) {
        physics_assert_near("x", start_fixture_get(f, ends[i], TINKER_MEANING_POSITION, 0), head + 2 * i,
                            TINKER_TOUCHING);
        physics_assert_near("y", start_fixture_get(f, ends[i], TINKER_MEANING_POSITION, 1), 0.2, TINKER_TOUCHING);
    }
}

/* A support that its motion has 0.5 m to the right at t = 0. */
static void test_moved_support(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        GRAVITY "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 2, 'position': [0, -1.5]},"
                "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': 'cosine', 'amplitude': 0.5},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80, 'rest_length': 1}");
    physics_assert_near("stretch", start_value_of(f, "Mass 0", TINKER_START_STRETCHED, NULL), hypot(0.5, 1.5) - 1,
                        1e-14);
    start_apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    start_assert_at(f, "Mass 0", 0.5, -1 - 2 * 9.81 / 80);
}

static void add_tests(void)
{
    g_test_add_func("/start/equilibrium", test_equilibrium);
    g_test_add_func("/start/rest-length-stays", test_rest_length_stays);
    g_test_add_func("/start/equilibrium-of-chain", test_equilibrium_of_chain);
    g_test_add_func("/start/incline", test_incline);
    g_test_add_func("/start/rest-on-incline", test_rest_on_incline);
    g_test_add_func("/start/rest-on-floor", test_rest_on_floor);
    g_test_add_func("/start/stopped-by-floor", test_stopped_by_floor);
    g_test_add_func("/start/lies-down", test_lies_down);
    g_test_add_func("/start/moved-support", test_moved_support);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
