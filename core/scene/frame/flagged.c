#include "scene/frame/flagged.h"

GArray *tinker_scene_flagged(TinkerScene *scene, uint32_t flag)
{
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class != NULL && (block_class->type->flags & flag) != 0) g_array_append_val(blocks, block);
    }
    return blocks->len > 0 ? g_steal_pointer(&blocks) : NULL;
}
