/* Editing the outline of a body corner by corner: of types with a list of points and a centre of mass in the axes of
 * these (TINKER_MEANING_CENTRE_OF_MASS). The other corners stay where they are in the world, wherever the centre of
 * mass comes to lie. All inside a step. */
#ifndef TINKER_CORE_OUTLINE_H
#define TINKER_CORE_OUTLINE_H

#include "scene/history/history.h"

/* Corners that an outline has at least. */
#define TINKER_LEAST_CORNERS 3

gboolean tinker_outline_is_of(const TinkerBlockClass *block_class);

/* 0 where the block has none. */
int32_t tinker_outline_corners(TinkerScene *scene, TinkerBlockId block);

/* Puts corner `number` to a place in the world (m). */
void tinker_outline_move(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t number,
                         const double place[2]);

/* A corner more, at this place, between the two whose edge is nearest to it. */
void tinker_outline_add(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, const double place[2]);

/* One corner less; an outline of TINKER_LEAST_CORNERS stays as it is. */
void tinker_outline_remove(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t number);

#endif
