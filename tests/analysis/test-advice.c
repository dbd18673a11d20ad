/* Advice: every kind is found where it is and nowhere else; after its repair it is gone, the scene compiles, and one
 * undo brings the text back. */
#include <math.h>
#include <string.h>

#include "analysis/start/advice.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "start-fixture.h"

static const TinkerAdvice *only(const GPtrArray *all, TinkerAdviceKind kind)
{
    if (all->len != 1) {
        for (guint i = 0; i < all->len; i++)
            g_test_message("%s", ((const TinkerAdvice *)g_ptr_array_index(all, i))->message);
        g_error("%u pieces of advice", all->len);
    }
    const TinkerAdvice *advice = g_ptr_array_index(all, 0);
    g_test_message("%s [%s]", advice->message, advice->repair == NULL ? "-" : advice->repair);
    g_assert_cmpint(advice->kind, ==, kind);
    g_assert_cmpuint(advice->blocks->len, >, 0);
    return advice;
}

/* The one piece of advice has these words and is about this block; NULL: no such repair. */
static void assert_only(const StartFixture *f, TinkerAdviceKind kind, gboolean blocks_run, const char *block,
                        const char *part, const char *repair)
{
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    const TinkerAdvice *advice = only(all, kind);
    g_assert_cmpint(advice->blocks_run, ==, blocks_run);
    g_assert_cmpint(g_array_index(advice->blocks, TinkerBlockId, 0), ==, start_fixture_block(f, block));
    g_assert_nonnull(strstr(advice->message, block));
    g_assert_nonnull(strstr(advice->message, part));
    g_assert_cmpstr(advice->repair, ==, repair);
}

/* Repairs the one piece of advice; then there is none. */
static void repair(StartFixture *f)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 1);
    g_assert_true(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, 0), &error));
    g_assert_no_error(error);
    start_fixture_assert_one_step(f);
    g_autoptr(GPtrArray) left = tinker_advice_new(f->scene);
    g_assert_cmpuint(left->len, ==, 0);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0);
}

static void test_nothing_wrong(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        "{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [3, -4], 'velocity': [4, 3]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Support 0'], 'length': 5},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1}");
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 0);
}

/* Two masses, a box of half width 0.2 about x = 3.2 and a point, and a spring whose second end is loose at (x, 0). */
static StartFixture *with_loose_end(double x)
{
    g_autofree char *blocks =
        g_strdup_printf("{'type': 'support', 'name': 'Far', 'position': [0, 0]},"
                        "{'type': 'mass', 'name': 'Near', 'position': [3.2, 0], 'width': 0.4},"
                        "{'type': 'mass', 'name': 'Point', 'position': [2.7, 0.4], 'width': 0, 'height': 0},"
                        "{'type': 'spring', 'ends': ['Far', [%g, 0]]}",
                        x);
    return start_fixture_new(blocks);
}

static void test_detached_end(void)
{
    g_autoptr(StartFixture) f = with_loose_end(2.8);
    assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Spring 0", "end 2", "Connect it to Near");
    g_autoptr(StartFixture) g = with_loose_end(3.1);
    repair(g);
    g_assert_cmpint(tinker_scene_end(g->scene, start_fixture_block(g, "Spring 0"), 1).block, ==,
                    start_fixture_block(g, "Near"));
    g_autoptr(StartFixture) h = with_loose_end(1e3);
    assert_only(h, TINKER_ADVICE_DETACHED_END, TRUE, "Spring 0", "end 2", NULL);
    g_autoptr(GPtrArray) all = tinker_advice_new(h->scene);
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_advice_repair(h->history, h->scene, g_ptr_array_index(all, 0), &error));
    start_fixture_assert_untouched(h);
}

static void test_missing_type(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'mass'}, {'type': 'masss', 'name': 'Odd'}");
    assert_only(f, TINKER_ADVICE_MISSING_TYPE, TRUE, "Odd", "mass", NULL);
}

/* (3, 1) along a rod of direction (0.6, 0.8) has 2.6 along it; what is left is (3, 1) - 2.6 (0.6, 0.8) = (1.44, -1.08),
 * of size 1.8. */
static void test_velocity(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support'}, {'type': 'mass', 'position': [0.6, 0.8], "
                          "'velocity': [3, 1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Mass 0", "2.6 m/s along Rod 0",
                "Set the velocity to 1.8 m/s across");
    repair(f);
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
    assert_only(f, TINKER_ADVICE_LENGTH, TRUE, "Rod 0", "5 m apart", "Use the length as drawn");
    repair(f);
    physics_assert_near("length", start_fixture_get(f, "Rod 0", TINKER_MEANING_LENGTH, 0), 5, 0);
}

/* The scene is refused, about the first of its rods. */
static void assert_contradiction(const char *blocks)
{
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    assert_only(f, TINKER_ADVICE_MODEL, TRUE, "Rod 0", "no motion satisfies these constraints", NULL);
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
    assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Mass 0", "does not fit what ties it", "Set the velocity to 0 m/s");
    repair(f);
    physics_assert_near("vx", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 0, 1e-14);
    physics_assert_near("vy", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 0, 1e-14);
}

/* The top lies at 0.2, the mass reaches down to -0.1. */
static void test_overlap(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 4, 'height': 0.4},"
                          "{'type': 'mass', 'position': [0, 0.3], 'height': 0.8}");
    assert_only(f, TINKER_ADVICE_OVERLAP, FALSE, "Mass 0", "Floor", "Move it out by 0.3 m");
    repair(f);
    physics_assert_near("y", start_fixture_get(f, "Mass 0", TINKER_MEANING_POSITION, 1), 0.6, 1e-15);
}

/* Of 40 boxes within a floor, all at one height, five are told of one by one and the other 35 at once; mended one after
 * another the last is told of in the end. */
static void test_many_overlaps(void)
{
    g_autoptr(GString) blocks =
        g_string_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 100, 'height': 0.4}");
    for (int i = 0; i < 40; i++)
        g_string_append_printf(blocks, ",{'type': 'mass', 'position': [%d, 0.3], 'height': 0.8}", i - 20);
    g_autoptr(StartFixture) f = start_fixture_new(blocks->str);
    for (guint left = 40; left > 0; left--) {
        g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
        g_assert_cmpuint(all->len, ==, MIN(left, 6));
        for (guint i = 0; i < MIN(left, 5); i++)
            g_assert_nonnull(((const TinkerAdvice *)g_ptr_array_index(all, i))->repair);
        if (left > 5) {
            const TinkerAdvice *more = g_ptr_array_index(all, 5);
            g_autofree char *text = g_strdup_printf("and %u more start", left - 5);
            g_assert_true(g_str_has_prefix(more->message, text));
            g_assert_null(more->repair);
            g_assert_cmpuint(more->blocks->len, ==, left - 5);
        }
        g_assert_true(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, 0), NULL));
    }
    g_autoptr(GPtrArray) none = tinker_advice_new(f->scene);
    g_assert_cmpuint(none->len, ==, 0);
}

/* The sides are 3.2 m apart and come nearer by 4 m/s, so they meet within the 10 s; there is nothing to repair. */
static void test_meeting(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'mass', 'position': [-3, 0], 'velocity': [3, 0]},"
                                                  "{'type': 'mass', 'position': [1, 0], 'velocity': [-1, 0]}");
    assert_only(f, TINKER_ADVICE_MEETING, FALSE, "Mass 0", "Mass 0 and Mass 1 meet at 0.8 s", NULL);
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
    assert_only(f, TINKER_ADVICE_VELOCITY, FALSE, "Bar 0", "does not fit what ties it", "Set the velocity to 0.5 m/s");
    repair(f);
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
    assert_only(f, TINKER_ADVICE_JOINT, TRUE, "Pin 0", "do not fit together", "Bring Support 0 and Bar 0 together");
    repair(f);
    physics_assert_near("x", start_fixture_get(f, "Bar 0", TINKER_MEANING_POSITION, 0), 0.5, 1e-12);
    physics_assert_near("second x", start_fixture_get(f, "Bar 1", TINKER_MEANING_POSITION, 0), 1.5, 1e-12);
}

/* A rope over the centre of a disc does not run round it, which the picture would have one think; an eye on its rim, a
 * support and a bar are no wheels. */
static void test_small_wheel(void)
{
    static const char *const blocks =
        "{'type': 'support', 'name': 'Hook', 'position': [0, 3], 'solid': false},"
        "{'type': 'disc', 'name': 'Wheel', 'position': [2, 3]}, {'type': 'bar', 'name': 'Bar', 'position': [5, 3]},"
        "{'type': 'mass', 'name': 'A', 'position': [-1, 0]}, {'type': 'mass', 'name': 'B', 'position': [8, 0]},"
        "{'type': 'rope', 'name': 'Line', 'ends': ['A', 'Hook', %s, 'Bar', 'B']}";
    g_autofree char *centre = g_strdup_printf(blocks, "'Wheel'");
    g_autofree char *rim = g_strdup_printf(blocks, "{'block': 'Wheel', 'at': [0, 0.4]}");
    g_autoptr(StartFixture) f = start_fixture_new(centre);
    assert_only(f, TINKER_ADVICE_SMALL_WHEEL, FALSE, "Line", "small wheel at the centre of Wheel", NULL);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 1);
    g_assert_cmpstr(g_ptr_array_index(tinker_model_warnings(model), 0), ==,
                    only(all, TINKER_ADVICE_SMALL_WHEEL)->message);
    g_autoptr(StartFixture) g = start_fixture_new(rim);
    g_autoptr(GPtrArray) none = tinker_advice_new(g->scene);
    g_assert_cmpuint(none->len, ==, 0);
}

/* What acts on angles alone does nothing to a mass, and between two ends of one disc; a support and a second disc are
 * turned against. */
static void test_idle_turns(void)
{
    static const char *const blocks = "{'type': 'mass', 'name': 'M', 'position': [0, 3]}, {'type': 'disc', 'name': "
                                      "'D'}, {'type': 'disc', 'name': 'E', 'position': [3, 0]}, {'type': 'support', "
                                      "'name': 'S', 'position': [0, -3]}, {'type': '%s', 'name': 'By', 'ends': %s}";
    static const struct {
        const char *type, *ends, *part;
    } cases[] = {
        {"torque", "['M']", "By: it acts on angles alone, and M is a point"},
        {"torsional-spring", "['D', 'M']", "By: it acts on angles alone, and M is a point"},
        {"torsional-damper", "['M', 'S']", "By: it acts on angles alone, and M is a point"},
        {"gear", "['D', 'D']", "By: two of its ends are on D"},
        {"torsional-spring", "['E', {'block': 'E', 'at': [0.1, 0]}]", "By: two of its ends are on E"},
        {"torque", "['D', 'S']", NULL},
        {"torsional-spring", "['D', 'E']", NULL},
        {"gear", "['D', 'E', 'S']", NULL},
        {"spring", "['M', 'D']", NULL},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = g_strdup_printf(blocks, cases[i].type, cases[i].ends);
        g_autoptr(StartFixture) f = start_fixture_new(text);
        if (cases[i].part != NULL) assert_only(f, TINKER_ADVICE_IDLE_TURN, FALSE, "By", cases[i].part, NULL);
        g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
        g_assert_nonnull(model);
        g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
        g_assert_cmpuint(tinker_model_warnings(model)->len, ==, cases[i].part != NULL);
        g_assert_cmpuint(all->len, ==, cases[i].part != NULL);
        if (cases[i].part != NULL)
            g_assert_cmpstr(g_ptr_array_index(tinker_model_warnings(model), 0), ==,
                            only(all, TINKER_ADVICE_IDLE_TURN)->message);
    }
}

/* A cord from a mass to a disc is the wrong way round; swapped, the scene compiles. With a radius of its own it is as
 * meant. */
static void test_wound_ends(void)
{
    static const char *const blocks = "{'type': 'disc', 'name': 'Wheel'}, {'type': 'mass', 'name': 'M', 'position': "
                                      "[0, -2]}, {'type': 'cord', 'name': 'Line', 'ends': ['M', 'Wheel']%s}";
    g_autofree char *wrong = g_strdup_printf(blocks, ""), *meant = g_strdup_printf(blocks, ", 'radius': 0.1");
    g_autoptr(StartFixture) f = start_fixture_new(wrong);
    assert_only(f, TINKER_ADVICE_WOUND_ENDS, TRUE, "Line", "M is not round", "Swap its ends");
    repair(f);
    const TinkerBlockId line = start_fixture_block(f, "Line");
    g_assert_cmpint(tinker_scene_end(f->scene, line, 0).block, ==, start_fixture_block(f, "Wheel"));
    g_assert_cmpint(tinker_scene_end(f->scene, line, 1).block, ==, start_fixture_block(f, "M"));
    g_autoptr(StartFixture) g = start_fixture_new(meant);
    g_autoptr(GPtrArray) none = tinker_advice_new(g->scene);
    for (guint i = 0; i < none->len; i++)
        g_assert_cmpint(((const TinkerAdvice *)g_ptr_array_index(none, i))->kind, !=, TINKER_ADVICE_WOUND_ENDS);
}

/* A loose end of a pin is connected where it lies, not to the centre. */
static void test_loose_pin(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'support'}, {'type': 'bar', 'position': [0.5, 0]},"
                                                  "{'type': 'pin', 'ends': ['Support 0', [0, 0]]}");
    assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Pin 0", "is not connected", "Connect it to Bar 0");
    repair(f);
    const TinkerSceneEnd end = tinker_scene_end(f->scene, start_fixture_block(f, "Pin 0"), 1);
    g_assert_cmpfloat(end.x, ==, -0.5);
}

/* What it is connected to lies under it, and above what else does: a drive of a crank with its other end over bearing,
 * coupler and rod gets the bearing, which is drawn above them; nothing is offered that lies 0.3 m away, on a canvas of
 * 10 m. A disc is as large as its radius. */
static void test_loose_end_finds_what_is_under_it(void)
{
    static const char *const blocks =
        "{'type': 'support', 'name': 'Bearing', 'solid': false, 'width': 0.3, 'height': 0.2},"
        "{'type': 'bar', 'name': 'Coupler', 'position': [0, 0.03], 'width': 0.1},"
        "{'type': 'bar', 'name': 'Crank', 'position': [0.5, 0], 'width': 0.1},"
        "{'type': 'disc', 'name': 'Wheel', 'position': [3, 0], 'radius': 1},"
        "{'type': 'drive', 'ends': ['Crank', [%g, %g]]}";
    static const struct {
        double x, y;
        const char *repair;
    } cases[] = {{0, 0.02, "Connect it to Bearing"}, {0.3, 0.04, "Connect it to Coupler"},
                 {0.3, 0.38, "Add a support there"}, {2.4, 0.7, "Connect it to Wheel"},
                 {2.2, 0.9, "Connect it to Wheel"},  {2.2, 1.1, "Add a support there"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = g_strdup_printf(blocks, cases[i].x, cases[i].y);
        g_autoptr(StartFixture) f = start_fixture_new(text);
        assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Drive 0", "is not connected", cases[i].repair);
    }
}

/* A loose end over a long plate stays where it was drawn, far from the plate's centre; at a pivot it goes to that. */
static void test_loose_end_at_a_support(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'width': 8}, {'type': 'mass', 'position': [0, 2]},"
                          "{'type': 'spring', 'ends': ['Mass 0', [-3, 0.4]]}");
    repair(f);
    const TinkerSceneEnd plate = tinker_scene_end(f->scene, start_fixture_block(f, "Spring 0"), 1);
    g_assert_cmpint(plate.block, ==, start_fixture_block(f, "Support 0"));
    physics_assert_near("x", plate.x, -3, 1e-12);
    physics_assert_near("y", plate.y, 0.4, 1e-12);
    g_autoptr(StartFixture) g =
        start_fixture_new("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 2]},"
                          "{'type': 'spring', 'ends': ['Mass 0', [0, 0.3]]}");
    repair(g);
    const TinkerSceneEnd pivot = tinker_scene_end(g->scene, start_fixture_block(g, "Spring 0"), 1);
    g_assert_cmpint(pivot.block, ==, start_fixture_block(g, "Support 0"));
    g_assert_true(pivot.x == 0 && pivot.y == 0);
}

/* A pendulum's pin without anything to hold on to gets a pivot where it is; a spring that hangs from nothing, too. */
static void test_support_is_added(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'bar', 'position': [0.5, 2]},"
                          "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [-0.5, 0]}, [0, 2]]}");
    assert_only(f, TINKER_ADVICE_DETACHED_END, TRUE, "Pin 0", "is not connected", "Add a support there");
    repair(f);
    const TinkerSceneEnd end = tinker_scene_end(f->scene, start_fixture_block(f, "Pin 0"), 1);
    g_assert_cmpint(end.block, ==, start_fixture_block(f, "Support 0"));
    physics_assert_near("x", start_fixture_get(f, "Support 0", TINKER_MEANING_POSITION, 0), 0, 0);
    physics_assert_near("y", start_fixture_get(f, "Support 0", TINKER_MEANING_POSITION, 1), 2, 0);
    physics_assert_near("solid", start_fixture_get(f, "Support 0", TINKER_MEANING_SOLID, 0), 0, 0);
    g_autoptr(GPtrArray) rest = tinker_advice_new(f->scene);
    g_assert_cmpuint(rest->len, ==, 0);
}

/* A bar that nothing holds, over a floor or leaning at it, would pass it; not where it is solid, hangs, is beside the
 * floor, or nothing pulls it. */
static void test_passing(void)
{
    static const char floor[] = "{'type': 'support', 'name': 'Floor', 'position': [0, -0.5], 'height': 1, 'width': 4}",
                      pull[] = "{'type': 'gravity', 'name': 'G'}";
    static const struct {
        const char *bar, *more;
        gboolean passes;
    } cases[] = {{"'position': [1, 3]", pull, TRUE},
                 {"'position': [1, 3], 'solid': true", pull, FALSE},
                 {"'position': [2.5, 3]", pull, FALSE},
                 {"'position': [1, 3]", NULL, FALSE},
                 {"'position': [1, -3]", pull, FALSE},
                 {"'position': [1, 3]", "{'type': 'wind', 'drag': 1}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'acceleration': 0}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'angle': '90 deg'}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'angle': '-45 deg'}", FALSE},
                 {"'position': [-3, 3]", "{'type': 'gravity', 'angle': '-45 deg'}", TRUE},
                 {"'position': [0, 0.5], 'orientation': '90 deg', 'width': 0", NULL, TRUE},
                 {"'position': [1, 3]",
                  "{'type': 'gravity', 'name': 'G'}, {'type': 'support', 'name': 'Hook', 'position': [1, 5], "
                  "'orientation': '180 deg'}, {'type': 'spring', 'name': 'K', 'ends': ['Hook', 'Bar']}",
                  FALSE}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *blocks =
            g_strdup_printf("%s, {'type': 'bar', 'name': 'Bar', 'length': 1, %s}%s%s", floor, cases[i].bar,
                            cases[i].more != NULL ? ", " : "", cases[i].more != NULL ? cases[i].more : "");
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        g_test_message("case %d", (int)i);
        if (cases[i].passes) {
            assert_only(f, TINKER_ADVICE_PASSING, FALSE, "Bar", "passes through Floor", "Make It Solid");
            repair(f);
        } else {
            g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
            g_assert_cmpuint(all->len, ==, 0);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/advice/support-is-added", test_support_is_added);
    g_test_add_func("/advice/loose-end-at-a-support", test_loose_end_at_a_support);
    g_test_add_func("/advice/rate", test_rate);
    g_test_add_func("/advice/joint", test_joint);
    g_test_add_func("/advice/small-wheel", test_small_wheel);
    g_test_add_func("/advice/idle-turns", test_idle_turns);
    g_test_add_func("/advice/passing", test_passing);
    g_test_add_func("/advice/loose-end-under", test_loose_end_finds_what_is_under_it);
    g_test_add_func("/advice/wound-ends", test_wound_ends);
    g_test_add_func("/advice/loose-pin", test_loose_pin);
    g_test_add_func("/advice/nothing-wrong", test_nothing_wrong);
    g_test_add_func("/advice/detached-end", test_detached_end);
    g_test_add_func("/advice/missing-type", test_missing_type);
    g_test_add_func("/advice/velocity", test_velocity);
    g_test_add_func("/advice/velocity-of-two", test_velocity_of_two);
    g_test_add_func("/advice/length", test_length);
    g_test_add_func("/advice/contradiction", test_contradiction);
    g_test_add_func("/advice/velocity-across-a-bar", test_velocity_across_a_bar);
    g_test_add_func("/advice/overlap", test_overlap);
    g_test_add_func("/advice/many-overlaps", test_many_overlaps);
    g_test_add_func("/advice/meeting", test_meeting);
    g_test_add_func("/advice/stale", test_stale);
    g_test_add_func("/advice/many", test_many);
    g_test_add_func("/advice/bundled-scenes", test_bundled_scenes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
