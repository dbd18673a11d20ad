/* Lines whose law gives no force over a range of lengths, as a bumper that nothing touches. A method that chooses its
 * steps sees nothing of the end of that range: its steps grow until one begins on this side of a bumper and ends on the
 * other. So while a line is idle, no such step goes beyond the instant at which its ends would leave the range, going
 * on as they are accelerated where it begins; and one that begins there goes but a little beyond it. */
#ifndef TINKER_CORE_IDLE_LINES_H
#define TINKER_CORE_IDLE_LINES_H

#include "physics/island/island-run.h"

typedef struct _TinkerIdleLines TinkerIdleLines;

/* NULL where no line of the island is ever idle. The run is borrowed. (transfer full) */
TinkerIdleLines *tinker_idle_lines_new(TinkerIslandRun *run);
void tinker_idle_lines_free(TinkerIdleLines *self);

/* Before a step from the run's state to `limit`: how far it may go. */
double tinker_idle_lines_limit(TinkerIdleLines *self, double limit);

#endif
