/* What is no longer true is thrown away with the edit, so that nothing is shown of another scene. */
#include "gui/mode/modes-task.h"

#include "gui/document/background.h"

#define MOMENT 200 /* ms */

struct _TinkerModesTask {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerBackground *background;
    TinkerModesResult *result;
    guint timer; /* id of the source that will start, or 0 */
    int wanted;  /* by how many */
};

G_DEFINE_FINAL_TYPE(TinkerModesTask, tinker_modes_task, G_TYPE_OBJECT)

static guint changed_signal;

typedef struct {
    TinkerModesTask *owner; /* borrowed; of the main thread */
    TinkerModesResult *result;
} ModesJob;

static void free_result(TinkerModesResult *result)
{
    if (result == NULL) return;
    g_clear_pointer(&result->responses, g_ptr_array_unref);
    tinker_mode_analysis_free(result->analysis);
    g_clear_error(&result->error);
    tinker_scene_free(result->scene);
    g_free(result);
}

static void analyse(G_GNUC_UNUSED TinkerBackground *background, void *data)
{
    TinkerModesResult *result = ((ModesJob *)data)->result;
    result->analysis = tinker_mode_analysis_new(result->scene, TRUE, &result->error);
    if (result->analysis != NULL) result->responses = tinker_drive_responses_new(result->analysis, result->scene);
}

static void take_result(void *data)
{
    ModesJob *job = data;
    TinkerModesTask *task = job->owner;
    g_clear_pointer(&task->background, tinker_background_let_go);
    task->result = g_steal_pointer(&job->result);
    g_signal_emit(task, changed_signal, 0);
}

static void free_job(void *data)
{
    free_result(((ModesJob *)data)->result);
    g_free(data);
}

static gboolean begin(gpointer data)
{
    static const TinkerBackgroundWork modes_work = {"modes", analyse, take_result, free_job};
    TinkerModesTask *task = data;
    ModesJob *job = g_new0(ModesJob, 1);
    task->timer = 0;
    job->owner = task;
    job->result = g_new0(TinkerModesResult, 1);
    job->result->scene = tinker_scene_copy(tinker_document_scene(task->document));
    task->background = tinker_background_start(&modes_work, job);
    return G_SOURCE_REMOVE;
}

static void stop(TinkerModesTask *task)
{
    if (task->timer != 0) g_source_remove(task->timer);
    task->timer = 0;
    g_clear_pointer(&task->background, tinker_background_let_go);
}

static void begin_if_wanted(TinkerModesTask *task)
{
    const gboolean is_done = task->result != NULL || task->background != NULL || task->timer != 0;
    if (task->wanted > 0 && !is_done) task->timer = g_timeout_add(MOMENT, begin, task);
}

static void on_edited(TinkerModesTask *task)
{
    TinkerModesResult *old = g_steal_pointer(&task->result);
    stop(task);
    if (old != NULL) g_signal_emit(task, changed_signal, 0); // who shows it lets go of it
    free_result(old);
    begin_if_wanted(task);
}

const TinkerModesResult *tinker_modes_task_result(TinkerModesTask *task)
{
    return task->result;
}

void tinker_modes_task_want(TinkerModesTask *task, gboolean wanted)
{
    task->wanted += wanted ? 1 : -1;
    begin_if_wanted(task);
}

static void tinker_modes_task_finalize(GObject *object)
{
    TinkerModesTask *task = TINKER_MODES_TASK(object);
    stop(task);
    free_result(task->result);
    g_object_unref(task->document);
    G_OBJECT_CLASS(tinker_modes_task_parent_class)->finalize(object);
}

static void tinker_modes_task_class_init(TinkerModesTaskClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_modes_task_finalize;
    changed_signal =
        g_signal_new("changed", TINKER_TYPE_MODES_TASK, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_modes_task_init(G_GNUC_UNUSED TinkerModesTask *task) {}

TinkerModesTask *tinker_modes_task_new(TinkerDocument *document)
{
    TinkerModesTask *task = g_object_new(TINKER_TYPE_MODES_TASK, NULL);
    task->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_edited), task, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_edited), task, G_CONNECT_SWAPPED);
    return task;
}
