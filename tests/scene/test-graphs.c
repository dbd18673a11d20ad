/* Graphs of several curves: what a file may hold, where its mistakes are, and how curves follow their blocks. */
#include <string.h>

#include "scene-fixture.h"
#include "scene/history/fragment.h"
#include "scene/history/history.h"

#define BLOCKS                                                                                                         \
    "{\"type\": \"mass\", \"name\": \"Mass 0\"}, {\"type\": \"mass\", \"name\": \"Mass 1\", \"position\": [1, 0]},"    \
    "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\", \"Mass 1\"]}"
#define SCENE(graphs) "{\"tinker\": 1, \"blocks\": [" BLOCKS "], \"graphs\": [\n" graphs "]}"

static const char full[] =
    "{\"curves\": [{\"block\": \"Mass 0\", \"quantity\": \"x\"}, {\"block\": \"Mass 0\", \"quantity\": \"distance to "
    "Mass 1\", \"axis\": 2}, {\"expression\": \"{Spring 0.stiffness}*{Mass 1.distance to Mass 0}\", \"title\": \"F\", "
    "\"unit\": \"N\"}, {\"block\": \"Scene\", \"quantity\": \"energy\", \"pen\": 3}], \"scale\": [\"linear\", "
    "\"log\"], "
    "\"range\": [null, [0.5, 2]], \"title\": \"All\"}";

static char *text_of(const TinkerScene *scene)
{
    return tinker_scene_to_text((TinkerScene *)scene, TINKER_WRITE_SI);
}

static TinkerScene *scene_of_full(void)
{
    g_autofree char *text = g_strconcat("{\"tinker\": 1, \"blocks\": [" BLOCKS "], \"graphs\": [", full, "]}", NULL);
    return scene_fixture_read(text);
}

/* What is written is what was read, the short form where there is one curve. */
static void test_written(void)
{
    g_autoptr(TinkerScene) scene = scene_of_full();
    g_autofree char *text = text_of(scene);
    g_assert_nonnull(strstr(text, full));
    g_autoptr(TinkerScene) again = scene_fixture_read(text);
    g_autofree char *same = text_of(again);
    g_assert_cmpstr(same, ==, text);
    g_autoptr(TinkerScene) one =
        scene_fixture_read(SCENE("{\"curves\": [{\"block\": \"Mass 0\", \"quantity\": \"x\"}], \"against\": \"vx\"}"));
    g_autofree char *short_form = text_of(one);
    g_assert_nonnull(strstr(short_form, "{\"block\": \"Mass 0\", \"quantity\": \"x\", \"against\": \"vx\"}"));
}

static void test_mistakes(void)
{
    const struct {
        const char *text, *findings;
    } bad[] = {
        {SCENE("{\"curves\": [{\"block\": \"Mass 2\", \"quantity\": \"x\"}]}"),
         "2:23: graphs[0]: block: there is no block \"Mass 2\" (did you mean \"Mass 0\"?)\n"},
        {SCENE("{\"curves\": [{\"block\": \"Mass 0\", \"quantity\": \"path lenght\"}]}"),
         "2:45: graphs[0]: quantity: a mass has no quantity \"path lenght\" (did you mean \"path length\"?)\n"},
        {SCENE("{\"curves\": [{\"expression\": \"2*{Mass 0.masss}\"}]}"),
         "2:28: graphs[0]: expression: column 3: {Mass 0.masss}: Mass 0 has no quantity or property \"masss\"; did you "
         "mean \"mass\"?\n"},
        {SCENE("{\"curves\": [{\"table\": \"a.csv\", \"time_column\": 1}]}"),
         "2:13: graphs[0]: column must be another one than that of the time (1)\n"
         "2:23: graphs[0]: table: \"a.csv\" cannot be read: No such file or directory\n"},
        {SCENE("{\"curves\": [{\"table\": \"a.csv\", \"time_column\": 0.5}]}"),
         "2:23: graphs[0]: table: \"a.csv\" cannot be read: No such file or directory\n"
         "2:47: graphs[0]: time_column must be a whole number from 0\n"},
        {SCENE("{\"curves\": [{\"expression\": \"2*{Mass 0.x}+\"}]}"),
         "2:28: graphs[0]: expression: column 14: a number, t, a function or \"(\" is expected, not the end\n"},
        {SCENE("{\"curves\": [{\"expression\": \"t\", \"block\": \"Mass 0\", \"quantity\": \"x\"}]}"),
         "2:13: graphs[0]: a curve has either \"block\" and \"quantity\", or \"expression\", or \"table\"\n"},
        {SCENE("{\"curves\": []}"), "2:12: graphs[0]: curves: a graph needs a curve\n"},
        {SCENE("{\"block\": \"Mass 0\", \"quantity\": \"x\", \"curves\": [{\"expression\": \"t\"}]}"),
         "2:11: graphs[0]: \"curves\" and \"block\" exclude each other (a curve of \"curves\" has the block)\n"},
        {SCENE("{\"curves\": [{\"expression\": \"t\", \"axis\": 3}]}"),
         "2:41: graphs[0]: axis: it is 1 (left) or 2 (right)\n"},
        {SCENE("{\"block\": \"Mass 0\", \"quantity\": \"x\", \"range\": [null, [2, 1]]}"),
         "2:47: graphs[0]: range: the second number must be greater than the first\n"},
        {SCENE("{\"block\": \"Mass 0\", \"quantity\": \"x\", \"scale\": [\"linear\", \"lug\"]}"),
         "2:58: graphs[0]: scale: \"lug\" is not known (did you mean \"log\"?)\n"},
        {SCENE("{\"curves\": [{\"expression\": \"t\"}], \"against\": \"x\"}"),
         "2:28: graphs[0]: against: only quantities are drawn against a quantity of their block\n"},
        {SCENE("{\"block\": \"Scene\", \"quantity\": \"enrgy\"}"),
         "2:32: graphs[0]: quantity: the scene has no quantity \"enrgy\" (did you mean \"energy\"?)\n"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *findings = scene_fixture_findings(bad[i].text, -1, NULL);
        g_assert_cmpstr(findings, ==, bad[i].findings);
    }
}

static void test_tables(void)
{
    const char *text = SCENE("{\"curves\": [{\"table\": \"../measured.csv\", \"column\": 2}]}");
    g_autofree char *findings = scene_fixture_findings(text, -1, "/tmp/some/scene.tinker.json");
    g_assert_cmpstr(findings, ==,
                    "2:23: graphs[0]: table: \"../measured.csv\" lies outside the scene's folder; a table must be a "
                    "file in it\n");
}

/* Names in curves, in what they are measured from, and in expressions. */
static void test_renamed(void)
{
    g_autoptr(TinkerScene) scene = scene_of_full();
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "Mass 1"), "Bob", NULL));
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "Mass 0"), "Tom", NULL));
    g_autofree char *text = text_of(scene);
    g_assert_nonnull(strstr(text, "{\"block\": \"Tom\", \"quantity\": \"distance to Bob\""));
    g_assert_nonnull(strstr(text, "{Spring 0.stiffness}*{Bob.distance to Tom}"));
}

/* The curves of a block go with it, and the others stay; undoing brings all back, in their order. */
static void test_blocks_vanish(void)
{
    g_autoptr(TinkerScene) scene = scene_of_full();
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = text_of(scene);
    const GPtrArray *graphs = tinker_scene_graphs(scene);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Mass 1"));
    g_assert_cmpuint(graphs->len, ==, 1);
    const TinkerSceneGraph *graph = g_ptr_array_index(graphs, 0);
    g_assert_cmpuint(graph->curves->len, ==, 2);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Mass 0"));
    graph = g_ptr_array_index(graphs, 0);
    g_assert_cmpuint(graph->curves->len, ==, 1);
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "Scene");
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *after = text_of(scene);
    g_assert_cmpstr(after, ==, before);
}

/* A copy's graph has the copies' names, also where they change places. */
static void test_pasted(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read(SCENE("{\"curves\": [{\"block\": \"Mass 0\", \"quantity\": \"distance to Mass 1\"}, "
                                 "{\"expression\": \"{Mass 1.x}\"}]}"));
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    const TinkerBlockId both[] = {tinker_scene_find_block(scene, "Mass 0"), tinker_scene_find_block(scene, "Mass 1")};
    g_autofree char *fragment = tinker_fragment_to_text(scene, both, 2);
    g_assert_true(tinker_fragment_paste(history, fragment, 0, 1, NULL, NULL));
    g_autofree char *text = text_of(scene);
    g_assert_nonnull(strstr(text, "{\"block\": \"Mass 2\", \"quantity\": \"distance to Mass 3\"}, {\"expression\": "
                                  "\"{Mass 3.x}\"}"));
}

static void add_tests(void)
{
    g_test_add_func("/scene/graphs/written", test_written);
    g_test_add_func("/scene/graphs/mistakes", test_mistakes);
    g_test_add_func("/scene/graphs/tables", test_tables);
    g_test_add_func("/scene/graphs/renamed", test_renamed);
    g_test_add_func("/scene/graphs/blocks-vanish", test_blocks_vanish);
    g_test_add_func("/scene/graphs/pasted", test_pasted);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
