/* How large a new block is: its type says it for a scene of ordinary width. */
#ifndef TINKER_CORE_FIRST_SIZE_H
#define TINKER_CORE_FIRST_SIZE_H

#include "scene/history/history.h"

/* Makes a new block as large for the scene as its type's sizes are for one of 10 m: by a round factor, 1, 2 or 5 times
 * a power of ten. Widths, heights, radii and corners; inside a step. */
void tinker_first_size(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block);

#endif
