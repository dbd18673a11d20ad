/* tinker check: everything that is wrong with a scene, in the order of the file; then what only compiling it tells. */
#include "cli/verb/verbs.h"

#include <stdio.h>
#include <string.h>

#include "cli/command/block-places.h"
#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "measure/until.h"
#include "physics/compile/compile.h"
#include "physics/model/breaks.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "scene/frame/boxes.h"
#include "scene/frame/overlaps.h"

static const TinkerVerbHelp help = {
    .verb = "check",
    .operands = "SCENE",
    .summary =
        "Lists every mistake in a scene, one a line with file, line and column where they are known, and warnings.\n"
        "Changes nothing.",
    .examples = "  tinker check bridge.tinker.json",
    .least_operands = 1,
    .most_operands = 1,
};

/* What was found. */
typedef struct {
    int errors, warnings;
    int status;
    const char *path, *name; /* of the scene's file: as given, and as messages call it */
    GArray *places;          /* of its blocks, once they are asked for */
} Findings;

/* A scene that is wrong is wrong, whatever else is missing. */
static void add_error(Findings *findings, const char *text, int status)
{
    tinker_print_line(stderr, "tinker: %s", text);
    findings->errors++;
    if (findings->status == TINKER_EXIT_DONE || status == TINKER_EXIT_SCENE) findings->status = status;
}

static void add_warning(Findings *findings, const char *text)
{
    tinker_print_line(stderr, "tinker: %s", text);
    findings->warnings++;
}

/* A scene with a block of a missing type, or with a missing method, can be opened and saved, so to the reader that is a
 * warning; here it is what keeps the scene from running. */
static void add_of_reader(Findings *findings, const GPtrArray *found)
{
    for (guint i = 0; i < found->len; i++) {
        const TinkerFinding *finding = g_ptr_array_index(found, i);
        gboolean runs = finding->code != TINKER_SCENE_ERROR_TYPE && finding->code != TINKER_SCENE_ERROR_METHOD;
        gboolean warning = finding->kind == TINKER_FINDING_WARNING && runs;
        TinkerFinding marked = *finding;
        g_autofree char *message = g_strdup_printf("%s%s", warning ? "warning: " : "", finding->message);
        marked.message = message;
        g_autofree char *text = tinker_finding_text(&marked, findings->name);
        GError error = {.domain = TINKER_SCENE_ERROR, .code = finding->code, .message = text};
        if (warning)
            add_warning(findings, text);
        else
            add_error(findings, text, tinker_exit_status(&error));
    }
}

static gboolean is_told(const GPtrArray *found, const char *text)
{
    for (guint i = 0; i < found->len; i++)
        if (strstr(((const TinkerFinding *)g_ptr_array_index(found, i))->message, text) != NULL) return TRUE;
    return FALSE;
}

/* A missing type may be that of a library which was refused without anybody knowing what is in it. */
static void add_of_catalogue(Findings *findings, TinkerCatalogue *catalogue, const GPtrArray *found)
{
    gboolean missing = FALSE;
    for (guint i = 0; i < found->len; i++)
        if (((const TinkerFinding *)g_ptr_array_index(found, i))->code == TINKER_SCENE_ERROR_TYPE) missing = TRUE;
    g_autoptr(GPtrArray) warnings = tinker_catalogue_warnings(catalogue);
    for (guint i = 0; missing && i < warnings->len; i++) {
        const char *warning = g_ptr_array_index(warnings, i);
        if (is_told(found, warning)) continue;
        g_autofree char *text = g_strconcat("warning: ", warning, NULL);
        add_warning(findings, text);
    }
}

/* What was found behind the reader: with the place of the block that it is about. */
static void add_refusal(Findings *findings, TinkerScene *scene, const GError *error)
{
    g_autofree char *text =
        tinker_placed_message(scene, findings->path, findings->name, &findings->places, error->message);
    add_error(findings, text, tinker_exit_status(error));
}

/* The first reason for which a model refuses is one; detached ends are listed one and all. */
static void add_detached_ends(Findings *findings, TinkerScene *scene)
{
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (tinker_scene_block_class(scene, block) == NULL) continue;
        const char *name = tinker_scene_block_name(scene, block);
        int32_t count = tinker_scene_end_count(scene, block);
        for (int32_t end = 0; end < count; end++) {
            if (tinker_scene_end(scene, block, end).block != TINKER_NO_BLOCK) continue;
            g_autofree char *message =
                count == 1
                    ? g_strdup_printf("%s: its end is detached (connect it to a block)", name)
                    : g_strdup_printf("%s: end %d of %d is detached (connect it to a block)", name, end + 1, count);
            const GError error = {TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, message};
            add_refusal(findings, scene, &error);
        }
    }
}

static void add_warning_of_scene(Findings *findings, const char *warning)
{
    g_autofree char *text = g_strdup_printf("%s: warning: %s", findings->name, warning);
    add_warning(findings, text);
}

static void add_warnings(Findings *findings, const GPtrArray *warnings)
{
    for (guint i = 0; i < warnings->len; i++)
        add_warning_of_scene(findings, g_ptr_array_index(warnings, i));
}

/* A method, step, tolerance or interval that no run can have, or a condition that cannot end one. */
static void add_of_run(Findings *findings, TinkerScene *scene, TinkerModel *model)
{
    g_autoptr(GError) error = NULL;
    TinkerRunOptions options = tinker_run_options_of(scene);
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    if (simulation == NULL || !tinker_model_check_breaks(model, options.duration, &error))
        add_refusal(findings, scene, error);
    g_autofree char *unmet = tinker_options_unmet(&options, model);
    if (unmet != NULL) add_warning_of_scene(findings, unmet);
    g_autoptr(GError) mistake = NULL;
    g_autoptr(TinkerUntil) until = tinker_until_new(scene, 0);
    if (tinker_until_add_all(until, tinker_scene_head(scene)->run.until, &mistake)) return;
    g_prefix_error(&mistake, "run: until: ");
    add_refusal(findings, scene, mistake);
}

static void add_of_model(Findings *findings, TinkerScene *scene)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    if (model == NULL) {
        add_refusal(findings, scene, error);
        return;
    }
    g_autoptr(GPtrArray) overlaps = g_ptr_array_new_with_free_func(g_free);
    tinker_overlaps_tell(scene, overlaps);
    g_autoptr(GPtrArray) of_model = tinker_warnings_texts(tinker_model_warnings(model));
    add_warnings(findings, of_model);
    tinker_boxes_tell(scene, tinker_scene_head(scene)->run.duration, overlaps);
    add_warnings(findings, overlaps);
    add_of_run(findings, scene, model);
}

static int conclude(const Findings *findings)
{
    g_autofree char *warnings = findings->warnings == 0 ? g_strdup("")
                                                        : g_strdup_printf(" (%d warning%s)", findings->warnings,
                                                                          findings->warnings == 1 ? "" : "s");
    if (findings->errors == 0) tinker_print_line(stdout, "no mistakes found%s", warnings);
    return findings->status;
}

static int check(const char *path, char **plugin_folders)
{
    const char *name = tinker_is_standard_stream(path) ? "standard input" : path;
    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(plugin_folders);
    g_autoptr(GPtrArray) found = tinker_findings_new();
    g_autoptr(GError) error = NULL;
    Findings findings = {.status = TINKER_EXIT_DONE, .path = path, .name = name};
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(catalogue, path, found, &error);
    add_of_reader(&findings, found);
    add_of_catalogue(&findings, catalogue, found);
    if (scene != NULL) add_detached_ends(&findings, scene);
    if (scene != NULL && findings.errors == 0) add_of_model(&findings, scene);
    g_clear_pointer(&findings.places, g_array_unref);
    return conclude(&findings);
}

int tinker_verb_check(int argc, char **argv)
{
    const GOptionEntry entries[] = {G_OPTION_ENTRY_NULL};
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;
    return check(line.operands[0], line.plugin_folders);
}
