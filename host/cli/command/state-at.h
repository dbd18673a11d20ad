/* What equations, diagrams and books ask for alike: blocks by name, and the state of a run at a time. */
#ifndef TINKER_CLI_STATE_AT_H
#define TINKER_CLI_STATE_AT_H

#include "cli/command/open-scene.h"
#include "cli/command/run-arguments.h"
#include "equations/state/model-state.h"

/* Runs the scene to a time, of which `option` is what it was given by. TINKER_CLI_ERROR_USAGE for a time beyond the
 * run's duration. (transfer full) */
TinkerModelState *tinker_state_at(const TinkerOpenScene *open, const TinkerRunArguments *arguments, const char *option,
                                  double time, GError **error);

/* The scene's settings with the arguments in their place, for a run to this time. */
gboolean tinker_run_options_to(const TinkerOpenScene *open, const TinkerRunArguments *arguments, const char *option,
                               double time, TinkerRunOptions *options, GError **error);

/* The blocks of these names (ended by NULL), each once, ended by -1; TINKER_CLI_ERROR_USAGE for a name that the scene
 * lacks. (transfer full) */
TinkerBlockId *tinker_blocks_named(TinkerScene *scene, char *const *names, GError **error);

#endif
