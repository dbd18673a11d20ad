/* What a student types into the search of the examples, and which of them it finds. */
#include <glib.h>
#include <string.h>

#include "gui/document/examples.h"
#include "gui/text/word-search.h"

static gboolean finds(const char *text, const char *typed)
{
    g_auto(GStrv) words = tinker_search_words(text), stems = tinker_search_stems(typed);
    return tinker_search_finds(words, stems);
}

static void test_words(void)
{
    static const struct {
        const char *text, *typed;
        gboolean found;
    } cases[] = {
        {"A damped oscillator", "oscillat", TRUE},
        {"A damped oscillator", "Oscillations", TRUE},
        {"A damped oscillator", "damping", TRUE},
        {"A damped oscillator", "damper oscillating", TRUE},
        {"A damped oscillator", "damping spring", FALSE},
        {"Mass on a spring", "springs", TRUE},
        {"Mass on a spring", "spring-mass", TRUE},
        {"Mass on a spring", "spr", TRUE},
        {"Mass on a spring", "ring", FALSE}, /* no word begins with it */
        {"Mass on a spring", "", TRUE},
        {"Blocks that slide down", "sliding", TRUE},
        {"A bar that bounces", "bouncing", TRUE},
        {"Sieben Federpendel", "Pendel", TRUE},
        {"Gedämpfte Schwingung", "schwingungen", TRUE},
        {"Gedämpfte Schwingung", "gedampft", TRUE},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_test_message("%s: %s", cases[i].text, cases[i].typed);
        g_assert_cmpint(finds(cases[i].text, cases[i].typed), ==, cases[i].found);
    }
}

/* Among the bundled scenes the one that a word is the concept of. */
static void test_examples(void)
{
    static const char *const cases[][2] = {
        {"springs", "spring-mass"}, {"oscillations", "damped-oscillator"},      {"earthquake", "el-centro-block"},
        {"resonant", "resonance"},  {"frictional incline", "friction-incline"}, {"pendulums", "pendulum"}};
    g_autoptr(GPtrArray) topics = tinker_examples_read(g_getenv("TINKER_SCENES"));
    for (gsize k = 0; k < G_N_ELEMENTS(cases); k++) {
        g_autofree char *file = g_strconcat("/", cases[k][1], ".tinker.json", NULL);
        gboolean found = FALSE;
        guint others = 0;
        for (guint t = 0; t < topics->len; t++) {
            const TinkerTopic *topic = g_ptr_array_index(topics, t);
            for (guint i = 0; i < topic->examples->len; i++) {
                const TinkerExample *example = g_ptr_array_index(topic->examples, i);
                g_autofree char *text = g_strjoin("\n", topic->title, example->title, example->description, NULL);
                if (!finds(text, cases[k][0]))
                    others++;
                else if (g_str_has_suffix(example->path, file))
                    found = TRUE;
            }
        }
        g_test_message("%s", cases[k][0]);
        g_assert_true(found);
        g_assert_cmpuint(others, >, 20); /* and by no means all */
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/gui/word-search/words", test_words);
    g_test_add_func("/gui/word-search/examples", test_examples);
    return g_test_run();
}
