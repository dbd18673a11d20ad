/* Every kind of mistake in a scene, with the message and the place that the user sees. */
#include "scene-fixture.h"

#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *name, *text, *findings;
} Bad;

/* Blocks, which begin on line 2 of the text. */
#define BLOCKS(lines) "{\"tinker\": 1, \"blocks\": [\n" lines "\n]}"
#define MASS          "{\"type\": \"mass\", \"name\": \"Mass 0\"},\n"
#define SUPPORT       "{\"type\": \"support\", \"name\": \"Support 0\"},\n"

static const Bad bad[] = {
#include "bad-inputs.h"
};

static void test_bad(gconstpointer data)
{
    const Bad *input = data;
    g_autofree char *findings = scene_fixture_findings(input->text, -1, NULL);
    g_assert_cmpstr(findings, ==, input->findings);
}

/* What is told of keys and types that nobody knows: a symbol is taken for its property, a type is told once. */
static void test_warnings(void)
{
    static const struct {
        const char *blocks, *findings;
    } rows[] = {
        {"{\"type\": \"spring\", \"name\": \"S\", \"ends\": [[0, 0], [1, 0]], \"k\": 100}",
         "2:59: warning: S: unknown key \"k\" (did you mean \"stiffness\"?)\n"},
        {"{\"type\": \"mass\", \"name\": \"M\", \"M\": 1, \"q\": 2}",
         "2:31: warning: M: unknown key \"M\" (did you mean \"mass\"?)\n"
         "2:39: warning: M: unknown key \"q\"; it is kept as it is (known here: mass, position, velocity, "
         "local_origin, orientation, width, height, static_friction, dynamic_friction, restitution, collides, type, "
         "name, on, along)\n"},
        {"{\"type\": \"sprng\"},\n{\"type\": \"sprng\"}, {\"type\": \"kite\"},\n{\"type\": \"sprng\"}",
         "2:10: warning: blocks[0] (sprng): no plugin provides the block type \"sprng\" (did you mean \"spring\"?); 2 "
         "more blocks are of it\n"
         "3:29: warning: blocks[2] (kite): no plugin provides the block type \"kite\" (its library belongs into a "
         "plugin "
         "folder, or into one named by --plugins)\n"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": [\n%s]}", rows[i].blocks);
        g_autofree char *findings = scene_fixture_findings(text, -1, NULL);
        g_assert_cmpstr(findings, ==, rows[i].findings);
    }
}

static void add_tests(void)
{
    g_test_add_func("/bad-input/warnings", test_warnings);
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *path = g_strdup_printf("/scene/bad/%s", bad[i].name);
        g_test_add_data_func(path, &bad[i], test_bad);
    }
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
