/* tinker animate: the motion as a film. */
#include "cli/verb/verbs.h"

#include <math.h>
#include <string.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "common/film/film-pictures.h"
#include "common/film/film.h"
#include "common/film/motion-film.h"
#include "common/program/exit-status.h"

static const TinkerVerbHelp help = {
    .verb = "animate",
    .operands = "SCENE",
    .summary = "Draws the motion as a film, .gif, .webm or .mp4, by the ffmpeg program (apt-get install ffmpeg). With\n"
               "--frames, or where the output ends in .png, the pictures are written one by one instead:\n"
               "FILE-0001.png and so on.",
    .examples = "  tinker animate pendulum.tinker.json -o pendulum.gif\n"
                "  tinker animate pendulum.tinker.json -o pendulum.mp4 --fps 60 --size 1280x720 --speed 0.5\n"
                "  tinker animate pendulum.tinker.json -o pendulum.png --frames",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    TinkerOverlayArguments over;
    char *output, *fps, *speed;
    gboolean frames, graphs, no_labels, no_grid;
} AnimateOptions;

static void animate_options_clear(AnimateOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    tinker_overlay_arguments_clear(&options->over);
    g_free(options->output);
    g_free(options->fps);
    g_free(options->speed);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(AnimateOptions, animate_options_clear)

static void tell_numbered_pictures(const char *output, gsize count)
{
    g_autofree char *first = tinker_film_pictures_name(output, 1);
    g_autofree char *last = tinker_film_pictures_name(output, (int)count);
    if (count > 1)
        tinker_report_note("wrote %" G_GSIZE_FORMAT " pictures, %s to %s", count, first, last);
    else
        tinker_report_note("wrote one picture, %s", first);
}

/* Of numbered pictures the output is called as if it were one. (transfer full) */
static char *film_path(const AnimateOptions *options)
{
    const char *dot = strrchr(options->output, '.'); /* it has one of the endings */
    return options->frames ? g_strdup_printf("%.*s.png", (int)(dot - options->output), options->output)
                           : g_strdup(options->output);
}

/* Before anything is run. */
static gboolean can_be_written(const char *path, GError **error)
{
    if (!tinker_film_is_joined(path) || tinker_film_can_join()) return TRUE;
    g_set_error(
        error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE,
        "%s: cannot be written: the program ffmpeg, which joins films, is not installed (apt-get install ffmpeg; "
        "--frames writes numbered pictures instead)",
        path);
    return FALSE;
}

static gboolean read_rate(const AnimateOptions *options, double *fps, double *speed, GError **error)
{
    static const TinkerDimension none = TINKER_DIMENSION_NONE;
    return (options->fps == NULL || tinker_option_value("fps", options->fps, none, 0, TRUE, fps, error)) &&
           (options->speed == NULL || tinker_option_value("speed", options->speed, none, 0, TRUE, speed, error));
}

static gboolean is_film_too_long(double duration, double spacing, GError **error)
{
    if (duration / spacing <= TINKER_MOTION_FILM_MOST_PICTURES) return FALSE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "the film would have %.0f pictures; choose a lower --fps, a higher --speed or a shorter --duration",
                duration / spacing);
    return TRUE;
}

static gboolean add_outputs(const char *path, const TinkerOpenScene *open, double pictures, GError **error)
{
    const TinkerAskedOutput none[] = {{NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    return tinker_outputs_add(files, none, error) && tinker_film_add_outputs(files, "--output", path, pictures, error);
}

/* What a failed run is to be believed in becomes a film, too. (transfer full) */
static TinkerMotionFilm *run_motion(const AnimateOptions *options, const TinkerOpenScene *open, const char *path,
                                    double spacing, GError **failure, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return NULL;
    g_autoptr(TinkerMotionFilm) motion = tinker_motion_film_new(open->scene, error);
    if (motion == NULL) return NULL;
    TinkerFilmOverlay over = {.forces = options->picture.forces, .vectors = options->over.vectors};
    if (!tinker_overlay_arguments_marks(&options->over, run_options.duration, &over.marks, error)) return NULL;
    run_options.interval = tinker_motion_film_show(motion, &over, spacing);
    if (!tinker_scene_run_until(&run, open->scene, &options->run, NULL, &run_options, error)) return NULL;
    const double duration = tinker_options_duration(&run_options);
    if (is_film_too_long(duration, spacing, error)) return NULL;
    if (!add_outputs(path, open, ceil(duration / spacing) + 1, error)) return NULL;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return NULL;
    tinker_motion_film_begin(motion, run.model, duration);
    if (options->graphs) tinker_motion_film_show_graphs(motion, NULL);
    const TinkerSampleTaker taker = {
        .sample = tinker_motion_film_sample, .begin_again = tinker_motion_film_begin_again, .data = motion};
    (void)tinker_scene_run_go(&run, tinker_motion_film_columns(motion), &taker, failure);
    tinker_scene_run_report_warnings(&run, open, &options->run);
    if (*failure == NULL) tinker_scene_run_report_end(&run, open->name);
    (void)tinker_motion_film_cut(motion, tinker_simulation_summary(run.simulation)->valid_until);
    return g_steal_pointer(&motion);
}

static gboolean animate(const AnimateOptions *options, const TinkerOpenScene *open, GError **failure, GError **error)
{
    static const char *const endings[] = {".gif", ".webm", ".mp4", ".png", NULL};
    if (tinker_picture_ending(options->output, endings, error) < 0) return FALSE;
    g_autofree char *path = film_path(options);
    if (!can_be_written(path, error)) return FALSE;
    TinkerProgress progress;
    TinkerFilmDrawing drawing = {
        .path = path,
        .width = 640,
        .height = 480,
        .frames_per_second = 25,
        .paint = tinker_paint_options_default(),
        .enough = tinker_progress_interrupted,
        .progress = tinker_progress_of_run,
        .data = &progress,
    };
    double speed = 1;
    drawing.paint.show_labels = !options->no_labels;
    drawing.paint.show_grid = !options->no_grid;
    drawing.paint.show_time = TRUE;
    if (!tinker_picture_arguments_read(&options->picture, &drawing.width, &drawing.height, &drawing.paint.theme, error))
        return FALSE;
    if (!read_rate(options, &drawing.frames_per_second, &speed, error)) return FALSE;

    g_autoptr(TinkerMotionFilm) motion =
        run_motion(options, open, path, speed / drawing.frames_per_second, failure, error);
    if (motion == NULL) return FALSE;
    gsize drawn = 0;
    g_autoptr(GHashTable) faults = tinker_picture_faults_new();
    drawing.paint.faults = faults;
    progress = tinker_progress_start("drawing");
    tinker_progress_catch_interrupt(); // one that stopped the run does not stop the drawing of it
    gboolean fine = tinker_motion_film_write(motion, &drawing, &drawn, error);
    tinker_progress_end(&progress);
    tinker_picture_report_faults(faults);
    if (fine && !tinker_film_is_joined(path)) tell_numbered_pictures(path, drawn);
    return fine;
}

int tinker_verb_animate(int argc, char **argv)
{
    g_auto(AnimateOptions) options = {0};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Write to FILE (.gif, .webm, .mp4 or .png)", "FILE"},
        {"fps", 0, 0, G_OPTION_ARG_FILENAME, &options.fps, "Pictures a second (25)", "N"},
        {"frames", 0, 0, G_OPTION_ARG_NONE, &options.frames, "Write numbered pictures, FILE-0001.png and so on", NULL},
        {"speed", 0, 0, G_OPTION_ARG_FILENAME, &options.speed, "Times real time: 0.5 is slow motion (1)", "X"},
        TINKER_PICTURE_ENTRIES(options.picture, "640x480"),
        TINKER_OVERLAY_ENTRIES(options.over),
        {"graphs", 0, 0, G_OPTION_ARG_NONE, &options.graphs, "Show the scene's graphs over time below the motion",
         NULL},
        {"no-labels", 0, 0, G_OPTION_ARG_NONE, &options.no_labels, "Leave out the names", NULL},
        {"no-grid", 0, 0, G_OPTION_ARG_NONE, &options.no_grid, "Leave out the grid", NULL},
        {"duration", 0, 0, G_OPTION_ARG_FILENAME, &options.run.duration, "How long to run", "S"},
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL, failure = NULL;
    if (!animate(&options, &open, &failure, &error)) return tinker_open_scene_report_error(&open, error);
    return failure != NULL ? tinker_report_error(open.name, failure) : TINKER_EXIT_DONE;
}
