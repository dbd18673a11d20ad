/* The scene itself: names, values, ends, tables and removal, and that a large one is put together rightly. */
#include "scene-fixture.h"

#include <math.h>

static TinkerBlockId add(TinkerScene *scene, const char *type, const char *name)
{
    g_autoptr(GError) error = NULL;
    TinkerBlockId id = tinker_scene_add_block(scene, scene_fixture_class(type), name, &error);
    g_assert_no_error(error);
    return id;
}

static gboolean set(TinkerScene *scene, TinkerBlockId id, const char *property, double x, double y, GError **error)
{
    int32_t number = tinker_block_class_property(tinker_scene_block_class(scene, id), property);
    g_assert_cmpint(number, >=, 0);
    return tinker_scene_set(scene, id, number, (double[2]){x, y}, error);
}

static double get(TinkerScene *scene, TinkerBlockId id, const char *property, int component)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    return tinker_scene_get(scene, id,
                            block_class->first_columns[tinker_block_class_property(block_class, property)] + component);
}

static void test_names(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(GError) error = NULL;
    TinkerBlockId first = add(scene, "mass", NULL), second = add(scene, "mass", NULL);
    add(scene, "mass", "Mass 2");
    g_assert_cmpstr(tinker_scene_block_name(scene, second), ==, "Mass 1");
    g_assert_cmpstr(tinker_scene_block_name(scene, add(scene, "mass", NULL)), ==, "Mass 3");
    tinker_scene_remove_block(scene, first);
    g_assert_true(tinker_scene_rename_block(scene, second, "Bob", NULL));
    g_assert_cmpint(tinker_scene_find_block(scene, "Bob"), ==, second);
    g_assert_cmpint(tinker_scene_find_block(scene, "Mass 1"), ==, TINKER_NO_BLOCK);
    /* The smallest numbers that have become free come first. */
    g_assert_cmpstr(tinker_scene_block_name(scene, add(scene, "mass", NULL)), ==, "Mass 0");
    g_assert_cmpstr(tinker_scene_block_name(scene, add(scene, "mass", NULL)), ==, "Mass 1");
    g_assert_cmpstr(tinker_scene_block_name(scene, add(scene, "mass", NULL)), ==, "Mass 4");

    g_assert_false(tinker_scene_rename_block(scene, second, "Mass 0", &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME);
    g_clear_error(&error);
    g_assert_cmpint(tinker_scene_add_block(scene, scene_fixture_class("mass"), "", &error), ==, TINKER_NO_BLOCK);
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME);
}

static void test_values(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(GError) error = NULL;
    TinkerBlockId mass = add(scene, "mass", "Mass 0"), support = add(scene, "support", "Support 0");
    g_assert_false(set(scene, mass, "mass", NAN, 0, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_clear_error(&error);
    g_assert_false(set(scene, mass, "mass", 0, 0, &error));
    g_assert_cmpstr(error->message, ==, "Mass 0: mass must be greater than 0 kg (it is 0 kg)");
    g_clear_error(&error);
    g_assert_cmpfloat(get(scene, mass, "mass", 0), ==, 1);

    /* The local origin is the position until it is given. */
    g_assert_true(set(scene, mass, "position", 3, 4, NULL));
    g_assert_cmpfloat(get(scene, mass, "local_origin", 1), ==, 4);
    g_assert_true(set(scene, mass, "local_origin", 1, 1, NULL));
    g_assert_true(set(scene, mass, "position", 5, 6, NULL));
    g_assert_cmpfloat(get(scene, mass, "local_origin", 1), ==, 1);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, mass);
    tinker_scene_unset(scene, mass, tinker_block_class_property(block_class, "local_origin"));
    g_assert_cmpfloat(get(scene, mass, "local_origin", 1), ==, 6);

    /* Sliding friction never exceeds that of rest. */
    g_assert_true(set(scene, support, "static_friction", 0.8, 0, NULL));
    g_assert_true(set(scene, support, "dynamic_friction", 0.7, 0, NULL));
    g_assert_false(set(scene, support, "static_friction", 0.6, 0, &error));
    g_assert_cmpstr(error->message, ==,
                    "Support 0: dynamic_friction must be at most static_friction, which is 0.6 (it is 0.7)");
    g_assert_cmpfloat(get(scene, support, "static_friction", 0), ==, 0.8);
    block_class = tinker_scene_block_class(scene, support);
    tinker_scene_unset(scene, support, tinker_block_class_property(block_class, "static_friction"));
    g_assert_cmpfloat(get(scene, support, "dynamic_friction", 0), <=, get(scene, support, "static_friction", 0));
}

static void test_ends(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(GError) error = NULL;
    TinkerBlockId mass = add(scene, "mass", NULL), support = add(scene, "support", NULL);
    TinkerBlockId spring = add(scene, "spring", NULL), motion = add(scene, "support-motion", NULL);
    g_assert_cmpint(tinker_scene_end_count(scene, spring), ==, 2);
    g_assert_cmpint(tinker_scene_first_detached(scene), ==, spring);
    g_assert_false(tinker_scene_set_end(scene, spring, 0, (TinkerSceneEnd){spring, 0, 0}, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_END);
    g_clear_error(&error);
    g_assert_false(tinker_scene_set_end(scene, spring, 0, (TinkerSceneEnd){mass, 1, 0}, &error));
    g_clear_error(&error);
    g_assert_false(tinker_scene_set_end(scene, motion, 0, (TinkerSceneEnd){mass, 0, 0}, &error));
    g_clear_error(&error);
    g_assert_true(tinker_scene_set_end(scene, motion, 0, (TinkerSceneEnd){support, 0, 0}, NULL));
    g_assert_true(tinker_scene_set_end(scene, spring, 0, (TinkerSceneEnd){mass, 0, 0}, NULL));
    g_assert_true(tinker_scene_set_end(scene, spring, 1, (TinkerSceneEnd){support, 2, 0}, NULL));
    g_assert_cmpint(tinker_scene_first_detached(scene), ==, TINKER_NO_BLOCK);

    /* A quarter turn takes the point 2 m to the right of the centre to 2 m above it; there the end is left. */
    g_assert_true(set(scene, support, "position", 1, 1, NULL));
    g_assert_true(set(scene, support, "orientation", G_PI / 2, 0, NULL));
    tinker_scene_remove_block(scene, support);
    TinkerSceneEnd end = tinker_scene_end(scene, spring, 1);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, 1, 1e-15);
    g_assert_cmpfloat_with_epsilon(end.y, 3, 1e-15);
}

/* Rows, columns and ends of the tables tell the same as the blocks themselves. */
static void check_tables(TinkerScene *scene)
{
    int32_t rows = 0;
    for (int32_t t = 0; t < tinker_scene_table_count(scene); t++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, t, &table);
        rows += table.count;
        for (int32_t row = 0; row < table.count; row++) {
            TinkerBlockId id = table.ids[row];
            g_assert_true(row == 0 || table.ids[row - 1] < id);
            g_assert_true(tinker_scene_block_class(scene, id) == table.block_class);
            g_assert_cmpint(table.end_offsets[row + 1] - table.end_offsets[row], ==, tinker_scene_end_count(scene, id));
            for (int32_t end = table.end_offsets[row]; end < table.end_offsets[row + 1]; end++)
                g_assert_cmpint(table.ends[end].block, ==,
                                tinker_scene_end(scene, id, end - table.end_offsets[row]).block);
            for (int32_t c = 0; c < table.block_class->column_count; c++) {
                double value = tinker_scene_get(scene, id, c);
                g_assert_cmpmem(&value, sizeof value, &table.columns[c][row], sizeof value);
            }
        }
    }
    g_assert_cmpint(rows, ==, tinker_scene_block_count(scene));
}

#define MANY 4000

/* A chain of masses with four springs each, the springs first, so that every end names a block that comes later. */
static char *many_blocks(void)
{
    GString *text = g_string_new(NULL);
    for (int i = 0; i < 4 * MANY; i++)
        g_string_append_printf(text,
                               "{\"type\": \"spring\", \"ends\": [\"Mass %d\", \"Mass %d\"], \"stiffness\": %d},\n",
                               i % MANY, (i + 1 + i / MANY) % MANY, i);
    for (int i = 0; i < MANY; i++)
        g_string_append_printf(text, "{\"type\": \"mass\", \"name\": \"Mass %d\", \"position\": [%d, 0.5]}%s\n", i, i,
                               i == MANY - 1 ? "" : ",");
    return g_string_free(text, FALSE);
}

static void test_many(void)
{
    g_autofree char *blocks = many_blocks();
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 5 * MANY);
    for (int i = 0; i < 4 * MANY; i++) {
        char name[32];
        g_snprintf(name, sizeof name, "Spring %d", i);
        TinkerBlockId spring = tinker_scene_block_at(scene, i);
        g_assert_cmpstr(tinker_scene_block_name(scene, spring), ==, name);
        g_assert_cmpfloat(get(scene, spring, "stiffness", 0), ==, i);
        TinkerBlockId first = tinker_scene_end(scene, spring, 0).block;
        TinkerBlockId second = tinker_scene_end(scene, spring, 1).block;
        g_assert_cmpfloat(get(scene, first, "position", 0), ==, i % MANY);
        g_assert_cmpfloat(get(scene, second, "position", 0), ==, (i + 1 + i / MANY) % MANY);
    }
    check_tables(scene);
    for (int i = 0; i < 200; i++)
        tinker_scene_remove_block(scene, tinker_scene_block_at(scene, 97 * i));
    check_tables(scene);
    g_assert_cmpint(tinker_scene_id_limit(scene), ==, 5 * MANY);
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_autoptr(TinkerScene) again = scene_fixture_read(text);
    g_autofree char *rewritten = tinker_scene_to_text(again, TINKER_WRITE_SI);
    g_assert_cmpstr(rewritten, ==, text);
}

static void test_rename_graphs(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "Mass 0"), "Bob", NULL));
    const TinkerSceneGraph *graph = g_ptr_array_index(tinker_scene_graphs(scene), 0);
    g_assert_cmpstr(tinker_scene_graph_curve(graph)->block, ==, "Bob");
}

static void add_tests(void)
{
    g_test_add_func("/scene/scene/names", test_names);
    g_test_add_func("/scene/scene/values", test_values);
    g_test_add_func("/scene/scene/ends", test_ends);
    g_test_add_func("/scene/scene/many", test_many);
    g_test_add_func("/scene/scene/rename-graphs", test_rename_graphs);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
