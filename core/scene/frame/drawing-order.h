/* What lies above what: pictures are drawn from the lowest layer up, and what is hit is looked for from the top down.
 */
#ifndef TINKER_CORE_DRAWING_ORDER_H
#define TINKER_CORE_DRAWING_ORDER_H

#include "scene/frame/frame.h"

/* Supports, bodies, pivots, connectors, forces and fields. */
#define TINKER_LAYERS 5

/* The layer of a block, as its type declares it; where that says nothing, connectors lie above bodies. A pivot, a
 * support that is not solid, lies above bodies: what hangs on it would hide it. */
int32_t tinker_frame_layer(const TinkerFrame *frame, TinkerBlockId block);

#endif
