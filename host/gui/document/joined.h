/* What is joined to a block follows it where a hand moves that: joints and lengths that are given hold while a scene is
 * being set up, too. */
#ifndef TINKER_GUI_JOINED_H
#define TINKER_GUI_JOINED_H

#include "scene/history/history.h"

/* Where a block is placed, and how it is turned. */
typedef struct {
    TinkerBlockId block;
    double place[2];    /* m */
    double orientation; /* rad */
} TinkerPlacement;

TinkerPlacement tinker_placement_of(const TinkerScene *scene, TinkerBlockId block);

/* Inside a step in which the block was moved or turned away from `before`: brings what is joined to it behind it, and
 * itself onto what holds it. FALSE: nothing within reach fits, as it did before; the block is back there, and the error
 * names what does not fit. */
gboolean tinker_joined_follow(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before,
                              GError **error);

/* Inside a step: brings what is joined to a block to it, where the block is. What does not fit stays as it is. */
void tinker_joined_bring(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block);

#endif
