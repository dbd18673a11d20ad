/* What a quantity of a block is by the places of a frame alone: for read-outs where nothing has been run. */
#ifndef TINKER_CORE_FRAME_QUANTITY_H
#define TINKER_CORE_FRAME_QUANTITY_H

#include "scene/frame/frame.h"

/* The quantity of this number (SI), as its block's plugin tells it when everything stands still where the frame has it.
 * FALSE where it cannot be told so (a placeholder, a detached end, a quantity that needs accelerations or the force of
 * a constraint), or is not finite. */
gboolean tinker_frame_quantity(TinkerFrame *frame, TinkerBlockId block, int32_t quantity, double *value);

#endif
