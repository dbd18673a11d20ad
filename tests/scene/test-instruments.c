/* Controls and meters: what a file may hold, where its mistakes are, and how they follow their blocks. */
#include <string.h>

#include "scene-fixture.h"
#include "scene/history/history.h"

#define BLOCKS                                                                                                         \
    "{\"type\": \"mass\", \"name\": \"Mass 0\"}, {\"type\": \"mass\", \"name\": \"Mass 1\", \"position\": [1, 0]},"    \
    "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\", \"Mass 1\"]},"                              \
    "{\"type\": \"support\", \"name\": \"Support 0\"}"
#define SCENE(lists)   "{\"tinker\": 1, \"blocks\": [" BLOCKS "], " lists "}"
#define CONTROL(entry) SCENE("\"controls\": [\n" entry "]")
#define METER(entry)   SCENE("\"meters\": [\n" entry "]")

static const char controls[] =
    "\"controls\": [\n"
    "    {\"block\": \"Spring 0\", \"property\": \"stiffness\", \"from\": 10, \"to\": 40, \"step\": 5, \"kind\": "
    "\"slider\", \"place\": [1, 2]},\n"
    "    {\"block\": \"Mass 0\", \"property\": \"velocity.y\", \"from\": -2, \"to\": 2, \"kind\": \"knob\"},\n"
    "    {\"block\": \"Support 0\", \"property\": \"solid\", \"from\": 0, \"to\": 1, \"kind\": \"switch\", \"pen\": "
    "3}\n"
    "  ]";
static const char meters[] = "\"meters\": [\n"
                             "    {\"block\": \"Scene\", \"quantity\": \"energy\", \"kind\": \"bar\"},\n"
                             "    {\"block\": \"Mass 0\", \"quantity\": \"distance to Mass 1\", \"kind\": \"dial\", "
                             "\"place\": [3, 4], \"makes_way\": true}\n"
                             "  ]";

static TinkerScene *scene_of_all(void)
{
    g_autofree char *text =
        g_strconcat("{\"tinker\": 1, \"blocks\": [" BLOCKS "], ", controls, ", ", meters, "}", NULL);
    return scene_fixture_read(text);
}

static char *text_of(const TinkerScene *scene)
{
    return tinker_scene_to_text((TinkerScene *)scene, TINKER_WRITE_SI);
}

/* What is written is what was read; also by a copy. */
static void test_written(void)
{
    g_autoptr(TinkerScene) scene = scene_of_all(), copy = tinker_scene_copy(scene);
    g_autofree char *text = text_of(scene), *of_copy = text_of(copy);
    g_assert_nonnull(strstr(text, controls));
    g_assert_nonnull(strstr(text, meters));
    g_assert_cmpstr(of_copy, ==, text);
}

static void test_units(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read(
        CONTROL("{\"block\": \"Mass 0\", \"property\": \"velocity.x\", \"from\": \"-36 km/h\", \"to\": \"36 km/h\"}"));
    const TinkerSceneInstrument *slider = g_ptr_array_index(tinker_scene_instruments(scene), 0);
    g_assert_cmpint(slider->kind, ==, TINKER_INSTRUMENT_SLIDER);
    g_assert_cmpfloat_with_epsilon(slider->from, -10, 1e-14);
    g_assert_cmpfloat_with_epsilon(slider->to, 10, 1e-14);
}

static void test_mistakes(void)
{
    const struct {
        const char *text, *findings;
    } bad[] = {
        {CONTROL("{\"block\": \"Mass 2\", \"property\": \"mass\", \"from\": 1, \"to\": 2}"),
         "2:1: controls[0]: block: there is no block \"Mass 2\" (did you mean \"Mass 0\"?)\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"from\": 1, \"to\": 2}"),
         "2:1: controls[0]: the key \"property\" is missing\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"property\": \"mass\", \"to\": 2}"),
         "2:1: controls[0]: the key \"from\" is missing: a control has a range\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"property\": \"velocity\", \"from\": 1, \"to\": 2}"),
         "2:1: controls[0]: property: a mass has no number \"velocity\" (of a vector one component is named: "
         "\"velocity.x\")\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"property\": \"mass\", \"from\": 2, \"to\": 1}"),
         "2:1: controls[0]: to: it must be greater than from\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"property\": \"mass\", \"from\": -1, \"to\": 1}"),
         "2:1: controls[0]: from: mass must be greater than 0 kg (it is -1 kg)\n"},
        {CONTROL("{\"block\": \"Support 0\", \"property\": \"solid\", \"from\": 0, \"to\": 1}"),
         "2:1: controls[0]: kind: solid is on or off: its control is a \"switch\"\n"},
        {CONTROL("{\"block\": \"Mass 0\", \"property\": \"mass\", \"from\": 1, \"to\": 2, \"kind\": \"dial\"}"),
         "2:69: controls[0]: kind: \"dial\" is not known (it is one of \"slider\", \"knob\", \"switch\")\n"},
        {METER("{\"block\": \"Mass 0\", \"quantity\": \"kinetic enrgy\"}"),
         "2:1: meters[0]: quantity: a mass has no quantity \"kinetic enrgy\" (did you mean \"kinetic energy\"?)\n"},
        {METER("7"), "2:1: meters[0]: an entry is an object, {\"block\": ..., \"quantity\": ...}\n"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *findings = scene_fixture_findings(bad[i].text, -1, NULL);
        g_assert_cmpstr(findings, ==, bad[i].findings);
    }
}

/* Instruments follow names, go with their block, and come back with it. */
static void test_follow(void)
{
    g_autoptr(TinkerScene) scene = scene_of_all();
    TinkerHistory *history = tinker_history_new(scene);
    const TinkerBlockId mass = tinker_scene_find_block(scene, "Mass 1");
    g_autofree char *before = text_of(scene);
    g_assert_true(tinker_history_rename_block(history, mass, "Bob", NULL));
    g_assert_cmpstr(((TinkerSceneInstrument *)tinker_scene_instruments(scene)->pdata[4])->of, ==, "distance to Bob");
    tinker_history_undo(history);
    tinker_history_remove_block(history, mass);
    g_assert_cmpuint(tinker_scene_instruments(scene)->len, ==, 4);
    tinker_history_undo(history);
    g_autofree char *after = text_of(scene);
    g_assert_cmpstr(after, ==, before);
    tinker_history_free(history);
}

static void test_changed(void)
{
    g_autoptr(TinkerScene) scene = scene_of_all();
    TinkerHistory *history = tinker_history_new(scene);
    g_autofree char *before = text_of(scene);
    g_autoptr(TinkerSceneInstrument) dial = tinker_scene_instrument_new(TINKER_INSTRUMENT_DIAL, "Mass 0", "speed");
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_history_set_instrument(history, 5, dial, NULL));
    g_assert_cmpuint(tinker_scene_instruments(scene)->len, ==, 6);
    g_assert_true(tinker_history_set_instrument(history, 0, NULL, NULL));
    g_assert_cmpuint(tinker_scene_instruments(scene)->len, ==, 5);
    g_free(dial->of);
    dial->of = g_strdup("sped");
    g_assert_false(tinker_history_set_instrument(history, 0, dial, &error));
    g_assert_nonnull(strstr(error->message, "did you mean \"speed\"?"));
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *after = text_of(scene);
    g_assert_cmpstr(after, ==, before);
    tinker_history_free(history);
}

static void add_tests(void)
{
    g_test_add_func("/scene/instruments/written", test_written);
    g_test_add_func("/scene/instruments/units", test_units);
    g_test_add_func("/scene/instruments/mistakes", test_mistakes);
    g_test_add_func("/scene/instruments/follow", test_follow);
    g_test_add_func("/scene/instruments/changed", test_changed);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
