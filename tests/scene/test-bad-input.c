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

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *path = g_strdup_printf("/scene/bad/%s", bad[i].name);
        g_test_add_data_func(path, &bad[i], test_bad);
    }
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
