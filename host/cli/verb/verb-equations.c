/* tinker equations: which equations a scene stands for. */
#include <stdio.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/run-arguments.h"
#include "cli/report/equations-json.h"
#include "cli/verb/verbs.h"
#include "equations/write.h"
#include "exit-status.h"
#include "print.h"

static const TinkerVerbHelp help = {
    .verb = "equations",
    .operands = "SCENE",
    .summary =
        "Writes the equations of motion that a scene stands for: for each body, mass times acceleration = the sum of\n"
        "the forces on it, one term a block, with the laws of the terms and what each symbol is.\n"
        "With --at the scene is run to that time first, and the numbers then stand below the symbols.",
    .examples = "  tinker equations pendulum.tinker.json\n"
                "  tinker equations pendulum.tinker.json --block \"Mass 0\" --at 1.5\n"
                "  tinker equations pendulum.tinker.json --as latex -o pendulum.tex\n"
                "  tinker equations pendulum.tinker.json --as mathml -o pendulum.html\n"
                "  tinker equations pendulum.tinker.json --at 1.5 --as json",
    .least_operands = 1,
    .most_operands = 1,
};

enum { AS_JSON = TINKER_TYPESET_MATHML + 1 };

typedef struct {
    TinkerRunArguments run;
    char *at, *as, *output;
    char **blocks;
} EquationsOptions;

static void equations_options_clear(EquationsOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    g_free(options->at);
    g_free(options->as);
    g_free(options->output);
    g_strfreev(options->blocks);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(EquationsOptions, equations_options_clear)

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

static gboolean take_state(TinkerSimulation *simulation, double time, G_GNUC_UNUSED const double *values, void *data,
                           GError **error)
{
    StateJob *job = data;
    g_clear_pointer(&job->state, tinker_model_state_free);
    job->state = tinker_model_state_take(simulation, job->run.model, job->scene, time, error);
    return job->state != NULL;
}

/* Runs the scene to a time; the state there is left in the job. */
static gboolean run_to(StateJob *job, const TinkerOpenScene *open, const EquationsOptions *options, double time,
                       GError **error)
{
    TinkerRunOptions run;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run, error)) return FALSE;
    if (time > run.duration) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--at %g: the scene's run lasts %g s (a time from 0 to that)", time, run.duration);
        return FALSE;
    }
    run.at = &time;
    run.at_count = 1;
    run.estimate = FALSE;
    job->scene = open->scene;
    const TinkerSampleTaker taker = {take_state, NULL, job};
    return tinker_scene_run_prepare(&job->run, open->scene, &options->run, &run, error) &&
           tinker_scene_run_go(&job->run, NULL, &taker, error);
}

/* The blocks that were named, ended by -1. (transfer full) */
static TinkerBlockId *blocks_named(const EquationsOptions *options, TinkerScene *scene, GError **error)
{
    const guint count = g_strv_length(options->blocks);
    g_autofree TinkerBlockId *blocks = g_new(TinkerBlockId, count + 1);
    for (guint i = 0; i < count; i++) {
        blocks[i] = tinker_scene_find_block(scene, options->blocks[i]);
        if (blocks[i] >= 0) continue;
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--block \"%s\": the scene has no such block",
                    options->blocks[i]);
        return NULL;
    }
    blocks[count] = -1;
    return g_steal_pointer(&blocks);
}

static gboolean write_equations(const EquationsOptions *options, const TinkerOpenScene *open, GError **error)
{
    static const char *const formats[] = {"text", "latex", "mathml", "json", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autofree TinkerBlockId *blocks = NULL;
    int as = TINKER_TYPESET_TEXT;
    double time = 0;
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    if (options->as != NULL && !tinker_option_choice("as", options->as, formats, &as, error)) return FALSE;
    if (options->at != NULL && !tinker_option_value("at", options->at, seconds, 0, FALSE, &time, error)) return FALSE;
    if (options->blocks != NULL && (blocks = blocks_named(options, open->scene, error)) == NULL) return FALSE;

    g_auto(StateJob) job = {0};
    if (!run_to(&job, open, options, time, error)) return FALSE;
    g_autoptr(TinkerEquations) equations = tinker_equations_new(open->scene, job.state, error);
    if (equations == NULL) return FALSE;
    const char *title = tinker_scene_head(open->scene)->title;
    const TinkerEquationsShown shown = {(TinkerTypesetFormat)as, title[0] != '\0' ? title : open->name, blocks,
                                        options->at != NULL};
    g_autofree char *text =
        as == AS_JSON ? tinker_equations_json(equations, blocks) : tinker_equations_write(equations, &shown);
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, options->output != NULL ? options->output : "-", error)) return FALSE;
    tinker_print_text(output.file, g_strchomp(text));
    return tinker_output_close(&output, error);
}

int tinker_verb_equations(int argc, char **argv)
{
    g_auto(EquationsOptions) options = {0};
    const GOptionEntry entries[] = {
        {"block", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options.blocks,
         "Of this body alone; may be given several times (all bodies)", "NAME"},
        {"at", 0, 0, G_OPTION_ARG_FILENAME, &options.at, "With the numbers at this time (none; JSON: those at 0)", "T"},
        {"as", 0, 0, G_OPTION_ARG_FILENAME, &options.as, "text, latex, mathml or json (text)", "FORMAT"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Write to FILE (standard output)", "FILE"},
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;

    g_auto(TinkerOpenScene) open = {0};
    status = tinker_open_scene(&open, line.plugin_folders, line.operands[0]);
    if (status != TINKER_EXIT_DONE) return status;
    g_autoptr(GError) error = NULL;
    return write_equations(&options, &open, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
