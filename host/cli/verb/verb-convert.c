/* tinker convert: reads a scene and writes it back in its normal form. */
#include "cli/verb/verbs.h"

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "common/program/exit-status.h"

static const TinkerVerbHelp help = {
    .verb = "convert",
    .operands = "SCENE",
    .summary =
        "Writes a scene back in its normal form: given properties in the order of their declaration, plain numbers\n"
        "in SI; with --units English as numbers with units, where they read back to the same bits. --units also\n"
        "sets the units that the scene displays.",
    .examples = "  tinker convert bridge.tinker.json -o tidy.tinker.json\n"
                "  tinker convert bridge.tinker.json --units English -o -",
    .least_operands = 1,
    .most_operands = 1,
};

/* The scene itself may be the output: it has been read, and is replaced as a whole. */
static gboolean add_output(const TinkerOpenScene *open, const char *output, GError **error)
{
    const TinkerAskedOutput outputs[] = {{"--output", output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_file_set_new();
    tinker_file_set_add_sources(files, open->scene, open->path);
    return tinker_outputs_add(files, outputs, error);
}

static gboolean convert(const TinkerOpenScene *open, const char *output, const char *units, GError **error)
{
    static const char *const systems[] = {"SI", "English", NULL};
    int system = 0;
    if (!add_output(open, output, error)) return FALSE;
    if (units != NULL) {
        if (!tinker_option_choice("units", units, systems, &system, error)) return FALSE;
        tinker_scene_head(open->scene)->units = system == 1 ? TINKER_UNIT_SYSTEM_ENGLISH : TINKER_UNIT_SYSTEM_SI;
    }
    return tinker_scene_write_file(open->scene, output, system == 1 ? TINKER_WRITE_ENGLISH : TINKER_WRITE_SI, error);
}

int tinker_verb_convert(int argc, char **argv)
{
    g_autofree char *output = NULL, *units = NULL;
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &output, "Write to FILE (standard output)", "FILE"},
        {"units", 0, 0, G_OPTION_ARG_FILENAME, &units, "SI or English", "SYSTEM"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    tinker_open_scene_report_warnings(&open);
    g_autoptr(GError) error = NULL;
    if (!convert(&open, output != NULL ? output : "-", units, &error)) return tinker_report_error(NULL, error);
    return TINKER_EXIT_DONE;
}
