/* tinker equations: which equations a scene stands for. */
#include <stdio.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/command/run-arguments.h"
#include "cli/command/state-at.h"
#include "cli/report/equations-json.h"
#include "cli/verb/verbs.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "equations/write/write.h"
#include "physics/compile/compile.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"

static const TinkerVerbHelp help = {
    .verb = "equations",
    .operands = "SCENE",
    .summary =
        "Writes the equations of motion that a scene stands for: for each body, mass times acceleration = the sum of\n"
        "the forces on it, one term a block, with the laws of the terms and what each symbol is.\n"
        "With --at the scene is run to that time first, and the numbers then stand below the symbols.",
    .examples = "  tinker equations pendulum.tinker.json\n"
                "  tinker equations pendulum.tinker.json --block \"Mass 0\" --at 1.5\n"
                "  tinker equations spring-mass.tinker.json --form matrix\n"
                "  tinker equations pendulum.tinker.json --as latex -o pendulum.tex\n"
                "  tinker equations pendulum.tinker.json --as mathml -o pendulum.html\n"
                "  tinker equations pendulum.tinker.json --at 1.5 --as json",
    .least_operands = 1,
    .most_operands = 1,
};

enum { AS_JSON = TINKER_TYPESET_MATHML + 1 };

typedef struct {
    TinkerRunArguments run;
    char *at, *as, *form, *output;
    char **blocks;
} EquationsOptions;

static void equations_options_clear(EquationsOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    g_free(options->at);
    g_free(options->as);
    g_free(options->form);
    g_free(options->output);
    g_strfreev(options->blocks);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(EquationsOptions, equations_options_clear)

/* (transfer full) */
static char *newton_text(const TinkerEquations *equations, const TinkerEquationsShown *shown, int as)
{
    return as == AS_JSON ? tinker_equations_json(equations, shown->blocks)
                         : tinker_equations_write(equations, NULL, NULL, shown);
}

/* (transfer full) */
static char *angles_text(TinkerEquations *equations, const TinkerEquationsShown *shown, int as)
{
    g_autoptr(TinkerAngleForm) form = tinker_angle_form_new(equations);
    return as == AS_JSON ? tinker_equations_angles_json(equations, form)
                         : tinker_equations_write(equations, NULL, form, shown);
}

/* What is linear is told by the plan. (transfer full) */
static char *matrix_text(const TinkerEquations *equations, const TinkerEquationsShown *shown, int as,
                         const EquationsOptions *options, const TinkerOpenScene *open, GError **error)
{
    TinkerRunOptions run;
    g_autoptr(TinkerModel) model = NULL;
    g_autoptr(GPtrArray) islands = NULL;
    g_autoptr(TinkerPlan) plan = NULL;
    if (!tinker_run_arguments_apply(&options->run, open->scene, &run, error)) return NULL;
    if ((model = tinker_model_new(open->scene, error)) == NULL) return NULL;
    if ((islands = tinker_islands_for(model, FALSE, error)) == NULL) return NULL;
    if ((plan = tinker_plan_new(model, islands, &run, error)) == NULL) return NULL;
    g_autoptr(TinkerMatrixForm) form = tinker_matrix_form_new(equations, plan, as == AS_JSON);
    return as == AS_JSON ? tinker_equations_matrix_json(equations, form)
                         : tinker_equations_write(equations, form, NULL, shown);
}

/* A browser and LaTeX make pictures of equations. */
static gboolean is_no_picture(const char *path, GError **error)
{
    if (!tinker_path_is_picture(path)) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "--output \"%s\": equations are written as text, not drawn (as in --as mathml -o FILE.html, --as latex "
                "-o FILE.tex)",
                path);
    return FALSE;
}

/* The blocks that are asked for; NULL where one of them is no body that can move, which alone has an equation.
 * (transfer full) */
static TinkerBlockId *bodies_named(TinkerScene *scene, char **names, GError **error)
{
    g_autofree TinkerBlockId *blocks = tinker_blocks_named(scene, names, error);
    for (const TinkerBlockId *block = blocks; block != NULL && *block >= 0; block++) {
        if (tinker_block_class_moves(tinker_scene_block_class(scene, *block))) continue;
        g_set_error(
            error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
            "--block \"%s\": it has no equation of motion (name a body that can move; forces on it stand in its "
            "equation)",
            tinker_scene_block_name(scene, *block));
        return NULL;
    }
    return g_steal_pointer(&blocks);
}

static gboolean write_equations(const EquationsOptions *options, const TinkerOpenScene *open, GError **error)
{
    static const char *const formats[] = {"text", "latex", "mathml", "json", NULL};
    static const char *const forms[] = {"newton", "matrix", "angles", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    g_autofree TinkerBlockId *blocks = NULL;
    int as = TINKER_TYPESET_TEXT, form = 0;
    double time = 0;
    if (!tinker_outputs_add(files, outputs, error) || !is_no_picture(options->output, error)) return FALSE;
    if (options->as != NULL && !tinker_option_choice("as", options->as, formats, &as, error)) return FALSE;
    if (options->form != NULL && !tinker_option_choice("form", options->form, forms, &form, error)) return FALSE;
    if (options->at != NULL && !tinker_option_value("at", options->at, seconds, 0, FALSE, &time, error)) return FALSE;
    if (options->blocks != NULL && (blocks = bodies_named(open->scene, options->blocks, error)) == NULL) return FALSE;

    g_autoptr(TinkerModelState) state = tinker_state_at(open, &options->run, "at", time, error);
    if (state == NULL) return FALSE;
    g_autoptr(TinkerEquations) equations = tinker_equations_new(open->scene, state, error);
    if (equations == NULL) return FALSE;
    const char *title = tinker_scene_head(open->scene)->title;
    const TinkerEquationsShown shown = {(TinkerTypesetFormat)as, title[0] != '\0' ? title : open->name, blocks,
                                        options->at != NULL};
    g_autofree char *text = form == 0   ? newton_text(equations, &shown, as)
                            : form == 1 ? matrix_text(equations, &shown, as, options, open, error)
                                        : angles_text(equations, &shown, as);
    if (text == NULL) return FALSE;
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
        {"form", 0, 0, G_OPTION_ARG_FILENAME, &options.form,
         "newton; matrix: M q'' + C q' + K q = f of what is linear; angles: Lagrange's of trees of rods (newton)",
         "FORM"},
        {"as", 0, 0, G_OPTION_ARG_FILENAME, &options.as, "text, latex, mathml or json (text)", "FORMAT"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output, "Write to FILE (standard output)", "FILE"},
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    return write_equations(&options, &open, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
