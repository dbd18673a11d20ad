/* The plan of a document's scene, worked out in a thread a moment after the last edit. No widget.
 *
 * Of large scenes it is worked out on demand alone. Signals:
 *   "changed"   there is another result, or none any more
 */
#ifndef TINKER_GUI_PLAN_TASK_H
#define TINKER_GUI_PLAN_TASK_H

#include "gui/document/document.h"
#include "physics/plan/plan.h"

#define TINKER_TYPE_PLAN_TASK (tinker_plan_task_get_type())
G_DECLARE_FINAL_TYPE(TinkerPlanTask, tinker_plan_task, TINKER, PLAN_TASK, GObject)

#define TINKER_PLAN_MOST_BLOCKS 2000 /* of a scene that is planned without being asked */

/* What is known of the scene as it was when it was planned. */
typedef struct {
    TinkerScene *scene;   /* a copy of it */
    TinkerPlan *plan;     /* NULL where the scene cannot run */
    GError *error;        /* then: why */
    gboolean automatic;   /* the scene leaves the choice of the method to the plan */
    GPtrArray *avoidable; /* of the plan's warnings (borrowed from it), those that would not be were the method chosen
                             automatically */
} TinkerPlanResult;

/* Takes a reference of the document. (transfer full) */
TinkerPlanTask *tinker_plan_task_new(TinkerDocument *document);

/* The last result, or NULL. Borrowed until "changed". */
const TinkerPlanResult *tinker_plan_task_result(TinkerPlanTask *task);
/* Whether the scene is another than the result's, or there is none: a plan is under way, or has to be asked for. */
gboolean tinker_plan_task_is_due(TinkerPlanTask *task);
/* Plans now if it is due, however large the scene. */
void tinker_plan_task_demand(TinkerPlanTask *task);

#endif
