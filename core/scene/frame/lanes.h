/* Lanes: connectors between the same two places are shown side by side instead of on top of each other. */
#ifndef TINKER_CORE_LANES_H
#define TINKER_CORE_LANES_H

#include "scene/store/scene.h"

/* By block id: how many lanes a connector stands to the left of the line from the end with the lower block to the
 * other, as seen along it; 0 for a connector that is alone, and for all other blocks. Lanes of a group are 1 apart and
 * centred on the line. Neither end's order nor anything but ends attached at the same places matters. (transfer full,
 * g_free) */
double *tinker_lanes_new(TinkerScene *scene);

#endif
