/* When velocities jumped, near which those of a run and of its companion tell nothing about the error; and how far two
 * states are apart. */
#ifndef TINKER_CORE_IMPACTS_H
#define TINKER_CORE_IMPACTS_H

#include "physics/island/island-run.h"

/* When velocities jumped. */
typedef struct {
    double last;   /* s: at the latest, at the state or behind it; -INFINITY: never */
    double passed; /* s: likewise, of those behind the state */
    double within; /* s: it is known so well, where that is a matter of steps; else 0 */
} TinkerImpacts;

/* Of an island, at its state. */
TinkerImpacts tinker_impacts_of(const TinkerIslandRun *run);

/* Within the reach of an impact the two may stand on its two sides, where velocities tell nothing. */
gboolean tinker_impacts_are_near(const TinkerImpacts *impacts, double t);

/* Whether velocities of the two tell anything at a point within a step: not near an impact of either, nor between them,
 * as one impact comes to the two at two instants. */
gboolean tinker_impacts_let_speeds_tell(const TinkerImpacts *ours, const TinkerImpacts *theirs, double t);

/* The largest square, not below `so_far`, of bodies' ways from one place to another (m^2), or of changes of their
 * velocities (m^2/s^2); 2 numbers a body. */
double tinker_largest_square(int32_t bodies, const double *from, const double *to, double so_far);

/* The same of all coordinates of a model. Of a body that turns what its places turn by counts as well: its angle times
 * its radius of gyration. */
double tinker_largest_way(const TinkerModel *model, const double *from, const double *to, double so_far);

#endif
