/* The hand on a control: sets a number of a block, again and again, and has the run made anew each time, so that curves
 * follow it. No widget.
 *
 * A run is given up when the number changes. But as a hand moves faster than a long run, each run has a quarter of a
 * second before the next one takes its place: else no curve would ever be seen whole. These runs go without an estimate
 * of their error, which takes as long again; the last one gets it as soon as the hand rests. */
#ifndef TINKER_GUI_HAND_H
#define TINKER_GUI_HAND_H

#include "gui/document/player.h"

#define TINKER_HAND_RUNS 20.0 /* a second: as many look like one motion, and need not be told */

typedef struct _TinkerHand TinkerHand;

/* Takes references. (transfer full) */
TinkerHand *tinker_hand_new(TinkerDocument *document, TinkerPlayer *player);
void tinker_hand_free(TinkerHand *hand);

/* The number `name` of a block (see tinker_scene_find_number) is to be `value` (SI). What is set of one number without
 * a pause is one step for undo. Of static and dynamic friction the other one goes along where it has to, and comes back
 * as the number does. */
void tinker_hand_set(TinkerHand *hand, TinkerBlockId block, const char *name, double value);
/* A new step for undo begins, as the hand lets go. */
void tinker_hand_let_go(TinkerHand *hand);

/* What the number is about to become, where it still waits; FALSE where it does not. */
gboolean tinker_hand_wanted(TinkerHand *hand, TinkerBlockId block, const char *name, double *value);
/* A second number of the block that the hand has changed, as it had to. */
typedef struct {
    int32_t property;
    double before, now; /* SI */
} TinkerCarried;

/* What went along with the number `name` of a block, and has not come back; FALSE: nothing, or the number still waits.
 */
gboolean tinker_hand_carried(TinkerHand *hand, TinkerBlockId block, const char *name, TinkerCarried *carried);
/* Runs a second that there is time for; 0 where nobody knows yet. */
double tinker_hand_rate(TinkerHand *hand);
/* Why the scene did not take the last value, or NULL. Borrowed. */
const char *tinker_hand_problem(TinkerHand *hand);

#endif
