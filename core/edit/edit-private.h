/* What hit and drag share: the edit interface that stands for a block. */
#ifndef TINKER_EDIT_PRIVATE_H
#define TINKER_EDIT_PRIVATE_H

#include "edit/drag.h"
#include "plugin/call/call.h"

#define MOST_HANDLES 128 /* of one block that are looked at */

/* The class's own interface, else the host's: of a connector its ends and the lines between them, of anything else
 * (NULL: of an unknown type) a spot around its centre that can be selected and not moved. Never NULL. */
const TinkerEdit *edit_of(const TinkerBlockClass *block_class);

/* The class, where that interface is its own; NULL where it is the host's. */
const TinkerBlockClass *edit_owner(const TinkerBlockClass *block_class);

/* The part of an instance that is hit: TINKER_PART_... or its number. */
int32_t edit_hit(const TinkerBlockClass *block_class, const TinkerInstance *instance, double x, double y, double reach);

/* The handles of an instance, none where the interface has none; never more than `room`. */
int32_t edit_handles(const TinkerBlockClass *block_class, const TinkerInstance *instance, TinkerHandle *handles,
                     int32_t room);

/* Whether this is a handle of an end of a long body that turns: one of two that are at both ends of its axis, as a bar
 * has them. A corner of a box is none. */
gboolean edit_is_handle_of_end(TinkerFrame *frame, TinkerHit hit);

/* The blocks under a point that the ends of this connector's type would accept, from the top of the picture down; at
 * most `room`. */
int32_t edit_hit_connectables(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach,
                              TinkerBlockId *blocks, int32_t room);

/* Whether an end that is dropped on this body stays at its place, without being asked to. */
gboolean edit_keeps_places(TinkerScene *scene, TinkerBlockId target);

/* Whether a body turns and is so long that it is held and joined by its ends, as a bar is. */
gboolean edit_has_ends(const TinkerFrame *frame, TinkerBlockId body);

/* Whether a block, or a joint, has an end on this one. */
gboolean edit_is_attached(const TinkerScene *scene, TinkerBlockId body);
gboolean edit_is_jointed(TinkerScene *scene, TinkerBlockId body);

/* A place in the axes of a block, from its centre; on a body that turns its centre or an end of it within `reach`. */
void edit_own_place(TinkerFrame *frame, TinkerBlockId target, const double place[2], double reach, double own[2]);

#endif
