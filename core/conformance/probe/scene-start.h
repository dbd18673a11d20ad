/* Start positions that fit a constraint. */
#ifndef TINKER_CONFORMANCE_SCENE_START_H
#define TINKER_CONFORMANCE_SCENE_START_H

#include "conformance/probe/kit.h"
#include "scene/store/scene.h"

/* Moves the bodies at the ends of a constraint to where it holds at t = 0, as far as steps of its own rows and Jacobian
 * lead there. Each end is to have a body of its own. Other blocks are left as they are. */
void kit_fit_start(KitCheck *check, TinkerScene *scene, TinkerBlockId block);

#endif
