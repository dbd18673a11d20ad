/* Blocks by the flags of their types. */
#ifndef TINKER_CORE_FLAGGED_H
#define TINKER_CORE_FLAGGED_H

#include "scene/store/scene.h"

/* The blocks whose types have this flag (TINKER_LEAVES_PATH, TINKER_HAS_SPAN), in the order of the scene; NULL where
 * there is none. Element: TinkerBlockId. (transfer full) */
GArray *tinker_scene_flagged(TinkerScene *scene, uint32_t flag);

#endif
