/* The thread measures a copy of the scene, which the result keeps: it says later on whether the scene is still the
 * same. */
#include "gui/accuracy/trade-task.h"

#include "gui/document/background.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "scene/history/difference.h"

#define LOOK_AGAIN 100 /* ms: how often progress is told */
#define FINENESS   10000

/* What is measured, and what came out of it. */
typedef struct {
    TinkerTradeTask *owner;       /* borrowed; of the main thread */
    TinkerBackground *background; /* borrowed; of the thread */
    TinkerScene *scene;
    TinkerTradeOptions options;
    gint progress; /* atomic; in 1/FINENESS */
    TinkerTrade *trade;
    char *advice, *reference;
    GError *error;
} Job;

struct _TinkerTradeTask {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerBackground *background;
    Job *running;  /* borrowed from the background */
    Job *measured; /* with a trade */
    char *failure;
    gboolean stale;
    guint timer;
};

G_DEFINE_FINAL_TYPE(TinkerTradeTask, tinker_trade_task, G_TYPE_OBJECT)

enum { CHANGED, PROGRESS, SIGNALS };
static guint signals[SIGNALS];

static void job_free(void *data)
{
    Job *job = data;
    if (job == NULL) return;
    tinker_trade_free(job->trade);
    g_free(job->advice);
    g_free(job->reference);
    g_clear_error(&job->error);
    tinker_scene_free(job->scene);
    g_free(job);
}

/* The thread ------------------------------------------------------------------------------------------------------- */

static gboolean is_cancelled(void *data)
{
    return tinker_background_is_cancelled(((Job *)data)->background);
}

static void note_progress(double share, void *data)
{
    g_atomic_int_set(&((Job *)data)->progress, (gint)(FINENESS * share));
}

static void work(TinkerBackground *background, void *data)
{
    Job *job = data;
    job->background = background;
    job->trade = tinker_trade_new(job->scene, &job->options, &job->error);
    if (job->trade == NULL) return;
    job->advice = tinker_trade_advice_text(job->trade, &job->options);
    job->reference = tinker_trade_reference_text(job->trade);
}

/* The owner -------------------------------------------------------------------------------------------------------- */

static void emit(TinkerTradeTask *task, int signal)
{
    g_signal_emit(task, signals[signal], 0);
}

static void let_go(TinkerTradeTask *task)
{
    g_clear_pointer(&task->background, tinker_background_let_go);
    task->running = NULL;
    if (task->timer != 0) g_source_remove(task->timer);
    task->timer = 0;
}

static void set_run(TinkerRunSettings *run, const TinkerRunSettings *from)
{
    g_free(run->method);
    g_free(run->contacts);
    run->method = g_strdup(from->method);
    run->contacts = g_strdup(from->contacts);
    run->step = from->step;
    run->tolerance = from->tolerance;
    run->accuracy = from->accuracy;
    run->interval = from->interval;
}

/* Whatever method the scene is run with and however it is sampled, the trade is the same: it tries all of them. */
static gboolean has_another_motion(TinkerTradeTask *task)
{
    if (task->measured == NULL) return FALSE;
    TinkerScene *scene = tinker_document_scene(task->document), *measured = task->measured->scene;
    set_run(&tinker_scene_head(measured)->run, &tinker_scene_head(scene)->run);
    return tinker_scene_difference(measured, scene) > TINKER_DIFFERENCE_DRAWING;
}

/* A steal by hand: the background frees what it was given, which is an empty job then. */
static Job *take(Job *job)
{
    Job *taken = g_memdup2(job, sizeof *job);
    *job = (Job){0};
    return taken;
}

static void on_done(void *data)
{
    Job *job = data;
    TinkerTradeTask *task = job->owner;
    if (job->trade != NULL) {
        job_free(task->measured);
        task->measured = take(job);
    } else if (!g_error_matches(job->error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) {
        task->failure = g_strdup(job->error->message);
    }
    let_go(task);
    task->stale = has_another_motion(task);
    emit(task, CHANGED);
}

static gboolean on_look_again(void *data)
{
    emit(data, PROGRESS);
    return G_SOURCE_CONTINUE;
}

void tinker_trade_task_start(TinkerTradeTask *task, double error, double seconds)
{
    static const TinkerBackgroundWork trade_work = {"trade", work, on_done, job_free};
    let_go(task);
    g_clear_pointer(&task->failure, g_free);
    Job *job = g_new0(Job, 1);
    job->owner = task;
    job->scene = tinker_scene_copy(tinker_document_scene(task->document));
    job->options = (TinkerTradeOptions){
        .run = tinker_run_options_of(job->scene),
        .error = error,
        .seconds = seconds,
        .cancelled = is_cancelled,
        .progress = note_progress,
        .data = job,
    };
    task->running = job;
    task->background = tinker_background_start(&trade_work, job);
    task->timer = g_timeout_add(LOOK_AGAIN, on_look_again, task);
    emit(task, CHANGED);
}

void tinker_trade_task_cancel(TinkerTradeTask *task)
{
    if (task->background != NULL) tinker_background_cancel(task->background);
}

gboolean tinker_trade_task_is_running(TinkerTradeTask *task)
{
    return task->background != NULL;
}

double tinker_trade_task_progress(TinkerTradeTask *task)
{
    return task->running != NULL ? g_atomic_int_get(&task->running->progress) / (double)FINENESS : 0;
}

const TinkerTrade *tinker_trade_task_result(TinkerTradeTask *task)
{
    return task->measured != NULL ? task->measured->trade : NULL;
}

const char *tinker_trade_task_advice(TinkerTradeTask *task)
{
    return task->measured != NULL ? task->measured->advice : NULL;
}

const char *tinker_trade_task_reference(TinkerTradeTask *task)
{
    return task->measured != NULL ? task->measured->reference : NULL;
}

const char *tinker_trade_task_failure(TinkerTradeTask *task)
{
    return task->failure;
}

gboolean tinker_trade_task_is_stale(TinkerTradeTask *task)
{
    return task->stale;
}

/* The document ----------------------------------------------------------------------------------------------------- */

static void on_changed(TinkerTradeTask *task)
{
    gboolean stale = has_another_motion(task);
    if (stale == task->stale) return;
    task->stale = stale;
    emit(task, CHANGED);
}

static void on_replaced(TinkerTradeTask *task)
{
    let_go(task);
    g_clear_pointer(&task->measured, job_free);
    g_clear_pointer(&task->failure, g_free);
    task->stale = FALSE;
    emit(task, CHANGED);
}

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_trade_task_finalize(GObject *object)
{
    TinkerTradeTask *task = TINKER_TRADE_TASK(object);
    let_go(task);
    job_free(task->measured);
    g_free(task->failure);
    g_object_unref(task->document);
    G_OBJECT_CLASS(tinker_trade_task_parent_class)->finalize(object);
}

static void tinker_trade_task_class_init(TinkerTradeTaskClass *class)
{
    static const char *const names[SIGNALS] = {"changed", "progress"};
    G_OBJECT_CLASS(class)->finalize = tinker_trade_task_finalize;
    for (int i = 0; i < SIGNALS; i++)
        signals[i] =
            g_signal_new(names[i], TINKER_TYPE_TRADE_TASK, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_trade_task_init(TinkerTradeTask *task) {}

TinkerTradeTask *tinker_trade_task_new(TinkerDocument *document)
{
    TinkerTradeTask *task = g_object_new(TINKER_TYPE_TRADE_TASK, NULL);
    task->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), task, G_CONNECT_SWAPPED);
    return task;
}
