/* Words for the islands of a plan. */
#ifndef TINKER_HOST_PLAN_WORDS_H
#define TINKER_HOST_PLAN_WORDS_H

#include "physics/plan/plan.h"

/* An error or a difference that is less than this share of what it is a part of is rounding, and is told as that. */
#define TINKER_ROUNDING 1e-13

/* "Mass 0, Spring 0": the first blocks of an island, and how many more there are. (transfer full) */
char *tinker_island_blocks_text(const TinkerScene *scene, const TinkerIslandPlan *island);

/* "rk4, step 0.01 s" or "dop853, tolerance 1e-09": by the one of `step` (s) and `tolerance` that is above 0, else the
 * method alone. (transfer full) */
char *tinker_method_text(const char *method, double step, double tolerance);

/* What an island is planned to run with, as text. (transfer full) */
char *tinker_island_method_text(const TinkerIslandPlan *island);

#endif
