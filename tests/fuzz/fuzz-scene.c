/* Scenes: read, written, read again, compiled. What is written of a scene, in either system of units, must read back as
 * the same scene. The blocks are the real ones. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz-target.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "scene/history/difference.h"
#include "scene/read/scene-json.h"

static TinkerCatalogue *catalogue;
static char *scene_path; /* of a scene that does not exist; beside it lie the tables that scenes may name */

/* As `PROGRAM plugins describe --output - FILE`: the program is its own probe. */
static void describe(const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = tinker_plugin_describe(path, &error);
    if (text == NULL) fprintf(stderr, "%s\n", error->message);
    if (text != NULL) fputs(text, stdout);
    fflush(stdout);
    _Exit(text == NULL ? 1 : 0);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    if (*argc > 2 && g_str_equal((*argv)[1], "plugins")) describe((*argv)[*argc - 1]);
    const char *plugins = g_getenv("TINKER_TEST_PLUGINS");
    if (plugins == NULL) g_error("TINKER_TEST_PLUGINS must name the folder of the plugins");
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    const char *folders[] = {plugins, NULL};
    const TinkerCatalogueOptions options = {.folders = folders, .probe_program = program, .probe_seconds = 60};
    catalogue = tinker_catalogue_new(&options);
    if (tinker_catalogue_type(catalogue, "mass", NULL) == NULL) g_error("there are no blocks in %s", plugins);
    scene_path = g_build_filename(FUZZ_FOLDER, "tables", "scene.tinker.json", NULL);
    return 0;
}

static TinkerScene *read_again(const char *text)
{
    g_autoptr(GError) error = NULL;
    TinkerScene *scene = tinker_scene_read_text(catalogue, text, strlen(text), scene_path, NULL, &error);
    if (scene == NULL) g_error("what was written does not read back: %s\n%s", error->message, text);
    return scene;
}

static void check_written(TinkerScene *scene)
{
    g_autofree char *normal = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_autofree char *english = tinker_scene_to_text(scene, TINKER_WRITE_ENGLISH);
    const char *written[] = {normal, english};
    for (gsize i = 0; i < G_N_ELEMENTS(written); i++) {
        g_autoptr(TinkerScene) again = read_again(written[i]);
        g_autofree char *text = tinker_scene_to_text(again, TINKER_WRITE_SI);
        if (!g_str_equal(text, normal)) g_error("it was\n%s\nand is read back as\n%s", normal, text);
    }
}

static void check_copy(TinkerScene *scene)
{
    g_autoptr(TinkerScene) copy = tinker_scene_copy(scene);
    if (tinker_scene_difference(scene, copy) != TINKER_DIFFERENCE_DRAWING) g_error("a copy is another scene");
}

static void check_compiled(TinkerScene *scene)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    if ((model == NULL) != (error != NULL)) g_error("a model without an error, or the other way round");
}

static void check_findings(const GPtrArray *findings, const TinkerScene *scene, const GError *error)
{
    gboolean errors = FALSE;
    for (guint i = 0; i < findings->len; i++) {
        const TinkerFinding *finding = g_ptr_array_index(findings, i);
        errors = errors || finding->kind == TINKER_FINDING_ERROR;
        if (!g_utf8_validate(finding->message, -1, NULL)) g_error("a message is not UTF-8");
    }
    if (errors == (scene != NULL) || errors != (error != NULL)) g_error("findings and result do not agree");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene =
        tinker_scene_read_text(catalogue, (const char *)data, size, scene_path, findings, &error);
    check_findings(findings, scene, error);
    if (scene == NULL) return 0;
    check_written(scene);
    check_copy(scene);
    check_compiled(scene);
    return 0;
}
