/* The difference of two states of a scene, by what it means to a run that is under way. */
#ifndef TINKER_CORE_DIFFERENCE_H
#define TINKER_CORE_DIFFERENCE_H

#include "scene/store/scene.h"

/* In ascending order: the greatest that applies counts. */
typedef enum {
    TINKER_DIFFERENCE_DRAWING, /* none, or names, graphs, titles, displayed units, order: the motion is the same */
    TINKER_DIFFERENCE_TUNABLE, /* properties that may change while a run is paused */
    TINKER_DIFFERENCE_START,   /* another start, another model or another way to run: begins anew */
} TinkerDifference;

/* How far `after` is from `before`, a copy of the same scene with the same ids. */
TinkerDifference tinker_scene_difference(const TinkerScene *before, const TinkerScene *after);

#endif
