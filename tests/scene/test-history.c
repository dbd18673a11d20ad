/* Undo and redo: whatever was done, taking all of it back gives the same text, and doing it again too. */
#include "scene/history.h"

#include <string.h>

#include "scene-fixture.h"

static char *text_of(TinkerScene *scene)
{
    return tinker_scene_to_text(scene, TINKER_WRITE_SI);
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
    g_autofree char *before = text_of(scene);
    tinker_history_begin(history, "Much", NULL);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Mass 0"));
    tinker_history_add_block(history, scene_fixture_class("mass"), "Mass 0", NULL);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Support 0"));
    tinker_history_abort(history);
    g_autofree char *after = text_of(scene);
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

static TinkerBlockId random_block(TinkerScene *scene, GRand *random)
{
    return tinker_scene_block_at(scene, g_rand_int_range(random, 0, tinker_scene_block_count(scene)));
}

static void random_property(TinkerScene *scene, TinkerHistory *history, GRand *random, TinkerBlockId id)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    if (block_class == NULL || block_class->property_count == 0) return;
    int32_t property = g_rand_int_range(random, 0, block_class->property_count);
    double values[2] = {g_rand_int_range(random, -1, 4), g_rand_double(random)};
    int32_t kind = block_class->properties[property].kind;
    if (g_rand_int_range(random, 0, 4) == 0) {
        tinker_history_unset(history, id, property);
    } else if (kind == TINKER_KIND_TEXT) {
        tinker_history_set_text(history, id, property, g_rand_boolean(random) ? "a" : "b");
    } else if (kind == TINKER_KIND_WAVEFORM) {
        g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(values[0] > 0 ? "t" : "2*t", NULL);
        tinker_history_set_waveform(history, id, property, waveform);
    } else {
        tinker_history_set(history, id, property, values, NULL);
    }
}

static void random_edit(TinkerScene *scene, TinkerHistory *history, GRand *random)
{
    const char *types[] = {"mass", "support", "spring", "motor", "damper", "every-kind"};
    int what = g_rand_int_range(random, 0, 10);
    if (what < 3 || tinker_scene_block_count(scene) == 0) {
        const char *type = types[g_rand_int_range(random, 0, G_N_ELEMENTS(types))];
        tinker_history_add_block(history, scene_fixture_class(type), NULL, NULL);
        return;
    }
    TinkerBlockId id = random_block(scene, random);
    if (what == 3) {
        tinker_history_remove_block(history, id);
    } else if (what == 4) {
        g_autofree char *name = g_strdup_printf("Mass %d", g_rand_int_range(random, 0, 20));
        tinker_history_rename_block(history, id, name, NULL);
    } else if (what < 7 && tinker_scene_end_count(scene, id) > 0) {
        TinkerSceneEnd end = {random_block(scene, random), 0, 0};
        tinker_history_set_end(history, id, g_rand_int_range(random, 0, tinker_scene_end_count(scene, id)), end, NULL);
    } else {
        random_property(scene, history, random, id);
    }
}

/* After every round all states are gone through backwards and forwards. */
static void test_random_edits(void)
{
    for (guint32 seed = 0; seed < 20; seed++) {
        g_autoptr(GRand) random = g_rand_new_with_seed(seed);
        g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
        g_autoptr(TinkerHistory) history = tinker_history_new(scene);
        g_autoptr(GPtrArray) states = g_ptr_array_new_with_free_func(g_free);
        g_ptr_array_add(states, text_of(scene));
        for (int step = 0; step < 60; step++) {
            g_autofree char *title = g_strdup_printf("Step %d", step);
            tinker_history_begin(history, title, NULL);
            int edits = g_rand_int_range(random, 1, 6);
            for (int i = 0; i < edits; i++)
                random_edit(scene, history, random);
            tinker_history_end(history);
            if (g_strcmp0(tinker_history_can_undo(history), title) == 0) g_ptr_array_add(states, text_of(scene));
        }
        for (guint i = states->len - 1; i-- > 0;) {
            tinker_history_undo(history);
            g_autofree char *text = text_of(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
        }
        g_assert_null(tinker_history_can_undo(history));
        for (guint i = 1; i < states->len; i++) {
            tinker_history_redo(history);
            g_autofree char *text = text_of(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
        }
        g_assert_null(tinker_history_can_redo(history));
    }
}

static void add_tests(void)
{
    g_test_add_func("/scene/history/titles-and-merging", test_titles_and_merging);
    g_test_add_func("/scene/history/abort", test_abort);
    g_test_add_func("/scene/history/removal", test_removal);
    g_test_add_func("/scene/history/random-edits", test_random_edits);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
