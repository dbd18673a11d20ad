/* Lines whose ends meet without passing each other. Where a line law has a tension T0 at length 0, as a spring of some
 * rest length has, the direction of its force ends there: ends that come to one place with a relative velocity pass
 * each other, and the force turns round; ends that come to rest there may go on in any direction, and rounding or the
 * method's error chooses one. That is an event, `direction lost`: the run goes on, but is determined up to then only.
 *
 * The ends meet where their energy beside that of rest at one place, |T0| L + mu u^2 / 2 (mu their reduced mass, u
 * their relative velocity), is no more than what the run's own energy is off by. Steps in which a force was evaluated
 * near length 0 are looked into; one in which ends may meet is made again, to the instant at which they are closest. */
#ifndef TINKER_CORE_DIRECTION_WATCH_H
#define TINKER_CORE_DIRECTION_WATCH_H

#include "physics/island/island-run.h"

typedef struct _TinkerDirectionWatch TinkerDirectionWatch;

/* NULL where no line of the island has a tension at length 0. The run is borrowed. (transfer full) */
TinkerDirectionWatch *tinker_direction_watch_new(TinkerIslandRun *run);
void tinker_direction_watch_free(TinkerDirectionWatch *watch);

/* Before a step to `limit`: answers it, or an instant before it at which ends are expected to meet. */
double tinker_direction_watch_begin(TinkerDirectionWatch *watch, double limit);
/* After the step, where it began at `from`: may end it earlier. */
TinkerStatus tinker_direction_watch_look(TinkerDirectionWatch *watch, double from, TinkerStepReport *report);

/* At the state of the run: where it begins, and where contacts have changed velocities. */
TinkerStatus tinker_direction_watch_check(TinkerDirectionWatch *watch);

#endif
