/* Starts by an angle, a stretch, a speed and a length against trigonometry, what is refused, and all that is offered in
 * the bundled scenes; undo against the text of the scene. */
#include <math.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "start-offers.h"

/* L sin, -L cos; the length stays what it is, whether given or drawn. */
static void test_pendulum(void)
{
    const char *const lengths[] = {"", ", 'length': 5"};
    for (gsize i = 0; i < G_N_ELEMENTS(lengths); i++) {
        g_autofree char *blocks =
            g_strdup_printf(GRAVITY "{'type': 'support', 'position': [1, 1]},"
                                    "{'type': 'mass', 'position': [4, -3], 'velocity': [0.8, 0.6]},"
                                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']%s}",
                            lengths[i]);
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        physics_assert_near("angle", start_value_of(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0"), atan2(3, 4), 1e-15);
        start_apply(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", -G_PI / 6);
        start_assert_at(f, "Mass 0", 1 - 2.5, 1 - 5 * sqrt(0.75));
        start_assert_moves(f, "Mass 0", cos(G_PI / 6), -sin(G_PI / 6)); /* across as before */
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
        g_assert_no_error(error);
        g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0);
        g_autoptr(StartFixture) g = start_fixture_new(blocks);
        start_apply(g, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
        start_assert_at(g, "Mass 0", 1, -4);
        g_assert_false(start_is_offered(f, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL));
    }
}

/* The second mass turns with the first; of the second alone the first stays where it is. */
static void test_double_pendulum(void)
{
    const char *blocks =
        GRAVITY "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [0, -1]},"
                "{'type': 'mass', 'position': [0, -3]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1'], 'length': 2}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    start_apply(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", G_PI / 2);
    start_assert_at(f, "Mass 0", 1, 0);
    start_assert_at(f, "Mass 1", 3, 0);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Mass 1", TINKER_START_AT_ANGLE, "Rod 1", G_PI / 2);
    start_assert_at(g, "Mass 0", 0, -1);
    start_assert_at(g, "Mass 1", 2, -1);
    /* tied to a second point, it cannot swing */
    g_autofree char *held = g_strconcat(blocks,
                                        ", {'type': 'support', 'name': 'Pin', 'position': [1, -1]},"
                                        "{'type': 'rod', 'name': 'Stay', 'ends': ['Pin', 'Mass 0']}",
                                        NULL);
    g_autoptr(StartFixture) h = start_fixture_new(held);
    start_assert_refused(h, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", 0.5, "its length is");
}

/* Bodies on a rod between them are shifted together; on a rod to a support nothing is offered. */
static void test_stretched_with_rods(void)
{
    const char *blocks = "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [2, 0]},"
                         "{'type': 'mass', 'position': [2, 1]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1.5}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    start_apply(f, "Mass 0", TINKER_START_STRETCHED, "Spring 0", -0.5);
    start_assert_at(f, "Mass 0", 1, 0);
    start_assert_at(f, "Mass 1", 1, 1);
    g_autofree char *held = g_strconcat(blocks, ", {'type': 'rod', 'ends': ['Mass 1', 'Support 0']}", NULL);
    g_autoptr(StartFixture) h = start_fixture_new(held);
    g_assert_false(start_is_offered(h, "Mass 0", TINKER_START_STRETCHED, NULL));
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_assert_refused(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", -1.5, "whole rest length");
    start_assert_refused(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", NAN, "finite");
}

static void test_thrown(void)
{
    const char *blocks = "{'type': 'mass', 'velocity': [3, 4]}, {'type': 'mass'}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    physics_assert_near("direction", start_value_of(f, "Mass 0", TINKER_START_DIRECTION, NULL), atan2(4, 3), 1e-15);
    start_apply(f, "Mass 0", TINKER_START_SPEED, NULL, 10);
    start_assert_moves(f, "Mass 0", 6, 8);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Mass 0", TINKER_START_DIRECTION, NULL, G_PI / 2);
    start_assert_moves(g, "Mass 0", 0, 5);
    g_autoptr(StartFixture) h = start_fixture_new(blocks);
    g_assert_false(start_is_offered(h, "Mass 1", TINKER_START_DIRECTION, NULL));
    start_assert_refused(h, "Mass 1", TINKER_START_SPEED, NULL, -1, "negative");
    start_apply(h, "Mass 1", TINKER_START_SPEED, NULL, 2);
    start_assert_moves(h, "Mass 1", 2, 0);
}

/* A place within a plate is no start. */
static void test_plate_in_the_way(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 9, 'height': 0.2},"
                          "{'type': 'support', 'name': 'Ceiling', 'solid': false, 'position': [0, 5]},"
                          "{'type': 'mass', 'position': [0, 2], 'height': 0.4},"
                          "{'type': 'spring', 'ends': ['Ceiling', 'Mass 0'], 'rest_length': 3}");
    start_assert_refused(f, "Mass 0", TINKER_START_STRETCHED, "Spring 0", 1.9, "Floor");
}

static void test_lengths_of_connectors(void)
{
    const char *blocks = "{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1},"
                         "{'type': 'rod', 'ends': ['Mass 0', 'Support 0'], 'length': 1}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    physics_assert_near("stretch", start_value_of(f, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL), 4, 1e-14);
    start_apply(f, "Spring 0", TINKER_START_LENGTH_AS_DRAWN, NULL, 0);
    physics_assert_near("rest length", start_fixture_get(f, "Spring 0", TINKER_MEANING_LENGTH, 0), 5, 1e-15);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    start_apply(g, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL, 0.5);
    physics_assert_near("rest length", start_fixture_get(g, "Spring 0", TINKER_MEANING_LENGTH, 0), 4.5, 1e-15);
    start_assert_at(g, "Mass 0", 3, 4);
    g_autoptr(StartFixture) h = start_fixture_new(blocks);
    g_assert_false(start_is_offered(h, "Rod 0", TINKER_START_LENGTH_STRETCHED, NULL));
    start_apply(h, "Rod 0", TINKER_START_LENGTH_AS_DRAWN, NULL, 0);
    physics_assert_near("length", start_fixture_get(h, "Rod 0", TINKER_MEANING_LENGTH, 0), 5, 1e-15);
    g_autoptr(StartFixture) k = start_fixture_new(blocks);
    start_assert_refused(k, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL, 6, "rest_length");
}

/* A block that is gone, a support, a loose connector: nothing to offer, and nothing breaks. */
static void test_nothing_to_offer(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support'}, {'type': 'mass'}, {'type': 'spring', 'ends': ['Mass 0', [1, 1]]}");
    const char *const names[] = {"Support 0", "Spring 0"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, names[i]));
        g_assert_cmpuint(options->len, ==, 0);
    }
    g_assert_false(start_is_offered(f, "Mass 0", TINKER_START_STRETCHED, NULL));
    g_autoptr(GPtrArray) of_mass = tinker_start_options_new(f->scene, start_fixture_block(f, "Mass 0"));
    tinker_scene_remove_block(f->scene, start_fixture_block(f, "Mass 0"));
    for (guint i = 0; i < of_mass->len; i++) {
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_start_apply(f->history, f->scene, g_ptr_array_index(of_mass, i), 1, &error));
        g_assert_nonnull(error);
    }
}

/* Every offer for every block of a bundled scene: applied with the value that it shows it is one step or changes
 * nothing; what it shows then is that value. */
static void try_all_offers(StartFixture *f, TinkerBlockId block)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, block);
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        g_autoptr(GError) error = NULL;
        g_assert_true(isfinite(option->value));
        if (tinker_start_apply(f->history, f->scene, option, option->value, &error)) {
            g_autoptr(GPtrArray) after = tinker_start_options_new(f->scene, block);
            const TinkerStartOption *again =
                option->other == TINKER_NO_BLOCK
                    ? start_find_option(f, after, option->kind, NULL)
                    : start_find_option(f, after, option->kind, tinker_scene_block_name(f->scene, option->other));
            if (again != NULL) physics_assert_near(option->label, again->value, option->value, 1e-8);
            while (tinker_history_can_undo(f->history) != NULL)
                tinker_history_undo(f->history);
        } else {
            g_assert_nonnull(error);
            g_test_message("%s", error->message);
        }
        g_autofree char *now = tinker_scene_to_text(f->scene, TINKER_WRITE_SI);
        g_assert_cmpstr(now, ==, f->text);
    }
}

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
        g_autoptr(StartFixture) f = g_new0(StartFixture, 1);
        f->scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
        g_assert_no_error(error);
        f->history = tinker_history_new(f->scene);
        f->text = tinker_scene_to_text(f->scene, TINKER_WRITE_SI);
        g_test_message("%s", name);
        for (int32_t i = 0; i < MIN(tinker_scene_block_count(f->scene), 40); i++)
            try_all_offers(f, tinker_scene_block_at(f->scene, i));
        scenes++;
    }
    g_assert_cmpint(scenes, >, 20);
}

static void add_tests(void)
{
    g_test_add_func("/start/pendulum", test_pendulum);
    g_test_add_func("/start/double-pendulum", test_double_pendulum);
    g_test_add_func("/start/stretched-with-rods", test_stretched_with_rods);
    g_test_add_func("/start/thrown", test_thrown);
    g_test_add_func("/start/plate-in-the-way", test_plate_in_the_way);
    g_test_add_func("/start/lengths-of-connectors", test_lengths_of_connectors);
    g_test_add_func("/start/nothing-to-offer", test_nothing_to_offer);
    g_test_add_func("/start/bundled-scenes", test_bundled_scenes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
