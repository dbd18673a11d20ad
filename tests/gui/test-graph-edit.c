/* Every edit of graphs is one step that can be taken back; size, place and order are kept. */
#include <glib/gstdio.h>

#include <math.h>

#include "graph-fixture.h"
#include "gui/curve/graph-edit.h"

/* Every edit is one step: as many undos lead back through the same texts, as many redos forward again. */
static void test_edits_are_steps(void)
{
    g_autoptr(GPtrArray) texts = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "{'block': 'Mass 0', 'quantity': 'y', 'pen': 3}");
    TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    TinkerDocument *document = fixture->document;
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    g_assert_cmpint(tinker_graph_add(document, mass, "vy", "y", (double[]){1, 2}, (double[]){3, 4}, NULL), ==, 1);
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    g_assert_cmpint(tinker_graph_move(document, 1, (double[]){5, 6}, NULL, TRUE, NULL), ==, 1);
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    g_assert_cmpint(tinker_graph_move(document, 0, (double[]){0, 1}, (double[]){2, 1}, TRUE, NULL), ==, 1);
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    tinker_graph_dock(document, 0);
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    tinker_graph_remove(document, 0);
    g_ptr_array_add(texts, gui_fixture_text(fixture));
    g_assert_cmpint(tinker_graph_move(document, 0, (double[]){0, 1}, (double[]){2, 1}, TRUE, NULL), ==, 0);
    g_assert_cmpstr(tinker_history_can_undo(tinker_document_history(document)), ==, "Delete Graph");
    for (guint i = texts->len - 1; i-- > 0;) {
        tinker_document_undo(document);
        g_autofree char *text = gui_fixture_text(fixture);
        g_assert_cmpstr(text, ==, g_ptr_array_index(texts, i));
    }
    g_assert_null(tinker_history_can_undo(tinker_document_history(document)));
    for (guint i = 1; i < texts->len; i++) {
        tinker_document_redo(document);
        g_autofree char *text = gui_fixture_text(fixture);
        g_assert_cmpstr(text, ==, g_ptr_array_index(texts, i));
    }
}

static void assert_graph(const TinkerSceneGraph *graph, const char *quantity, const char *against, gboolean floats)
{
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "Mass 0");
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->quantity, ==, quantity);
    g_assert_cmpstr(graph->against, ==, against);
    g_assert_cmpint(graph->has_place, ==, floats);
}

/* Size, place and order come back from the file; what is not good is refused and leaves no step. */
static void test_saved_and_read(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "tinker-graphs.tinker.json", NULL);
    g_autoptr(GuiFixture) fixture = graph_fixture_fall("SI", "");
    TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    g_assert_cmpint(tinker_graph_add(fixture->document, mass, "sideways", NULL, NULL, NULL, &error), ==, -1);
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_clear_error(&error);
    g_assert_null(tinker_history_can_undo(tinker_document_history(fixture->document)));
    tinker_graph_add(fixture->document, mass, "y", NULL, (double[]){0.1, -0.7}, (double[]){2.25, 1.5}, NULL);
    tinker_graph_add(fixture->document, mass, "x", NULL, NULL, NULL, NULL);
    tinker_graph_add(fixture->document, mass, "vy", "y", (double[]){1, 1}, (double[]){2, 2}, NULL);
    tinker_graph_move(fixture->document, 0, NULL, NULL, TRUE, NULL);
    g_assert_true(tinker_document_save(fixture->document, path, &error));
    g_assert_true(tinker_document_open(fixture->document, path, NULL, &error));
    g_remove(path);
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(fixture->document));
    g_assert_cmpuint(graphs->len, ==, 3);
    assert_graph(g_ptr_array_index(graphs, 0), "x", "time", FALSE);
    assert_graph(g_ptr_array_index(graphs, 1), "vy", "y", TRUE);
    const TinkerSceneGraph *front = g_ptr_array_index(graphs, 2);
    assert_graph(front, "y", "time", TRUE);
    g_assert_cmpfloat(front->place[0], ==, 0.1);
    g_assert_cmpfloat(front->place[1], ==, -0.7);
    g_assert_cmpfloat(front->size[0], ==, 2.25);
    g_assert_cmpfloat(front->size[1], ==, 1.5);
}

static gboolean apart(const TinkerGraphBox *a, const TinkerGraphBox *b)
{
    return a->x + a->width <= b->x || b->x + b->width <= a->x || a->y + a->height <= b->y || b->y + b->height <= a->y;
}

/* As long as there is room, new graphs stay clear of one another and inside the area. */
static void test_room(void)
{
    TinkerGraphBox taken[4];
    for (int i = 0; i < 4; i++) {
        taken[i] = (TinkerGraphBox){0, 0, 340, 230};
        tinker_graph_find_room(&taken[i], 800, 600, taken, i);
        g_assert_cmpfloat(taken[i].x, >=, 0);
        g_assert_cmpfloat(taken[i].y, >=, 0);
        g_assert_cmpfloat(taken[i].x + 340, <=, 800);
        g_assert_cmpfloat(taken[i].y + 230, <=, 600);
        for (int k = 0; k < i; k++)
            g_assert_true(apart(&taken[i], &taken[k]));
    }
    g_assert_cmpfloat(taken[0].x, >, 400); /* the first: upper right */
    g_assert_cmpfloat(taken[0].y, <, 100);
    TinkerGraphBox large = {0, 0, 900, 700};
    tinker_graph_find_room(&large, 800, 600, taken, 4);
    g_assert_cmpfloat(large.x, ==, 0);
    g_assert_cmpfloat(large.y, ==, 0);
}

/* Beside the other, by the shorter way; and where it is as long as it covers nothing, or nothing can be done. */
static void test_move_to_room(void)
{
    const TinkerGraphBox other = {100, 100, 200, 100}, all = {0, 0, 400, 300};
    TinkerGraphBox box = {130, 180, 100, 50};
    g_assert_true(tinker_graph_move_to_room(&box, 400, 300, &other, 1));
    g_assert_true(apart(&box, &other));
    g_assert_cmpfloat(fabs(box.x - 130), <=, 6);
    g_assert_cmpfloat(box.y, >=, 200);
    g_assert_cmpfloat(box.y, <, 212);
    const TinkerGraphBox there = box;
    g_assert_true(tinker_graph_move_to_room(&box, 400, 300, &other, 1));
    g_assert_cmpmem(&box, sizeof box, &there, sizeof there);
    g_assert_false(tinker_graph_move_to_room(&box, 400, 300, &all, 1));
    g_assert_cmpmem(&box, sizeof box, &there, sizeof there);
}

static void add_tests(void)
{
    g_test_add_func("/gui/graph-edit/steps", test_edits_are_steps);
    g_test_add_func("/gui/graph-edit/saved-and-read", test_saved_and_read);
    g_test_add_func("/gui/graph-edit/room", test_room);
    g_test_add_func("/gui/graph-edit/move-to-room", test_move_to_room);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
