/* Where blocks that leave a path (TINKER_LEAVES_PATH) have been. */
#ifndef TINKER_CORE_PATHS_H
#define TINKER_CORE_PATHS_H

#include "scene/store/scene.h"

typedef struct _TinkerPaths TinkerPaths;

/* One for each block of the scene that leaves a path, empty; NULL where there is none. (transfer full) */
TinkerPaths *tinker_paths_new(TinkerScene *scene);
void tinker_paths_free(TinkerPaths *paths);

/* The blocks, in the order of the scene. Borrowed. */
const TinkerBlockId *tinker_paths_blocks(const TinkerPaths *paths, int32_t *count);

/* The time (s) of the last places noted; -INFINITY where there are none. */
double tinker_paths_last(const TinkerPaths *paths);

/* Notes the places (x, y of each block in order, m) at time t, which is later than the last. */
void tinker_paths_note(TinkerPaths *paths, double t, const double *places);

/* x, y of a block's places that were noted up to time t. Borrowed until the next is noted. NULL and 0 of a block that
 * leaves none. */
const double *tinker_paths_of(const TinkerPaths *paths, TinkerBlockId block, double t, int32_t *count);

#endif
