/* The plan: islands one by one, then sentences about the whole. */
#include "physics/plan/plan.h"

#include <math.h>

#include "numerics/methods/integrators.h"
#include "physics/constraint/constraints.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/plan/islands.h"
#include "physics/plan/operations.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/run-options.h"
#include "physics/plan/tolerances.h"
#include "physics/system/method-call.h"

/* Rows of one island up to which those that depend on others are named. */
#define MOST_NAMED 600

static void island_plan_free(gpointer data)
{
    TinkerIslandPlan *island = data;
    g_array_unref(island->blocks);
    tinker_spectrum_free(island->spectrum);
    g_free(island->reason);
    g_free(island);
}

static int compare_ids(const void *a, const void *b)
{
    return *(const TinkerBlockId *)a - *(const TinkerBlockId *)b;
}

/* Bodies, then what acts on them: everything with an end on one of them. */
static GArray *blocks_of(const TinkerModel *model)
{
    GArray *blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId)), *others;
    others = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    g_array_append_vals(blocks, model->body_blocks, (guint)model->bodies);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const int32_t *points = tinker_model_end_points(model, batch);
        for (int32_t row = 0; row < batch->count; row++) {
            gboolean acts = FALSE;
            for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++)
                acts |= points[e] < model->first_support;
            if (acts) g_array_append_val(others, batch->ids[row]);
        }
    }
    g_array_sort(blocks, compare_ids);
    g_array_sort(others, compare_ids);
    g_array_append_vals(blocks, others->data, others->len);
    g_array_unref(others);
    return blocks;
}

/* Whether a frequency is more than rounding: what pulls along and across a level bar or rod cancels to that. */
static gboolean swings(const TinkerIsland *island, double omega, const TinkerDecision *decision)
{
    return island->linear != NULL || omega > TINKER_LEAST_SWING * decision->speed_of_change;
}

/* Then nothing grows across its line. */
static gboolean is_straight(const TinkerIsland *island)
{
    return island->linear != NULL && tinker_linear_form_is_straight(island->linear, NULL);
}

static TinkerIslandPlan *plan_island(const TinkerIsland *island, const TinkerRunOptions *options, GPtrArray *warnings,
                                     GError **error)
{
    TinkerModelSizes sizes = tinker_model_sizes(island->model);
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(island);
    g_autoptr(GString) reason = g_string_new(NULL);
    TinkerDecision decision = {.reason = reason};
    if (!tinker_decide(island, options, spectrum, &decision, warnings, error)) return NULL;
    TinkerIslandPlan *plan = g_new0(TinkerIslandPlan, 1);
    *plan = (TinkerIslandPlan){
        .blocks = blocks_of(island->model),
        .bodies = sizes.bodies,
        .degrees_of_freedom = sizes.degrees_of_freedom,
        .constraint_rows = sizes.constraint_rows,
        .redundant_rows = sizes.redundant_rows,
        .linear = island->linear != NULL,
        .sideways_growth = is_straight(island) ? 0 : tinker_model_sideways_growth(island->model),
        .omega_max = swings(island, spectrum->omega_max, &decision) ? spectrum->omega_max : 0,
        .damping_max = spectrum->damping_max,
        .growth_max = spectrum->growth_max,
        .spectral_radius = options->spectral_radius,
        .choice = decision.choice,
        .evaluations = decision.cost.evaluations,
        .operations = decision.cost.operations,
        .reason = g_strdup(reason->str),
        .expected_error = decision.cost.error,
    };
    plan->operations += tinker_operations_samples(island, plan->choice.method, tinker_options_samples(options));
    plan->expected_s = plan->operations * TINKER_SECONDS_PER_OPERATION;
    plan->spectrum = g_steal_pointer(&spectrum);
    plan->shafts = island->linear != NULL && tinker_linear_form_is_of_shafts(island->linear);
    if (island->linear != NULL) plan->straight = tinker_linear_form_is_straight(island->linear, plan->direction);
    return plan;
}

/* Takes out of a row what lies along `count` others, which are of length 1 or 0; answers the length that is left, of 1.
 */
static double take_out(gsize n, gsize count, const double *others, double *row)
{
    double size = 0, left = 0;
    for (gsize i = 0; i < n; i++)
        size += row[i] * row[i];
    for (gsize k = 0; k < 2 * count; k++) { /* twice: once leaves rounding behind */
        const double *other = others + (k % count) * n;
        double part = 0;
        for (gsize i = 0; i < n; i++)
            part += other[i] * row[i];
        for (gsize i = 0; i < n; i++)
            row[i] -= part * other[i];
    }
    for (gsize i = 0; i < n; i++)
        left += row[i] * row[i];
    gboolean stays = size > 0 && left > TINKER_DEPENDENT_LENGTH * TINKER_DEPENDENT_LENGTH * size;
    for (gsize i = 0; i < n; i++)
        row[i] = stays ? row[i] / sqrt(left) : 0;
    return stays ? sqrt(left / size) : 0;
}

/* Names of the blocks whose rows depend, at the start, on those before them in the scene. */
static void name_redundant(TinkerModel *model, GPtrArray *names)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->redundant == 0 || all->rows > MOST_NAMED || tinker_model_set_time(model, 0.0) != TINKER_OK) return;
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (tinker_constraints_evaluate(model) != TINKER_OK) return;
    gsize n = (gsize)MAX(model->coordinates, 1);
    g_autofree double *rows = g_new0(double, n *(gsize)all->rows);
    g_autofree TinkerCoordinateEntry *entries = tinker_constraints_row_room(all);
    TinkerBlockId last = TINKER_NO_BLOCK;
    for (int32_t row = 0; row < all->rows; row++) {
        if (tinker_constraints_is_idle(all, row)) continue;
        double *own = rows + (gsize)row * n;
        const int32_t count = tinker_constraints_list_row(all, row, entries);
        for (int32_t k = 0; k < count; k++)
            if (entries[k].coordinate < model->coordinates)
                own[entries[k].coordinate] +=
                    entries[k].value * sqrt(model->inverse_mass[tinker_model_moved_by(model, entries[k].coordinate)]);
        if (take_out(n, (gsize)row, rows, own) > 0 || all->blocks[row] == last) continue;
        last = all->blocks[row];
        g_ptr_array_add(names, g_strdup(tinker_scene_block_name(model->scene, last)));
    }
}

TinkerPlan *tinker_plan_new(TinkerModel *model, GPtrArray *islands, const TinkerRunOptions *options, GError **error)
{
    if (!tinker_model_check_breaks(model, tinker_options_span(options), error)) return NULL;
    g_autoptr(TinkerPlan) plan = g_new0(TinkerPlan, 1);
    plan->accuracy = options->accuracy;
    plan->islands = g_ptr_array_new_with_free_func(island_plan_free);
    plan->redundant = g_ptr_array_new_with_free_func(g_free);
    plan->modelled = g_ptr_array_new_with_free_func(g_free);
    plan->left_out = g_ptr_array_new_with_free_func(g_free);
    plan->warnings = tinker_warnings_new();
    tinker_warnings_add_copies(plan->warnings, model->warnings);
    char *unmet = tinker_options_unmet(options, model);
    if (unmet != NULL) tinker_warnings_add(plan->warnings, TINKER_WARNING_SCENE, unmet);
    for (guint i = 0; i < islands->len; i++) {
        TinkerIslandPlan *island = plan_island(g_ptr_array_index(islands, i), options, plan->warnings, error);
        if (island == NULL) return NULL;
        g_ptr_array_add(plan->islands, island);
        name_redundant(((TinkerIsland *)g_ptr_array_index(islands, i))->model, plan->redundant);
    }
    tinker_plan_describe(plan, model, options);
    return g_steal_pointer(&plan);
}

void tinker_plan_free(TinkerPlan *plan)
{
    if (plan == NULL) return;
    GPtrArray *arrays[] = {plan->islands, plan->redundant, plan->modelled, plan->left_out, plan->warnings};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_clear_pointer(&arrays[i], g_ptr_array_unref);
    g_free(plan);
}

GPtrArray *tinker_plan_limited_methods(const TinkerIslandPlan *island)
{
    GPtrArray *methods = g_ptr_array_new();
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        if (tinker_method_is_fixed_explicit(*each)) g_ptr_array_add(methods, (gpointer)*each);
    gboolean contact = tinker_method_solves_contact(island->choice.method);
    if (!contact && tinker_method_is_fixed_explicit(island->choice.method) &&
        !g_ptr_array_find(methods, island->choice.method, NULL))
        g_ptr_array_add(methods, (gpointer)island->choice.method);
    return methods;
}

double tinker_plan_stable_step(const TinkerIslandPlan *island, const TinkerIntegrator *method)
{
    return tinker_spectrum_stable_step(island->spectrum, method, island->spectral_radius);
}
