/* The layers of pictures: those that types declare, and one more for pivots between bodies and connectors. */
#include "scene/frame/drawing-order.h"

#include <tinker/render.h>

enum { SUPPORTS, BODIES, PIVOTS, CONNECTORS, FORCES };

int32_t tinker_frame_layer(const TinkerFrame *frame, TinkerBlockId block)
{
    static const int32_t of_declared[] = {SUPPORTS, BODIES, CONNECTORS, FORCES};
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    if (block_class == NULL) return BODIES;
    if (block_class->render == NULL) return block_class->type->least_ends > 0 ? CONNECTORS : BODIES;
    const int32_t declared = CLAMP(block_class->render->layer, 0, (int32_t)G_N_ELEMENTS(of_declared) - 1);
    const gboolean is_pivot = declared == 0 && tinker_frame_meaning(frame, block, TINKER_MEANING_SOLID, 0, 1) == 0;
    return is_pivot ? PIVOTS : of_declared[declared];
}
