/* Writing: the normal form, what survives it, and that reading it gives the same scene. */
#include "scene-fixture.h"

#include <cjson/cJSON.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define HEAD                                                                                                           \
    "{\n  \"tinker\": 1,\n  \"run\": {\"duration\": 10, \"interval\": 0.01, \"method\": \"auto\", \"step\": 0.01, "    \
    "\"tolerance\": 1e-09},\n  \"blocks\": ["

static void check_written(const char *blocks, TinkerWriteUnits units, const char *expected)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
    g_autofree char *text = tinker_scene_to_text(scene, units);
    g_autofree char *whole = g_strconcat(HEAD, "\n    ", expected, "\n  ]\n}\n", NULL);
    g_assert_cmpstr(text, ==, whole);
}

static void test_empty(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_cmpstr(text, ==, HEAD "]\n}\n");
}

/* Keys come out in the descriptor's order, and only those that were given. */
static void test_normal_form(void)
{
    check_written("{ \"velocity\":[1.50,-0],\n\"mass\" :2e0, \"name\":\"A\" ,\"type\":\"mass\"}", TINKER_WRITE_SI,
                  "{\"type\": \"mass\", \"name\": \"A\", \"mass\": 2, \"velocity\": [1.5, -0]}");
    check_written("{\"type\": \"support\", \"name\": \"A\"}, {\"ends\": [{\"at\": [0, 0], \"block\": \"A\"}, [1, 2]], "
                  "\"type\": \"spring\"}",
                  TINKER_WRITE_SI,
                  "{\"type\": \"support\", \"name\": \"A\"},\n    {\"type\": \"spring\", \"name\": \"Spring 0\", "
                  "\"ends\": [\"A\", [1, 2]]}");
    check_written(
        "{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"motor\", \"name\": \"M\", \"ends\": [\"A\"], "
        "\"waveform\": {\"expression\": \"2 * t\"}}",
        TINKER_WRITE_SI,
        "{\"type\": \"mass\", \"name\": \"A\"},\n    {\"type\": \"motor\", \"name\": \"M\", \"ends\": [\"A\"], "
        "\"waveform\": {\"expression\": \"2 * t\"}}");
}

/* A block that is newly made has all that a reader asks for. */
static void test_required(void)
{
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    tinker_scene_add_block(scene, scene_fixture_class("disc"), NULL, NULL);
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(text, "{\"type\": \"disc\", \"name\": \"Disc 0\", \"position\": [0, 0]}"));
    g_autoptr(TinkerScene) again = scene_fixture_read(text);
    g_assert_nonnull(again);
}

static void test_english(void)
{
    check_written("{\"type\": \"mass\", \"name\": \"A\", \"mass\": \"0.5 slug\", \"position\": [\"3 ft\", 0.3048], "
                  "\"orientation\": \"30 deg\"}",
                  TINKER_WRITE_ENGLISH,
                  "{\"type\": \"mass\", \"name\": \"A\", \"mass\": \"0.5 slug\", \"position\": [\"3 ft\", \"1 ft\"], "
                  "\"orientation\": \"30 deg\"}");
}

static void check_same_values(TinkerScene *a, TinkerScene *b)
{
    g_assert_cmpint(tinker_scene_block_count(a), ==, tinker_scene_block_count(b));
    for (int32_t place = 0; place < tinker_scene_block_count(a); place++) {
        TinkerBlockId first = tinker_scene_block_at(a, place), second = tinker_scene_block_at(b, place);
        g_assert_cmpstr(tinker_scene_block_name(a, first), ==, tinker_scene_block_name(b, second));
        const TinkerBlockClass *block_class = tinker_scene_block_class(a, first);
        g_assert_true(tinker_scene_block_class(b, second) == block_class);
        for (int32_t c = 0; block_class != NULL && c < block_class->column_count; c++) {
            double x = tinker_scene_get(a, first, c), y = tinker_scene_get(b, second, c);
            g_assert_cmpmem(&x, sizeof x, &y, sizeof y);
        }
        g_assert_cmpint(tinker_scene_end_count(a, first), ==, tinker_scene_end_count(b, second));
        for (int32_t end = 0; end < tinker_scene_end_count(a, first); end++) {
            TinkerSceneEnd x = tinker_scene_end(a, first, end), y = tinker_scene_end(b, second, end);
            g_assert_cmpint(x.block, ==, y.block);
            g_assert_cmpfloat(x.x, ==, y.x);
            g_assert_cmpfloat(x.y, ==, y.y);
        }
    }
}

/* In both systems of units to the last bit, and what is written twice is the same text. */
static void test_round_trip(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    for (int units = TINKER_WRITE_SI; units <= TINKER_WRITE_ENGLISH; units++) {
        g_autofree char *text = tinker_scene_to_text(scene, (TinkerWriteUnits)units);
        g_autoptr(TinkerScene) again = scene_fixture_read(text);
        g_autofree char *rewritten = tinker_scene_to_text(again, (TinkerWriteUnits)units);
        g_assert_cmpstr(rewritten, ==, text);
        check_same_values(scene, again);
        g_assert_cmpfloat(tinker_scene_head(again)->canvas_width, ==, tinker_scene_head(scene)->canvas_width);
    }
}

static void test_random_numbers(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(99);
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    const TinkerBlockClass *mass = scene_fixture_class("mass");
    int32_t position = tinker_block_class_property(mass, "position");
    for (int i = 0; i < 500; i++) {
        TinkerBlockId id = tinker_scene_add_block(scene, mass, NULL, NULL);
        double place[2] = {g_rand_double_range(random, -1, 1), g_rand_double_range(random, -1e9, 1e-9)};
        g_assert_true(tinker_scene_set(scene, id, position, place, NULL));
    }
    for (int units = TINKER_WRITE_SI; units <= TINKER_WRITE_ENGLISH; units++) {
        g_autofree char *text = tinker_scene_to_text(scene, (TinkerWriteUnits)units);
        g_autoptr(TinkerScene) again = scene_fixture_read(text);
        check_same_values(scene, again);
    }
}

static const cJSON *find(const cJSON *json, const char *path)
{
    g_auto(GStrv) keys = g_strsplit(path, "/", -1);
    for (int i = 0; keys[i] != NULL; i++)
        json = cJSON_IsArray(json) ? cJSON_GetArrayItem(json, atoi(keys[i]))
                                   : cJSON_GetObjectItemCaseSensitive(json, keys[i]);
    return json;
}

/* What the reader does not know comes back as the same JSON. */
static void test_unknown_survives(void)
{
    const char *paths[] = {"canvas/ruler", "run/seed", "blocks/2/colour", "blocks/5", "graphs/0/pen", "other"};
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    cJSON *before = cJSON_Parse(scene_fixture_example), *after = cJSON_Parse(text);
    for (gsize i = 0; i < G_N_ELEMENTS(paths); i++) {
        g_assert_nonnull(find(before, paths[i]));
        g_assert_true(cJSON_Compare(find(before, paths[i]), find(after, paths[i]), TRUE));
    }
    cJSON_Delete(before);
    cJSON_Delete(after);
}

static void test_end_extras(void)
{
    check_written(
        "{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"motor\", \"name\": \"M\", \"ends\": [{\"block\": "
        "\"A\", \"pin\" : [ 1 ]}]}",
        TINKER_WRITE_SI,
        "{\"type\": \"mass\", \"name\": \"A\"},\n    {\"type\": \"motor\", \"name\": \"M\", \"ends\": "
        "[{\"block\": \"A\", \"pin\": [1]}]}");
}

/* A placeholder follows a new name; one without a name gets it written where an end needs it. */
static void test_placeholder_names(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks("{\"size\": 1, \"name\": \"P\", \"type\": \"pulley\"}");
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "P"), "Q", NULL));
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(text, "{\"type\": \"pulley\", \"name\": \"Q\", \"size\": 1}"));

    check_written("{\"type\": \"pulley\"}", TINKER_WRITE_SI, "{\"type\": \"pulley\"}");
    check_written(
        "{\"type\": \"pulley\"}, {\"type\": \"motor\", \"name\": \"M\", \"ends\": [\"Pulley 0\"]}", TINKER_WRITE_SI,
        "{\"type\": \"pulley\", \"name\": \"Pulley 0\"},\n    {\"type\": \"motor\", \"name\": \"M\", \"ends\": "
        "[\"Pulley 0\"]}");
}

/* A table comes back as the object that named it, also on another block that was given the same waveform. */
static void test_table_source(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-scene-XXXXXX", NULL);
    g_autofree char *table = g_build_filename(folder, "a.csv", NULL);
    g_autofree char *path = g_build_filename(folder, "a.json", NULL);
    g_assert_true(g_file_set_contents(table, "0,1,2\n1,3,4\n", -1, NULL));
    const char *text =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"A\"}, {\"type\": \"motor\", "
        "\"name\": \"M\", \"ends\": [\"A\"], \"waveform\": {\"scale\":2.0, \"table\":\"a.csv\",\"column\":2}}]}";
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene =
        tinker_scene_read_text(scene_fixture_catalogue(), text, strlen(text), path, NULL, &error);
    g_assert_no_error(error);
    const TinkerBlockClass *motor = scene_fixture_class("motor");
    int32_t waveform = tinker_block_class_property(motor, "waveform");
    TinkerBlockId copy = tinker_scene_add_block(scene, motor, "N", NULL);
    tinker_scene_set_waveform(scene, copy, waveform,
                              tinker_scene_get_waveform(scene, tinker_scene_find_block(scene, "M"), waveform));
    g_autofree char *written = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    const char *object = "\"waveform\": {\"scale\": 2.0, \"table\": \"a.csv\", \"column\": 2}}";
    const char *first = strstr(written, object);
    g_assert_nonnull(first);
    g_assert_nonnull(strstr(first + 1, object));
    g_assert_cmpint(remove(table), ==, 0);
    g_assert_cmpint(remove(folder), ==, 0);
}

/* A pipe is written to; a file in its place would cut off who reads it. */
static void test_pipe(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-XXXXXX", NULL);
    g_autofree char *path = g_build_filename(folder, "pipe", NULL);
    g_assert_cmpint(mkfifo(path, 0600), ==, 0);
    int reader = open(path, O_RDONLY | O_NONBLOCK);
    g_assert_cmpint(reader, >=, 0);
    g_autoptr(TinkerScene) scene = tinker_scene_new(scene_fixture_catalogue());
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_scene_write_file(scene, path, TINKER_WRITE_SI, &error));
    g_assert_no_error(error);
    char text[1024] = "";
    g_assert_cmpint((int)read(reader, text, sizeof text - 1), >, 0);
    g_assert_cmpstr(text, ==, HEAD "]\n}\n");
    close(reader);
    g_assert_cmpint(g_unlink(path), ==, 0);
    g_assert_cmpint(g_rmdir(folder), ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/scene/write/empty", test_empty);
    g_test_add_func("/scene/write/normal-form", test_normal_form);
    g_test_add_func("/scene/write/required", test_required);
    g_test_add_func("/scene/write/english", test_english);
    g_test_add_func("/scene/write/round-trip", test_round_trip);
    g_test_add_func("/scene/write/random-numbers", test_random_numbers);
    g_test_add_func("/scene/write/unknown-survives", test_unknown_survives);
    g_test_add_func("/scene/write/end-extras", test_end_extras);
    g_test_add_func("/scene/write/placeholder-names", test_placeholder_names);
    g_test_add_func("/scene/write/table-source", test_table_source);
    g_test_add_func("/scene/write/pipe", test_pipe);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
