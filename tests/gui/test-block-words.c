/* What the outline says of blocks. */
#include "gui/text/block-words.h"
#include "panel-fixture.h"

static void test_words(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING ", {'type': 'gravity', 'name': 'G'},"
                                 "{'type': 'motor', 'name': 'M', 'ends': [[0, 0]]},"
                                 "{'type': 'nobody', 'name': 'P'}");
    static const char *const words[] = {"Mass 0, Mass, at (3.20000 m, 2.40000 m)",
                                        "Support 0, Support, at (0.00000 m, 4.00000 m)",
                                        "Spring 0, Spring, from Support 0 to Mass 0",
                                        "G, Gravity",
                                        "M, Motor, on a loose end",
                                        "P, nobody"};
    TinkerScene *scene = tinker_document_scene(fixture->document);
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autofree char *said = tinker_block_words(scene, tinker_scene_block_at(scene, (int32_t)i));
        g_assert_cmpstr(said, ==, words[i]);
    }
    panel_go_english(fixture);
    g_autofree char *said = tinker_block_words(scene, tinker_scene_block_at(scene, 0));
    g_assert_cmpstr(said, ==, "Mass 0, Mass, at (10.49869 ft, 7.87402 ft)");
}

/* A component is called by its own title, with what it is of where that does not say so; one that has none by the
 * property's title and its axis, so that the two are told apart. */
static void test_components(void)
{
    static const struct {
        TinkerPropertyType type;
        const char *words[2];
    } cases[] = {
        {{.kind = TINKER_KIND_VECTOR, .title = "Pull", .group = "Forces"}, {"Pull x", "Pull y"}},
        {{.kind = TINKER_KIND_VECTOR, .title = "Pull", .group = "Forces", .component_titles = {"X", "Y"}},
         {"Pull X", "Pull Y"}},
        {{.kind = TINKER_KIND_VECTOR, .title = "Pull", .group = "First Pull", .component_titles = {"X", "Y"}},
         {"First Pull X", "First Pull Y"}},
        {{.kind = TINKER_KIND_VECTOR, .title = "Pull", .group = "Forces", .component_titles = {"X Pull", "Y Pull"}},
         {"X Pull", "Y Pull"}},
        {{.kind = TINKER_KIND_REAL, .title = "Pull", .group = "Forces"}, {"Pull", "Pull"}},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        for (int32_t component = 0; component < 2; component++) {
            g_autofree char *words = tinker_property_words(&cases[i].type, component);
            g_assert_cmpstr(words, ==, cases[i].words[component]);
        }
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-list/components", test_components);
    g_test_add_func("/gui/property-list/words", test_words);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
