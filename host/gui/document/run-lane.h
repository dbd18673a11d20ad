/* Threads for the runs of one player, of which only the newest counts: two at most, one that works and one that is
 * still being ended. What comes while both are taken waits, and makes room for what comes after it. No widget. */
#ifndef TINKER_GUI_RUN_LANE_H
#define TINKER_GUI_RUN_LANE_H

#include <glib.h>

typedef struct _TinkerRunLane TinkerRunLane;

/* Of each item one of the two is called, once: `work` in a thread, or `drop` (in any) where a newer one has taken its
 * place. */
TinkerRunLane *tinker_run_lane_new(void (*work)(void *item), void (*drop)(void *item));
/* Threads go on with what they have. */
void tinker_run_lane_unref(TinkerRunLane *lane);

void tinker_run_lane_add(TinkerRunLane *lane, void *item);

#endif
