/* What the plan says of the method and the step that a scene asks for. */
#include <glib/gi18n-lib.h>

#include "analysis/advice-private.h"
#include "physics/compile/compile.h"
#include "physics/linearise/linearise.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

/* One that says what would change: the method chosen automatically, if it is not already. */
static void tell(GPtrArray *all, const TinkerRunOptions *options, const TinkerModel *model, gboolean blocks_run,
                 const char *message)
{
    TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_METHOD, blocks_run, g_strdup(message));
    const int32_t bodies = tinker_model_sizes(model).bodies;
    for (int32_t i = 0; i < bodies; i++)
        advice_add_block(advice, tinker_model_body_block(model, i));
    advice->contacts_apart = options->impulses;
    if (options->impulses)
        advice->repair = g_strdup(_("Treat contacts as events and choose the method automatically"));
    else if (!g_str_equal(options->method, "auto"))
        advice->repair = g_strdup(_("Choose the method automatically"));
}

GPtrArray *tinker_advice_plan_new(TinkerScene *scene)
{
    GPtrArray *all = advice_array_new();
    const TinkerRunOptions options = tinker_run_options_of(scene);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, NULL);
    g_autoptr(GPtrArray) islands = model == NULL ? NULL : tinker_islands_for(model, options.impulses, NULL);
    for (guint i = 0; islands != NULL && i < islands->len; i++) {
        const TinkerIsland *island = g_ptr_array_index(islands, i);
        g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
        g_autoptr(GError) error = NULL;
        TinkerChoice choice;
        const gboolean chosen = tinker_plan_choose(island, &options, &choice, warnings, &error);
        for (guint k = 0; k < warnings->len; k++)
            tell(all, &options, island->model, FALSE, g_ptr_array_index(warnings, k));
        if (!chosen) tell(all, &options, island->model, TRUE, error->message);
    }
    return all;
}
