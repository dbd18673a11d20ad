/* What is joined to a block follows it where that is moved: joints and lengths that are given hold while a scene is
 * being set up, too. Each call is part of a step of the history. */
#ifndef TINKER_CORE_JOINED_H
#define TINKER_CORE_JOINED_H

#include "scene/history/history.h"

/* Where a block is placed, how it is turned, and how large it is. */
typedef struct {
    TinkerBlockId block;
    double place[2];    /* m */
    double orientation; /* rad */
    double size[2];     /* m, along its own axes; 0: it has none */
} TinkerPlacement;

TinkerPlacement tinker_placement_of(const TinkerScene *scene, TinkerBlockId block);

/* The block was moved, turned or given another size since `before`: brings what is joined to it behind it, and itself
 * onto what holds it. What is attached at an edge stays at that edge, so that a longer bar has its pins further apart.
 * FALSE: nothing within reach fits, as it did before; the block is as it was, and the error names what does not fit.
 */
gboolean tinker_joined_follow(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before,
                              GError **error);

/* As tinker_joined_follow, of a body that a hand has moved by its place `grip` (m, in the body's own axes): where what
 * joins it does not let it go there, this place is brought as near to the hand (m) as that does, so that a crank
 * follows the hand by whatever it is held. */
gboolean tinker_joined_follow_hand(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before,
                                   const double grip[2], const double hand[2], GError **error);

/* Whether there are places where all that is joined to a block fits, with the block where it is. */
gboolean tinker_joined_can_be_brought(TinkerScene *scene, TinkerBlockId block);

/* Brings what is joined to a block to it, where the block is. What does not fit stays as it is. */
void tinker_joined_bring(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block);

/* The block was given another angular velocity: gives it, and what is joined to it, velocities that what joins them
 * allows. Errors as of tinker_assemble. */
gboolean tinker_joined_spin(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, GError **error);

#endif
