/* What hit and drag share: the edit interface that stands for a block. */
#ifndef TINKER_EDIT_PRIVATE_H
#define TINKER_EDIT_PRIVATE_H

#include "edit/drag.h"

#define MOST_HANDLES 16 /* of one block that are looked at */

/* The class's own interface, else the host's: of a connector its ends and the lines between them, of anything else (NULL:
 * of an unknown type) a spot around its centre that can be selected and not moved. Never NULL. */
const TinkerEdit *edit_of(const TinkerBlockClass *block_class);

/* The handles of an instance, none where the interface has none; never more than `room`. */
int32_t edit_handles(const TinkerEdit *edit, const TinkerInstance *instance, TinkerHandle *handles, int32_t room);

#endif
