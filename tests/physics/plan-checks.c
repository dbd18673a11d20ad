#include "plan-checks.h"

#include <string.h>

#include "physics/compile/compile.h"

void planned_clear(Planned *planned)
{
    tinker_plan_free(planned->plan);
    g_ptr_array_unref(planned->islands);
    tinker_model_free(planned->model);
    tinker_scene_free(planned->scene);
    g_clear_error(&planned->error);
}

TinkerRunOptions planned_options(const char *method, double step, double tolerance, double duration)
{
    return (TinkerRunOptions){.duration = duration,
                              .interval = 0.01 * duration,
                              .method = method,
                              .step = step,
                              .tolerance = tolerance,
                              .spectral_radius = 0.8,
                              .estimate = TRUE};
}

Planned planned_new(const char *blocks, const TinkerRunOptions *options)
{
    g_autoptr(GError) error = NULL;
    Planned planned = {.scene = physics_scene(NULL, blocks)};
    planned.model = tinker_model_new(planned.scene, &error);
    if (planned.model != NULL) planned.islands = tinker_islands_new(planned.model, &error);
    if (planned.islands == NULL) g_error("%s", error->message);
    planned.plan = tinker_plan_new(planned.model, planned.islands, options, &planned.error);
    return planned;
}

const TinkerIslandPlan *planned_island(const Planned *planned, guint number)
{
    g_assert_cmpuint(number, <, planned->plan->islands->len);
    return g_ptr_array_index(planned->plan->islands, number);
}

int planned_count_holding(const GPtrArray *sentences, const char *text)
{
    int count = 0;
    for (guint i = 0; i < sentences->len; i++)
        count += strstr(g_ptr_array_index(sentences, i), text) != NULL;
    return count;
}

void planned_assert_holds(const GPtrArray *sentences, const char *text)
{
    if (planned_count_holding(sentences, text) == 1) return;
    for (guint i = 0; i < sentences->len; i++)
        g_test_message("%s", (const char *)g_ptr_array_index(sentences, i));
    g_test_fail_printf("\"%s\" is in %d sentences, not in one", text, planned_count_holding(sentences, text));
}

void planned_assert_warns(const TinkerPlan *plan, const char *text)
{
    g_autoptr(GPtrArray) sentences = tinker_warnings_texts(plan->warnings);
    planned_assert_holds(sentences, text);
}
