/* tinker plan: what of a scene is modelled, how each part of it would be stepped, and why. */
#include "cli/verb/verbs.h"

#include <stdio.h>

#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/run-arguments.h"
#include "cli/report/plan-report.h"
#include "common/program/exit-status.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/plan-trial.h"
#include "scene/frame/boxes.h"

static const TinkerVerbHelp help = {
    .verb = "plan",
    .operands = "SCENE",
    .summary =
        "Tells what of a scene is modelled and what is left out, which parts are stepped apart, the method and step "
        "of\n"
        "each and why, the steps at which each method is stable, and what a run is expected to cost and to miss.\n"
        "The cost is told by a trial of the run's first steps, of which nothing is recorded. What is not given is "
        "taken\n"
        "from the scene.",
    .examples = "  tinker plan bridge.tinker.json\n"
                "  tinker plan bridge.tinker.json --method rk4 --step \"5 ms\"\n"
                "  tinker plan bridge.tinker.json --method auto --tolerance 1e-6 --json plan.json",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    char *json;
} PlanOptions;

static void plan_options_clear(PlanOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    g_free(options->json);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(PlanOptions, plan_options_clear)

/* Everything that a plan is made of. */
typedef struct {
    TinkerRunOptions options;
    TinkerModel *model;
    GPtrArray *islands;
    TinkerPlan *plan;
    TinkerOutput json;
} PlanJob;

static void plan_job_clear(PlanJob *job)
{
    g_clear_pointer(&job->plan, tinker_plan_free);
    g_clear_pointer(&job->islands, g_ptr_array_unref);
    g_clear_pointer(&job->model, tinker_model_free);
    tinker_output_clear(&job->json);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(PlanJob, plan_job_clear)

static gboolean prepare(PlanJob *job, const PlanOptions *options, const TinkerOpenScene *open, GError **error)
{
    const TinkerAskedOutput outputs[] = {{"--json", options->json}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autoptr(GError) reason = NULL;
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &job->options, error)) return FALSE;
    job->model = tinker_model_new(open->scene, &reason);
    if (job->model != NULL) job->islands = tinker_islands_for(job->model, job->options.impulses, &reason);
    if (job->islands != NULL) job->plan = tinker_plan_new_counted(job->model, job->islands, &job->options, &reason);
    if (job->plan == NULL) {
        tinker_run_arguments_blame(&options->run, &reason);
        g_propagate_error(error, g_steal_pointer(&reason));
        return FALSE;
    }
    return options->json == NULL || tinker_output_open(&job->json, options->json, error);
}

static gboolean write_plan(PlanJob *job, const PlanOptions *options, const TinkerOpenScene *open, GError **error)
{
    g_autoptr(GPtrArray) warnings = g_ptr_array_new();
    g_autoptr(GPtrArray) of_plan = tinker_warnings_texts(job->plan->warnings);
    const GPtrArray *sources[] = {open->warnings, of_plan};
    for (gsize s = 0; s < G_N_ELEMENTS(sources); s++)
        for (guint i = 0; i < sources[s]->len; i++)
            g_ptr_array_add(warnings, g_ptr_array_index(sources[s], i));
    g_autoptr(GPtrArray) opened = tinker_catalogue_opened(open->catalogue);
    TinkerPlanReport report = {
        .scene = open->scene,
        .scene_name = open->name,
        .sizes = tinker_model_sizes(job->model),
        .plan = job->plan,
        .libraries = opened,
        .warnings = warnings,
    };
    tinker_plan_write_text(&report, tinker_is_standard_stream(options->json) ? stderr : stdout);
    if (job->json.file != NULL) tinker_plan_write_json(&report, job->json.file);
    return tinker_output_close(&job->json, error);
}

static int plan(const PlanOptions *options, const TinkerCommandLine *line)
{
    g_auto(TinkerOpenScene) open = {0};
    int status = tinker_open_scene(&open, line->plugin_folders, line->operands[0]);
    if (status != TINKER_EXIT_DONE) return status;
    g_auto(PlanJob) job = {0};
    g_autoptr(GError) error = NULL;
    if (!prepare(&job, options, &open, &error)) return tinker_open_scene_report_error(&open, error);
    tinker_boxes_tell(open.scene, job.options.duration, open.warnings);
    return write_plan(&job, options, &open, &error) ? TINKER_EXIT_DONE : tinker_report_error(open.name, error);
}

int tinker_verb_plan(int argc, char **argv)
{
    g_auto(PlanOptions) options = {0};
    const GOptionEntry entries[] = {
        TINKER_RUN_ENTRIES(options.run),
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &options.json, "Write the plan to FILE as JSON", "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;
    return plan(&options, &line);
}
