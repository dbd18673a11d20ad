/* tinker animate: the motion as a film. One run records where the bodies are at every picture's time; then every
 * picture is drawn with one view, that of the box that holds all of them. */
#include "verbs.h"

#include <math.h>

#include "exit-status.h"
#include "film.h"
#include "options.h"
#include "output.h"
#include "physics/record.h"
#include "picture.h"

#define MARGIN 0.08 /* about the motion, of the picture's shorter side: for the names */

/* A film of more pictures, an hour long, is a slip: a speed or rate of the wrong size. */
#define MOST_PICTURES 100000

static const TinkerVerbHelp help = {
    .verb = "animate",
    .operands = "SCENE",
    .summary =
        "Draws the motion as a film, .gif, .webm or .mp4, by the ffmpeg program. Where that is not installed, or\n"
        "the output ends in .png, the pictures are written one by one: FILE-0001.png and so on.",
    .examples = "  tinker animate pendulum.tinker.json -o pendulum.gif\n"
                "  tinker animate pendulum.tinker.json -o pendulum.mp4 --fps 60 --size 1280x720 --speed 0.5",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *output, *fps, *speed;
    gboolean no_labels, no_grid;
} AnimateOptions;

static void animate_options_clear(AnimateOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->output);
    g_free(options->fps);
    g_free(options->speed);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(AnimateOptions, animate_options_clear)

/* The recorded motion: a row a picture, of the time and of place and orientation of every body that can move; and the
 * box that holds all of it. */
typedef struct {
    TinkerFrame *frame;
    GArray *bodies; /* of TinkerBlockId */
    TinkerRecord *record;
    GArray *row; /* of double: scratch */
    double box[4];
} Motion;

static void motion_clear(Motion *motion)
{
    g_clear_pointer(&motion->frame, tinker_frame_free);
    g_clear_pointer(&motion->bodies, g_array_unref);
    g_clear_pointer(&motion->record, tinker_record_free);
    g_clear_pointer(&motion->row, g_array_unref);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Motion, motion_clear)

static gboolean can_move(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL && block_class->physics->body != NULL &&
           block_class->physics->body->degrees_of_freedom > 0;
}

static gboolean motion_init(Motion *motion, TinkerScene *scene, GError **error)
{
    motion->frame = tinker_frame_new(scene, error);
    if (motion->frame == NULL) return FALSE;
    motion->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (can_move(tinker_scene_block_class(scene, block))) g_array_append_val(motion->bodies, block);
    }
    guint width = 1 + 3 * motion->bodies->len;
    motion->record = tinker_record_new(width, 0);
    motion->row = g_array_set_size(g_array_new(FALSE, TRUE, sizeof(double)), width);
    tinker_painter_bounds(motion->frame, motion->box);
    return TRUE;
}

static gboolean record_motion(TinkerSimulation *simulation, double time, const double *values, void *data,
                              GError **error)
{
    Motion *motion = data;
    if (!tinker_simulation_place(simulation, motion->frame, error)) return FALSE;
    double *row = (double *)(gpointer)motion->row->data;
    *row++ = time;
    for (guint i = 0; i < motion->bodies->len; i++, row += 3)
        tinker_frame_centre(motion->frame, g_array_index(motion->bodies, TinkerBlockId, i), &row[0], &row[1], &row[2]);
    return tinker_record_append(motion->record, (const double *)(gpointer)motion->row->data, error);
}

static gboolean place_picture(Motion *motion, gsize picture, GError **error)
{
    double *row = (double *)(gpointer)motion->row->data;
    if (!tinker_record_read(motion->record, picture, 1, row, error)) return FALSE;
    if (!tinker_frame_set_time(motion->frame, row[0], error)) return FALSE;
    for (guint i = 0; i < motion->bodies->len; i++)
        tinker_frame_place(motion->frame, g_array_index(motion->bodies, TinkerBlockId, i), row[3 * i + 1],
                           row[3 * i + 2], row[3 * i + 3]);
    return TRUE;
}

static double column_of(const Motion *motion, TinkerBlockId block, int32_t meaning)
{
    int32_t column =
        tinker_block_class_meaning_column(tinker_scene_block_class(tinker_frame_scene(motion->frame), block), meaning);
    return column < 0 ? 0 : tinker_frame_column(motion->frame, block, column);
}

/* Widens the box by every block as it lies now, turned any way. */
static void widen_box(Motion *motion)
{
    TinkerScene *scene = tinker_frame_scene(motion->frame);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        double x, y, orientation;
        tinker_frame_centre(motion->frame, block, &x, &y, &orientation);
        if (isnan(x)) continue;
        double reach =
            hypot(column_of(motion, block, TINKER_MEANING_WIDTH), column_of(motion, block, TINKER_MEANING_HEIGHT)) / 2;
        motion->box[0] = fmin(motion->box[0], x - reach);
        motion->box[1] = fmin(motion->box[1], y - reach);
        motion->box[2] = fmax(motion->box[2], x + reach);
        motion->box[3] = fmax(motion->box[3], y + reach);
    }
}

/* Forgets what a failed run is not to be believed in, and finds the box that holds the rest. */
static gboolean bound_motion(Motion *motion, double valid_until, GError **error)
{
    gsize count = tinker_record_rows(motion->record);
    for (gsize picture = 0; picture < count; picture++) {
        if (!place_picture(motion, picture, error)) return FALSE;
        if (tinker_frame_time(motion->frame) > valid_until) {
            tinker_record_cut(motion->record, picture);
            break;
        }
        widen_box(motion);
    }
    return TRUE;
}

/* Draws the recorded pictures until Ctrl-C; `drawn` counts them. */
static gboolean draw_pictures(Motion *motion, TinkerFilm *film, int width, int height, const TinkerPaintOptions *paint,
                              TinkerProgress *progress, gsize *drawn, GError **error)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    cairo_t *cairo = cairo_create(surface);
    TinkerView view = tinker_view_fit(motion->box, width, height, MARGIN * MIN(width, height));
    gsize count = tinker_record_rows(motion->record);
    gboolean fine = TRUE;
    for (gsize picture = 0; fine && picture < count; picture++) {
        if (picture > 0 && tinker_progress_interrupted(NULL)) break;
        fine = place_picture(motion, picture, error);
        if (!fine) break;
        tinker_paint_scene(cairo, motion->frame, &view, paint);
        fine = tinker_film_add(film, surface, error);
        *drawn = picture + 1;
        tinker_progress_update(progress, (double)picture, (double)count);
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return fine;
}

static void tell_numbered_pictures(const char *output, gsize count)
{
    g_autofree char *first = tinker_film_picture_name(output, 1);
    g_autofree char *last = tinker_film_picture_name(output, (int)count);
    gboolean wanted = tinker_path_has_ending(output, ".png");
    const char *reason = wanted ? "" : "ffmpeg is not installed, so the film cannot be joined; ";
    if (count > 1)
        tinker_report_note("%swrote %" G_GSIZE_FORMAT " pictures, %s to %s", reason, count, first, last);
    else
        tinker_report_note("%swrote one picture, %s", reason, first);
}

static gboolean read_rate(const AnimateOptions *options, double *fps, double *speed, GError **error)
{
    static const TinkerDimension none = TINKER_DIMENSION_NONE;
    return (options->fps == NULL || tinker_option_value("fps", options->fps, none, 0, TRUE, fps, error)) &&
           (options->speed == NULL || tinker_option_value("speed", options->speed, none, 0, TRUE, speed, error));
}

static gboolean run_motion(Motion *motion, const AnimateOptions *options, const TinkerOpenScene *open, double spacing,
                           GError **failure, GError **error)
{
    TinkerRunOptions run_options;
    g_auto(TinkerSceneRun) run = {0};
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run_options, error)) return FALSE;
    run_options.interval = spacing;
    if (run_options.duration / spacing > MOST_PICTURES) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "the film would have %.0f pictures; choose a lower --fps, a higher --speed or a shorter --duration",
                    run_options.duration / spacing);
        return FALSE;
    }
    if (!motion_init(motion, open->scene, error)) return FALSE;
    if (!tinker_scene_run_prepare(&run, open->scene, &options->run, &run_options, error)) return FALSE;
    (void)tinker_scene_run_go(&run, NULL, record_motion, motion, failure);
    tinker_scene_run_report_warnings(&run, open, &options->run);
    return bound_motion(motion, tinker_simulation_summary(run.simulation)->valid_until, error);
}

static gboolean animate(const AnimateOptions *options, const TinkerOpenScene *open, GError **failure, GError **error)
{
    static const char *const endings[] = {".gif", ".webm", ".mp4", ".png", NULL};
    int width = 640, height = 480;
    double fps = 25, speed = 1;
    TinkerPaintOptions paint = tinker_paint_options_default();
    paint.show_labels = !options->no_labels;
    paint.show_grid = !options->no_grid;
    paint.show_time = TRUE;
    if (tinker_picture_ending(options->output, endings, error) < 0) return FALSE;
    if (!tinker_picture_arguments_read(&options->picture, &width, &height, &paint.theme, error)) return FALSE;
    if (!read_rate(options, &fps, &speed, error)) return FALSE;

    g_auto(Motion) motion = {0};
    if (!run_motion(&motion, options, open, speed / fps, failure, error)) return FALSE;
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    paint.memory = memory;
    g_autoptr(TinkerFilm) film = tinker_film_new(options->output, width, height, fps, error);
    if (film == NULL) return FALSE;
    TinkerProgress progress = tinker_progress_start("drawing");
    gboolean joined = !tinker_path_has_ending(options->output, ".png") && tinker_film_can_join();
    gsize drawn = 0;
    gboolean fine = draw_pictures(&motion, film, width, height, &paint, &progress, &drawn, error);
    tinker_progress_end(&progress);
    if (!fine || !tinker_film_finish(film, error)) return FALSE;
    if (!joined) tell_numbered_pictures(options->output, drawn);
    return TRUE;
}

int tinker_verb_animate(int argc, char **argv)
{
    g_auto(AnimateOptions) options = {0};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Write to FILE (.gif, .webm, .mp4 or .png)", "FILE"},
        {"fps", 0, 0, G_OPTION_ARG_FILENAME, &options.fps, "Pictures a second (25)", "N"},
        {"speed", 0, 0, G_OPTION_ARG_FILENAME, &options.speed, "Times real time: 0.5 is slow motion (1)", "X"},
        TINKER_PICTURE_ENTRIES(options.picture, "640x480"),
        {"no-labels", 0, 0, G_OPTION_ARG_NONE, &options.no_labels, "Leave out the names", NULL},
        {"no-grid", 0, 0, G_OPTION_ARG_NONE, &options.no_grid, "Leave out the grid", NULL},
        {"duration", 0, 0, G_OPTION_ARG_FILENAME, &options.run.duration, "How long to run", "S"},
        TINKER_RUN_METHOD_ENTRIES(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;

    g_auto(TinkerOpenScene) open = {0};
    status = tinker_open_scene(&open, line.plugin_folders, line.operands[0]);
    if (status != TINKER_EXIT_DONE) return status;
    g_autoptr(GError) error = NULL, failure = NULL;
    if (!animate(&options, &open, &failure, &error)) return tinker_open_scene_report_error(&open, error);
    return failure != NULL ? tinker_report_error(open.name, failure) : TINKER_EXIT_DONE;
}
