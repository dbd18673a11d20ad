/* The plan as JSON. */
#include <math.h>

#include <cjson/cJSON.h>

#include "cli/report/plan-report.h"
#include "cli/report/scene-json.h"
#include "common/program/print.h"

static void add_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value))
        cJSON_AddNumberToObject(object, key, value);
    else
        cJSON_AddNullToObject(object, key);
}

static void add_texts(cJSON *root, const char *key, const GPtrArray *texts)
{
    cJSON *array = cJSON_AddArrayToObject(root, key);
    for (guint i = 0; i < texts->len; i++)
        cJSON_AddItemToArray(array, cJSON_CreateString(g_ptr_array_index(texts, i)));
}

static void add_stable_steps(cJSON *object, const TinkerIslandPlan *island)
{
    cJSON *steps = cJSON_AddObjectToObject(object, "stable_step");
    g_autoptr(GPtrArray) methods = tinker_plan_limited_methods(island);
    for (guint i = 0; i < methods->len; i++) {
        const TinkerIntegrator *method = g_ptr_array_index(methods, i);
        double step = tinker_plan_stable_step(island, method);
        if (!isnan(step)) add_number(steps, method->id, step); /* that it is not known is no limit of none */
    }
}

static void add_island(cJSON *array, const TinkerPlanReport *report, const TinkerIslandPlan *island)
{
    cJSON *object = cJSON_CreateObject();
    tinker_json_add_names(object, report->scene, island->blocks);
    cJSON_AddStringToObject(object, "method", island->choice.method->id);
    if (island->choice.step > 0)
        add_number(object, "step", island->choice.step);
    else
        add_number(object, "tolerance", island->choice.tolerance);
    cJSON_AddStringToObject(object, "reason", island->reason);
    add_number(object, "omega_max", island->omega_max);
    add_number(object, "damping_max", island->damping_max);
    add_stable_steps(object, island);
    add_number(object, "expected_evaluations", island->evaluations);
    add_number(object, "expected_s", island->expected_s);
    add_number(object, "expected_error", island->expected_error);
    cJSON_AddItemToArray(array, object);
}

void tinker_plan_write_json(const TinkerPlanReport *report, FILE *file)
{
    const TinkerPlan *plan = report->plan;
    cJSON *root = cJSON_CreateObject();
    cJSON_AddNumberToObject(root, "bodies", report->sizes.bodies);
    cJSON_AddNumberToObject(root, "degrees_of_freedom", report->sizes.degrees_of_freedom);
    cJSON_AddNumberToObject(root, "constraints", report->sizes.constraint_rows);
    add_texts(root, "redundant_constraints", plan->redundant);
    add_number(root, "accuracy", plan->accuracy > 0 ? plan->accuracy : NAN);
    cJSON *islands = cJSON_AddArrayToObject(root, "islands");
    for (guint i = 0; i < plan->islands->len; i++)
        add_island(islands, report, g_ptr_array_index(plan->islands, i));
    add_texts(root, "modelled", plan->modelled);
    add_texts(root, "left_out", plan->left_out);
    add_texts(root, "libraries", report->libraries);
    add_texts(root, "warnings", report->warnings);

    char *text = cJSON_Print(root);
    tinker_print_text(file, text);
    cJSON_free(text);
    cJSON_Delete(root);
}
