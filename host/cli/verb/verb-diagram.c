/* tinker diagram: the free-body diagram of a body, and its kinetic diagram. */
#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/command/run-arguments.h"
#include "cli/command/state-at.h"
#include "cli/report/diagram-report.h"
#include "cli/verb/verbs.h"
#include "common/diagram/diagram-picture.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "render/draw/surface.h"

static const TinkerVerbHelp help = {
    .verb = "diagram",
    .operands = "SCENE",
    .summary =
        "Lists every force on a body at a time, each with the block that it comes from and the block on which its\n"
        "opposite acts (the free-body diagram), and mass times acceleration, which they add up to (the kinetic one).\n"
        "Of several bodies together only forces from outside are listed; of a support what acts on it.\n"
        "With -o FILE.svg, .png or .pdf it draws them.",
    .examples = "  tinker diagram pendulum.tinker.json --block \"Mass 0\"\n"
                "  tinker diagram pendulum.tinker.json --block \"Mass 0\" --time 1.5 --as json\n"
                "  tinker diagram pendulum.tinker.json --block \"Mass 0\" -o pendulum.svg --theme print\n"
                "  tinker diagram double-pendulum.tinker.json --block \"Mass 0\" --block \"Mass 1\"",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *time, *as, *kind, *output;
    char **blocks;
} DiagramOptions;

static void diagram_options_clear(DiagramOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->time);
    g_free(options->as);
    g_free(options->kind);
    g_free(options->output);
    g_strfreev(options->blocks);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(DiagramOptions, diagram_options_clear)

/* What is asked for, read. */
typedef struct {
    int as, kind; /* kind: TinkerDiagramKind */
    double time;
    gboolean is_picture;
    int width, height;
    const TinkerTheme *theme;
} Wish;

static gboolean read_wish(const DiagramOptions *options, Wish *wish, GError **error)
{
    static const char *const formats[] = {"text", "json", NULL};
    static const char *const kinds[] = {"both", "free-body", "kinetic", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    *wish = (Wish){.width = 900, .height = 620};
    if (options->blocks == NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "a body is needed (as in --block \"Mass 0\"; given several times, of these together)");
        return FALSE;
    }
    if (options->as != NULL && !tinker_option_choice("as", options->as, formats, &wish->as, error)) return FALSE;
    if (options->kind != NULL && !tinker_option_choice("kind", options->kind, kinds, &wish->kind, error)) return FALSE;
    if (options->time != NULL && !tinker_option_value("time", options->time, seconds, 0, FALSE, &wish->time, error))
        return FALSE;
    if (!tinker_picture_or_text(&options->picture, options->output, options->as, &wish->is_picture, error))
        return FALSE;
    if (options->kind != NULL && !wish->is_picture) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--kind belongs to a picture; text and json hold both diagrams (add -o FILE.svg, .png or .pdf)");
        return FALSE;
    }
    return tinker_picture_arguments_read(&options->picture, &wish->width, &wish->height, &wish->theme, error);
}

static gboolean draw_diagram(const DiagramOptions *options, const Wish *wish, const TinkerOpenScene *open,
                             const TinkerModelState *state, const TinkerDiagram *diagram, const TinkerBlockId *blocks,
                             GError **error)
{
    if (wish->kind == TINKER_DIAGRAM_KINETIC && !diagram->moves) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--kind kinetic: \"%s\" cannot move, and has no kinetic diagram (free-body has what acts on it)",
                    tinker_scene_block_name(open->scene, blocks[0]));
        return FALSE;
    }
    g_autoptr(TinkerFrame) frame = tinker_diagram_frame(open->scene, state, error);
    if (frame == NULL) return FALSE;
    TinkerDiagramPicture picture = {.frame = frame,
                                    .diagram = diagram,
                                    .blocks = blocks,
                                    .kind = (TinkerDiagramKind)wish->kind,
                                    .theme = wish->theme};
    return tinker_surface_to_file(tinker_diagram_draw, &picture, wish->width, wish->height, options->output, error);
}

static gboolean write_text(const DiagramOptions *options, const Wish *wish, const TinkerOpenScene *open,
                           const TinkerDiagram *diagram, const TinkerBlockId *blocks, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, options->output != NULL ? options->output : "-", error)) return FALSE;
    if (wish->as == 0) {
        tinker_diagram_write_text(diagram, open->scene, blocks, output.file);
    } else {
        g_autofree char *text = tinker_diagram_json(diagram, open->scene, blocks);
        tinker_print_text(output.file, text);
    }
    return tinker_output_close(&output, error);
}

/* Forces add up to m a of what moves alone: what holds a support is no force of the scene's. */
static gboolean check_together(TinkerScene *scene, const TinkerBlockId *blocks, GError **error)
{
    for (const TinkerBlockId *each = blocks; blocks[1] >= 0 && *each >= 0; each++) {
        if (tinker_block_class_moves(tinker_scene_block_class(scene, *each))) continue;
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--block \"%s\": it cannot move, and has a diagram of its own alone (leave out the others, or it)",
                    tinker_scene_block_name(scene, *each));
        return FALSE;
    }
    return TRUE;
}

static gboolean write_diagram(const DiagramOptions *options, const TinkerOpenScene *open, GError **error)
{
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    Wish wish;
    if (!read_wish(options, &wish, error) || !tinker_outputs_add(files, outputs, error)) return FALSE;
    g_autofree TinkerBlockId *blocks = tinker_blocks_named(open->scene, options->blocks, error);
    if (blocks == NULL || !check_together(open->scene, blocks, error)) return FALSE;
    g_autoptr(TinkerModelState) state = tinker_state_at(open, &options->run, "time", wish.time, error);
    if (state == NULL) return FALSE;
    g_autoptr(TinkerDiagram) diagram = tinker_diagram_new(open->scene, state, blocks, error);
    if (diagram == NULL) return FALSE;
    return wish.is_picture ? draw_diagram(options, &wish, open, state, diagram, blocks, error)
                           : write_text(options, &wish, open, diagram, blocks, error);
}

int tinker_verb_diagram(int argc, char **argv)
{
    g_auto(DiagramOptions) options = {0};
    const GOptionEntry entries[] = {
        {"block", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options.blocks,
         "Of this body; given several times, of these together", "NAME"},
        {"time", 0, 0, G_OPTION_ARG_FILENAME, &options.time, "Run the scene up to this time first (0)", "S"},
        {"as", 0, 0, G_OPTION_ARG_FILENAME, &options.as, "text or json (text)", "FORMAT"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
         "Write to FILE (standard output); .png, .svg or .pdf: draw", "FILE"},
        {"kind", 0, 0, G_OPTION_ARG_FILENAME, &options.kind, "Draw free-body, kinetic or both (both)", "KIND"},
        TINKER_PICTURE_LOOK_ENTRIES(options.picture, "900x620"),
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    return write_diagram(&options, &open, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
