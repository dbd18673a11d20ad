/* Conditions that end a run: those of the command line, or the scene's own. */
#include "cli/command/options.h"
#include "cli/command/run-arguments.h"
#include "common/program/exit-status.h"
#include "physics/compile/compile.h"
#include "physics/system/summary.h"

static gboolean add_conditions(TinkerUntil *until, char **conditions, TinkerScene *scene, GError **error)
{
    if (conditions == NULL) {
        if (tinker_until_add_all(until, tinker_scene_head(scene)->run.until, error)) return TRUE;
        g_prefix_error(error, "run: until: ");
        return FALSE;
    }
    for (char **text = conditions; *text != NULL; text++)
        if (!tinker_until_add(until, *text, error)) {
            tinker_blame_option("until", error);
            return FALSE;
        }
    return TRUE;
}

gboolean tinker_scene_run_until(TinkerSceneRun *run, TinkerScene *scene, const TinkerRunArguments *arguments,
                                char **conditions, TinkerRunOptions *options, GError **error)
{
    TinkerRunOptions usual;
    int number = -1;
    run->until = tinker_until_new(scene, 0);
    if (!add_conditions(run->until, conditions, scene, error)) return FALSE;
    if (tinker_until_count(run->until) == 0) return TRUE;
    if (!tinker_run_arguments_apply(arguments, scene, &usual, error)) return FALSE;
    g_autoptr(GError) reason = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &reason);
    TinkerProgress progress = tinker_progress_start("looking for the end");
    TinkerRunOptions search = *options;
    search.cancelled = tinker_progress_interrupted;
    search.progress = tinker_progress_of_run;
    search.data = &progress;
    tinker_progress_catch_interrupt();
    const gboolean found =
        model != NULL && tinker_until_end(run->until, model, usual.interval, &search, &number, &reason);
    tinker_progress_end(&progress);
    options->at = search.at;
    options->at_count = search.at_count;
    if (!found) {
        tinker_run_arguments_blame(arguments, &reason);
        g_propagate_error(error, g_steal_pointer(&reason));
        return FALSE;
    }
    if (number >= 0) run->stopped_by = tinker_until_text(run->until, number);
    return TRUE;
}

void tinker_scene_run_report_end(const TinkerSceneRun *run, const char *name)
{
    if (run->until == NULL || tinker_until_count(run->until) == 0) return;
    const double end = tinker_simulation_summary(run->simulation)->simulated_s;
    if (run->stopped_by != NULL)
        tinker_report_note("%s: ended at %.10g s, where %s", name, end, run->stopped_by);
    else
        tinker_report_note("%s: no condition that would end the run came true in %g s", name, end);
}
