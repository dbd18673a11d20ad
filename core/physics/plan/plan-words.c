/* What is modelled, and what is not because nothing asks for it: sentences from the compiled model, which knows roles
 * and no block by name. */
#include <glib/gi18n-lib.h>

#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/plan-words-private.h"

/* Where units do not come out. */
static void describe_typed_laws(TinkerPlan *plan, const TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (guint k = 0; batch->law_notes != NULL && k < batch->law_notes->len; k++)
            g_ptr_array_add(plan->modelled, g_strdup(g_ptr_array_index(batch->law_notes, k)));
    }
}

static gboolean any_nonlinear(const TinkerPlan *plan)
{
    for (guint i = 0; i < plan->islands->len; i++)
        if (!((const TinkerIslandPlan *)g_ptr_array_index(plan->islands, i))->linear) return TRUE;
    return FALSE;
}

static void describe_islands(TinkerPlan *plan)
{
    int32_t straight = 0, count = (int32_t)plan->islands->len;
    for (guint i = 0; i < plan->islands->len; i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->islands, i);
        straight += island->straight;
        if (island->sideways_growth > 0)
            tinker_warnings_add(
                plan->warnings, TINKER_WARNING_METHOD,
                g_strdup_printf(
                    _("straight motion is unstable, grows at %.3g/s: island %u is stepped in both coordinates, and any "
                      "disturbance across its line grows"),
                    island->sideways_growth, i + 1));
        else if (island->growth_max > 0)
            plan_say(plan->modelled, _("the start of island %u is unstable: what leaves it grows at %.3g/s"), i + 1,
                     island->growth_max);
    }
    if (count > 1)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%d island, each with its own method and step",
                             "%d islands, each with its own method and step", (gulong)count),
                 count);
    if (straight > 0)
        plan_say(plan->left_out,
                 g_dngettext(GETTEXT_PACKAGE, "motion across the line: %d island lies and moves along one line",
                             "motion across the line: %d islands lie and move along one line", (gulong)straight),
                 straight);
    if (!any_nonlinear(plan)) plan_say(plan->left_out, _("large-displacement geometry: all motion is linear"));
}

void tinker_plan_describe(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    plan_describe_bodies(plan, model, options);
    describe_islands(plan);
    plan_describe_lines(plan, model);
    plan_describe_fields(plan, model);
    plan_describe_forces(plan, model);
    plan_describe_constraints(plan, model);
    plan_describe_supports(plan, model);
    describe_typed_laws(plan, model);
    plan_describe_contact(plan, model, options);
    /* what feels velocities, or may, takes energy */
    if (!tinker_model_feels_velocities(model) && !plan_is_rough(model))
        plan_say(plan->left_out, _("damping: no block takes energy"));
    if (options->accuracy > 0)
        plan_say(
            plan->modelled,
            _("an accuracy of %g: steps and tolerances are chosen for it, and made tighter where the run’s own error "
              "estimate misses it"),
            options->accuracy);
    if (!options->estimate) plan_say(plan->left_out, _("the error estimate: it is switched off"));
}
