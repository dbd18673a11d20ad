/* The parts of what a plan says of a whole model. */
#ifndef TINKER_CORE_PLAN_WORDS_PRIVATE_H
#define TINKER_CORE_PLAN_WORDS_PRIVATE_H

#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

/* Adds a sentence. */
void plan_say(GPtrArray *sentences, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* "1 body", "3 bodies" for a place in a sentence; the text is good until the next call with the same buffer. */
const char *plan_counted(char buffer[128], const char *format, ...) G_GNUC_PRINTF(2, 3);

/* plan-words-bodies.c: bodies, and their contact among themselves. */
void plan_describe_bodies(TinkerPlan *plan, const TinkerModel *model, const TinkerRunOptions *options);
/* How many bodies meet others; 0: none does. */
int32_t plan_count_meeting(const TinkerModel *model, const TinkerRunOptions *options);

/* plan-words-supports.c: what is held or moved by others: constraints, supports, and contact with these. */
void plan_describe_constraints(TinkerPlan *plan, const TinkerModel *model);
void plan_describe_supports(TinkerPlan *plan, TinkerModel *model);
void plan_describe_contact(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options);
gboolean plan_is_rough(const TinkerModel *model);

/* plan-words-forces.c: connectors, fields and other forces. */
void plan_describe_lines(TinkerPlan *plan, const TinkerModel *model);
void plan_describe_fields(TinkerPlan *plan, const TinkerModel *model);
void plan_describe_forces(TinkerPlan *plan, const TinkerModel *model);

#endif
