/* Words for the islands of a plan. */
#ifndef TINKER_HOST_PLAN_WORDS_H
#define TINKER_HOST_PLAN_WORDS_H

#include "physics/plan.h"

/* "Mass 0, Spring 0": the first blocks of an island, and how many more there are. (transfer full) */
char *tinker_island_blocks_text(const TinkerScene *scene, const TinkerIslandPlan *island);

/* "rk4, step 0.01 s". (transfer full) */
char *tinker_island_method_text(const TinkerIslandPlan *island);

#endif
