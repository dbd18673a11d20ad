/* Pictures: what the verbs that draw have in common. */
#include "cli/command/picture.h"

#include <string.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "common/film/film.h"
#include "common/program/exit-status.h"
#include "physics/run/acting-forces.h"

/* Cairo's image surfaces end at 32767 pixels; a picture of half of that takes a gigabyte. */
#define GREATEST_SIDE 16384
#define MOST_PLACES   10000 /* of a path in a picture */
#define MOST_MARKS    1000  /* of a trail */
#define SCALE_SAMPLES 400   /* of a run, to find the greatest of its vectors */

void tinker_picture_arguments_clear(TinkerPictureArguments *arguments)
{
    g_clear_pointer(&arguments->size, g_free);
    g_clear_pointer(&arguments->theme, g_free);
}

static gboolean read_size(const char *text, int *width, int *height, GError **error)
{
    g_auto(GStrv) sides = g_strsplit(text, "x", 2);
    if (g_strv_length(sides) != 2) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--size \"%s\": not width and height in pixels (as in --size 800x600)", text);
        return FALSE;
    }
    return tinker_option_integer("size", sides[0], 1, GREATEST_SIDE, width, error) &&
           tinker_option_integer("size", sides[1], 1, GREATEST_SIDE, height, error);
}

gboolean tinker_picture_arguments_read(const TinkerPictureArguments *arguments, int *width, int *height,
                                       const TinkerTheme **theme, GError **error)
{
    const char *const *themes = tinker_theme_ids();
    int place = 0;
    if (arguments->size != NULL && !read_size(arguments->size, width, height, error)) return FALSE;
    if (arguments->theme != NULL && !tinker_option_choice("theme", arguments->theme, themes, &place, error))
        return FALSE;
    *theme = tinker_theme_find(themes[place]);
    return TRUE;
}

void tinker_overlay_arguments_clear(TinkerOverlayArguments *arguments)
{
    g_clear_pointer(&arguments->marks, g_free);
}

gboolean tinker_overlay_arguments_marks(const TinkerOverlayArguments *arguments, double time, double *every,
                                        GError **error)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    *every = arguments->trail ? tinker_motion_trail_spacing(time) : 0;
    if (arguments->marks != NULL && !tinker_option_value("marks", arguments->marks, seconds, 0, TRUE, every, error))
        return FALSE;
    if (arguments->marks != NULL && !arguments->trail)
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--marks %s: there is no trail (add --trail)",
                    arguments->marks);
    else if (arguments->trail && time / *every > MOST_MARKS)
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--marks: the trail would have %.0f marks (choose a time of %g s or more)", time / *every,
                    time / MOST_MARKS);
    else
        return TRUE;
    return FALSE;
}

static gboolean has_ending_of(const char *path, const char *const *endings)
{
    for (; path != NULL && *endings != NULL; endings++)
        if (tinker_path_has_ending(path, *endings)) return TRUE;
    return FALSE;
}

static const char *const drawn_endings[] = {".png", ".svg", ".pdf", NULL};

gboolean tinker_path_is_picture(const char *path)
{
    static const char *const others[] = {".jpg", ".jpeg", ".gif", ".webp", ".bmp",
                                         ".tif", ".tiff", ".eps", ".ps",   NULL};
    return has_ending_of(path, drawn_endings) || has_ending_of(path, others);
}

gboolean tinker_picture_or_text(const TinkerPictureArguments *arguments, const char *path, const char *as,
                                gboolean *is_picture, GError **error)
{
    *is_picture = has_ending_of(path, drawn_endings);
    if (!*is_picture && tinker_path_is_picture(path)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--output \"%s\": no picture is made with this ending (.png, .svg or .pdf; any other is text)",
                    path);
        return FALSE;
    }
    if (*is_picture && as != NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--as %s: \"%s\" would be a picture by its ending (leave out --as, or choose another ending)", as,
                    path);
        return FALSE;
    }
    if (!*is_picture && (arguments->size != NULL || arguments->theme != NULL)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--%s belongs to a picture; none is asked for (add -o FILE.svg, .png or .pdf)",
                    arguments->size != NULL ? "size" : "theme");
        return FALSE;
    }
    return !*is_picture || tinker_output_is_writable(path, error);
}

int tinker_picture_ending(const char *path, const char *const *endings, GError **error)
{
    g_autofree char *list = g_strjoinv(", ", (char **)endings);
    if (path == NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "no output is given (add -o FILE; its ending says what is written: %s)", list);
        return -1;
    }
    for (int place = 0; endings[place] != NULL; place++)
        if (tinker_path_has_ending(path, endings[place])) return tinker_output_is_writable(path, error) ? place : -1;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "--output \"%s\": the ending must say what is written: %s", path, list);
    return -1;
}

/* What a sample fills. */
typedef struct {
    TinkerFrame *frame;
    double time; /* s: of the picture */
    gboolean reached;
    TinkerPictureCourse *course;
    TinkerActingForces *acting; /* NULL: not needed */
    GArray *forces, *vectors;   /* of the sample */
} Sampled;

/* All vectors of a sample; after that of the picture they are measured alone, with the frame as it was. */
static void take_vectors(Sampled *sampled, TinkerSimulation *simulation, double time)
{
    TinkerPictureCourse *course = sampled->course;
    g_array_set_size(sampled->vectors, 0);
    if (course->choice.kinds[TINKER_VECTOR_VELOCITY])
        tinker_motion_vectors_add_velocities(sampled->vectors, sampled->frame, simulation);
    tinker_motion_vectors_add_forces(sampled->vectors, sampled->frame, sampled->forces, &course->choice);
    tinker_motion_vectors_measure(sampled->vectors, course->greatest);
    if (time == sampled->time) g_array_append_vals(course->vectors, sampled->vectors->data, sampled->vectors->len);
}

static gboolean place_frame(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Sampled *sampled = data;
    TinkerPictureCourse *course = sampled->course;
    if (time <= sampled->time && !tinker_simulation_place(simulation, sampled->frame, error)) return FALSE;
    if (time <= sampled->time) tinker_frame_note_paths(sampled->frame);
    if (time <= sampled->time) tinker_frame_note_spans(sampled->frame);
    if (time <= sampled->time && course->trail != NULL) tinker_motion_trail_note_frame(course->trail, sampled->frame);
    if (sampled->acting != NULL && !tinker_acting_forces_at(sampled->acting, simulation, sampled->forces, error))
        return FALSE;
    if (course->vectors != NULL) take_vectors(sampled, simulation, time);
    if (time != sampled->time) return TRUE;
    sampled->reached = TRUE;
    if (course->forces != NULL) g_array_append_vals(course->forces, sampled->forces->data, sampled->forces->len);
    return TRUE;
}

/* A run that begins again for an accuracy. */
static void forget_samples(void *data)
{
    Sampled *sampled = data;
    sampled->reached = FALSE;
    memset(sampled->course->greatest, 0, sizeof(sampled->course->greatest));
    if (sampled->course->vectors != NULL) g_array_set_size(sampled->course->vectors, 0);
    if (sampled->course->forces != NULL) g_array_set_size(sampled->course->forces, 0);
    if (sampled->course->trail != NULL) tinker_motion_trail_clear(sampled->course->trail);
}

static void add_times(GArray *times, double spacing, double until)
{
    for (gsize k = 0; (double)k * spacing < until; k++) {
        const double t = (double)k * spacing;
        g_array_append_val(times, t);
    }
}

static int compare_times(const void *left, const void *right)
{
    const double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* The one sample that is drawn; before it, where blocks or a trail leave paths or blocks have a span, one at every
 * interval of the scene's, and at every mark; and where vectors are wanted, some over the whole run. Ascending, each
 * once. Element: double. (transfer full) */
static GArray *sample_times(const TinkerFrame *frame, const TinkerRunOptions *options, double time,
                            const TinkerPictureCourse *course)
{
    g_autoptr(GArray) all = g_array_new(FALSE, FALSE, sizeof(double));
    if (tinker_frame_leaves_paths(frame) || tinker_frame_has_spans(frame) || course->trail != NULL)
        add_times(all, MAX(options->interval, time / MOST_PLACES), time);
    if (course->trail != NULL) add_times(all, tinker_motion_trail_every(course->trail), time);
    if (course->vectors != NULL) add_times(all, options->duration / SCALE_SAMPLES, options->duration);
    if (course->vectors != NULL && options->duration > time) g_array_append_val(all, options->duration);
    g_array_append_val(all, time);
    g_array_sort(all, compare_times);
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < all->len; i++) {
        const double t = g_array_index(all, double, i);
        if (times->len == 0 || t != g_array_index(times, double, times->len - 1)) g_array_append_val(times, t);
    }
    return times;
}

gboolean tinker_picture_run_to(TinkerFrame *frame, const TinkerOpenScene *open, const TinkerRunArguments *arguments,
                               double time, TinkerPictureCourse *course, GError **error)
{
    if (time <= 0 && course->vectors == NULL) {
        tinker_open_scene_report_warnings(open);
        return course->forces == NULL || tinker_acting_forces_at_start(open->scene, course->forces, error);
    }
    TinkerRunOptions options;
    if (!tinker_run_arguments_apply(arguments, open->scene, &options, error)) return FALSE;
    g_autoptr(GArray) times = sample_times(frame, &options, time, course);
    options.at = (const double *)(const void *)times->data;
    options.at_count = times->len;
    g_auto(TinkerSceneRun) run = {0};
    if (!tinker_scene_run_prepare(&run, open->scene, arguments, &options, error)) return FALSE;
    const gboolean asks_forces = course->forces != NULL || course->choice.kinds[TINKER_VECTOR_ACCELERATION] ||
                                 course->choice.kinds[TINKER_VECTOR_NET_FORCE];
    g_autoptr(TinkerActingForces) acting = asks_forces ? tinker_acting_forces_new(run.model) : NULL;
    g_autoptr(GArray) forces = tinker_acting_forces_array();
    g_autoptr(GArray) vectors = tinker_motion_vectors_array();
    Sampled sampled = {frame, time, FALSE, course, acting, forces, vectors};
    const TinkerSampleTaker taker = {.sample = place_frame, .begin_again = forget_samples, .data = &sampled};
    g_autoptr(GError) failure = NULL;
    const gboolean done = tinker_scene_run_go(&run, NULL, &taker, &failure);
    tinker_scene_run_report_warnings(&run, open, arguments);
    const gboolean failed_later = !done && sampled.reached && times->len > 0 &&
                                  g_array_index(times, double, times->len - 1) > time &&
                                  !g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY);
    if (done || failed_later) return TRUE;
    g_propagate_error(error, g_steal_pointer(&failure));
    return FALSE;
}

GHashTable *tinker_picture_faults_new(void)
{
    return g_hash_table_new_full(NULL, NULL, NULL, g_free);
}

void tinker_picture_report_faults(GHashTable *faults)
{
    GHashTableIter iter;
    gpointer text;
    g_hash_table_iter_init(&iter, faults);
    while (g_hash_table_iter_next(&iter, NULL, &text))
        tinker_report_warning("%s", (const char *)text);
}
