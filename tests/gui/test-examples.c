/* The examples: every bundled scene once, under the topic that the README gives it. */
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

#include "gui/document/examples.h"

#define ENDING ".tinker.json"

static void test_all_are_there(void)
{
    g_autoptr(GPtrArray) topics = tinker_examples_read(g_getenv("TINKER_SCENES"));
    g_autoptr(GHashTable) listed = g_hash_table_new(g_str_hash, g_str_equal);
    g_assert_cmpuint(topics->len, >, 3);
    for (guint t = 0; t < topics->len; t++) {
        const TinkerTopic *topic = topics->pdata[t];
        g_assert_cmpstr(topic->title, !=, "Others");
        for (guint i = 0; i < topic->examples->len; i++) {
            const TinkerExample *example = topic->examples->pdata[i];
            g_assert_true(g_hash_table_add(listed, example->path));
            g_assert_cmpstr(example->title, !=, "");
            g_assert_null(strstr(example->title, ENDING));
        }
    }
    guint files = 0;
    g_autoptr(GDir) dir = g_dir_open(g_getenv("TINKER_SCENES"), 0, NULL);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
        if (g_str_has_suffix(name, ENDING)) files++;
    g_assert_cmpuint(g_hash_table_size(listed), ==, files);
    const TinkerTopic *first = topics->pdata[0];
    g_assert_cmpstr(first->title, ==, "To begin with");
    g_assert_cmpstr(((TinkerExample *)first->examples->pdata[0])->title, ==, "Spring-mass system");
}

/* A folder without a README, and one that does not exist. */
static void test_other_folders(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-examples-XXXXXX", NULL);
    g_autofree char *good = g_build_filename(folder, "b" ENDING, NULL),
                    *bad = g_build_filename(folder, "a" ENDING, NULL);
    g_assert_true(g_file_set_contents(good, "{\"tinker\": 1}", -1, NULL));
    g_assert_true(g_file_set_contents(bad, "no scene", -1, NULL));
    g_autoptr(GPtrArray) topics = tinker_examples_read(folder), none = tinker_examples_read("/nowhere");
    g_assert_cmpuint(none->len, ==, 0);
    g_assert_cmpuint(topics->len, ==, 1);
    const TinkerTopic *topic = topics->pdata[0];
    g_assert_cmpuint(topic->examples->len, ==, 1);
    g_assert_cmpstr(((TinkerExample *)topic->examples->pdata[0])->title, ==, "b");
    g_assert_cmpint(g_unlink(good) + g_unlink(bad) + g_rmdir(folder), ==, 0);
}

/* The scenes of a bundle stand under its title; a bundle without scenes has no topic. */
static void test_bundles(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-examples-XXXXXX", NULL);
    g_autofree char *scene = g_build_filename(folder, "a" ENDING, NULL);
    g_assert_true(g_file_set_contents(scene, "{\"tinker\": 1, \"title\": \"A lever\"}", -1, NULL));
    g_autoptr(GPtrArray) topics = tinker_examples_read("/nowhere"), bundles = g_ptr_array_new();
    g_autoptr(GPtrArray) scenes = g_ptr_array_new(), none = g_ptr_array_new();
    g_ptr_array_add(scenes, scene);
    TinkerBundleEntry course = {.title = (char *)"Mechanics 1", .scenes = scenes},
                      empty = {.title = (char *)"Empty", .scenes = none};
    g_ptr_array_add(bundles, &empty);
    g_ptr_array_add(bundles, &course);
    tinker_examples_add_bundles(topics, bundles);
    g_assert_cmpuint(topics->len, ==, 1);
    const TinkerTopic *topic = topics->pdata[0];
    g_assert_cmpstr(topic->title, ==, "Mechanics 1");
    g_assert_cmpuint(topic->examples->len, ==, 1);
    g_assert_cmpstr(((TinkerExample *)topic->examples->pdata[0])->title, ==, "A lever");
    g_assert_cmpstr(((TinkerExample *)topic->examples->pdata[0])->path, ==, scene);
    g_assert_cmpint(g_unlink(scene) + g_rmdir(folder), ==, 0);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/gui/examples/all-are-there", test_all_are_there);
    g_test_add_func("/gui/examples/other-folders", test_other_folders);
    g_test_add_func("/gui/examples/bundles", test_bundles);
    return g_test_run();
}
