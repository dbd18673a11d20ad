/* Ends: which bodies are so long that they have some, and what has its own on a body. */
#include "edit/edit-private.h"

#define LONG 3 /* times as long as high: what is held and joined at its ends */

gboolean edit_has_ends(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    const double width = tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0);
    return tinker_block_class_turns(block_class) && width > 0 &&
           width > LONG * tinker_frame_meaning(frame, block, TINKER_MEANING_HEIGHT, 0, 0);
}

gboolean tinker_is_joint(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const TinkerConstraint *constraint =
        block_class != NULL && block_class->physics != NULL ? block_class->physics->constraint : NULL;
    return constraint != NULL && constraint->joint != 0 && tinker_scene_end_count(scene, block) == 2;
}

gboolean edit_is_attached(const TinkerScene *scene, TinkerBlockId body)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        for (int32_t e = 0; e < tinker_scene_end_count(scene, block); e++)
            if (tinker_scene_end(scene, block, e).block == body) return TRUE;
    }
    return FALSE;
}

gboolean edit_is_jointed(TinkerScene *scene, TinkerBlockId body)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId joint = tinker_scene_block_at(scene, i);
        for (int32_t e = 0; e < 2 && tinker_is_joint(scene, joint); e++)
            if (tinker_scene_end(scene, joint, e).block == body) return TRUE;
    }
    return FALSE;
}
