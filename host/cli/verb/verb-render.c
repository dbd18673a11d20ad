/* tinker render: the scene as a picture, as placed or after it has run for some time. */
#include "cli/verb/verbs.h"

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "exit-status.h"
#include "force-arrows.h"
#include "scene/frame/tops.h"

static const TinkerVerbHelp help = {
    .verb = "render",
    .operands = "SCENE",
    .summary = "Draws the scene: as it is placed, or at a time of its run. The ending of the output, .png, .svg or\n"
               ".pdf, says what is written.",
    .examples = "  tinker render pendulum.tinker.json -o pendulum.png\n"
                "  tinker render pendulum.tinker.json -o pendulum.svg --time 2.5 --no-grid --theme print",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *output, *time;
    gboolean no_labels, no_grid;
} RenderOptions;

static void render_options_clear(RenderOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->output);
    g_free(options->time);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(RenderOptions, render_options_clear)

static gboolean render(const RenderOptions *options, const TinkerOpenScene *open, GError **error)
{
    static const char *const endings[] = {".png", ".svg", ".pdf", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    int width = 800, height = 600;
    double time = 0;
    TinkerPaintOptions paint = tinker_paint_options_default();
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (tinker_picture_ending(options->output, endings, error) < 0) return FALSE;
    if (!tinker_picture_arguments_read(&options->picture, &width, &height, &paint.theme, error)) return FALSE;
    if (options->time != NULL && !tinker_option_value("time", options->time, seconds, 0, FALSE, &time, error))
        return FALSE;

    g_autoptr(TinkerFrame) frame = tinker_frame_new(open->scene, error);
    if (frame == NULL) return FALSE;
    tinker_tops_turn_bodies(frame);
    g_autoptr(GError) failure = NULL;
    g_autoptr(GArray) acting = options->picture.forces ? tinker_acting_forces_array() : NULL;
    gboolean reached = tinker_picture_run_to(frame, open, &options->run, time, acting, &failure) ||
                       g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY);
    gboolean drawn = FALSE;
    paint.show_labels = !options->no_labels;
    paint.show_grid = !options->no_grid;
    paint.show_time = time > 0;
    g_autoptr(GHashTable) faults = tinker_picture_faults_new();
    paint.faults = faults;
    g_autoptr(GArray) at_start = tinker_acting_forces_array();
    TinkerForceArrows forces = {.scene = open->scene, .acting = acting, .at_start = at_start, .lit = TINKER_NO_BLOCK};
    if (reached && acting != NULL) {
        if (!tinker_acting_forces_at_start(open->scene, at_start, error)) return FALSE;
        tinker_force_arrows_keep_moving(open->scene, acting);
        paint.over = tinker_force_arrows_over;
        paint.over_data = &forces;
    }
    if (reached) drawn = tinker_paint_to_file(frame, NULL, width, height, &paint, options->output, error);
    tinker_picture_report_faults(faults);
    if (failure == NULL || (reached && !drawn)) return drawn;
    g_propagate_error(error, g_steal_pointer(&failure));
    return FALSE;
}

int tinker_verb_render(int argc, char **argv)
{
    g_auto(RenderOptions) options = {0};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Draw to FILE (.png, .svg or .pdf)", "FILE"},
        {"time", 0, 0, G_OPTION_ARG_FILENAME, &options.time, "Run the scene up to this time first (0)", "S"},
        TINKER_PICTURE_ENTRIES(options.picture, "800x600"),
        {"no-labels", 0, 0, G_OPTION_ARG_NONE, &options.no_labels, "Leave out the names", NULL},
        {"no-grid", 0, 0, G_OPTION_ARG_NONE, &options.no_grid, "Leave out the grid", NULL},
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    return render(&options, &open, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
