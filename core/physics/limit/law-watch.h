/* No step passes over what a typed law does in a narrow band of time or place, as a short pulse or a thin wall: neither
 * error control nor a companion sees what no evaluation met. Behind a step the law is enclosed along it, an eighth of
 * the step at a time. Where it is not gentle there (units/compiled/compiled.h), and may do more than the tolerance lets
 * pass, an adaptive method makes the step again, as far as where that begins. A method with fixed steps goes on, and
 * the run tells what it may have missed. */
#ifndef TINKER_CORE_LAW_WATCH_H
#define TINKER_CORE_LAW_WATCH_H

#include "physics/island/island-run.h"

typedef struct _TinkerLawWatch TinkerLawWatch;

/* NULL where no law of the island needs it. The run is borrowed. (transfer full) */
TinkerLawWatch *tinker_law_watch_new(TinkerIslandRun *run);
void tinker_law_watch_free(TinkerLawWatch *self);

/* Until when the run goes (s): laws that would keep it from there stop it. */
void tinker_law_watch_set_end(TinkerLawWatch *self, double end);

/* tinker_island_run_make_step, watched. */
TinkerStatus tinker_law_watch_step(TinkerLawWatch *self, double limit, TinkerStepReport *report);

/* At the end of a run: warns of what fixed steps may have missed, beside the speed that there has been. */
void tinker_law_watch_tell(TinkerLawWatch *self);

#endif
