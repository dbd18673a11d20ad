/* Laying a body on a top, as the file does by "on" and "along" (place-on.c). */
#include <math.h>

#include "scene/frame/tops.h"
#include "scene/store/scene-data.h"

gboolean tinker_scene_lay_on(TinkerScene *scene, TinkerBlockId block, TinkerBlockId plate, double along, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const TinkerBlockClass *plate_class = tinker_scene_block_class(scene, plate);
    const char *name = tinker_scene_block_name(scene, block), *on_name = tinker_scene_block_name(scene, plate);
    const gboolean can = tinker_class_can_lie(block_class) && plate_class != NULL && tinker_class_has_top(plate_class);
    if (!can || block == plate) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                    "%s cannot lie on %s (what can move lies on what has a top, as a mass on a support)", name,
                    on_name);
        return FALSE;
    }
    TinkerFrame *frame = tinker_frame_new(scene, error);
    if (frame == NULL) return FALSE;
    const TinkerTop top = tinker_top_of(frame, plate);
    tinker_frame_free(frame);
    if (!(fabs(along) <= top.half_width)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                    "%s cannot lie %g m along the top of %s (it reaches from %g m to %g m)", name, along, on_name,
                    -top.half_width, top.half_width);
        return FALSE;
    }
    const int32_t orientation = block_class->meanings[TINKER_MEANING_ORIENTATION];
    tinker_scene_unset(scene, block, block_class->meanings[TINKER_MEANING_POSITION]);
    if (orientation >= 0) tinker_scene_unset(scene, block, orientation);
    scene_set_place_on(scene, block, &(ScenePlaceOn){plate, along});
    scene_settle(scene);
    return TRUE;
}
