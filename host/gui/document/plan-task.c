/* One thread at a time: an edit while it works lets go of it, and another starts a moment later. */
#include "gui/document/plan-task.h"

#include "gui/document/background.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

#define MOMENT 300 /* ms */

struct _TinkerPlanTask {
    GObject parent_instance;
    TinkerDocument *document;
    guint timer; /* id of the source that will start a plan, or 0 */
    TinkerBackground *background;
    TinkerPlanResult *result;
    gboolean due;
};

G_DEFINE_FINAL_TYPE(TinkerPlanTask, tinker_plan_task, G_TYPE_OBJECT)

static guint changed_signal;

static void result_free(TinkerPlanResult *result)
{
    if (result == NULL) return;
    g_clear_pointer(&result->avoidable, g_ptr_array_unref);
    tinker_plan_free(result->plan);
    g_clear_error(&result->error);
    tinker_scene_free(result->scene);
    g_free(result);
}

/* The thread ------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerPlanTask *owner; /* borrowed; of the main thread */
    TinkerPlanResult *result;
} Job;

static TinkerPlan *plan_scene(TinkerScene *scene, const TinkerRunOptions *options, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return NULL;
    g_autoptr(GPtrArray) islands = tinker_islands_for(model, options->impulses, error);
    return islands != NULL ? tinker_plan_new(model, islands, options, error) : NULL;
}

/* Asks the plan that a free choice would make, which of the warnings that leaves. */
static void find_avoidable(TinkerPlanResult *result, TinkerRunOptions options)
{
    options.method = "auto";
    g_autoptr(TinkerPlan) other = plan_scene(result->scene, &options, NULL);
    for (guint i = 0; other != NULL && i < result->plan->warnings->len; i++) {
        TinkerWarning *warning = g_ptr_array_index(result->plan->warnings, i);
        if (!tinker_warnings_say(other->warnings, warning->text)) g_ptr_array_add(result->avoidable, warning);
    }
}

static void work(TinkerBackground *background, void *data)
{
    TinkerPlanResult *result = ((Job *)data)->result;
    TinkerRunOptions options = tinker_run_options_of(result->scene);
    result->automatic = g_str_equal(options.method, "auto");
    result->plan = plan_scene(result->scene, &options, &result->error);
    gboolean warned = result->plan != NULL && result->plan->warnings->len > 0;
    if (warned && !result->automatic && !tinker_background_is_cancelled(background)) find_avoidable(result, options);
}

static void job_free(void *data)
{
    Job *job = data;
    result_free(job->result);
    g_free(job);
}

/* The owner -------------------------------------------------------------------------------------------------------- */

static void set_result(TinkerPlanTask *task, TinkerPlanResult *result)
{
    if (result == NULL && task->result == NULL) return;
    result_free(task->result);
    task->result = result;
    g_signal_emit(task, changed_signal, 0);
}

static void on_done(void *data)
{
    Job *job = data;
    TinkerPlanTask *task = job->owner;
    g_clear_pointer(&task->background, tinker_background_let_go);
    task->due = FALSE;
    set_result(task, g_steal_pointer(&job->result));
}

static void let_go(TinkerPlanTask *task)
{
    if (task->timer != 0) g_source_remove(task->timer);
    task->timer = 0;
    g_clear_pointer(&task->background, tinker_background_let_go);
}

static void start(TinkerPlanTask *task)
{
    static const TinkerBackgroundWork plan_work = {"plan", work, on_done, job_free};
    let_go(task);
    Job *job = g_new0(Job, 1);
    job->owner = task;
    job->result = g_new0(TinkerPlanResult, 1);
    job->result->scene = tinker_scene_copy(tinker_document_scene(task->document));
    job->result->avoidable = g_ptr_array_new();
    task->background = tinker_background_start(&plan_work, job);
}

static gboolean on_moment_passed(void *data)
{
    TinkerPlanTask *task = data;
    task->timer = 0;
    start(task);
    return G_SOURCE_REMOVE;
}

/* Until there is a new plan the old one still says more than nothing, but not of another scene. */
static void on_changed(TinkerPlanTask *task)
{
    let_go(task);
    task->due = TRUE;
    if (tinker_scene_block_count(tinker_document_scene(task->document)) > TINKER_PLAN_MOST_BLOCKS)
        set_result(task, NULL);
    else
        task->timer = g_timeout_add(MOMENT, on_moment_passed, task);
}

static void on_replaced(TinkerPlanTask *task)
{
    let_go(task);
    set_result(task, NULL);
}

const TinkerPlanResult *tinker_plan_task_result(TinkerPlanTask *task)
{
    return task->result;
}

gboolean tinker_plan_task_is_due(TinkerPlanTask *task)
{
    return task->due;
}

void tinker_plan_task_demand(TinkerPlanTask *task)
{
    if (task->due && task->background == NULL) start(task);
}

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_plan_task_finalize(GObject *object)
{
    TinkerPlanTask *task = TINKER_PLAN_TASK(object);
    let_go(task);
    result_free(task->result);
    g_object_unref(task->document);
    G_OBJECT_CLASS(tinker_plan_task_parent_class)->finalize(object);
}

static void tinker_plan_task_class_init(TinkerPlanTaskClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_plan_task_finalize;
    changed_signal =
        g_signal_new("changed", TINKER_TYPE_PLAN_TASK, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_plan_task_init(TinkerPlanTask *task) {}

TinkerPlanTask *tinker_plan_task_new(TinkerDocument *document)
{
    TinkerPlanTask *task = g_object_new(TINKER_TYPE_PLAN_TASK, NULL);
    task->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), task, G_CONNECT_SWAPPED);
    on_changed(task);
    return task;
}
