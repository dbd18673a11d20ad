/* Advice about places, lengths and velocities, and of scenes that need none: every kind is found where it is and
 * nowhere else; after its repair it is gone, the scene compiles, and one undo brings the text back. */
#include <math.h>
#include <string.h>

#include "advice-checks.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"

static void test_nothing_wrong(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        "{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [3, -4], 'velocity': [4, 3]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Support 0'], 'length': 5},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1}");
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 0);
}

static void test_missing_type(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'mass'}, {'type': 'masss', 'name': 'Odd'}");
    advice_assert_only(f, TINKER_ADVICE_MISSING_TYPE, TRUE, "Odd", "mass", NULL);
}

/* (3, 1) along a rod of direction (0.6, 0.8) has 2.6 along it; what is left is (3, 1) - 2.6 (0.6, 0.8) = (1.44, -1.08),
 * of size 1.8. */
static void test_velocity(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support'}, {'type': 'mass', 'position': [0.6, 0.8], "
                          "'velocity': [3, 1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    advice_assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Mass 0", "2.6 m/s along Rod 0",
                       "Set the velocity to 1.8 m/s across");
    advice_repair(f);
    physics_assert_near("vx", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 1.44, 1e-14);
    physics_assert_near("vy", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), -1.08, 1e-14);
}

/* On a rod between 1 and 3 kg of which one is pushed along it with 4 m/s both move with 1, by momentum; a second such
 * pair is advice of its own. */
static void test_velocity_of_two(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        "{'type': 'mass', 'velocity': [4, 0.5], 'width': 0}, {'type': 'mass', 'mass': 3, 'position': [2, 0]},"
        "{'type': 'rod', 'ends': ['Mass 1', 'Mass 0']}, {'type': 'mass', 'position': [0, 5]},"
        "{'type': 'mass', 'position': [0, 6], 'velocity': [0, 1], 'width': 0}, {'type': 'rod', 'ends': ['Mass 2', "
        "'Mass 3']}");
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 2);
    for (guint i = 0; i < 2; i++)
        g_assert_true(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, i), NULL));
    physics_assert_near("v0", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 1, 1e-14);
    physics_assert_near("v0 across", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 0.5, 1e-14);
    physics_assert_near("v1", start_fixture_get(f, "Mass 1", TINKER_MEANING_VELOCITY, 0), 1, 1e-14);
    physics_assert_near("v2", start_fixture_get(f, "Mass 2", TINKER_MEANING_VELOCITY, 1), 0.5, 1e-14);
    g_autoptr(GPtrArray) left = tinker_advice_new(f->scene);
    g_assert_cmpuint(left->len, ==, 0);
}

static void test_length(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"
                                                  "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    advice_assert_only(f, TINKER_ADVICE_LENGTH, TRUE, "Rod 0", "5 m apart", "Use the length as drawn");
    advice_repair(f);
    physics_assert_near("length", start_fixture_get(f, "Rod 0", TINKER_MEANING_LENGTH, 0), 5, 0);
}

/* The scene is refused, about the first of its rods. */
static void assert_contradiction(const char *blocks)
{
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    advice_assert_only(f, TINKER_ADVICE_MODEL, TRUE, "Rod 0", "no motion satisfies these constraints", NULL);
}

/* A mass between two rods in one line, of which one pulls with 1 m/s^2 and the other holds: no motion satisfies both. A
 * rigid triangle that hangs on parallel rods of 1, 2 and 3 m and starts across them with 1 m/s without turning: each
 * rod asks for v^2 / l upwards, 1, 1/2 and 1/3 m/s^2, and a rigid body's third corner, halfway along, for their mean,
 * 3/4. */
static void test_contradiction(void)
{
    assert_contradiction(
        "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
        "{'type': 'support', 'solid': false, 'position': [2, 0]}, {'type': 'mass', 'position': [1, 0]},"
        "{'type': 'support-motion', 'ends': ['Support 1'], 'waveform': {'expression': '0.5*t^2'}},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 0']}");
    assert_contradiction(
        "{'type': 'support', 'solid': false, 'position': [0, 1]},"
        "{'type': 'support', 'solid': false, 'position': [2, 2]},"
        "{'type': 'support', 'solid': false, 'position': [1, 4]},"
        "{'type': 'mass', 'velocity': [1, 0]}, {'type': 'mass', 'position': [2, 0], 'velocity': [1, 0]},"
        "{'type': 'mass', 'position': [1, 1], 'velocity': [1, 0]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 1']},"
        "{'type': 'rod', 'ends': ['Support 2', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
        "{'type': 'rod', 'ends': ['Mass 1', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 2', 'Mass 0']}");
}

/* Rods in one line between supports are a straight bar, which holds what lies on it: a velocity across it is left out,
 * and is none along a rod. */
static void test_velocity_across_a_bar(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
        "{'type': 'support', 'solid': false, 'position': [2, 0]},"
        "{'type': 'mass', 'position': [1, 0], 'velocity': [0, 1]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 0']}");
    advice_assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Mass 0", "does not fit what ties it",
                       "Set the velocity to 0 m/s");
    advice_repair(f);
    physics_assert_near("vx", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 0, 1e-14);
    physics_assert_near("vy", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 0, 1e-14);
}

/* Advice outlives the scene that it was given for. */
static void test_stale(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"
                                                  "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}");
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_autoptr(GError) error = NULL;
    tinker_scene_remove_block(f->scene, start_fixture_block(f, "Rod 0"));
    g_assert_false(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, 0), &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_assert_null(tinker_history_can_undo(f->history));
}

/* 100 masses in a row, every second pushed along its rod: a mistake each, and none of the others. */
static void test_many(void)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'support', 'solid': false, 'name': 'M0'}");
    for (int i = 1; i <= 100; i++)
        g_string_append_printf(
            blocks,
            ", {'type': 'mass', 'name': 'M%d', 'position': [%d, 0], 'velocity': [%d, 0], 'width': 0},"
            "{'type': '%s', 'ends': ['M%d', 'M%d']}",
            i, i, i % 2, i % 2 ? "spring" : "rod", i - 1, i);
    g_autoptr(StartFixture) f = start_fixture_new(blocks->str);
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 50);
}

/* What is bundled runs, and is well set up. */
static void test_bundled_scenes(void)
{
    g_autofree char *folder = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "scenes", NULL);
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    int scenes = 0;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
        g_assert_no_error(error);
        g_autoptr(GPtrArray) all = tinker_advice_new(scene);
        g_test_message("%s", name);
        for (guint i = 0; i < all->len; i++) {
            const TinkerAdvice *advice = g_ptr_array_index(all, i);
            g_test_message("%s", advice->message);
            g_assert_false(advice->blocks_run);
        }
        scenes++;
    }
    g_assert_cmpint(scenes, >, 20);
}

/* A bar on a pin that is told to spin, and its centre to stand still: the repair gives both what fits. */
static void test_rate(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support'}, {'type': 'bar', 'position': [0.5, 0], 'angular_velocity': 4},"
                          "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    advice_assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Bar 0", "does not fit what ties it",
                       "Set the velocity to 0.5 m/s");
    advice_repair(f);
    const double rate = start_fixture_get(f, "Bar 0", TINKER_MEANING_ANGULAR_VELOCITY, 0);
    physics_assert_near("rate", rate, 4 * (1 / 12.0) / (1 / 12.0 + 0.25), 1e-12); /* I / (I + m l^2 / 4) of it */
    physics_assert_near("vy", start_fixture_get(f, "Bar 0", TINKER_MEANING_VELOCITY, 1), 0.5 * rate, 1e-12);
}

/* A pin whose ends lie 0.3 m apart, and a bar behind it: the repair moves the bars, the wall stays. */
static void test_joint(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        "{'type': 'support'}, {'type': 'bar', 'position': [0.8, 0]}, {'type': 'bar', 'position': [2, 0]},"
        "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, {'block': 'Bar 1', 'at': [-0.5, "
        "0]}]}");
    advice_assert_only(f, TINKER_ADVICE_JOINT, TRUE, "Pin 0", "do not fit together",
                       "Bring Support 0 and Bar 0 together");
    advice_repair(f);
    physics_assert_near("x", start_fixture_get(f, "Bar 0", TINKER_MEANING_POSITION, 0), 0.5, 1e-12);
    physics_assert_near("second x", start_fixture_get(f, "Bar 1", TINKER_MEANING_POSITION, 0), 1.5, 1e-12);
}

static void add_tests(void)
{
    g_test_add_func("/advice/rate", test_rate);
    g_test_add_func("/advice/joint", test_joint);
    g_test_add_func("/advice/nothing-wrong", test_nothing_wrong);
    g_test_add_func("/advice/missing-type", test_missing_type);
    g_test_add_func("/advice/velocity", test_velocity);
    g_test_add_func("/advice/velocity-of-two", test_velocity_of_two);
    g_test_add_func("/advice/length", test_length);
    g_test_add_func("/advice/contradiction", test_contradiction);
    g_test_add_func("/advice/velocity-across-a-bar", test_velocity_across_a_bar);
    g_test_add_func("/advice/stale", test_stale);
    g_test_add_func("/advice/many", test_many);
    g_test_add_func("/advice/bundled-scenes", test_bundled_scenes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
