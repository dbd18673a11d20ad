/* The words for what bodies do in a mode, where closed forms tell it: in step and against each other, along a line and
 * about axes. */
#include "common/words/mode-words.h"
#include "modes-fixture.h"

/* The oscillations of a scene, in order, are said to be these; NULL: nothing is said. */
static void assert_words(const char *blocks, const char *const *words, guint count)
{
    g_autoptr(ModesFixture) a = modes_about_rest(blocks);
    guint place = 0;
    g_assert_cmpuint(modes_count(a, TINKER_MODE_OSCILLATION), ==, count);
    for (guint i = 0; i < a->analysis->modes->len; i++) {
        if (modes_at(a, i)->kind != TINKER_MODE_OSCILLATION) continue;
        g_autofree char *said = tinker_mode_motion(a->analysis, modes_at(a, i));
        g_assert_cmpstr(said, ==, words[place++]);
    }
}

#define LINE(x0_, y0_, x1_, y1_, x2_, y2_, x3_, y3_)                                                                   \
    "{'type': 'support', 'position': [" x0_ ", " y0_ "]}, {'type': 'mass', 'position': [" x1_ ", " y1_ "]},"           \
    "{'type': 'mass', 'position': [" x2_ ", " y2_ "]}, {'type': 'support', 'position': [" x3_ ", " y3_ "]},"           \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3},"                                             \
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2},"                                                \
    "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'stiffness': 3}"

/* x1 = x2 with 3 s^-2, x1 = -x2 with 7 s^-2; along a line that leans they go neither sideways nor up and down. */
static void test_two_masses(void)
{
    static const char *const level[] = {"sideways in step", "sideways against each other"};
    static const char *const upright[] = {"up and down in step", "up and down against each other"};
    static const char *const leaning[] = {NULL, NULL};
    assert_words(LINE("0", "0", "1", "0", "2", "0", "3", "0"), level, 2);
    assert_words(LINE("0", "0", "0", "1", "0", "2", "0", "3"), upright, 2);
    assert_words(LINE("0", "0", "3", "4", "6", "8", "9", "12"), leaning, 2);
}

/* Alike springs between three of 1 kg and two walls: (1, sqrt 2, 1), (1, 0, -1), (1, -sqrt 2, 1). What stands still
 * counts on neither side; of one against two nothing simple is said but the way. */
static void test_three_masses(void)
{
    static const char *const words[] = {"sideways in step", "sideways against each other", "sideways"};
    assert_words(
        "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 0]},"
        "{'type': 'mass', 'position': [3, 0]}, {'type': 'support', 'position': [4, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0']}, {'type': 'spring', 'ends': ['Mass 0', 'Mass 1']},"
        "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2']}, {'type': 'spring', 'ends': ['Mass 2', 'Support 1']}",
        words, 3);
}

/* Two alike discs on pins, with torsional springs of 3, 2 and 3 N m/rad to a wall, between them and to it. */
static void test_two_discs(void)
{
    static const char *const words[] = {"turning in step", "turning against each other"};
    assert_words(
        "{'type': 'support', 'solid': false}, {'type': 'disc', 'position': [0, 0], 'radius': 0.5, 'solid': false},"
        "{'type': 'support', 'position': [2, 0], 'solid': false},"
        "{'type': 'disc', 'radius': 0.5, 'position': [2, 0], 'solid': false},"
        "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'pin', 'ends': ['Support 1', 'Disc 1']},"
        "{'type': 'torsional-spring', 'ends': ['Support 0', 'Disc 0'], 'stiffness': 3},"
        "{'type': 'torsional-spring', 'ends': ['Disc 0', 'Disc 1'], 'stiffness': 2},"
        "{'type': 'torsional-spring', 'ends': ['Support 1', 'Disc 1'], 'stiffness': 3}",
        words, 2);
}

/* 1 kg on 4 N/m: 2 rad/s, 1/pi Hz, pi s. */
static void test_captions(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                                                 "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 4}");
    g_autofree char *free = tinker_mode_caption(a->analysis, modes_at(a, 0), modes_at(a, 0)->number),
                    *swings = tinker_mode_caption(a->analysis, modes_at(a, 1), modes_at(a, 1)->number);
    g_assert_cmpstr(free, ==, "Mode, up and down: moves freely, 0 Hz");
    g_assert_cmpstr(swings, ==, "Mode 1, sideways: ω₀ = 2 rad/s, f = 0.3183 Hz, T = 3.142 s");
}

/* 1 kg on 25 N/m and 3 N s/m: ζ = c / (2 √(k m)) = 0.3, and it swings with 5 rad/s √(1 - ζ²) = 4.7697 rad/s. */
static void test_damped_caption(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest("{'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                                                 "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 25},"
                                                 "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 3}");
    g_autofree char *swings = tinker_mode_caption(a->analysis, modes_at(a, 1), modes_at(a, 1)->number);
    g_assert_cmpstr(swings, ==,
                    "Mode 1, sideways: ω₀ = 5 rad/s, damping ratio 0.3; damped: f = 0.7591 Hz, T = 1.317 s");
}

/* What swings is numbered alone: 1 kg on 4 N/m moves freely up and down, which has no number. Of two masses the ratios
 * are those of their shapes. */
static void test_numbers_and_ratios(void)
{
    static const char *const ratios[] = {"Mass 0 : Mass 1 = 1 : 1", "Mass 0 : Mass 1 = 1 : −1"};
    g_autoptr(ModesFixture) a = modes_about_rest(LINE("0", "0", "1", "0", "2", "0", "3", "0"));
    guint swinging = 0;
    for (guint i = 0; i < a->analysis->modes->len; i++) {
        const TinkerMode *mode = modes_at(a, i);
        g_assert_cmpuint(mode->number, ==, mode->kind == TINKER_MODE_RIGID ? 0 : ++swinging);
        if (mode->kind == TINKER_MODE_RIGID) continue;
        g_autofree char *ratio = tinker_mode_ratio(a->analysis, mode, a->scene);
        g_assert_cmpstr(ratio, ==, ratios[swinging - 1]);
    }
    g_assert_cmpuint(swinging, ==, 2);
}

/* Of 1, 1 and 1 kg between two walls the shapes are (1, sqrt 2, 1), (1, 0, -1), (1, -sqrt 2, 1). */
static void test_ratio_of_three(void)
{
    static const char *const ratios[] = {"A : B : C = 1 : 1.41 : 1", "A : B : C = 1 : 0 : −1",
                                         "A : B : C = 1 : −1.41 : 1"};
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support'}, {'type': 'mass', 'name': 'A', 'position': [1, 0]}, {'type': 'mass', 'name': 'B', "
        "'position': [2, 0]}, {'type': 'mass', 'name': 'C', 'position': [3, 0]}, {'type': 'support', 'position': [4, "
        "0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'A']}, {'type': 'spring', 'ends': ['A', 'B']},"
        "{'type': 'spring', 'ends': ['B', 'C']}, {'type': 'spring', 'ends': ['C', 'Support 1']}");
    for (guint i = 0; i < a->analysis->modes->len; i++) {
        if (modes_at(a, i)->number == 0) continue;
        g_autofree char *ratio = tinker_mode_ratio(a->analysis, modes_at(a, i), a->scene);
        g_assert_cmpstr(ratio, ==, ratios[modes_at(a, i)->number - 1]);
    }
}

/* An overdamped oscillator of 1 kg, 4 N/m and 5 N s/m has the roots -1 and -4, another one swings with 2 rad/s: pairs
 * count by the larger root, so that it is the first. */
static void test_number_of_pair(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [-1, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 4},"
        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 5},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 1'], 'stiffness': 4}");
    for (guint i = 0; i < a->analysis->modes->len; i++) {
        const TinkerModeKind kind = modes_at(a, i)->kind;
        g_assert_cmpuint(modes_at(a, i)->number, ==,
                         kind == TINKER_MODE_OSCILLATION ? 1
                         : kind == TINKER_MODE_DECAY     ? 2
                                                         : 0);
    }
    g_assert_cmpuint(modes_count(a, TINKER_MODE_DECAY), ==, 2);
}

/* A block that friction holds, one that two rods hold, and a support alone. */
static void test_nothing_to_swing(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        "{'type': 'gravity'}, {'type': 'support', 'name': 'Floor', 'width': 8, 'height': 0.2, 'static_friction': 0.5, "
        "'dynamic_friction': 0.4}, {'type': 'mass', 'name': 'Block', 'width': 1, 'height': 1, 'position': [0, 0.6]}");
    g_autoptr(ModesFixture) rod = modes_about_rest(
        "{'type': 'support', 'solid': false}, {'type': 'support', 'name': 'Other', 'solid': false, 'position': [2, 0]},"
        "{'type': 'mass', 'position': [1, 1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': "
        "1.4142135623730951},"
        "{'type': 'rod', 'ends': ['Other', 'Mass 0'], 'length': 1.4142135623730951}");
    g_autoptr(ModesFixture) empty = modes_about_rest("{'type': 'support'}");
    g_autofree char *held = tinker_modes_none(a->analysis, a->scene),
                    *joined = tinker_modes_none(rod->analysis, rod->scene),
                    *none = tinker_modes_none(empty->analysis, empty->scene);
    g_assert_cmpuint(a->analysis->modes->len, ==, 0);
    g_assert_nonnull(strstr(held, "none of the scene's 2 degrees of freedom where it comes to rest"));
    g_assert_nonnull(strstr(held, "\nBlock: held on Floor by friction"));
    g_assert_cmpstr(joined, ==, "Nothing in this scene swings: its joints leave it no degree of freedom.");
    g_assert_cmpstr(none, ==, "Nothing in this scene can move.");
}

static void assert_left_out(const char *blocks, const char *sentence)
{
    g_autoptr(ModesFixture) fixture = modes_about_rest(blocks);
    g_autoptr(GPtrArray) sentences = tinker_modes_left_out(fixture->analysis, fixture->scene);
    g_assert_cmpuint(sentences->len, ==, sentence != NULL ? 1 : 0);
    if (sentence != NULL) g_assert_cmpstr(g_ptr_array_index(sentences, 0), ==, sentence);
}

/* On a spring from a wall, over a floor; on that at 0.3, where it would sink through the floor to hang on its spring.
 */
static char *disc_at(double height)
{
    return g_strdup_printf(
        "{'type': 'gravity'}, {'type': 'support', 'name': 'Floor', 'position': [0, -0.2], 'width': 10},"
        "{'type': 'support', 'name': 'Wall', 'position': [-2, 0.3], 'solid': false},"
        "{'type': 'disc', 'radius': 0.3, 'position': [0, %g]},"
        "{'type': 'spring', 'ends': ['Wall', 'Disc 0'], 'stiffness': 30}",
        height);
}

/* A collar on a spring along an arm that a drive turns. */
static char *arm_driven_at(double speed)
{
    return g_strdup_printf("{'type': 'support', 'name': 'O', 'solid': false, 'position': [0, 0]},"
                           "{'type': 'bar', 'name': 'Arm', 'position': [0, 0]}, {'type': 'pin', 'ends': ['O', 'Arm']},"
                           "{'type': 'drive', 'ends': ['Arm', 'O'], 'speed': %g}, {'type': 'mass', 'position': [1, 0]},"
                           "{'type': 'slot', 'ends': ['Arm', 'Mass 0']},"
                           "{'type': 'spring', 'ends': ['O', 'Mass 0'], 'rest_length': 1}",
                           speed);
}

static void test_left_out(void)
{
    g_autofree char *touching = disc_at(0.3), *above = disc_at(20), *turning = arm_driven_at(5),
                    *standing = arm_driven_at(0);
    assert_left_out(touching, "Disc 0 touches Floor, which is left out: it rests and moves through it (a slot "
                              "holds what slides, a rack what rolls)");
    assert_left_out(above, NULL);
    assert_left_out(turning, "Drive 0 is held still where it is at t = 0: its motion is left out");
    assert_left_out(standing, NULL);
}

/* What is added in time alone forces the mass, and is left out of no mode. */
static void test_varying(void)
{
    static const struct {
        const char *law;
        gboolean is_connector, varies;
    } cases[] = {
        {"9*(L - 1)*(1 + 0.2*sin(6*t))", TRUE, TRUE},
        {"9*(L - 1) + 3*sin(6*t)", TRUE, FALSE},
        {"(1 + t)*rate", TRUE, TRUE},
        {"-if(t < 20, 1, 2)*x", FALSE, TRUE},
        {"3*t - x", FALSE, FALSE},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *blocks = g_strdup_printf(
            cases[i].is_connector ? "{'type': 'support', 'name': 'Wall'}, {'type': 'mass', 'position': [1, 0]},"
                                    "{'type': 'law-connector', 'ends': ['Wall', 'Mass 0'], 'tension': '%s'}"
                                  : "{'type': 'mass', 'position': [0, 0]},"
                                    "{'type': 'law-force', 'ends': ['Mass 0'], 'force_x': '%s'}",
            cases[i].law);
        const char *name = cases[i].is_connector ? "Typed Connector 0" : "Typed Force 0";
        g_autofree char *sentence =
            g_strdup_printf("%s varies in time: its stiffness and damping count as at t = 0", name);
        assert_left_out(blocks, cases[i].varies ? sentence : NULL);
    }
}

static void add_tests(void)
{
    g_test_add_func("/analysis/mode-words/two-masses", test_two_masses);
    g_test_add_func("/analysis/mode-words/three-masses", test_three_masses);
    g_test_add_func("/analysis/mode-words/two-discs", test_two_discs);
    g_test_add_func("/analysis/mode-words/numbers-and-ratios", test_numbers_and_ratios);
    g_test_add_func("/analysis/mode-words/ratio-of-three", test_ratio_of_three);
    g_test_add_func("/analysis/mode-words/number-of-pair", test_number_of_pair);
    g_test_add_func("/analysis/mode-words/nothing-to-swing", test_nothing_to_swing);
    g_test_add_func("/analysis/mode-words/left-out", test_left_out);
    g_test_add_func("/analysis/mode-words/varying", test_varying);
    g_test_add_func("/analysis/mode-words/captions", test_captions);
    g_test_add_func("/analysis/mode-words/damped-caption", test_damped_caption);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
