/* Reading: what the scene holds afterwards. */
#include "scene-fixture.h"
#include "scene/value/table-source.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static double value(TinkerScene *scene, const char *name, const char *property, int component)
{
    TinkerBlockId block = tinker_scene_find_block(scene, name);
    g_assert_cmpint(block, !=, TINKER_NO_BLOCK);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t number = tinker_block_class_property(block_class, property);
    g_assert_cmpint(number, >=, 0);
    return tinker_scene_get(scene, block, block_class->first_columns[number] + component);
}

static void test_head(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    const TinkerSceneHead *head = tinker_scene_head(scene);
    g_assert_cmpstr(head->title, ==, "Everything \303\244\360\237\230\200");
    g_assert_cmpstr(head->description, ==, "");
    g_assert_cmpint(head->units, ==, TINKER_UNIT_SYSTEM_ENGLISH);
    g_assert_cmpfloat(head->canvas_width, ==, 12 * 0.3048);
    g_assert_cmpfloat(head->canvas_grid, ==, 0.2);
    g_assert_false(head->canvas_snap);
    g_assert_cmpfloat(head->run.duration, ==, 2);
    g_assert_cmpfloat(head->run.interval, ==, 0.01);
    g_assert_cmpstr(head->run.method, ==, "rk4");
    g_assert_cmpfloat(head->run.step, ==, 0.001);
    g_assert_cmpfloat(head->run.tolerance, ==, 1e-9);
    g_assert_cmpstr(head->run.contacts, ==, "events");
}

static void test_values(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_assert_cmpfloat(value(scene, "Support 0", "orientation", 0), ==, G_PI);
    g_assert_cmpfloat(value(scene, "Mass 0", "position", 1), ==, 2);
    /* A slug is a pound-force second squared per foot: 0.45359237 * 9.80665 / 0.3048 kg. */
    g_assert_cmpfloat_with_epsilon(value(scene, "Mass 0", "mass", 0), 0.5 * 0.45359237 * 9.80665 / 0.3048, 1e-14);
    g_assert_cmpfloat(value(scene, "Mass 0", "local_origin", 1), ==, 2);
    g_assert_true(isnan(value(scene, "Spring 0", "rest_length", 0)));
    TinkerBlockId kind = tinker_scene_find_block(scene, "Every Kind 0");
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, kind);
    g_assert_cmpfloat(value(scene, "Every Kind 0", "shade", 0), ==, 1);
    g_assert_cmpfloat(value(scene, "Every Kind 0", "count", 0), ==, 3);
    g_assert_cmpfloat(value(scene, "Every Kind 0", "open", 0), ==, 1);
    g_assert_cmpstr(tinker_scene_get_text(scene, kind, tinker_block_class_property(block_class, "note")), ==,
                    "a \"b\"\n");
    TinkerBlockId motor = tinker_scene_find_block(scene, "Motor 0");
    int32_t waveform = tinker_block_class_property(tinker_scene_block_class(scene, motor), "waveform");
    g_assert_cmpstr(tinker_waveform_expression(tinker_scene_get_waveform(scene, motor, waveform)), ==, "10*sin(2*t)");
}

static void test_ends(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    TinkerBlockId spring = tinker_scene_find_block(scene, "Spring 0");
    TinkerSceneEnd end = tinker_scene_end(scene, spring, 0);
    g_assert_cmpint(end.block, ==, tinker_scene_find_block(scene, "Support 0"));
    g_assert_cmpfloat(end.x, ==, 0.5);
    g_assert_cmpfloat(end.y, ==, 2 * 0.0254);
    end = tinker_scene_end(scene, spring, 1);
    g_assert_cmpint(end.block, ==, tinker_scene_find_block(scene, "Mass 0"));
    end = tinker_scene_end(scene, tinker_scene_find_block(scene, "Damper 0"), 0);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat(end.y, ==, 2);
    g_assert_cmpint(tinker_scene_first_detached(scene), ==, tinker_scene_find_block(scene, "Damper 0"));
    g_assert_cmpint(tinker_scene_first_placeholder(scene), ==, tinker_scene_find_block(scene, "Pulley 0"));
}

/* An end may name a block without a name in the file by the name that it gets. */
/* A key is the same however it is escaped. */
static void test_escaped_keys(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read("{\"tinker\": 1, \"bl\\u006fcks\": [{\"type\": \"mass\"}], "
                           "\"gr\\u0061phs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\"}]}");
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 1);
    g_assert_cmpuint(tinker_scene_graphs(scene)->len, ==, 1);
}

static void test_default_names(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks("{\"type\": \"mass\"},\n{\"type\": \"motor\", \"ends\": [\"Mass 2\"]},\n"
                                  "{\"type\": \"mass\", \"name\": \"Mass 1\"},\n{\"type\": \"mass\"}");
    g_assert_cmpstr(tinker_scene_block_name(scene, tinker_scene_block_at(scene, 0)), ==, "Mass 0");
    g_assert_cmpstr(tinker_scene_block_name(scene, tinker_scene_block_at(scene, 3)), ==, "Mass 2");
    g_assert_cmpint(tinker_scene_end(scene, tinker_scene_find_block(scene, "Motor 0"), 0).block, ==,
                    tinker_scene_find_block(scene, "Mass 2"));
}

/* A folder with a scene's folder in it, and tables inside, outside and linked to. */
typedef struct {
    char *top, *scene, *inside, *outside, *link, *path;
} Folder;

static Folder folder_new(void)
{
    Folder folder;
    folder.top = g_dir_make_tmp("tinker-scene-XXXXXX", NULL);
    folder.scene = g_build_filename(folder.top, "scene", NULL);
    g_assert_cmpint(g_mkdir(folder.scene, 0700), ==, 0);
    folder.inside = g_build_filename(folder.scene, "inside.csv", NULL);
    folder.outside = g_build_filename(folder.top, "outside.csv", NULL);
    folder.link = g_build_filename(folder.scene, "link.csv", NULL);
    folder.path = g_build_filename(folder.scene, "a.tinker.json", NULL);
    g_assert_true(g_file_set_contents(folder.inside, "t,a\n0,0\n1,2\n2,0\n", -1, NULL));
    g_assert_true(g_file_set_contents(folder.outside, "t,a\n0,0\n1,2\n", -1, NULL));
    g_assert_cmpint(symlink(folder.outside, folder.link), ==, 0);
    return folder;
}

static void folder_free(Folder folder)
{
    char *files[] = {folder.inside, folder.outside, folder.link, folder.path};
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++) {
        g_remove(files[i]);
        g_free(files[i]);
    }
    g_rmdir(folder.scene);
    g_rmdir(folder.top);
    g_free(folder.scene);
    g_free(folder.top);
}

static char *table_findings(const Folder *folder, const char *table)
{
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [\n{\"type\": \"support\", \"name\": \"S\"},\n{\"type\": "
        "\"support-motion\", \"name\": \"Motion\", \"ends\": [\"S\"],\n\"waveform\": {\"table\": \"%s\", "
        "\"kind\": \"acceleration\", \"scale\": 9.81}}]}",
        table);
    return scene_fixture_findings(text, -1, folder->path);
}

static void test_tables(void)
{
    Folder folder = folder_new();
    g_autofree char *inside = table_findings(&folder, "inside.csv");
    g_assert_cmpstr(inside, ==, "");
    g_autofree char *round_about = table_findings(&folder, "./../scene/inside.csv");
    g_assert_cmpstr(round_about, ==, "");
    g_autofree char *outside = table_findings(&folder, "../outside.csv");
    g_assert_cmpstr(
        outside, ==,
        "4:23: Motion: waveform: table: \"../outside.csv\" lies outside the scene's folder; a table must be "
        "a file in it\n");
    g_autofree char *link = table_findings(&folder, "link.csv");
    g_assert_cmpstr(link, ==,
                    "4:23: Motion: waveform: table: \"link.csv\" is a link that leads outside the scene's folder; a "
                    "table must be a file in it\n");
    g_autofree char *absolute = table_findings(&folder, folder.inside);
    g_assert_nonnull(strstr(absolute, "lies outside the scene's folder"));
    g_autofree char *itself = table_findings(&folder, ".");
    g_assert_nonnull(strstr(itself, "lies outside the scene's folder"));
    folder_free(folder);
}

/* The waveform of a block that moves a place, or gives a force. */
static const TinkerPropertyType *waveform_type(const char *type)
{
    const TinkerBlockClass *block_class = scene_fixture_class(type);
    return &block_class->properties[tinker_block_class_property(block_class, "waveform")];
}

/* For a scene that is there: held to the same rules as a table that is read with its scene. */
static void test_table_for_scene(void)
{
    Folder folder = folder_new();
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks("{\"type\": \"support\", \"name\": \"S\"}");
    const TinkerPropertyType *motion = waveform_type("support-motion"), *force = waveform_type("motor");
    TinkerTableSource source = {"inside.csv", 1, 9.81, TINKER_TABLE_ACCELERATION};
    TinkerTableFacts facts;
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) read = tinker_scene_read_table(scene, folder.path, &source, motion, NULL, &error);
    g_assert_no_error(error);
    g_assert_true(tinker_waveform_table_facts(read, &facts));
    g_assert_cmpuint(facts.rows, ==, 3);
    g_assert_cmpint(facts.column, ==, 1);
    g_assert_cmpfloat(facts.scale, ==, 9.81);
    g_assert_cmpint(facts.kind, ==, TINKER_TABLE_ACCELERATION);
    g_autofree char *file = tinker_scene_table_file(scene, read);
    g_assert_cmpstr(file, ==, "inside.csv");

    const struct {
        const char *file;
        const TinkerPropertyType *type;
        const char *message;
    } wrong[] = {
        {"inside.csv", force, "a table of accelerations can only move a place"},
        {"../outside.csv", motion, "lies outside the scene's folder"},
        {"link.csv", motion, "is a link that leads outside the scene's folder"},
        {"none.csv", motion, "cannot be read"},
        {"\xff.csv", motion, "not UTF-8"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(GError) reason = NULL;
        source.file = wrong[i].file;
        g_assert_null(tinker_scene_read_table(scene, folder.path, &source, wrong[i].type, NULL, &reason));
        g_assert_nonnull(strstr(reason->message, wrong[i].message));
    }
    g_autoptr(TinkerWaveform) sine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_SINE);
    g_assert_false(tinker_waveform_table_facts(sine, &facts));
    g_assert_null(tinker_scene_table_file(scene, sine));
    folder_free(folder);
}

/* Nothing but a file of the folder is opened: no pipe, which would keep the reader waiting, nor what lies behind a link
 * to another folder. */
static void test_table_traps(void)
{
    Folder folder = folder_new();
    g_autofree char *pipe = g_build_filename(folder.scene, "pipe.csv", NULL);
    g_autofree char *up = g_build_filename(folder.scene, "up", NULL);
    g_autofree char *zero = g_build_filename(folder.scene, "zero.csv", NULL);
    g_autofree char *again = g_build_filename(folder.scene, "again.csv", NULL);
    g_assert_cmpint(mkfifo(pipe, 0600), ==, 0);
    g_assert_cmpint(symlink(folder.top, up), ==, 0);
    g_assert_cmpint(symlink("/dev/zero", zero), ==, 0);
    g_assert_cmpint(symlink("inside.csv", again), ==, 0);
    static const char *const cases[][2] = {
        {"pipe.csv", "is not a file"},
        {"up", "is a link that leads outside the scene's folder; a table must be a file in it"},
        {"up/outside.csv", "is a link that leads outside the scene's folder; a table must be a file in it"},
        {"zero.csv", "is a link that leads outside the scene's folder; a table must be a file in it"},
        {"inside.csv/x", "cannot be read: Not a directory"},
        {"", "lies outside the scene's folder; a table must be a file in it"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *findings = table_findings(&folder, cases[i][0]);
        g_autofree char *expected =
            g_strdup_printf("4:23: Motion: waveform: table: \"%s\" %s\n", cases[i][0], cases[i][1]);
        g_assert_cmpstr(findings, ==, expected);
    }
    g_autofree char *link_inside = table_findings(&folder, "again.csv");
    g_assert_cmpstr(link_inside, ==, "");
    g_autofree char *through = table_findings(&folder, "up/scene/inside.csv");
    g_assert_cmpstr(through, ==, "");
    char *const made[] = {pipe, up, zero, again};
    for (gsize i = 0; i < G_N_ELEMENTS(made); i++)
        g_remove(made[i]);
    folder_free(folder);
}

static void test_file(void)
{
    Folder folder = folder_new();
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_assert_null(tinker_scene_read_file(scene_fixture_catalogue(), folder.path, findings, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE);
    g_assert_cmpuint(findings->len, ==, 1);
    g_clear_error(&error);
    g_assert_true(g_file_set_contents(folder.path, "", 0, NULL));
    g_assert_null(tinker_scene_read_file(scene_fixture_catalogue(), folder.path, NULL, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_SYNTAX);
    g_clear_error(&error);
    g_assert_true(g_file_set_contents(folder.path, scene_fixture_example, -1, NULL));
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), folder.path, NULL, &error);
    g_assert_no_error(error);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 8);

    /* Written over itself and read again it is the same. */
    g_autofree char *before = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_true(tinker_scene_write_file(scene, folder.path, TINKER_WRITE_SI, &error));
    g_autofree char *after = NULL;
    g_assert_true(g_file_get_contents(folder.path, &after, NULL, NULL));
    g_assert_cmpstr(after, ==, before);
    folder_free(folder);
}

static void add_tests(void)
{
    g_test_add_func("/scene/read/head", test_head);
    g_test_add_func("/scene/read/values", test_values);
    g_test_add_func("/scene/read/ends", test_ends);
    g_test_add_func("/scene/read/escaped-keys", test_escaped_keys);
    g_test_add_func("/scene/read/default-names", test_default_names);
    g_test_add_func("/scene/read/tables", test_tables);
    g_test_add_func("/scene/read/table-for-scene", test_table_for_scene);
    g_test_add_func("/scene/read/table-traps", test_table_traps);
    g_test_add_func("/scene/read/file", test_file);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
