/* What an edit means to a run that is under way: each kind of change on a copy, by hand. */
#include "scene-fixture.h"

#include "scene/history/difference.h"
#include "scene/history/history.h"

static const char scene_text[] = "{\"type\": \"support\", \"name\": \"S\", \"position\": [0, 3]},"
                                 "{\"type\": \"mass\", \"name\": \"M\", \"position\": [0, 1]},"
                                 "{\"type\": \"spring\", \"name\": \"K\", \"ends\": [\"S\", \"M\"]},"
                                 "{\"type\": \"motor\", \"name\": \"F\", \"ends\": [\"M\"]}";

static void set(TinkerScene *scene, const char *block, const char *property, double x, double y)
{
    TinkerBlockId id = tinker_scene_find_block(scene, block);
    int32_t number = tinker_block_class_property(tinker_scene_block_class(scene, id), property);
    g_assert_true(tinker_scene_set(scene, id, number, (double[]){x, y}, NULL));
}

static void unset(TinkerScene *scene, const char *block, const char *property)
{
    TinkerBlockId id = tinker_scene_find_block(scene, block);
    tinker_scene_unset(scene, id, tinker_block_class_property(tinker_scene_block_class(scene, id), property));
}

static void change_nothing(TinkerScene *scene) {}

static void change_name(TinkerScene *scene)
{
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "M"), "Bob", NULL));
}

static void change_units(TinkerScene *scene)
{
    tinker_scene_head(scene)->units = TINKER_UNIT_SYSTEM_ENGLISH;
}

static void change_local_origin(TinkerScene *scene)
{
    set(scene, "M", "local_origin", 0, 2);
}

static void change_stiffness(TinkerScene *scene)
{
    set(scene, "K", "stiffness", 30, 0);
}

static void change_rest_length(TinkerScene *scene)
{
    set(scene, "K", "rest_length", 2, 0);
}

static void change_waveform(TinkerScene *scene)
{
    TinkerBlockId id = tinker_scene_find_block(scene, "F");
    g_autoptr(TinkerWaveform) sine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_SINE);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    tinker_scene_set_waveform(scene, id, tinker_block_class_property(block_class, "waveform"), sine);
}

static void change_position(TinkerScene *scene)
{
    set(scene, "M", "position", 0, 1.5);
}

static void change_both(TinkerScene *scene)
{
    change_stiffness(scene);
    change_position(scene);
}

static void change_step(TinkerScene *scene)
{
    tinker_scene_head(scene)->run.step = 0.001;
}

static void add_block(TinkerScene *scene)
{
    tinker_scene_add_block(scene, scene_fixture_class("mass"), NULL, NULL);
}

static void remove_block(TinkerScene *scene)
{
    tinker_scene_remove_block(scene, tinker_scene_find_block(scene, "F"));
}

static void remove_and_add(TinkerScene *scene)
{
    remove_block(scene);
    tinker_scene_add_block(scene, scene_fixture_class("motor"), "F", NULL);
}

static void change_end(TinkerScene *scene)
{
    TinkerSceneEnd detached = {TINKER_NO_BLOCK, 0, 1};
    g_assert_true(tinker_scene_set_end(scene, tinker_scene_find_block(scene, "K"), 1, detached, NULL));
}

static void set_and_unset(TinkerScene *scene)
{
    change_rest_length(scene);
    unset(scene, "K", "rest_length");
}

static const struct {
    const char *name;
    void (*change)(TinkerScene *scene);
    TinkerDifference difference;
} rows[] = {
    {"nothing", change_nothing, TINKER_DIFFERENCE_DRAWING},
    {"name", change_name, TINKER_DIFFERENCE_DRAWING},
    {"units", change_units, TINKER_DIFFERENCE_DRAWING},
    {"local-origin", change_local_origin, TINKER_DIFFERENCE_DRAWING},
    {"and-back", set_and_unset, TINKER_DIFFERENCE_DRAWING},
    {"stiffness", change_stiffness, TINKER_DIFFERENCE_TUNABLE},
    {"rest-length", change_rest_length, TINKER_DIFFERENCE_TUNABLE},
    {"waveform", change_waveform, TINKER_DIFFERENCE_TUNABLE},
    {"position", change_position, TINKER_DIFFERENCE_START},
    {"both", change_both, TINKER_DIFFERENCE_START},
    {"step", change_step, TINKER_DIFFERENCE_START},
    {"added", add_block, TINKER_DIFFERENCE_START},
    {"removed", remove_block, TINKER_DIFFERENCE_START},
    {"another-of-the-name", remove_and_add, TINKER_DIFFERENCE_START},
    {"end", change_end, TINKER_DIFFERENCE_START},
};

static void test_row(gconstpointer data)
{
    gsize row = GPOINTER_TO_SIZE(data);
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(scene_text);
    g_autoptr(TinkerScene) before = tinker_scene_copy(scene);
    rows[row].change(scene);
    g_assert_cmpint(tinker_scene_difference(before, scene), ==, rows[row].difference);
}

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *path = g_strconcat("/difference/", rows[i].name, NULL);
        g_test_add_data_func(path, GSIZE_TO_POINTER(i), test_row);
    }
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
