/* Undo and redo of edits of chance: all states are gone through backwards and forwards. */
#include "history-fixture.h"

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

/* A graph of some block with quantities; FALSE where it has none. */
static gboolean random_graph(TinkerScene *scene, GRand *random, TinkerSceneGraph *graph)
{
    TinkerBlockId id = random_block(scene, random);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    if (block_class == NULL || block_class->quantity_count == 0) return FALSE;
    int32_t quantity = g_rand_int_range(random, 0, block_class->quantity_count);
    TinkerSceneGraph *made = history_graph(tinker_scene_block_name(scene, id), block_class->quantities[quantity].id);
    id = random_block(scene, random);
    block_class = tinker_scene_block_class(scene, id);
    if (block_class != NULL && block_class->quantity_count > 0)
        tinker_scene_graph_add(made, tinker_scene_block_name(scene, id), block_class->quantities[0].id);
    *graph = *made;
    graph->has_place = TRUE;
    graph->place[0] = g_rand_double(random);
    return TRUE;
}

static void random_other(TinkerScene *scene, TinkerHistory *history, GRand *random)
{
    TinkerSceneGraph graph;
    int32_t graphs = (int32_t)tinker_scene_graphs(scene)->len;
    int what = g_rand_int_range(random, 0, 6);
    if (what == 0 || (what < 3 && graphs == 0)) {
        if (random_graph(scene, random, &graph))
            g_assert_cmpint(tinker_history_add_graph(history, &graph, NULL), ==, graphs);
    } else if (what == 1) {
        tinker_history_remove_graph(history, g_rand_int_range(random, 0, graphs));
    } else if (what == 2) {
        if (random_graph(scene, random, &graph))
            g_assert_true(tinker_history_change_graph(history, g_rand_int_range(random, 0, graphs), &graph, NULL));
    } else if (what == 3) {
        TinkerSceneHead head = *tinker_scene_head(scene);
        g_autofree char *title = g_strdup_printf("Title %d", g_rand_int_range(random, 0, 9));
        head.title = title;
        head.run.duration = g_rand_int_range(random, 1, 9);
        g_assert_true(tinker_history_set_head(history, &head, NULL));
    } else {
        const TinkerBlockId some[] = {random_block(scene, random), random_block(scene, random)};
        const guint count = some[0] == some[1] ? 1 : g_rand_int_range(random, 1, 3);
        tinker_history_order_blocks(history, some, count, what == 4);
    }
}

/* One block, or several of whatever kind. */
static void remove_some(TinkerScene *scene, TinkerHistory *history, GRand *random)
{
    g_autoptr(GArray) some = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    const int count = tinker_scene_block_count(scene), step = g_rand_int_range(random, 1, 4);
    for (int place = g_rand_int_range(random, 0, count); place < count && some->len < 4; place += step) {
        TinkerBlockId id = tinker_scene_block_at(scene, place);
        g_array_prepend_val(some, id);
    }
    tinker_history_remove_blocks(history, (const TinkerBlockId *)(gpointer)some->data, some->len);
}

static void random_edit(TinkerScene *scene, TinkerHistory *history, GRand *random)
{
    const char *types[] = {"mass", "support", "spring", "motor", "damper", "every-kind"};
    int what = g_rand_int_range(random, 0, 14);
    if (what < 3 || tinker_scene_block_count(scene) == 0) {
        const char *type = types[g_rand_int_range(random, 0, G_N_ELEMENTS(types))];
        tinker_history_add_block(history, scene_fixture_class(type), NULL, NULL);
        return;
    }
    TinkerBlockId id = random_block(scene, random);
    if (what >= 10) {
        random_other(scene, history, random);
    } else if (what == 3) {
        remove_some(scene, history, random);
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
        g_ptr_array_add(states, history_text(scene));
        guint saved = 0;
        for (int step = 0; step < 60; step++) {
            g_autofree char *title = g_strdup_printf("Step %d", step);
            if (step == 30) {
                tinker_history_mark_saved(history);
                saved = states->len - 1;
            }
            tinker_history_begin(history, title, NULL);
            int edits = g_rand_int_range(random, 1, 6);
            for (int i = 0; i < edits; i++)
                random_edit(scene, history, random);
            tinker_history_end(history);
            if (g_strcmp0(tinker_history_can_undo(history), title) == 0) g_ptr_array_add(states, history_text(scene));
        }
        for (guint i = states->len - 1; i-- > 0;) {
            tinker_history_undo(history);
            g_autofree char *text = history_text(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
            g_assert_true(tinker_history_is_saved(history) == (i == saved));
        }
        g_assert_null(tinker_history_can_undo(history));
        for (guint i = 1; i < states->len; i++) {
            tinker_history_redo(history);
            g_autofree char *text = history_text(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
            g_assert_true(tinker_history_is_saved(history) == (i == saved));
        }
        g_assert_null(tinker_history_can_redo(history));
    }
}

static void add_tests(void)
{
    g_test_add_func("/scene/history/random-edits", test_random_edits);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
