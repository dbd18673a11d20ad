/* Plans of scenes, and their sentences. */
#ifndef TEST_PLAN_CHECKS_H
#define TEST_PLAN_CHECKS_H

#include "physics-fixture.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    GPtrArray *islands;
    TinkerPlan *plan; /* NULL where it was refused */
    GError *error;
} Planned;

void planned_clear(Planned *planned);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Planned, planned_clear)

TinkerRunOptions planned_options(const char *method, double step, double tolerance, double duration);

/* The blocks as of physics-fixture.h. */
Planned planned_new(const char *blocks, const TinkerRunOptions *options);
const TinkerIslandPlan *planned_island(const Planned *planned, guint number);

/* How many of the sentences hold a text. */
int planned_count_holding(const GPtrArray *sentences, const char *text);
/* Fails unless one of the sentences holds a text. */
void planned_assert_holds(const GPtrArray *sentences, const char *text);

/* Whether it warns of that once. */
void planned_assert_warns(const TinkerPlan *plan, const char *text);

#endif
