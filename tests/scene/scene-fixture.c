#include "scene-fixture.h"

#include <stdio.h>
#include <string.h>

static TinkerCatalogue *catalogue;

const char scene_fixture_example[] =
    "{\n"
    "  \"tinker\": 1,\n"
    "  \"title\": \"Everything \\u00e4\\ud83d\\ude00\",\n"
    "  \"units\": \"English\",\n"
    "  \"canvas\": {\"width\": \"12 ft\", \"snap\": false, \"ruler\": 1},\n"
    "  \"run\": {\"duration\": 2, \"method\": \"rk4\", \"step\": 1e-3, \"seed\": [1, 2]},\n"
    "  \"blocks\": [\n"
    "    {\"type\": \"gravity\", \"name\": \"Gravity\"},\n"
    "    {\"type\": \"support\", \"name\": \"Support 0\", \"position\": [0, 4], \"orientation\": \"180 deg\"},\n"
    "    {\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [{\"block\": \"Support 0\", \"at\": [0.5, \"2 "
    "in\"]}, "
    "\"Mass 0\"], \"stiffness\": 25, \"colour\": \"red\"},\n"
    "    {\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": \"0.5 slug\", \"position\": [0.1, 2]},\n"
    "    {\"type\": \"damper\", \"ends\": [[1, 2], \"Mass 0\"]},\n"
    "    {\"type\": \"pulley\", \"name\": \"Pulley 0\", \"ends\": [\"Mass 0\"], \"ratio\": 2.50},\n"
    "    {\"type\": \"motor\", \"ends\": [\"Mass 0\"], \"waveform\": {\"expression\": \"10*sin(2*t)\"}},\n"
    "    {\"type\": \"every-kind\", \"note\": \"a \\\"b\\\"\\n\", \"count\": 3, \"shade\": \"grey\", \"open\": true}\n"
    "  ],\n"
    "  \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\", \"place\": [1, 1], \"pen\": 3}],\n"
    "  \"other\": {\"x\": [1, 2, {}]}\n"
    "}\n";

/* As `PROGRAM plugins describe --output - FILE`. */
static int describe(const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = tinker_plugin_describe(path, &error);
    if (text == NULL) {
        fprintf(stderr, "%s\n", error->message);
        return 1;
    }
    fputs(text, stdout);
    return 0;
}

int scene_fixture_main_with(int argc, char **argv, const char *plugins, void (*add_tests)(void))
{
    if (argc > 2 && g_str_equal(argv[1], "plugins")) return describe(argv[argc - 1]);
    g_test_init(&argc, &argv, NULL);
    g_autofree char *probe = g_file_read_link("/proc/self/exe", NULL);
    g_autofree char *own = g_build_filename(g_getenv("G_TEST_BUILDDIR"), plugins, NULL);
    const char *folders[] = {g_getenv("TINKER_TEST_PLUGINS"), own, NULL};
    const TinkerCatalogueOptions options = {.folders = folders, .probe_program = probe, .probe_seconds = 60};
    catalogue = tinker_catalogue_new(&options);
    add_tests();
    int status = g_test_run();
    tinker_catalogue_free(catalogue);
    return status;
}

int scene_fixture_main(int argc, char **argv, void (*add_tests)(void))
{
    return scene_fixture_main_with(argc, argv, "scene/plugins", add_tests);
}

TinkerCatalogue *scene_fixture_catalogue(void)
{
    return catalogue;
}

const TinkerBlockClass *scene_fixture_class(const char *type)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
    g_assert_no_error(error);
    return block_class;
}

TinkerScene *scene_fixture_read(const char *text)
{
    g_autoptr(GError) error = NULL;
    TinkerScene *scene = tinker_scene_read_text(catalogue, text, strlen(text), NULL, NULL, &error);
    g_assert_no_error(error);
    g_assert_nonnull(scene);
    return scene;
}

TinkerScene *scene_fixture_read_blocks(const char *blocks)
{
    g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": [\n%s]}", blocks);
    return scene_fixture_read(text);
}

char *scene_fixture_findings(const char *text, gssize length, const char *path)
{
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_autoptr(GError) error = NULL;
    gsize size = length < 0 ? strlen(text) : (gsize)length;
    g_autoptr(TinkerScene) scene = tinker_scene_read_text(catalogue, text, size, path, findings, &error);
    GString *lines = g_string_new(NULL);
    const TinkerFinding *first = NULL;
    for (guint i = 0; i < findings->len; i++) {
        const TinkerFinding *finding = g_ptr_array_index(findings, i);
        gboolean wrong = finding->kind == TINKER_FINDING_ERROR;
        g_string_append_printf(lines, "%d:%d: %s%s\n", finding->line, finding->column,
                               wrong ? "" : "warning: ", finding->message);
        if (wrong && first == NULL) first = finding;
    }
    /* The scene is there exactly if no finding is an error, and the error is the first of them. */
    g_assert_true((scene == NULL) == (first != NULL));
    if (first != NULL) {
        g_autofree char *expected =
            g_strdup_printf("%s:%d:%d: %s", path == NULL ? "scene" : path, first->line, first->column, first->message);
        g_assert_error(error, TINKER_SCENE_ERROR, first->code);
        g_assert_cmpstr(error->message, ==, expected);
    } else {
        g_assert_no_error(error);
    }
    return g_string_free(lines, FALSE);
}
