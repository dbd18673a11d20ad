/* Copies and fragments: a copy is the scene, and leads a life of its own; what is pasted is what was copied, elsewhere.
 */
#include "scene/history/fragment.h"

#include <math.h>
#include <string.h>

#include <glib/gstdio.h>

#include "scene-fixture.h"

static char *text_of(TinkerScene *scene)
{
    return tinker_scene_to_text(scene, TINKER_WRITE_SI);
}

static char *fragment_of(TinkerScene *scene, const char *const *names)
{
    g_autoptr(GArray) ids = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (; *names != NULL; names++) {
        TinkerBlockId id = tinker_scene_find_block(scene, *names);
        g_assert_cmpint(id, !=, TINKER_NO_BLOCK);
        g_array_append_val(ids, id);
    }
    return tinker_fragment_to_text(scene, (const TinkerBlockId *)(void *)ids->data, (int32_t)ids->len);
}

static double column(TinkerScene *scene, const char *name, const char *property, int32_t component)
{
    TinkerBlockId id = tinker_scene_find_block(scene, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    return tinker_scene_get(scene, id,
                            block_class->first_columns[tinker_block_class_property(block_class, property)] + component);
}

static void test_copy(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    tinker_scene_remove_block(scene, tinker_scene_find_block(scene, "Gravity")); /* ids with a gap */
    g_autofree char *before = text_of(scene);
    TinkerScene *copy = tinker_scene_copy(scene);
    g_autofree char *copied = text_of(copy);
    g_assert_cmpstr(copied, ==, before);
    g_assert_cmpint(tinker_scene_id_limit(copy), ==, tinker_scene_id_limit(scene));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId id = tinker_scene_block_at(scene, place);
        g_assert_cmpint(tinker_scene_block_at(copy, place), ==, id);
        g_assert_cmpstr(tinker_scene_block_name(copy, id), ==, tinker_scene_block_name(scene, id));
    }
    /* it grows and shrinks without the original */
    for (int i = 0; i < 20; i++) {
        tinker_scene_add_block(copy, scene_fixture_class("mass"), NULL, NULL);
        tinker_scene_add_block(copy, scene_fixture_class("every-kind"), NULL, NULL);
    }
    g_assert_cmpint(tinker_scene_find_block(copy, "Mass 20"), !=, TINKER_NO_BLOCK);
    while (tinker_scene_block_count(copy) > 0)
        tinker_scene_remove_block(copy, tinker_scene_block_at(copy, 0));
    tinker_scene_free(copy);
    g_autofree char *after = text_of(scene);
    g_assert_cmpstr(after, ==, before);
}

/* What is cut off becomes detached where it is; what belongs to the blocks stays with them. */
static void test_text(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autofree char *text = fragment_of(scene, (const char *[]){"Mass 0", "Spring 0", "Pulley 0", NULL});
    /* the support is turned by 180 degrees: its end is at (0 - 0.5, 4 - 2 in) */
    g_assert_cmpstr(text, ==,
                    "{\n  \"tinker\": 1,\n  \"blocks\": [\n"
                    "    {\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [[-0.5, 3.9492], \"Mass 0\"], "
                    "\"stiffness\": 25, \"colour\": \"red\"},\n"
                    "    {\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": 7.296951468603182, "
                    "\"position\": [0.1, 2]},\n"
                    "    {\"type\": \"pulley\", \"name\": \"Pulley 0\", \"ends\": [\"Mass 0\"], \"ratio\": 2.50}\n"
                    "  ],\n  \"graphs\": [\n"
                    "    {\"block\": \"Mass 0\", \"quantity\": \"y\", \"place\": [1, 1], \"pen\": 3}\n  ]\n}\n");
}

static void test_paste(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = text_of(scene);
    g_autofree char *text = fragment_of(scene, (const char *[]){"Mass 0", "Spring 0", "Pulley 0", "Motor 0", NULL});
    g_autoptr(GArray) pasted = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_fragment_paste(history, text, 1, -2, pasted, &error));
    g_assert_no_error(error);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Paste 4 Blocks");
    g_assert_cmpuint(pasted->len, ==, 4);
    const char *names[] = {"Spring 1", "Mass 1", "Pulley 1", "Motor 1"};
    for (guint i = 0; i < pasted->len; i++)
        g_assert_cmpstr(tinker_scene_block_name(scene, g_array_index(pasted, TinkerBlockId, i)), ==, names[i]);
    g_assert_cmpfloat(column(scene, "Mass 1", "position", 0), ==, 1.1);
    g_assert_cmpfloat(column(scene, "Mass 1", "position", 1), ==, 0);
    TinkerSceneEnd end = tinker_scene_end(scene, tinker_scene_find_block(scene, "Spring 1"), 0);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat(end.x, ==, 0.5);
    g_assert_cmpfloat(end.y, ==, 3.9492 - 2);
    TinkerBlockId mass = tinker_scene_find_block(scene, "Mass 1");
    g_assert_cmpint(tinker_scene_end(scene, tinker_scene_find_block(scene, "Spring 1"), 1).block, ==, mass);
    g_assert_cmpint(tinker_scene_end(scene, tinker_scene_find_block(scene, "Motor 1"), 0).block, ==, mass);
    g_assert_cmpuint(tinker_scene_graphs(scene)->len, ==, 2);
    const TinkerSceneGraph *graph = g_ptr_array_index(tinker_scene_graphs(scene), 1);
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "Mass 1");
    g_autofree char *after = text_of(scene);
    g_assert_nonnull(strstr(after, "\"ratio\": 2.50}"));
    g_assert_nonnull(strstr(after, "\"name\": \"Motor 1\", \"ends\": [\"Mass 1\"], \"waveform\": {\"expression\": "
                                   "\"10*sin(2*t)\"}}"));
    g_assert_nonnull(strstr(strstr(after, "Spring 1"), "\"colour\": \"red\""));
    g_assert_nonnull(strstr(strstr(after, "\"Pulley 1\""), "\"ends\": [\"Mass 1\"]"));
    g_autoptr(TinkerScene) again = scene_fixture_read(after);

    tinker_history_undo(history);
    g_autofree char *undone = text_of(scene);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(history);
    g_autofree char *redone = text_of(scene);
    g_assert_cmpstr(redone, ==, after);
}

/* Local origins move where they are given, and follow their block where they are not. Names that are free stay. */
static void test_displacement_and_names(void)
{
    g_autoptr(TinkerScene) from = scene_fixture_read_blocks(
        "{\"type\": \"mass\", \"name\": \"Given\", \"position\": [1, 1], \"local_origin\": [0, 2]},"
        "{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [1, 1]},"
        "{\"type\": \"mass\", \"name\": \"Mass 1\"}");
    g_autofree char *text = fragment_of(from, (const char *[]){"Given", "Mass 0", "Mass 1", NULL});
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks("{\"type\": \"mass\", \"name\": \"Mass 0\"}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    tinker_history_begin(history, "Duplicate", NULL);
    g_assert_true(tinker_fragment_paste(history, text, 0.5, 0.25, NULL, NULL));
    tinker_history_end(history);
    g_assert_cmpstr(tinker_history_can_undo(history), ==, "Duplicate");
    g_assert_cmpfloat(column(scene, "Given", "local_origin", 0), ==, 0.5);
    g_assert_cmpfloat(column(scene, "Given", "local_origin", 1), ==, 2.25);
    g_assert_cmpfloat(column(scene, "Mass 2", "local_origin", 0), ==, 1.5); /* was Mass 0 */
    g_assert_cmpfloat(column(scene, "Mass 1", "position", 0), ==, 0.5);
    TinkerBlockId id = tinker_scene_find_block(scene, "Mass 2");
    int32_t origin = tinker_block_class_property(tinker_scene_block_class(scene, id), "local_origin");
    g_assert_false(tinker_scene_property_given(scene, id, origin));
}

/* A table whose file the other scene's folder does not have, and one that has no file at all. */
static void test_tables(void)
{
    g_autofree char *folder = g_dir_make_tmp("fragment-XXXXXX", NULL);
    g_autofree char *table = g_build_filename(folder, "quake.csv", NULL);
    g_autofree char *path = g_build_filename(folder, "scene.tinker.json", NULL);
    g_assert_true(g_file_set_contents(table, "0, 1\n2, 5\n", -1, NULL));
    const char *text = "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\"}, {\"type\": "
                       "\"support-motion\", \"name\": \"File\", \"ends\": [\"S\"], \"waveform\": {\"table\": "
                       "\"quake.csv\"}}, {\"type\": \"support-motion\", \"name\": \"Memory\", \"ends\": [\"S\"]}]}";
    TinkerScene *from = tinker_scene_read_text(scene_fixture_catalogue(), text, strlen(text), path, NULL, NULL);
    g_assert_nonnull(from);
    g_autoptr(TinkerWaveform) made =
        tinker_waveform_new_table((double[]){0, 1}, (double[]){3, 4}, 2, TINKER_TABLE_VALUE, NULL);
    TinkerBlockId memory = tinker_scene_find_block(from, "Memory"), file = tinker_scene_find_block(from, "File");
    int32_t property = tinker_block_class_property(tinker_scene_block_class(from, memory), "waveform");
    tinker_scene_set_waveform(from, memory, property, made);
    g_autoptr(TinkerWaveform) read = tinker_waveform_ref(tinker_scene_get_waveform(from, file, property));
    g_autofree char *fragment = fragment_of(from, (const char *[]){"S", "File", "Memory", NULL});
    tinker_scene_free(from);
    g_assert_cmpint(g_remove(table), ==, 0);
    g_assert_cmpint(g_rmdir(folder), ==, 0);

    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_fragment_paste(history, fragment, 0, 0, NULL, &error));
    g_assert_no_error(error);
    g_assert_true(tinker_scene_get_waveform(scene, tinker_scene_find_block(scene, "File"), property) == read);
    g_assert_true(tinker_scene_get_waveform(scene, tinker_scene_find_block(scene, "Memory"), property) == made);
    g_autofree char *saved = text_of(scene);
    g_assert_nonnull(strstr(saved, "\"waveform\": {\"table\": \"quake.csv\"}"));
    g_assert_null(strstr(saved, "in memory"));
}

static void test_refused(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = text_of(scene);
    const struct {
        const char *text, *message;
        double dx;
    } bad[] = {
        {"", "scene:1:1: ", 0},
        {"hello", "scene:1:1: ", 0},
        {"[1]", "not a scene", 0},
        {"{\"tinker\": 1}", "it is a scene without blocks", 0},
        {"{\"blocks\": [{\"type\": \"mass\"}]}", "the key \"tinker\"", 0},
        {"{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"mass\", \"mass\": -1}]}",
         "mass must be greater than 0 kg", 0},
        {"{\"tinker\": 1, \"blocks\": [{\"type\": \"spring\", \"ends\": [\"Mass 0\", [0, 0]]}]}",
         "names no block \"Mass 0\"", 0},
        {"{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}]}", "position: x must be a finite number", INFINITY},
    };
    const guint64 revision = tinker_history_revision(history);
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(GError) error = NULL;
        g_autoptr(GArray) pasted = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
        g_assert_false(tinker_fragment_paste(history, bad[i].text, bad[i].dx, 0, pasted, &error));
        g_assert_cmpint(error->domain, ==, TINKER_SCENE_ERROR);
        if (strstr(error->message, bad[i].message) == NULL) g_test_fail_printf("%s", error->message);
        g_assert_cmpuint(pasted->len, ==, 0);
    }
    g_autofree char *after = text_of(scene);
    g_assert_cmpstr(after, ==, before);
    g_assert_null(tinker_history_can_undo(history));
    g_assert_cmpuint(tinker_history_revision(history), ==, revision);
}

static void add_tests(void)
{
    g_test_add_func("/scene/copy", test_copy);
    g_test_add_func("/scene/fragment/text", test_text);
    g_test_add_func("/scene/fragment/paste", test_paste);
    g_test_add_func("/scene/fragment/displacement-and-names", test_displacement_and_names);
    g_test_add_func("/scene/fragment/tables", test_tables);
    g_test_add_func("/scene/fragment/refused", test_refused);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
