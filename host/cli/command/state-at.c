#include "cli/command/state-at.h"

#include "common/program/exit-status.h"

/* What is looked at while the scene runs. */
typedef struct {
    TinkerSceneRun run;
    TinkerScene *scene;
    TinkerModelState *state;
} StateJob;

static void state_job_clear(StateJob *job)
{
    g_clear_pointer(&job->state, tinker_model_state_free);
    tinker_scene_run_clear(&job->run);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(StateJob, state_job_clear)

static gboolean take_state(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    StateJob *job = data;
    g_clear_pointer(&job->state, tinker_model_state_free);
    job->state = tinker_model_state_take(simulation, job->run.model, job->scene, time, values, error);
    return job->state != NULL;
}

gboolean tinker_run_options_to(const TinkerOpenScene *open, const TinkerRunArguments *arguments, const char *option,
                               double time, TinkerRunOptions *options, GError **error)
{
    if (!tinker_run_arguments_apply(arguments, open->scene, options, error)) return FALSE;
    if (time <= options->duration) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "--%s %g: the scene's run lasts %g s (a time from 0 to that)", option, time, options->duration);
    return FALSE;
}

TinkerModelState *tinker_state_at(const TinkerOpenScene *open, const TinkerRunArguments *arguments, const char *option,
                                  double time, GError **error)
{
    g_auto(StateJob) job = {.scene = open->scene};
    TinkerRunOptions options;
    if (!tinker_run_options_to(open, arguments, option, time, &options, error)) return NULL;
    options.at = &time;
    options.at_count = 1;
    options.estimate = options.accuracy > 0;
    g_autoptr(GArray) columns = tinker_model_state_columns(open->scene);
    const TinkerSampleTaker taker = {.sample = take_state, .begin_again = NULL, .data = &job};
    if (!tinker_scene_run_prepare(&job.run, open->scene, arguments, &options, error) ||
        !tinker_scene_run_go(&job.run, columns, &taker, error))
        return NULL;
    return g_steal_pointer(&job.state);
}

static gboolean is_listed(const GArray *blocks, TinkerBlockId block)
{
    for (guint i = 0; i < blocks->len; i++)
        if (g_array_index(blocks, TinkerBlockId, i) == block) return TRUE;
    return FALSE;
}

TinkerBlockId *tinker_blocks_named(TinkerScene *scene, char *const *names, GError **error)
{
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (; *names != NULL; names++) {
        const TinkerBlockId block = tinker_scene_find_block(scene, *names);
        if (block >= 0 && !is_listed(blocks, block)) g_array_append_val(blocks, block);
        if (block >= 0) continue;
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--block \"%s\": the scene has no such block",
                    *names);
        return NULL;
    }
    const TinkerBlockId end = -1;
    g_array_append_val(blocks, end);
    return (TinkerBlockId *)(void *)g_array_free(g_steal_pointer(&blocks), FALSE);
}
