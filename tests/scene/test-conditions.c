/* Conditions that end a run: taken apart, kept in scenes, and renamed with their blocks. */
#include <string.h>

#include "scene-fixture.h"
#include "scene/history/difference.h"
#include "scene/history/history.h"
#include "scene/read/scene-json.h"
#include "scene/store/conditions.h"

static void test_split(void)
{
    static const struct {
        const char *text, *parts;
    } cases[] = {
        {"", ""},
        {" ; ;", ""},
        {" {A.y} = 0 ", "{A.y} = 0"},
        {"{A.y} = 0;event(impact, A; B) ; t > 2", "{A.y} = 0|event(impact, A; B)|t > 2"},
        {"{A (1.y} = 0; {:-).y} = t; t > 1", "{A (1.y} = 0|{:-).y} = t|t > 1"},
        {"{A;B.y} < 1; min(1; 2) = t", "{A;B.y} < 1|min(1; 2) = t"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_auto(GStrv) parts = tinker_conditions_split(cases[i].text);
        g_autofree char *joined = g_strjoinv("|", parts);
        g_assert_cmpstr(joined, ==, cases[i].parts);
    }
}

static void test_renamed(void)
{
    static const struct {
        const char *text, *renamed;
    } cases[] = {
        {"{A.y} = 0", "{Bob.y} = 0"},
        {"{AB.y} = 0", NULL},
        {"event(impact)", NULL},
        {"event( impact ,A )", "event(impact, Bob)"},
        {"event(impact, A (2))", NULL},
        {"t > 2; {A.y} > {S.x}; event(slip, A)", "t > 2; {Bob.y} > {S.x}; event(slip, Bob)"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *renamed = tinker_conditions_renamed(cases[i].text, "A", "Bob");
        g_assert_cmpstr(renamed, ==, cases[i].renamed);
    }
}

static void test_events(void)
{
    g_autofree char *block = NULL, *kind = tinker_condition_event("event(slip, Box (2))", &block);
    g_assert_cmpstr(kind, ==, "slip");
    g_assert_cmpstr(block, ==, "Box (2)");
    char *none;
    g_autofree char *any = tinker_condition_event("event(direction lost)", &none);
    g_assert_cmpstr(any, ==, "direction lost");
    g_assert_null(none);
    g_assert_null(tinker_condition_event("{A.y} = 0", &none));
    g_assert_null(none);
}

static void test_scene(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(
        "{\"tinker\": 1, \"run\": {\"until\": \"{Mass 0.y} = 1; event(impact, Mass 0)\"}, \"blocks\": [{\"type\": "
        "\"mass\"}]}");
    g_assert_cmpstr(tinker_scene_head(scene)->run.until, ==, "{Mass 0.y} = 1; event(impact, Mass 0)");
    g_autoptr(TinkerScene) copy = tinker_scene_copy(scene);
    g_assert_cmpint(tinker_scene_difference(scene, copy), ==, TINKER_DIFFERENCE_DRAWING);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_assert_true(tinker_history_rename_block(history, tinker_scene_find_block(scene, "Mass 0"), "Bob", NULL));
    g_autofree char *renamed = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(renamed, "\"until\": \"{Bob.y} = 1; event(impact, Bob)\""));
    tinker_history_undo(history);
    g_assert_cmpstr(tinker_scene_head(scene)->run.until, ==, tinker_scene_head(copy)->run.until);
    TinkerSceneHead head = *tinker_scene_head(scene);
    head.run.until = (char *)"";
    g_assert_true(tinker_history_set_head(history, &head, NULL));
    g_assert_cmpint(tinker_scene_difference(scene, copy), ==, TINKER_DIFFERENCE_START);
    g_autofree char *without = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_null(strstr(without, "until"));
}

static void add_tests(void)
{
    g_test_add_func("/scene/conditions/split", test_split);
    g_test_add_func("/scene/conditions/renamed", test_renamed);
    g_test_add_func("/scene/conditions/events", test_events);
    g_test_add_func("/scene/conditions/scene", test_scene);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
