/* Continuing a run that was paused: a scene whose t = 0 is a later time of another's run. */
#ifndef TINKER_CORE_CONTINUED_H
#define TINKER_CORE_CONTINUED_H

#include "scene/frame/frame.h"

/* A copy of the scene, with the same ids, that starts where a run of it stands at time t (s): bodies that can move are
 * where `now` has them and have these velocities (vx and vy in m/s, the rate in rad/s, by block id, 3 for each id that
 * the frame's scene has given); lengths "as placed" are what they were at the run's start; waveforms and instants go on
 * from t. Its properties are otherwise those of the scene, which may have been changed since the run was started:
 * blocks that the frame's scene does not have stay as they are. Local origins stay where they were. Tables that were
 * shifted have no form in a scene file, so such a scene is to be run, not saved. Fails where a value is out of its
 * property's range. (transfer full) */
TinkerScene *tinker_scene_continued(const TinkerScene *scene, const TinkerFrame *now, double t,
                                    const double *velocities, GError **error);

#endif
