/* Undo and redo: whatever was done, taking all of it back gives the same text, and doing it again too. */
#include "scene/history/history.h"

#include <math.h>
#include <string.h>

#include "scene-fixture.h"

static char *text_of(TinkerScene *scene)
{
    return tinker_scene_to_text(scene, TINKER_WRITE_SI);
}

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
    g_autofree char *whole = text_of(scene);
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 1);
    tinker_history_redo(history);
    tinker_history_redo(history);
    g_autofree char *again = text_of(scene);
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

/* Of all graphs that the tests made: they are copied by the history, and live to the end. */
static GPtrArray *made;

/* What it points to is borrowed. */
static TinkerSceneGraph graph_of(const char *block, const char *quantity)
{
    if (made == NULL) made = g_ptr_array_new();
    TinkerSceneGraph *graph = tinker_scene_graph_new();
    tinker_scene_graph_add(graph, block, quantity);
    g_ptr_array_add(made, graph);
    return *graph;
}

/* A graph of some block with quantities; FALSE where it has none. */
static gboolean random_graph(TinkerScene *scene, GRand *random, TinkerSceneGraph *graph)
{
    TinkerBlockId id = random_block(scene, random);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    if (block_class == NULL || block_class->quantity_count == 0) return FALSE;
    int32_t quantity = g_rand_int_range(random, 0, block_class->quantity_count);
    *graph = graph_of(tinker_scene_block_name(scene, id), block_class->quantities[quantity].id);
    id = random_block(scene, random);
    block_class = tinker_scene_block_class(scene, id);
    if (block_class != NULL && block_class->quantity_count > 0)
        tinker_scene_graph_add(g_ptr_array_index(made, made->len - 1), tinker_scene_block_name(scene, id),
                               block_class->quantities[0].id);
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
    } else if (what == 4) {
        tinker_history_raise(history, random_block(scene, random));
    } else {
        tinker_history_lower(history, random_block(scene, random));
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
        g_ptr_array_add(states, text_of(scene));
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
            if (g_strcmp0(tinker_history_can_undo(history), title) == 0) g_ptr_array_add(states, text_of(scene));
        }
        for (guint i = states->len - 1; i-- > 0;) {
            tinker_history_undo(history);
            g_autofree char *text = text_of(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
            g_assert_true(tinker_history_is_saved(history) == (i == saved));
        }
        g_assert_null(tinker_history_can_undo(history));
        for (guint i = 1; i < states->len; i++) {
            tinker_history_redo(history);
            g_autofree char *text = text_of(scene);
            g_assert_cmpstr(text, ==, g_ptr_array_index(states, i));
            g_assert_true(tinker_history_is_saved(history) == (i == saved));
        }
        g_assert_null(tinker_history_can_redo(history));
    }
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
    g_autofree char *before = text_of(scene);
    tinker_history_begin(history, "Swap", NULL);
    g_assert_true(tinker_history_rename_block(history, a, "C", NULL));
    g_assert_true(tinker_history_rename_block(history, b, "A", NULL));
    g_assert_true(tinker_history_rename_block(history, a, "B", NULL));
    tinker_history_end(history);
    g_autofree char *after = text_of(scene);
    tinker_history_undo(history);
    g_autofree char *undone = text_of(scene);
    tinker_history_redo(history);
    g_autofree char *redone = text_of(scene);
    g_assert_cmpstr(undone, ==, before);
    g_assert_cmpstr(redone, ==, after);
    const TinkerSceneGraph *graph = g_ptr_array_index(tinker_scene_graphs(scene), 0);
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "B");
}

static void assert_head_refused(TinkerHistory *history, const TinkerSceneHead *head, const char *message)
{
    g_autoptr(GError) error = NULL;
    guint64 revision = tinker_history_revision(history);
    g_assert_false(tinker_history_set_head(history, head, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_assert_cmpstr(error->message, ==, message);
    g_assert_cmpuint(tinker_history_revision(history), ==, revision);
}

/* Nobody knows what a placeholder does with its ends, but a file must not name a block that there is not. */
static void test_placeholder_ends(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"mass\", \"name\": \"B\"}, "
        "{\"type\": \"pulley\", \"name\": \"P\", \"ends\": [\"A\", {\"block\": \"A\", \"pin\": 1}, "
        "\"P\", \"Gone\"], \"note\": \"A\"}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = text_of(scene);
    g_assert_false(tinker_history_rename_block(history, tinker_scene_find_block(scene, "A"), "B", NULL));
    g_assert_true(tinker_history_rename_block(history, tinker_scene_find_block(scene, "P"), "Q", NULL));
    g_assert_true(tinker_history_rename_block(history, tinker_scene_find_block(scene, "A"), "Gone", NULL));
    g_autofree char *after = text_of(scene);
    g_assert_nonnull(strstr(after, "\"name\": \"Q\", \"ends\": [\"Gone\", {\"block\": \"Gone\", \"pin\": 1}, "
                                   "\"Q\", \"Gone\"], \"note\": \"A\"}"));
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *undone = text_of(scene);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(history);
    tinker_history_redo(history);
    g_autofree char *redone = text_of(scene);
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
    g_autofree char *before = text_of(scene);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "W"));
    g_autofree char *after = text_of(scene);
    g_assert_nonnull(strstr(after, "\"name\": \"P\", \"ends\": [[1, 2], [0.5, 2], \"P\", {\"block\": \"B\", "
                                   "\"pin\": 2}, [3, 4]], \"note\": \"W\"}"));
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "P")); /* it names itself */
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *undone = text_of(scene);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(history);
    g_autofree char *redone = text_of(scene);
    g_assert_cmpstr(redone, ==, after);
}

static void test_head(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerSceneHead head = *tinker_scene_head(scene), bad = head;
    bad.run.duration = -1;
    assert_head_refused(history, &bad, "run: duration must be greater than 0 s (it is -1 s)");
    bad = head;
    bad.run.tolerance = 1;
    assert_head_refused(history, &bad, "run: tolerance must be less than 1 (it is 1)");
    bad = head;
    bad.run.accuracy = -1e-6;
    assert_head_refused(history, &bad, "run: accuracy must be greater than 0 (it is -1e-06)");
    bad = head;
    bad.canvas_grid = NAN;
    assert_head_refused(history, &bad, "canvas: grid must be a finite number");
    bad = head;
    bad.run.contacts = (char *)"magic";
    assert_head_refused(history, &bad, "run: contacts must be \"events\" or \"impulse\" (it is \"magic\")");
    bad = head;
    bad.title = (char *)"\xff";
    assert_head_refused(history, &bad, "title must be UTF-8 text");

    g_autofree char *old_title = g_strdup(head.title);
    head.title = (char *)"Another";
    head.units = TINKER_UNIT_SYSTEM_SI;
    head.canvas_width = 7;
    g_assert_true(tinker_history_set_head(history, &head, NULL));
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Change Scene");
    g_assert_cmpstr(tinker_scene_head(scene)->title, ==, "Another");
    g_assert_cmpfloat(tinker_scene_head(scene)->canvas_width, ==, 7);
    tinker_history_undo(history);
    g_assert_cmpstr(tinker_scene_head(scene)->title, ==, old_title);
    g_assert_cmpint(tinker_scene_head(scene)->units, ==, TINKER_UNIT_SYSTEM_ENGLISH);
}

static void test_graphs(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerSceneGraph graph = graph_of("Mass 0", "vy"), flat = graph;
    graph.title = (char *)"Speed";
    flat.has_size = TRUE;
    flat.size[0] = 1;
    g_assert_cmpint(tinker_history_add_graph(history, &graph, NULL), ==, 1);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Add Graph of Mass 0");

    const struct {
        TinkerSceneGraph graph;
        const char *message;
    } bad[] = {
        {graph_of("Mass 9", "y"), "graph: there is no block \"Mass 9\""},
        {graph_of("Mass 0", "vz"), "graph: a mass has no quantity \"vz\" (did you mean \"vx\"?)"},
        {flat, "graph: size: both numbers must be greater than 0"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_cmpint(tinker_history_add_graph(history, &bad[i].graph, &error), ==, -1);
        g_assert_cmpstr(error->message, ==, bad[i].message);
        g_assert_false(tinker_history_change_graph(history, 0, &bad[i].graph, NULL));
    }

    /* a drag of a graph is one step */
    for (int i = 1; i <= 3; i++) {
        graph.has_place = TRUE;
        graph.place[0] = i;
        tinker_history_begin(history, "Move Graph", "drag");
        g_assert_true(tinker_history_change_graph(history, 1, &graph, NULL));
        tinker_history_end(history);
    }
    tinker_history_undo(history);
    const TinkerSceneGraph *shown = g_ptr_array_index(tinker_scene_graphs(scene), 1);
    g_assert_false(shown->has_place);
    tinker_history_remove_graph(history, 0);
    g_assert_cmpuint(tinker_scene_graphs(scene)->len, ==, 1);
    tinker_history_undo(history);
    shown = g_ptr_array_index(tinker_scene_graphs(scene), 0);
    g_assert_cmpstr(tinker_scene_graph_curve(shown)->quantity, ==, "y");
    g_assert_cmpstr(shown->extras, ==, "\"pen\": 3");
}

static void test_order(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    TinkerBlockId spring = tinker_scene_find_block(scene, "Spring 0");
    tinker_history_raise(history, spring);
    g_assert_cmpint(tinker_scene_block_at(scene, tinker_scene_block_count(scene) - 1), ==, spring);
    tinker_history_lower(history, spring);
    g_assert_cmpint(tinker_scene_block_at(scene, 0), ==, spring);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Lower Spring 0");
    tinker_history_undo(history);
    tinker_history_undo(history);
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
    g_test_add_func("/scene/history/head", test_head);
    g_test_add_func("/scene/history/graphs", test_graphs);
    g_test_add_func("/scene/history/order", test_order);
    g_test_add_func("/scene/history/saved-and-revision", test_saved_and_revision);
    g_test_add_func("/scene/history/random-edits", test_random_edits);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
