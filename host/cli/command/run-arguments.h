/* The options that say how a scene is run, shared by every verb that runs one, and the run itself. */
#ifndef TINKER_CLI_RUN_ARGUMENTS_H
#define TINKER_CLI_RUN_ARGUMENTS_H

#include "cli/command/open-scene.h"
#include "cli/command/progress.h"
#include "measure/until.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/accurate-run.h"
#include "physics/run/simulation.h"

/* As given on the command line; NULL: the scene's own. */
typedef struct {
    char *duration, *interval, *method, *contacts, *step, *tolerance, *accuracy;
    gboolean no_estimate;
} TinkerRunArguments;

void tinker_run_arguments_clear(TinkerRunArguments *arguments);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerRunArguments, tinker_run_arguments_clear)

/* Rows of a table of options. */
#define TINKER_RUN_METHOD_ENTRIES(arguments)                                                                           \
    {"method", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).method, "Integrator: auto, rk4, dop853, verlet, ...", "M"},   \
        {"contacts", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).contacts, "Contact by events, or as impulse", "C"},     \
        {"step", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).step, "Step of fixed-step methods", "S"},                   \
    {                                                                                                                  \
        "tolerance", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).tolerance, "Tolerance of adaptive methods", "E"         \
    }
#define TINKER_RUN_ACCURACY_ENTRY(arguments)                                                                           \
    {                                                                                                                  \
        "accuracy", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).accuracy,                                                \
            "Hold the estimated error of the run to E, whatever step or tolerance it takes", "E"                       \
    }
#define TINKER_RUN_ENTRIES(arguments)                                                                                  \
    {"no-estimate",                                                                                                    \
     0,                                                                                                                \
     0,                                                                                                                \
     G_OPTION_ARG_NONE,                                                                                                \
     &(arguments).no_estimate,                                                                                         \
     "Leave out the companion run that estimates the error",                                                           \
     NULL},                                                                                                            \
        {"duration", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).duration, "How long to run", "S"},                      \
        {"interval", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).interval, "Time between samples", "S"},                 \
        TINKER_RUN_METHOD_ENTRIES(arguments), TINKER_RUN_ACCURACY_ENTRY(arguments)

/* The scene's settings with the arguments in their place. Strings are borrowed from both. Errors:
 * TINKER_CLI_ERROR_USAGE. */
gboolean tinker_run_arguments_apply(const TinkerRunArguments *arguments, TinkerScene *scene, TinkerRunOptions *options,
                                    GError **error);

/* Reads "T1,T2,..." of --at: ascending, each time once. (transfer full) */
GArray *tinker_run_arguments_times(const char *text, GError **error);

/* What the scene itself asks for in vain is the scene's fault, what the command line asks for the user's: turns an
 * error of the method or its step into a usage error where any of the arguments was given. */
void tinker_run_arguments_blame(const TinkerRunArguments *arguments, GError **error);

/* A scene compiled and ready to run. */
typedef struct {
    TinkerModel *model;
    TinkerSimulation *simulation;
    gboolean automatic; /* the method was chosen, not named */
    TinkerProgress progress;
    TinkerUntil *until;     /* conditions that end it; NULL: it was not asked for */
    const char *stopped_by; /* the one that does; NULL: none */
} TinkerSceneRun;

/* Ends the run where the first condition holds: of `conditions`, which stand on the command line; NULL: of the scene.
 * Where that is does not depend on the options' interval, but on the scene's or on the one given in the arguments. To
 * be called before it is prepared. Errors: of a condition, and as below. */
gboolean tinker_scene_run_until(TinkerSceneRun *run, TinkerScene *scene, const TinkerRunArguments *arguments,
                                char **conditions, TinkerRunOptions *options, GError **error);

/* Tells on standard error which condition ended the run, where there are any; `name` is the scene's. After the run. */
void tinker_scene_run_report_end(const TinkerSceneRun *run, const char *name);

/* Compiles the scene and prepares its run, with Ctrl-C and the progress line set up; a method or step that was given
 * on the command line and cannot be is a usage error. The scene run must stay where it is: the simulation points into
 * it. */
gboolean tinker_scene_run_prepare(TinkerSceneRun *run, TinkerScene *scene, const TinkerRunArguments *arguments,
                                  TinkerRunOptions *options, GError **error);

/* Runs it, as often as an accuracy asks for; erases the progress line. */
gboolean tinker_scene_run_go(TinkerSceneRun *run, const GArray *columns, const TinkerSampleTaker *taker,
                             GError **error);

void tinker_scene_run_clear(TinkerSceneRun *run);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerSceneRun, tinker_scene_run_clear)

/* Everything there is to say about a run: of the catalogue, the reader, the model, the simulation; each text once. Of
 * char *. (transfer full) */
GPtrArray *tinker_scene_run_warnings(const TinkerSceneRun *run, const TinkerOpenScene *open,
                                     const TinkerRunArguments *arguments);

/* Writes these warnings to standard error. */
void tinker_scene_run_report_warnings(const TinkerSceneRun *run, const TinkerOpenScene *open,
                                      const TinkerRunArguments *arguments);

#endif
