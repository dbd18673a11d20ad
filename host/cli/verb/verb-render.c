/* tinker render: the scene as a picture, as placed or after it has run for some time. */
#include "cli/verb/verbs.h"

#include <math.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "common/overlay/force-arrows.h"
#include "common/program/exit-status.h"
#include "render/draw/text.h"
#include "scene/frame/tops.h"

static const TinkerVerbHelp help = {
    .verb = "render",
    .operands = "SCENE",
    .summary = "Draws the scene: as it is placed, or at a time of its run. The ending of the output, .png, .svg or\n"
               ".pdf, says what is written. With --trail also where the bodies have been, as by a stroboscope.",
    .examples = "  tinker render pendulum.tinker.json -o pendulum.png\n"
                "  tinker render pendulum.tinker.json -o pendulum.svg --time 2.5 --no-grid --theme print\n"
                "  tinker render pendulum.tinker.json -o swing.png --time 1 --trail --velocity --acceleration",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    TinkerOverlayArguments over;
    char *output, *time;
    gboolean no_labels, no_grid;
} RenderOptions;

static void render_options_clear(RenderOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->output);
    g_free(options->time);
    tinker_overlay_arguments_clear(&options->over);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(RenderOptions, render_options_clear)

/* What is drawn over the scene. */
typedef struct {
    TinkerForceArrows arrows;
    TinkerPictureCourse course;
    TinkerFrame *ghosts; /* NULL: there is no trail */
} Overlay;

static void overlay_clear(Overlay *overlay)
{
    g_clear_pointer(&overlay->course.forces, g_array_unref);
    g_clear_pointer(&overlay->course.vectors, g_array_unref);
    g_clear_pointer(&overlay->course.trail, tinker_motion_trail_free);
    g_clear_pointer(&overlay->ghosts, tinker_frame_free);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Overlay, overlay_clear)

static void draw_under(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data)
{
    const Overlay *overlay = data;
    if (overlay->course.trail != NULL)
        tinker_motion_trail_draw_ghosts(overlay->course.trail, cairo, view, theme, overlay->ghosts);
}

static void draw_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data)
{
    Overlay *overlay = data;
    if (overlay->course.trail != NULL)
        tinker_motion_trail_draw(overlay->course.trail, cairo, view, theme, INFINITY, NULL, NULL);
    tinker_force_arrows_over(cairo, view, theme, &overlay->arrows);
}

/* When the run ends: where the scene says, or after its duration. */
static gboolean find_end(const RenderOptions *options, TinkerScene *scene, double *time, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    if (!tinker_run_arguments_apply(&options->run, scene, &run_options, error) ||
        !tinker_scene_run_until(&run, scene, &options->run, NULL, &run_options, error))
        return FALSE;
    *time = tinker_options_duration(&run_options);
    return TRUE;
}

/* The picture's time; with a trail and none given, the end of the run. */
static gboolean read_times(const RenderOptions *options, TinkerScene *scene, double *time, double *every,
                           GError **error)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    *time = 0;
    if (options->over.trail && options->time == NULL && !find_end(options, scene, time, error)) return FALSE;
    if (options->time != NULL && !tinker_option_value("time", options->time, seconds, 0, FALSE, time, error))
        return FALSE;
    return tinker_overlay_arguments_marks(&options->over, *time, every, error);
}

/* Makes what the course of the run is to fill. */
static gboolean overlay_prepare(Overlay *overlay, const RenderOptions *options, TinkerScene *scene, double every,
                                GError **error)
{
    overlay->arrows = (TinkerForceArrows){.scene = scene};
    overlay->course.choice = options->over.vectors;
    overlay->course.forces = tinker_acting_forces_array();
    if (tinker_vector_choice_any(&options->over.vectors)) overlay->course.vectors = tinker_motion_vectors_array();
    if (!options->over.trail) return TRUE;
    overlay->course.trail = tinker_motion_trail_new(scene, every);
    overlay->ghosts = tinker_frame_new(scene, error);
    return overlay->ghosts != NULL;
}

/* Once the run has filled the course. */
static void overlay_finish(Overlay *overlay, gboolean forces, const GArray *at_start, const GPtrArray *texts,
                           const char *every)
{
    TinkerForceArrows *arrows = &overlay->arrows;
    if (!forces) g_array_set_size(overlay->course.forces, 0);
    tinker_force_arrows_keep_moving(arrows->scene, overlay->course.forces);
    arrows->acting = overlay->course.forces;
    arrows->at_start = at_start;
    arrows->vectors = overlay->course.vectors;
    arrows->greatest = overlay->course.greatest;
    arrows->texts = texts;
    arrows->marks = overlay->course.trail != NULL ? every : NULL;
}

static gboolean render(const RenderOptions *options, const TinkerOpenScene *open, GError **error)
{
    static const char *const endings[] = {".png", ".svg", ".pdf", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    int width = 800, height = 600;
    double time, every, box[4];
    TinkerPaintOptions paint = tinker_paint_options_default();
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (tinker_picture_ending(options->output, endings, error) < 0) return FALSE;
    if (!tinker_picture_arguments_read(&options->picture, &width, &height, &paint.theme, error)) return FALSE;
    if (!read_times(options, open->scene, &time, &every, error)) return FALSE;

    g_auto(Overlay) overlay = {0};
    g_autoptr(TinkerFrame) frame = tinker_frame_new(open->scene, error);
    if (frame == NULL || !overlay_prepare(&overlay, options, open->scene, every, error)) return FALSE;
    tinker_tops_turn_bodies(frame);
    const gboolean arrows = options->picture.forces || tinker_vector_choice_any(&options->over.vectors);
    g_autoptr(GError) failure = NULL;
    if (!arrows) g_clear_pointer(&overlay.course.forces, g_array_unref);
    gboolean reached = tinker_picture_run_to(frame, open, &options->run, time, &overlay.course, &failure) ||
                       g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY);
    gboolean drawn = FALSE;
    paint.show_labels = !options->no_labels;
    paint.show_grid = !options->no_grid;
    paint.show_time = time > 0;
    g_autoptr(GHashTable) faults = tinker_picture_faults_new();
    paint.faults = faults;
    g_autoptr(GArray) at_start = tinker_acting_forces_array();
    g_autoptr(GPtrArray) texts = tinker_written_texts_new();
    g_autofree char *every_text = tinker_quantity_brief(every, seconds, tinker_scene_head(open->scene)->units);
    if (reached && arrows && !tinker_acting_forces_at_start(open->scene, at_start, error)) return FALSE;
    if (reached && (arrows || options->over.trail)) {
        if (overlay.course.forces == NULL) overlay.course.forces = tinker_acting_forces_array();
        overlay_finish(&overlay, options->picture.forces, at_start, texts, every_text);
        paint.over = draw_over;
        paint.under = draw_under;
        paint.over_data = &overlay;
        paint.texts = texts;
    }
    overlay.arrows.frame = frame;
    tinker_painter_bounds(frame, box);
    if (options->over.trail) tinker_motion_trail_widen(overlay.course.trail, overlay.ghosts, box);
    if (reached) drawn = tinker_paint_to_file(frame, box, width, height, &paint, options->output, error);
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
        TINKER_OVERLAY_ENTRIES(options.over),
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
