/* Conditions that end a run: the time at which the first of them holds.
 *
 * A condition is "A = B", which holds where the difference of two expressions of quantities (formula.h) changes its
 * sign after the start; a comparison, "A < B", which holds once it becomes true, having been false; or "event(KIND)" or
 * "event(KIND, BLOCK)", which is an event of the run. A condition is looked for at eight points an interval: what holds
 * for less time than that may be missed. */
#ifndef TINKER_CORE_UNTIL_H
#define TINKER_CORE_UNTIL_H

#include "physics/model/model.h"
#include "physics/plan/run-options.h"

typedef struct _TinkerUntil TinkerUntil;

/* No condition yet. The scene is borrowed. (transfer full) */
TinkerUntil *tinker_until_new(TinkerScene *scene);
void tinker_until_free(TinkerUntil *until);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerUntil, tinker_until_free)

/* Adds a condition. Errors (TINKER_SCENE_ERROR_NAME) say what is wrong with it, and in which column. */
gboolean tinker_until_add(TinkerUntil *until, const char *text, GError **error);

/* Finds the first time within the options' duration at which one of the conditions holds, to 1e-11 of it or of a
 * second, and the number of that condition; INFINITY and -1 where none does, or where the run fails before. The model
 * is run several times for that, without estimate, in the steps that a run with these options takes, so that one which
 * is sampled at this time ends there exactly. FALSE where the run is stopped or cannot begin. */
gboolean tinker_until_find(TinkerUntil *until, TinkerModel *model, const TinkerRunOptions *options, double *time,
                           int *number, GError **error);

#endif
