/* Words for what happens in a run. */
#ifndef TINKER_HOST_EVENT_WORDS_H
#define TINKER_HOST_EVENT_WORDS_H

#include "physics/system/summary.h"

/* "Mass 0 leaves the end of Support 0": what happened at an event, without its time; the scene is the one that was run.
 * (transfer full) */
char *tinker_event_text(const TinkerScene *scene, const TinkerEvent *event);

#endif
