/* What two scenes differ in, in words: names for the curves of one beside those of the other. */
#ifndef TINKER_CORE_CHANGES_H
#define TINKER_CORE_CHANGES_H

#include "scene/store/scene.h"

/* "Spring 0: K 25 → 50 N/m", of blocks of the same name and type, and of the settings of the run: the first two, and
 * how many there are besides. NULL where these do not differ. (transfer full) */
char *tinker_scene_changes(TinkerScene *before, TinkerScene *after);

/* "Spring 0: K 25 N/m": of the same, what they were in the first. NULL where these do not differ. (transfer full) */
char *tinker_scene_values_changed(TinkerScene *before, TinkerScene *after);

#endif
