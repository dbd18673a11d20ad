/* What a plan says of forces: of connectors, of fields, and of all others. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/model/model-data.h"
#include "physics/plan/plan-words-private.h"

static int32_t count_asked(const GArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return count;
}

void plan_describe_lines(TinkerPlan *plan, const TinkerModel *model)
{
    char linear[128], merged[128];
    int32_t laws = 0, asked = count_asked(model->asked_lines);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) laws += batch->count;
    }
    if (laws - asked > 0)
        plan_say(plan->modelled, _("%s with a linear law, stepped as %s"),
                 plan_counted(linear,
                              g_dngettext(GETTEXT_PACKAGE, "%d connector", "%d connectors", (gulong)(laws - asked)),
                              laws - asked),
                 plan_counted(merged, g_dngettext(GETTEXT_PACKAGE, "%d line", "%d lines", (gulong)model->lines.count),
                              model->lines.count));
    if (asked > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%d connector with a nonlinear law, asked at every evaluation",
                             "%d connectors with a nonlinear law, asked at every evaluation", (gulong)asked),
                 asked);
    if (laws == 0)
        plan_say(plan->left_out, _("elastic and viscous connectors: there are none"));
    else if (asked == 0)
        plan_say(plan->left_out, _("nonlinear laws: every connector's law is linear"));
}

void plan_describe_fields(TinkerPlan *plan, const TinkerModel *model)
{
    double gravity = hypot(model->field_acceleration[0], model->field_acceleration[1]);
    int32_t asked = count_asked(model->asked_fields);
    if (gravity > 0)
        plan_say(plan->modelled, _("a uniform acceleration of %g m/s² on every body"), gravity);
    else if (asked == 0)
        plan_say(plan->left_out, _("gravity: no block asks for it"));
    if (model->field_drag != 0 || model->field_force[0] != 0 || model->field_force[1] != 0)
        plan_say(plan->modelled, _("air that moves or resists: a force linear in each body's velocity"));
    else if (asked == 0)
        plan_say(plan->left_out, _("air: no block makes it resist or blow"));
    if (asked > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%d field that the state changes, asked at every evaluation",
                             "%d fields that the state changes, asked at every evaluation", (gulong)asked),
                 asked);
}

/* How many joints move as they are told, such as drives. */
static int32_t count_prescribed(const TinkerConstraints *all)
{
    int32_t count = 0;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->constraint->prescribed_rate != NULL) count += part->batch->count;
    }
    return count;
}

void plan_describe_forces(TinkerPlan *plan, const TinkerModel *model)
{
    int32_t asked = count_asked(model->asked_forces), prescribed = count_prescribed(&model->constraints);
    if (model->driven->len > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%u force of time alone", "%u forces of time alone",
                             (gulong)model->driven->len),
                 model->driven->len);
    if (asked > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%d force that depends on the state",
                             "%d forces that depend on the state", (gulong)asked),
                 asked);
    if (prescribed > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%d prescribed motion of a joint, and the force or torque that it takes",
                             "%d prescribed motions of joints, and the forces or torques that they take",
                             (gulong)prescribed),
                 prescribed);
    if (model->driven->len == 0 && asked == 0 && prescribed == 0 && model->constant_force == NULL)
        plan_say(plan->left_out, _("driving forces: no block applies one"));
}
