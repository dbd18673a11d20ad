/* Messages of the core as the window shows them. */
#include "gui/text/sentence.h"

#include "scene-fixture.h"

static void assert_sentence(TinkerScene *scene, const char *message, const char *expected)
{
    g_autofree char *sentence = scene != NULL ? tinker_sentence_in(scene, message) : tinker_sentence(message);
    g_assert_cmpstr(sentence, ==, expected);
}

static void test_capital_and_stop(void)
{
    assert_sentence(NULL, "not predictable (a smaller step helps)", "Not predictable (a smaller step helps).");
    assert_sentence(NULL, "what is meant?", "What is meant?");
    assert_sentence(NULL, "It is done.", "It is done.");
    assert_sentence(NULL, "überzählig: Rod 0", "Überzählig: Rod 0.");
    assert_sentence(NULL, "", "");
}

/* Also where it is one of several, but not where a word merely begins like one. */
static void test_name_stays(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks("{\"type\": \"mass\", \"name\": \"a\"}, {\"type\": \"mass\", \"name\": \"m1\"}");
    assert_sentence(scene, "m1: its motion is not a number", "m1: its motion is not a number.");
    assert_sentence(scene, "m1, a: no motion satisfies these", "m1, a: no motion satisfies these.");
    assert_sentence(scene, "m1 starts below the top", "m1 starts below the top.");
    assert_sentence(scene, "m12 is not there", "M12 is not there.");
    assert_sentence(scene, "an end is loose", "An end is loose.");
    assert_sentence(scene, "", "");
}

static void add_tests(void)
{
    g_test_add_func("/gui/sentence/capital-and-stop", test_capital_and_stop);
    g_test_add_func("/gui/sentence/name", test_name_stays);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
