/* Watching a run for bodies that pass through each other: nothing holds two of them apart, and whoever sees them
 * overlap is told so. It looks at samples alone. */
#ifndef TINKER_CORE_BOX_WATCH_H
#define TINKER_CORE_BOX_WATCH_H

#include "physics/model/model.h"

typedef struct _TinkerBoxWatch TinkerBoxWatch;

/* NULL where fewer than two bodies have a box. The model is borrowed. (transfer full) */
TinkerBoxWatch *tinker_box_watch_new(const TinkerModel *model);
void tinker_box_watch_free(TinkerBoxWatch *watch);

/* Looks at the bodies at q (relative to the model's origin), turned as `orientation` (rad; NAN: as at the start) says.
 * The blocks of the two with the least ids that overlap; FALSE where none do. Costs little more than the bodies: they
 * are kept sorted from look to look. */
gboolean tinker_box_watch_look(TinkerBoxWatch *watch, const double *q, const double *orientation,
                               TinkerBlockId pair[2]);

#endif
