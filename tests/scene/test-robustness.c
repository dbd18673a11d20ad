/* Texts that are no scenes must be refused, whatever they are: no crash, no hang, no scene that cannot be written. */
#include "scene-fixture.h"

#include <string.h>

/* Reads; what is read must survive being written and read again. */
static void try_text(const char *text, gsize length)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = tinker_scene_read_text(scene_fixture_catalogue(), text, length, NULL, NULL, &error);
    g_assert_true((scene == NULL) == (error != NULL));
    if (scene == NULL) return;
    g_autofree char *written = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_autoptr(TinkerScene) again = scene_fixture_read(written);
    g_autofree char *rewritten = tinker_scene_to_text(again, TINKER_WRITE_SI);
    g_assert_cmpstr(rewritten, ==, written);
}

/* The text is copied so that a read beyond its end is found by the address sanitizer. */
static void test_truncated(void)
{
    gsize length = strlen(scene_fixture_example);
    for (gsize cut = 0; cut < length - 2; cut++) {
        g_autofree char *text = g_memdup2(scene_fixture_example, cut);
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerScene) scene = tinker_scene_read_text(scene_fixture_catalogue(), text, cut, NULL, NULL, &error);
        g_assert_null(scene);
        g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_SYNTAX);
    }
}

static void test_mutated(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(20240229);
    const char likely[] = "{}[]\",:\\0123456789.eE+-tfn \n\x80\xff";
    gsize length = strlen(scene_fixture_example);
    for (int round = 0; round < 4000; round++) {
        g_autofree char *text = g_memdup2(scene_fixture_example, length);
        int count = g_rand_int_range(random, 1, 4);
        for (int i = 0; i < count; i++) {
            gint32 at = g_rand_int_range(random, 0, (gint32)length);
            gboolean any = g_rand_boolean(random);
            text[at] = any ? (char)g_rand_int_range(random, 0, 256)
                           : likely[g_rand_int_range(random, 0, (gint32)sizeof likely - 1)];
        }
        try_text(text, length);
    }
}

/* Pieces taken out, doubled and moved. */
static void test_shuffled(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(7);
    gsize length = strlen(scene_fixture_example);
    for (int round = 0; round < 2000; round++) {
        gsize from = (gsize)g_rand_int_range(random, 0, (gint32)length);
        gsize size = (gsize)g_rand_int_range(random, 1, 80);
        size = MIN(size, length - from);
        gsize to = (gsize)g_rand_int_range(random, 0, (gint32)length);
        g_autoptr(GString) text = g_string_new(scene_fixture_example);
        g_autofree char *piece = g_strndup(text->str + from, size);
        if (g_rand_boolean(random)) g_string_erase(text, (gssize)from, (gssize)size);
        g_string_insert(text, (gssize)MIN(to, text->len), piece);
        try_text(text->str, text->len);
    }
}

static void test_nested(void)
{
    const char *beginnings[] = {
        "", "{\"tinker\": 1, \"x\": ", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": "};
    const char *places[] = {"1:201: ", "1:219: ", "1:248: "};
    for (gsize i = 0; i < G_N_ELEMENTS(beginnings); i++) {
        g_autoptr(GString) text = g_string_new(beginnings[i]);
        for (int depth = 0; depth < 100000; depth++)
            g_string_append_c(text, '[');
        g_autofree char *findings = scene_fixture_findings(text->str, (gssize)text->len, NULL);
        g_autofree char *expected = g_strconcat(places[i], "arrays and objects are nested more than 200 deep\n", NULL);
        g_assert_cmpstr(findings, ==, expected);
    }
}

/* Sizes at which anything quadratic would be noticed. */
static void test_many_of_everything(void)
{
    g_autoptr(GString) text = g_string_new("{\"tinker\": 1");
    for (int i = 0; i < 50000; i++)
        g_string_append_printf(text, ", \"k%d\": {}", i % 40000);
    g_string_append(text, ", \"blocks\": [{\"type\": \"every-kind\", \"name\": \"Kind\", \"ends\": [null");
    for (int i = 0; i < 50000; i++)
        g_string_append(text, ", \"nobody\", {\"at\": 1}");
    g_string_append(text, "]}");
    for (int i = 0; i < 20000; i++)
        g_string_append_printf(text, ", {\"type\": \"motor\", \"name\": \"Motor %d\", \"ends\": [\"M %d\"]}", i, i);
    g_string_append(text, "]}");
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_autoptr(TinkerScene) scene =
        tinker_scene_read_text(scene_fixture_catalogue(), text->str, text->len, NULL, findings, NULL);
    g_assert_null(scene);
    /* 50 000 unknown keys of which 10 000 twice; null, 50 000 names, 50 000 times "at" and no block; 20 000 names. */
    g_assert_cmpuint(findings->len, ==, 50000 + 10000 + 1 + 50000 + 2 * 50000 + 20000);
}

static void add_tests(void)
{
    g_test_add_func("/scene/robustness/truncated", test_truncated);
    g_test_add_func("/scene/robustness/mutated", test_mutated);
    g_test_add_func("/scene/robustness/shuffled", test_shuffled);
    g_test_add_func("/scene/robustness/nested", test_nested);
    g_test_add_func("/scene/robustness/many-of-everything", test_many_of_everything);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
