/* Pictures: what the verbs that draw have in common. */
#include "cli/command/picture.h"

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "exit-status.h"
#include "film.h"
#include "physics/run/acting-forces.h"

/* Cairo's image surfaces end at 32767 pixels; a picture of half of that takes a gigabyte. */
#define GREATEST_SIDE 16384
#define MOST_PLACES   10000 /* of a path in a picture */

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

gboolean tinker_picture_or_text(const TinkerPictureArguments *arguments, const char *path, const char *as,
                                gboolean *is_picture, GError **error)
{
    static const char *const endings[] = {".png", ".svg", ".pdf", NULL};
    *is_picture = FALSE;
    for (int i = 0; path != NULL && endings[i] != NULL; i++)
        *is_picture = *is_picture || tinker_path_has_ending(path, endings[i]);
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
    TinkerActingForces *acting; /* NULL: not wanted */
    GArray *forces;
} Sampled;

static gboolean place_frame(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Sampled *sampled = data;
    if (!tinker_simulation_place(simulation, sampled->frame, error)) return FALSE;
    tinker_frame_note_paths(sampled->frame);
    return sampled->acting == NULL || tinker_acting_forces_at(sampled->acting, simulation, sampled->forces, error);
}

/* The one sample that is drawn; before it, where blocks leave paths, one at every interval of the scene's. Element:
 * double. (transfer full) */
static GArray *sample_times(const TinkerFrame *frame, double interval, double time)
{
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    interval = MAX(interval, time / MOST_PLACES);
    for (gsize k = 0; tinker_frame_leaves_paths(frame) && (double)k * interval < time; k++) {
        const double t = (double)k * interval;
        g_array_append_val(times, t);
    }
    g_array_append_val(times, time);
    return times;
}

gboolean tinker_picture_run_to(TinkerFrame *frame, const TinkerOpenScene *open, const TinkerRunArguments *arguments,
                               double time, GArray *forces, GError **error)
{
    if (time <= 0) {
        tinker_open_scene_report_warnings(open);
        return forces == NULL || tinker_acting_forces_at_start(open->scene, forces, error);
    }
    TinkerRunOptions options;
    if (!tinker_run_arguments_apply(arguments, open->scene, &options, error)) return FALSE;
    g_autoptr(GArray) times = sample_times(frame, tinker_scene_head(open->scene)->run.interval, time);
    options.at = (const double *)(const void *)times->data;
    options.at_count = times->len;
    g_auto(TinkerSceneRun) run = {0};
    if (!tinker_scene_run_prepare(&run, open->scene, arguments, &options, error)) return FALSE;
    g_autoptr(TinkerActingForces) acting = forces != NULL ? tinker_acting_forces_new(run.model) : NULL;
    Sampled sampled = {frame, acting, forces};
    const TinkerSampleTaker taker = {.sample = place_frame, .data = &sampled};
    gboolean done = tinker_scene_run_go(&run, NULL, &taker, error);
    tinker_scene_run_report_warnings(&run, open, arguments);
    return done;
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
