/* Conditions that end a run: the time at which the first of them holds.
 *
 * A condition is "A = B", which holds where the difference of two expressions of quantities (formula.h) changes its
 * sign after the start, or comes to be 0 to rounding; a comparison, "A < B", which holds once it becomes true, having
 * been false; or "event(KIND)" or "event(KIND, BLOCK)", which is an event of the run. A condition is looked for at
 * eight points an interval: what holds for less time than that may be missed. */
#ifndef TINKER_CORE_UNTIL_H
#define TINKER_CORE_UNTIL_H

#include "physics/model/model.h"
#include "physics/plan/run-options.h"

typedef struct _TinkerUntil TinkerUntil;

/* No condition yet. The scene is borrowed; `start` (s) is what t is in expressions at the start of the run: 0, but
 * where it goes on with one before it. (transfer full) */
TinkerUntil *tinker_until_new(TinkerScene *scene, double start);
void tinker_until_free(TinkerUntil *until);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerUntil, tinker_until_free)

/* Adds a condition. Errors (TINKER_SCENE_ERROR_NAME) say what is wrong with it, and in which column. */
gboolean tinker_until_add(TinkerUntil *until, const char *text, GError **error);

/* Adds all conditions of a text (scene/store/conditions.h), as a scene's run has it. */
gboolean tinker_until_add_all(TinkerUntil *until, const char *text, GError **error);

/* How many there are, and one of them as it was given. Borrowed. */
guint tinker_until_count(const TinkerUntil *until);
const char *tinker_until_text(const TinkerUntil *until, int number);

/* Finds the first time within the options' duration at which one of the conditions holds, to 1e-11 of it or of a
 * second, and the number of that condition; INFINITY and -1 where none does, or where the run fails before. The model
 * is run several times for that, without estimate, in the steps that a run with these options takes, so that one which
 * is sampled at this time ends there exactly. FALSE where the run is stopped or cannot begin. */
gboolean tinker_until_find(TinkerUntil *until, TinkerModel *model, const TinkerRunOptions *options, double *time,
                           int *number, GError **error);

/* Ends a run with these options where the first of the conditions holds, looked for as in a run with a sample every
 * `interval` (s): the options are then given the times of their samples up to there, the end among them, which the
 * conditions own. `number` is as above; without a condition, or where none holds, the options stay as they are. FALSE
 * as above. */
gboolean tinker_until_end(TinkerUntil *until, TinkerModel *model, double interval, TinkerRunOptions *options,
                          int *number, GError **error);

#endif
