/* One thread at a time: an edit while it works lets go of it. While time goes on one result follows the other, each
 * some time after the one before, so that they take a small part of a processor only, and each is of the run itself:
 * what is shown is never of another motion, but at most a little old. Books, which look at the whole run, follow where
 * they take little. */
#include "gui/equation/model-task.h"

#include "gui/document/background.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/accurate-run.h"

#define MOMENT      150   /* ms: from an edit or a move to the work */
#define FOLLOWING   150   /* ms: at least, from one result to the next one's work while time goes on, */
#define PATIENCE    3     /* and at least so many times as long as the last one took */
#define BRIEF_BOOKS 50000 /* us: books that take longer do not follow */

struct _TinkerModelTask {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerBackground *background;
    TinkerModelResult *result;
    guint timer;             /* id of the source that will start, or 0 */
    gint64 took, books_took; /* us: the last result, and the last books */
    gboolean wanted, due;
};

G_DEFINE_FINAL_TYPE(TinkerModelTask, tinker_model_task, G_TYPE_OBJECT)

static guint changed_signal;

static void result_free(TinkerModelResult *result)
{
    if (result == NULL) return;
    g_clear_pointer(&result->matrix, tinker_matrix_form_free);
    g_clear_pointer(&result->angles, tinker_angle_form_free);
    g_clear_pointer(&result->equations, tinker_equations_free);
    g_clear_pointer(&result->books, tinker_books_free);
    g_clear_pointer(&result->state, tinker_model_state_free);
    g_clear_error(&result->error);
    tinker_scene_free(result->scene);
    g_free(result->bodies);
    g_free(result);
}

/* The thread ------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerModelTask *owner; /* borrowed; of the main thread */
    TinkerModelResult *result;
    TinkerModel *model;           /* while it runs */
    TinkerBackground *background; /* likewise */
    gint64 began, books_took;     /* us: on the clock */
} Job;

static gboolean is_cancelled(void *data)
{
    const Job *job = data;
    return tinker_background_is_cancelled(job->background);
}

static gboolean take_state(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Job *job = data;
    g_clear_pointer(&job->result->state, tinker_model_state_free);
    job->result->state = tinker_model_state_take(simulation, job->model, job->result->scene, time, values, error);
    return job->result->state != NULL;
}

static gboolean run_to_time(Job *job, const TinkerRunOptions *options, GError **error)
{
    g_autoptr(GArray) columns = tinker_model_state_columns(job->result->scene);
    const TinkerSampleTaker taker = {.sample = take_state, .begin_again = NULL, .data = job};
    if ((job->model = tinker_model_new(job->result->scene, error)) == NULL) return FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(job->model, options, error);
    return simulation != NULL && tinker_accurate_run(&simulation, columns, &taker, error);
}

/* What is linear is told by the plan. */
static void find_forms(TinkerModelResult *result, const TinkerRunOptions *options)
{
    g_autoptr(TinkerModel) model = tinker_model_new(result->scene, NULL);
    g_autoptr(GPtrArray) islands = model != NULL ? tinker_islands_for(model, FALSE, NULL) : NULL;
    g_autoptr(TinkerPlan) plan = islands != NULL ? tinker_plan_new(model, islands, options, NULL) : NULL;
    if (plan != NULL) result->matrix = tinker_matrix_form_new(result->equations, plan, FALSE);
    result->angles = tinker_angle_form_new(result->equations);
}

static void work(TinkerBackground *background, void *data)
{
    static const double origin[2] = {0, 0};
    Job *job = data;
    TinkerModelResult *result = job->result;
    TinkerRunOptions options = tinker_run_options_of(result->scene);
    job->background = background;
    options.cancelled = is_cancelled;
    options.data = job;
    const double time = result->time - result->start;
    options.at = &time;
    options.at_count = 1;
    if (run_to_time(job, &options, &result->error))
        result->equations = tinker_equations_new(result->scene, result->state, &result->error);
    g_clear_pointer(&job->model, tinker_model_free);
    if (result->equations == NULL) {
        g_clear_pointer(&result->state, tinker_model_state_free);
        return;
    }
    options.at = NULL;
    options.at_count = 0;
    if (!is_cancelled(job)) find_forms(result, &options);
    if (result->books_behind || result->bodies[0] == TINKER_NO_BLOCK || time <= 0 || is_cancelled(job)) return;
    const gint64 began = g_get_monotonic_time();
    result->books = tinker_books_new(result->scene, &options, result->bodies, 0, time, origin, NULL);
    job->books_took = g_get_monotonic_time() - began;
}

static void job_free(void *data)
{
    Job *job = data;
    result_free(job->result);
    g_free(job);
}

/* The owner -------------------------------------------------------------------------------------------------------- */

static gboolean is_playing(TinkerModelTask *task)
{
    return tinker_player_state(task->player) == TINKER_PLAYER_PLAYING;
}

static gboolean are_same_bodies(const TinkerBlockId *some, const TinkerBlockId *others)
{
    while (*some == *others && *some != TINKER_NO_BLOCK)
        some++, others++;
    return *some == *others;
}

/* Books that do not follow stay those of an earlier moment, which they tell. */
static void keep_books(TinkerModelResult *before, TinkerModelResult *result)
{
    if (result->books_behind && before != NULL && before->start == result->start &&
        before->revision == result->revision && are_same_bodies(before->bodies, result->bodies))
        result->books = g_steal_pointer(&before->books);
}

static void on_done(void *data)
{
    Job *job = data;
    TinkerModelTask *task = job->owner;
    g_clear_pointer(&task->background, tinker_background_let_go);
    task->due = FALSE;
    task->took = g_get_monotonic_time() - job->began;
    if (job->result->books != NULL) task->books_took = job->books_took;
    keep_books(task->result, job->result);
    result_free(task->result);
    task->result = g_steal_pointer(&job->result);
    g_signal_emit(task, changed_signal, 0);
}

static void let_go(TinkerModelTask *task)
{
    if (task->timer != 0) g_source_remove(task->timer);
    task->timer = 0;
    g_clear_pointer(&task->background, tinker_background_let_go);
}

/* Those of the selection that can move. (transfer full) */
static TinkerBlockId *selected_bodies(TinkerDocument *document)
{
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(GArray) bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    const TinkerBlockId none = TINKER_NO_BLOCK;
    int count;
    const TinkerBlockId *selection = tinker_document_selection(document, &count);
    for (int i = 0; i < count; i++) {
        if (tinker_block_class_moves(tinker_scene_block_class(scene, selection[i])))
            g_array_append_val(bodies, selection[i]);
    }
    g_array_append_val(bodies, none);
    return (TinkerBlockId *)(void *)g_array_free(g_steal_pointer(&bodies), FALSE);
}

static gboolean start(gpointer data)
{
    static const TinkerBackgroundWork model_work = {"model", work, on_done, job_free};
    TinkerModelTask *task = data;
    task->timer = 0;
    g_clear_pointer(&task->background, tinker_background_let_go);
    Job *job = g_new0(Job, 1);
    job->owner = task;
    job->result = g_new0(TinkerModelResult, 1);
    job->result->scene = tinker_player_scene_shown(task->player, &job->result->start);
    job->result->time = tinker_player_time(task->player);
    job->result->revision = tinker_history_revision(tinker_document_history(task->document));
    job->result->bodies = selected_bodies(task->document);
    job->result->books_behind = is_playing(task) && task->books_took > BRIEF_BOOKS;
    job->began = g_get_monotonic_time();
    task->background = tinker_background_start(&model_work, job);
    return G_SOURCE_REMOVE;
}

static void start_later(TinkerModelTask *task)
{
    let_go(task);
    if (task->wanted && task->due) task->timer = g_timeout_add(MOMENT, start, task);
}

static void on_changed(TinkerModelTask *task)
{
    task->due = TRUE;
    start_later(task);
}

/* The next result while time goes on. */
static void follow(TinkerModelTask *task)
{
    if (!task->wanted || task->timer != 0 || task->background != NULL) return;
    task->timer = g_timeout_add(MAX(FOLLOWING, (guint)(PATIENCE * task->took / 1000)), start, task);
}

static void on_moved(TinkerModelTask *task)
{
    const TinkerModelResult *result = task->result;
    const gboolean known = result != NULL && result->time == tinker_player_time(task->player) && !result->books_behind;
    if (is_playing(task))
        follow(task);
    else if (!known)
        on_changed(task);
}

static void on_replaced(TinkerModelTask *task)
{
    let_go(task);
    g_clear_pointer(&task->result, result_free);
    g_signal_emit(task, changed_signal, 0);
}

const TinkerModelResult *tinker_model_task_result(TinkerModelTask *task)
{
    return task->result;
}

void tinker_model_task_want(TinkerModelTask *task, gboolean wanted)
{
    task->wanted = wanted;
    if (wanted && task->timer == 0 && task->background == NULL) start_later(task);
}

gboolean tinker_model_task_is_due(TinkerModelTask *task)
{
    return task->wanted && task->due;
}

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_model_task_finalize(GObject *object)
{
    TinkerModelTask *task = TINKER_MODEL_TASK(object);
    let_go(task);
    result_free(task->result);
    g_object_unref(task->player);
    g_object_unref(task->document);
    G_OBJECT_CLASS(tinker_model_task_parent_class)->finalize(object);
}

static void tinker_model_task_class_init(TinkerModelTaskClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_model_task_finalize;
    changed_signal =
        g_signal_new("changed", TINKER_TYPE_MODEL_TASK, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_model_task_init(TinkerModelTask *task)
{
    task->due = TRUE;
}

TinkerModelTask *tinker_model_task_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerModelTask *task = g_object_new(TINKER_TYPE_MODEL_TASK, NULL);
    task->document = g_object_ref(document);
    task->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(on_changed), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_moved), task, G_CONNECT_SWAPPED);
    return task;
}
