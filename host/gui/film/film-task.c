/* The thread runs a copy of the scene, then draws it. */
#include "gui/film/film-task.h"

#include "common/film/motion-film.h"
#include "gui/document/background.h"
#include "gui/text/translate.h"
#include "measure/until.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/accurate-run.h"
#include "physics/run/simulation.h"

#define LOOK_AGAIN 100 /* ms: how often progress is told */
#define FINENESS   10000
#define RUN_SHARE  0.3 /* of the progress; the rest is the drawing */

typedef struct {
    TinkerFilmTask *owner;        /* borrowed; of the main thread */
    TinkerBackground *background; /* borrowed; of the thread */
    TinkerScene *scene;
    TinkerFilmSettings settings; /* with a path of its own */
    gint progress;               /* atomic; in 1/FINENESS */
    gboolean written;
    char *stopped_by; /* the condition that ended the run, or NULL */
    GError *failure;  /* of the run */
    GError *error;
} Job;

struct _TinkerFilmTask {
    GObject parent_instance;
    TinkerBackground *background;
    Job *running; /* borrowed from the background */
    TinkerFilmState state;
    char *path, *failure, *stopped_by;
    guint timer;
};

G_DEFINE_FINAL_TYPE(TinkerFilmTask, tinker_film_task, G_TYPE_OBJECT)

enum { CHANGED, PROGRESS, SIGNALS };
static guint signals[SIGNALS];

static void job_free(void *data)
{
    Job *job = data;
    g_free((char *)job->settings.path);
    g_free(job->stopped_by);
    g_clear_error(&job->failure);
    g_clear_error(&job->error);
    tinker_scene_free(job->scene);
    g_free(job);
}

double tinker_film_settings_pictures(const TinkerFilmSettings *settings, double duration)
{
    return 1 + duration * settings->frames_per_second / settings->speed;
}

/* The thread ------------------------------------------------------------------------------------------------------- */

static gboolean is_cancelled(void *data)
{
    return tinker_background_is_cancelled(((Job *)data)->background);
}

static void note_progress(Job *job, double share)
{
    g_atomic_int_set(&job->progress, (gint)(FINENESS * CLAMP(share, 0, 1)));
}

static void note_run(double t, double duration, void *data)
{
    note_progress(data, RUN_SHARE * t / duration);
}

static void note_drawing(double done, double whole, void *data)
{
    note_progress(data, RUN_SHARE + (1 - RUN_SHARE) * done / whole);
}

/* Where the scene has conditions that end it, the film ends where the run in the window does. */
static gboolean end_at_condition(Job *job, TinkerUntil *until, TinkerModel *model, TinkerRunOptions *options,
                                 GError **error)
{
    const TinkerRunSettings *run = &tinker_scene_head(job->scene)->run;
    int number;
    if (!tinker_until_add_all(until, run->until, error) ||
        !tinker_until_end(until, model, run->interval, options, &number, error))
        return FALSE;
    job->stopped_by = number >= 0 ? g_strdup(tinker_until_text(until, number)) : NULL;
    return TRUE;
}

static gboolean run_scene(Job *job, TinkerMotionFilm *motion, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new(job->scene, error);
    if (model == NULL) return FALSE;
    TinkerRunOptions options = tinker_run_options_of(job->scene);
    TinkerFilmOverlay over = job->settings.over;
    over.marks = job->settings.show_trails ? tinker_motion_trail_spacing(options.duration) : 0;
    options.interval = tinker_motion_film_show(motion, &over, job->settings.speed / job->settings.frames_per_second);
    options.estimate = options.accuracy > 0; /* else nobody would see it */
    options.cancelled = is_cancelled;
    options.data = job;
    g_autoptr(TinkerUntil) until = tinker_until_new(job->scene, 0);
    if (!end_at_condition(job, until, model, &options, error)) return FALSE;
    options.progress = note_run;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    tinker_motion_film_begin(motion, model, tinker_options_duration(&options));
    if (job->settings.show_graphs) tinker_motion_film_show_graphs(motion, tinker_translate);
    const TinkerSampleTaker taker = {
        .sample = tinker_motion_film_sample, .begin_again = tinker_motion_film_begin_again, .data = motion};
    if (tinker_accurate_run(&simulation, tinker_motion_film_columns(motion), &taker, &job->failure)) return TRUE;
    if (g_error_matches(job->failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY)) {
        g_clear_error(&job->failure); /* the film is whole, and the window's own run tells what it misses */
        return TRUE;
    }
    gsize pictures = tinker_motion_film_cut(motion, tinker_simulation_summary(simulation)->valid_until);
    if (pictures > 1) return TRUE;
    g_propagate_error(error, g_steal_pointer(&job->failure));
    return FALSE;
}

static void work(TinkerBackground *background, void *data)
{
    Job *job = data;
    job->background = background;
    TinkerFilmDrawing drawing = {
        .path = job->settings.path,
        .width = job->settings.width,
        .height = job->settings.height,
        .frames_per_second = job->settings.frames_per_second,
        .paint = tinker_paint_options_default(),
        .cancelled = is_cancelled,
        .progress = note_drawing,
        .data = job,
    };
    drawing.paint.show_labels = job->settings.show_labels;
    drawing.paint.show_grid = job->settings.show_grid;
    drawing.paint.show_time = TRUE;
    gsize drawn;
    g_autoptr(TinkerMotionFilm) motion = tinker_motion_film_new(job->scene, &job->error);
    job->written = motion != NULL && run_scene(job, motion, &job->error) && !is_cancelled(job) &&
                   tinker_motion_film_write(motion, &drawing, &drawn, &job->error);
}

/* The owner -------------------------------------------------------------------------------------------------------- */

static void let_go(TinkerFilmTask *task)
{
    g_clear_pointer(&task->background, tinker_background_let_go);
    task->running = NULL;
    if (task->timer != 0) g_source_remove(task->timer);
    task->timer = 0;
}

/* A film that was whole before the thread heard that it was not wanted is there. */
static TinkerFilmState state_after(const Job *job)
{
    if (job->written) return job->failure != NULL ? TINKER_FILM_CUT_SHORT : TINKER_FILM_WRITTEN;
    return tinker_background_is_cancelled(job->background) ? TINKER_FILM_CANCELLED : TINKER_FILM_FAILED;
}

static void on_done(void *data)
{
    Job *job = data;
    TinkerFilmTask *task = job->owner;
    const GError *reason = job->written ? job->failure : job->error;
    task->state = state_after(job);
    if (task->state != TINKER_FILM_CANCELLED && reason != NULL) task->failure = g_strdup(reason->message);
    if (task->state == TINKER_FILM_WRITTEN) task->stopped_by = g_steal_pointer(&job->stopped_by);
    let_go(task);
    g_signal_emit(task, signals[CHANGED], 0);
}

static gboolean on_look_again(void *data)
{
    g_signal_emit(data, signals[PROGRESS], 0);
    return G_SOURCE_CONTINUE;
}

void tinker_film_task_start(TinkerFilmTask *task, TinkerScene *scene, const TinkerFilmSettings *settings)
{
    static const TinkerBackgroundWork film_work = {"film", work, on_done, job_free};
    let_go(task);
    g_clear_pointer(&task->failure, g_free);
    g_clear_pointer(&task->stopped_by, g_free);
    g_free(task->path);
    task->path = g_strdup(settings->path);
    Job *job = g_new0(Job, 1);
    job->owner = task;
    job->scene = tinker_scene_copy(scene);
    job->settings = *settings;
    job->settings.path = g_strdup(settings->path);
    task->running = job;
    task->state = TINKER_FILM_UNDER_WAY;
    task->background = tinker_background_start(&film_work, job);
    task->timer = g_timeout_add(LOOK_AGAIN, on_look_again, task);
    g_signal_emit(task, signals[CHANGED], 0);
}

void tinker_film_task_cancel(TinkerFilmTask *task)
{
    if (task->background != NULL) tinker_background_cancel(task->background);
}

TinkerFilmState tinker_film_task_state(TinkerFilmTask *task)
{
    return task->state;
}

double tinker_film_task_progress(TinkerFilmTask *task)
{
    return task->running != NULL ? g_atomic_int_get(&task->running->progress) / (double)FINENESS : 0;
}

const char *tinker_film_task_path(TinkerFilmTask *task)
{
    return task->path;
}

const char *tinker_film_task_failure(TinkerFilmTask *task)
{
    return task->failure;
}

const char *tinker_film_task_stopped_by(TinkerFilmTask *task)
{
    return task->stopped_by;
}

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_film_task_finalize(GObject *object)
{
    TinkerFilmTask *task = TINKER_FILM_TASK(object);
    let_go(task);
    g_free(task->path);
    g_free(task->failure);
    g_free(task->stopped_by);
    G_OBJECT_CLASS(tinker_film_task_parent_class)->finalize(object);
}

static void tinker_film_task_class_init(TinkerFilmTaskClass *class)
{
    static const char *const names[SIGNALS] = {"changed", "progress"};
    G_OBJECT_CLASS(class)->finalize = tinker_film_task_finalize;
    for (int i = 0; i < SIGNALS; i++)
        signals[i] =
            g_signal_new(names[i], TINKER_TYPE_FILM_TASK, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_film_task_init(TinkerFilmTask *task) {}

TinkerFilmTask *tinker_film_task_new(void)
{
    return g_object_new(TINKER_TYPE_FILM_TASK, NULL);
}
