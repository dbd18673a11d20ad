/* Opening a scene with one line for everything that is wrong. */
#include "cli/command/open-scene.h"

#include <string.h>

#include "cli/command/block-places.h"
#include "cli/command/output.h"
#include "common/program/exit-status.h"
#include "common/program/installation.h"
#include "common/program/plugin-folders.h"
#include "physics/model/model.h"
#include "scene/frame/overlaps.h"

TinkerCatalogue *tinker_open_catalogue(char **plugin_folders)
{
    g_auto(GStrv) folders = tinker_plugin_folders(plugin_folders);
    return tinker_installation_catalogue((const char *const *)folders);
}

char *tinker_finding_text(const TinkerFinding *finding, const char *name)
{
    if (finding->line <= 0) return g_strdup_printf("%s: %s", name, finding->message);
    return g_strdup_printf("%s:%d:%d: %s", name, finding->line, finding->column, finding->message);
}

static void collect_warnings(TinkerOpenScene *open, const GPtrArray *findings)
{
    open->finding_count = findings->len;
    g_autoptr(GPtrArray) search = tinker_catalogue_warnings(open->catalogue);
    for (guint i = 0; i < search->len; i++)
        g_ptr_array_add(open->warnings, g_strdup(g_ptr_array_index(search, i)));
    for (guint i = 0; i < findings->len; i++) {
        const TinkerFinding *finding = g_ptr_array_index(findings, i);
        if (finding->kind != TINKER_FINDING_WARNING) continue;
        g_ptr_array_add(open->warnings, tinker_finding_text(finding, open->name));
        if (finding->code == TINKER_SCENE_ERROR_TYPE) open->missing_types++;
    }
}

static void tell_of_check(const TinkerOpenScene *open, guint count)
{
    tinker_report_note("%s: \"tinker check %s\" lists all %u findings", open->name, open->path, count);
}

static guint count_detached_ends(const TinkerScene *scene)
{
    guint count = 0;
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (tinker_scene_block_class(scene, block) == NULL) continue;
        for (int32_t end = 0; end < tinker_scene_end_count(scene, block); end++)
            if (tinker_scene_end(scene, block, end).block == TINKER_NO_BLOCK) count++;
    }
    return count;
}

int tinker_open_scene(TinkerOpenScene *open, char **plugin_folders, const char *path)
{
    *open = (TinkerOpenScene){
        .catalogue = tinker_open_catalogue(plugin_folders),
        .path = g_strdup(path),
        .name = g_strdup(tinker_is_standard_stream(path) ? "standard input" : path),
        .warnings = g_ptr_array_new_with_free_func(g_free),
    };
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    open->scene = tinker_scene_read_file(open->catalogue, path, findings, &error);
    if (open->scene == NULL) {
        int status = tinker_report_error(NULL, error);
        if (findings->len > 1) tell_of_check(open, findings->len);
        return status;
    }
    collect_warnings(open, findings);
    tinker_overlaps_tell(open->scene, open->warnings);
    return TINKER_EXIT_DONE;
}

gboolean tinker_open_scene_of_line(TinkerOpenScene *open, TinkerCommandLine *line, const TinkerVerbHelp *help,
                                   const GOptionEntry *entries, int argc, char **argv, int *status)
{
    if (!tinker_command_line_read(line, help, entries, argc, argv, status)) return FALSE;
    *status = tinker_open_scene(open, line->plugin_folders, line->operands[0]);
    return *status == TINKER_EXIT_DONE;
}

void tinker_open_scene_report_warnings(const TinkerOpenScene *open)
{
    for (guint i = 0; i < open->warnings->len; i++)
        tinker_report_warning("%s", (const char *)g_ptr_array_index(open->warnings, i));
}

/* Whether a text is the scene's name, a place, and this message, perhaps with more behind it. */
static gboolean is_placed(const char *text, const char *name, const char *message)
{
    const char *found = g_str_has_prefix(text, name) ? strstr(text + strlen(name), message) : NULL;
    return found != NULL && found >= text + strlen(name) + 2 && g_str_has_prefix(found - 2, ": ");
}

/* Reports the error; with line and column where the reader has found the same, or where it is about a block. */
static int report_with_place(const TinkerOpenScene *open, const GError *error)
{
    for (guint i = 0; i < open->warnings->len; i++) {
        char *warning = g_ptr_array_index(open->warnings, i);
        if (!is_placed(warning, open->name, error->message)) continue;
        const GError placed = {.domain = error->domain, .code = error->code, .message = warning};
        return tinker_report_error(open->name, &placed);
    }
    if (error->domain != TINKER_MODEL_ERROR) return tinker_report_error(open->name, error);
    g_autoptr(GArray) places = NULL;
    g_autofree char *text = tinker_placed_message(open->scene, open->path, open->name, &places, error->message);
    const GError placed = {.domain = error->domain, .code = error->code, .message = text};
    return tinker_report_error(open->name, &placed);
}

/* Whether the error says as much as a warning; both may begin with what they are about. */
static gboolean is_told(const char *warning, const GError *error)
{
    const char *colon = strstr(error->message, ": "), *reason = colon != NULL ? colon + 2 : error->message;
    return strstr(warning, reason) != NULL || strstr(error->message, warning) != NULL;
}

int tinker_open_scene_report_error(const TinkerOpenScene *open, const GError *error)
{
    int status = report_with_place(open, error);
    gboolean refused =
        error->domain != TINKER_CLI_ERROR && (status == TINKER_EXIT_SCENE || status == TINKER_EXIT_PLUGIN);
    if (!refused) return status;
    for (guint i = 0; i < open->warnings->len; i++) {
        const char *warning = g_ptr_array_index(open->warnings, i);
        if (!is_told(warning, error)) tinker_report_warning("%s", warning);
    }
    guint detached = count_detached_ends(open->scene);
    gboolean all_told = open->missing_types > 0 ? detached == 0 : detached <= 1;
    if (!all_told) tell_of_check(open, open->finding_count + detached);
    return status;
}

TinkerFileSet *tinker_open_scene_files(const TinkerOpenScene *open)
{
    TinkerFileSet *files = tinker_file_set_new();
    tinker_file_set_add_scene(files, open->path);
    tinker_file_set_add_sources(files, open->scene, open->path);
    return files;
}

void tinker_open_scene_clear(TinkerOpenScene *open)
{
    g_clear_pointer(&open->scene, tinker_scene_free);
    g_clear_pointer(&open->catalogue, tinker_catalogue_free);
    g_clear_pointer(&open->path, g_free);
    g_clear_pointer(&open->name, g_free);
    g_clear_pointer(&open->warnings, g_ptr_array_unref);
}
