/* Undo and redo of what belongs to the whole scene: its head and its graphs. */
#include <math.h>

#include "history-fixture.h"

static void assert_head_refused(TinkerHistory *history, const TinkerSceneHead *head, const char *message)
{
    g_autoptr(GError) error = NULL;
    guint64 revision = tinker_history_revision(history);
    g_assert_false(tinker_history_set_head(history, head, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_assert_cmpstr(error->message, ==, message);
    g_assert_cmpuint(tinker_history_revision(history), ==, revision);
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
    TinkerSceneGraph graph = *history_graph("Mass 0", "vy"), flat = graph;
    graph.title = (char *)"Speed";
    flat.has_size = TRUE;
    flat.size[0] = 1;
    g_assert_cmpint(tinker_history_add_graph(history, &graph, NULL), ==, 1);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Add Graph of Mass 0");

    const struct {
        TinkerSceneGraph graph;
        const char *message;
    } bad[] = {
        {*history_graph("Mass 9", "y"), "graph: there is no block \"Mass 9\""},
        {*history_graph("Mass 0", "vz"), "graph: a mass has no quantity \"vz\" (did you mean \"vx\"?)"},
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

static void add_tests(void)
{
    g_test_add_func("/scene/history/head", test_head);
    g_test_add_func("/scene/history/graphs", test_graphs);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
