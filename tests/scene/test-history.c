/* Undo and redo: whatever was done, taking all of it back gives the same text, and doing it again too. */
#include <math.h>
#include <string.h>

#include "history-fixture.h"

/* A rope with four ends comes and goes as a whole, and its ends are set one by one. */
static void test_ends_of_choice(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId mass = tinker_history_add_block(history, scene_fixture_class("mass"), NULL, NULL);
    TinkerBlockId rope = tinker_history_add_block_of(history, scene_fixture_class("rope"), 4);
    g_assert_cmpint(tinker_scene_end_count(scene, rope), ==, 4);
    g_assert_cmpstr(tinker_scene_block_name(scene, rope), ==, "Rope 0");
    g_assert_true(tinker_history_set_end(history, rope, 3, (TinkerSceneEnd){mass, 0, 0}, NULL));
    g_autofree char *whole = history_text(scene);
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 1);
    tinker_history_redo(history);
    tinker_history_redo(history);
    g_autofree char *again = history_text(scene);
    g_assert_cmpstr(again, ==, whole);
    g_assert_cmpint(tinker_scene_end(scene, rope, 3).block, ==, mass);
}

static void test_titles_and_merging(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    const TinkerBlockClass *mass = scene_fixture_class("mass");
    int32_t position = tinker_block_class_property(mass, "position");
    g_assert_null(tinker_history_can_undo(history));
    TinkerBlockId id = tinker_history_add_block(history, mass, NULL, NULL);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Add Mass 0");
    for (int i = 1; i <= 3; i++) {
        tinker_history_begin(history, "Move Mass 0", "drag");
        tinker_history_set(history, id, position, (double[2]){i, i}, NULL);
        tinker_history_end(history);
    }
    tinker_history_begin(history, "Nothing", NULL);
    tinker_history_end(history);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Move Mass 0");
    tinker_history_undo(history);
    g_assert_cmpfloat(tinker_scene_get(scene, id, mass->first_columns[position]), ==, 0);
    g_assert_false(tinker_scene_property_given(scene, id, position));
    g_assert_cmpstr(tinker_history_can_redo(history), ==, "Move Mass 0");
    tinker_history_redo(history);
    g_assert_cmpfloat(tinker_scene_get(scene, id, mass->first_columns[position]), ==, 3);
    g_assert_null(tinker_history_can_redo(history));
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 0);
    g_assert_null(tinker_history_can_undo(history));
}

static void test_abort(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = history_text(scene);
    tinker_history_begin(history, "Much", NULL);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Mass 0"));
    tinker_history_add_block(history, scene_fixture_class("mass"), "Mass 0", NULL);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Support 0"));
    tinker_history_abort(history);
    g_autofree char *after = history_text(scene);
    g_assert_cmpstr(after, ==, before);
    g_assert_null(tinker_history_can_undo(history));
}

/* An undone removal brings back id, name, place, the ends that were on it, and its graph. */
static void test_removal(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId mass = tinker_scene_find_block(scene, "Mass 0"), spring = tinker_scene_find_block(scene, "Spring 0");
    tinker_history_remove_block(history, mass);
    g_assert_false(tinker_scene_has_block(scene, mass));
    TinkerSceneEnd end = tinker_scene_end(scene, spring, 1);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat(end.x, ==, 0.1);
    g_assert_cmpfloat(end.y, ==, 2);
    g_assert_cmpuint(tinker_scene_graphs(scene)->len, ==, 0);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_find_block(scene, "Mass 0"), ==, mass);
    g_assert_cmpint(tinker_scene_block_at(scene, 3), ==, mass);
    g_assert_cmpint(tinker_scene_end(scene, spring, 1).block, ==, mass);
    g_assert_cmpuint(tinker_scene_graphs(scene)->len, ==, 1);
}

/* Two blocks that change names in one step, with graphs, which must not change owners on the way. */
static void test_swapped_names(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read("{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"mass\", "
                           "\"name\": \"B\"}], \"graphs\": [{\"block\": \"A\", \"quantity\": \"x\"}, {\"block\": "
                           "\"B\", \"quantity\": \"y\"}]}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId a = tinker_scene_find_block(scene, "A"), b = tinker_scene_find_block(scene, "B");
    g_autofree char *before = history_text(scene);
    tinker_history_begin(history, "Swap", NULL);
    g_assert_true(tinker_history_rename_block(history, a, "C", NULL));
    g_assert_true(tinker_history_rename_block(history, b, "A", NULL));
    g_assert_true(tinker_history_rename_block(history, a, "B", NULL));
    tinker_history_end(history);
    g_autofree char *after = history_text(scene);
    tinker_history_undo(history);
    g_autofree char *undone = history_text(scene);
    tinker_history_redo(history);
    g_autofree char *redone = history_text(scene);
    g_assert_cmpstr(undone, ==, before);
    g_assert_cmpstr(redone, ==, after);
    const TinkerSceneGraph *graph = g_ptr_array_index(tinker_scene_graphs(scene), 0);
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "B");
}

/* Nobody knows what a placeholder does with its ends, but a file must not name a block that there is not. */
static void test_placeholder_ends(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"mass\", \"name\": \"B\"}, "
        "{\"type\": \"pulley\", \"name\": \"P\", \"ends\": [\"A\", {\"block\": \"A\", \"pin\": 1}, "
        "\"P\", \"Gone\"], \"note\": \"A\"}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = history_text(scene);
    g_assert_false(tinker_history_rename_block(history, tinker_scene_find_block(scene, "A"), "B", NULL));
    g_assert_true(tinker_history_rename_block(history, tinker_scene_find_block(scene, "P"), "Q", NULL));
    g_assert_true(tinker_history_rename_block(history, tinker_scene_find_block(scene, "A"), "Gone", NULL));
    g_autofree char *after = history_text(scene);
    g_assert_nonnull(strstr(after, "\"name\": \"Q\", \"ends\": [\"Gone\", {\"block\": \"Gone\", \"pin\": 1}, "
                                   "\"Q\", \"Gone\"], \"note\": \"A\"}"));
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *undone = history_text(scene);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(history);
    tinker_history_redo(history);
    g_autofree char *redone = history_text(scene);
    g_assert_cmpstr(redone, ==, after);
}

/* Where a block goes, an end on it stays lying where it was: of a support at (1, 2) turned by 180 deg, 0.5 m along it
 * is (0.5, 2). */
static void test_placeholder_ends_detached(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"W\", \"position\": [1, 2], \"orientation\": \"180 deg\"}, "
        "{\"type\": \"mass\", \"name\": \"B\"}, {\"type\": \"pulley\", \"name\": \"P\", \"ends\": [\"W\", "
        "{\"block\": \"W\", \"at\": [\"50 cm\", 0], \"pin\": 1}, \"P\", {\"block\": \"B\", \"pin\": 2}, [3, 4]], "
        "\"note\": \"W\"}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = history_text(scene);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "W"));
    g_autofree char *after = history_text(scene);
    g_assert_nonnull(strstr(after, "\"name\": \"P\", \"ends\": [[1, 2], [0.5, 2], \"P\", {\"block\": \"B\", "
                                   "\"pin\": 2}, [3, 4]], \"note\": \"W\"}"));
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "P")); /* it names itself */
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *undone = history_text(scene);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(history);
    g_autofree char *redone = history_text(scene);
    g_assert_cmpstr(redone, ==, after);
}

static void test_order(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId spring = tinker_scene_find_block(scene, "Spring 0");
    tinker_history_order_blocks(history, &spring, 1, TRUE);
    g_assert_cmpint(tinker_scene_block_at(scene, tinker_scene_block_count(scene) - 1), ==, spring);
    tinker_history_order_blocks(history, &spring, 1, FALSE);
    g_assert_cmpint(tinker_scene_block_at(scene, 0), ==, spring);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Lower Spring 0");
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_block_at(scene, 2), ==, spring);

    /* several keep their order among each other */
    const TinkerBlockId first = tinker_scene_block_at(scene, 0);
    const int32_t count = tinker_scene_block_count(scene);
    tinker_history_order_blocks(history, (const TinkerBlockId[]){spring, first}, 2, TRUE);
    g_assert_cmpint(tinker_scene_block_at(scene, count - 2), ==, first);
    g_assert_cmpint(tinker_scene_block_at(scene, count - 1), ==, spring);
    tinker_history_order_blocks(history, (const TinkerBlockId[]){spring, first}, 2, FALSE);
    g_assert_cmpint(tinker_scene_block_at(scene, 0), ==, first);
    g_assert_cmpint(tinker_scene_block_at(scene, 1), ==, spring);
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_block_at(scene, 0), ==, first);
    g_assert_cmpint(tinker_scene_block_at(scene, 2), ==, spring);
}

static void test_saved_and_revision(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId mass = tinker_scene_find_block(scene, "Mass 0");
    int32_t position = tinker_block_class_property(tinker_scene_block_class(scene, mass), "position");
    guint64 revision = tinker_history_revision(history);
    g_assert_true(tinker_history_is_saved(history));
    for (int i = 0; i < 4; i++) { /* a drag, saved in its middle */
        tinker_history_begin(history, "Move", "drag");
        g_assert_cmpuint(tinker_history_revision(history), ==, revision);
        tinker_history_set(history, mass, position, (double[2]){i, i}, NULL);
        g_assert_cmpuint(tinker_history_revision(history), >, revision);
        g_assert_false(tinker_history_is_saved(history));
        revision = tinker_history_revision(history);
        tinker_history_end(history);
        if (i == 1) tinker_history_mark_saved(history);
    }
    tinker_history_undo(history);
    g_assert_cmpuint(tinker_history_revision(history), >, revision);
    g_assert_true(tinker_history_is_saved(history));
    tinker_history_undo(history);
    g_assert_false(tinker_history_is_saved(history));
    tinker_history_redo(history);
    g_assert_true(tinker_history_is_saved(history));
    revision = tinker_history_revision(history);
    tinker_history_begin(history, "Much", NULL);
    tinker_history_remove_block(history, mass);
    tinker_history_abort(history);
    g_assert_true(tinker_history_is_saved(history));
    g_assert_cmpuint(tinker_history_revision(history), >, revision);
    tinker_history_undo(history);
    tinker_history_remove_block(history, mass); /* the saved state is gone for good */
    tinker_history_undo(history);
    g_assert_false(tinker_history_is_saved(history));
    g_assert_false(tinker_history_set(history, mass, position, (double[2]){NAN, 0}, NULL));
}

static void add_tests(void)
{
    g_test_add_func("/scene/history/ends-of-choice", test_ends_of_choice);
    g_test_add_func("/scene/history/titles-and-merging", test_titles_and_merging);
    g_test_add_func("/scene/history/abort", test_abort);
    g_test_add_func("/scene/history/removal", test_removal);
    g_test_add_func("/scene/history/swapped-names", test_swapped_names);
    g_test_add_func("/scene/history/placeholder-ends", test_placeholder_ends);
    g_test_add_func("/scene/history/placeholder-ends-detached", test_placeholder_ends_detached);
    g_test_add_func("/scene/history/order", test_order);
    g_test_add_func("/scene/history/saved-and-revision", test_saved_and_revision);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
