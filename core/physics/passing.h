/* Passing: a warning for bodies that run through a solid surface. Contact is not modelled, so nothing stops them; a motion
 * that shows it must not go without a word. */
#ifndef TINKER_CORE_PASSING_H
#define TINKER_CORE_PASSING_H

#include "physics/model-private.h"

typedef struct _TinkerPassing TinkerPassing;

/* Watches every box of the model against every solid plate; NULL where there are none, or too many pairs to look at.
 * (transfer full) */
TinkerPassing *tinker_passing_new(TinkerModel *model);
void tinker_passing_free(TinkerPassing *passing);

/* Looks at the state in the model's points at time t. A body that was above a plate's top and is now below adds one warning
 * (of char *) in all. Does nothing with NULL. */
void tinker_passing_look(TinkerPassing *passing, double t, GPtrArray *warnings);

#endif
