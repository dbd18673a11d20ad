/* Compiling, third part: constraint rows. */
#include <math.h>
#include <string.h>

#include "physics/compile/compile-private.h"
#include "physics/compile/constraint-parts.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/pin-chains.h"
#include "physics/constraint/row-chains.h"
#include "physics/constraint/straight-bars.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/angles.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

static int32_t ends_of(const TinkerBlockBatch *batch, int32_t row)
{
    return batch->end_offsets[row + 1] - batch->end_offsets[row];
}

/* The distances that the rows keep, where they do nothing else and say so; else NULL. (transfer full) */
static double *distances_of(const TinkerBlockBatch *batch, TinkerBatch *view)
{
    const TinkerConstraint *constraint = batch->block_class->physics->constraint;
    if (constraint->distance == NULL || constraint->prescribed_rate != NULL) return NULL;
    if (constraint->rows != 1 || view->ends != 2) return NULL;
    g_autofree double *length = g_new0(double, view->count);
    TinkerStatus status = TINKER_CALL_BATCH(batch, "distance", view, constraint->distance(view, length));
    return status == TINKER_OK ? g_steal_pointer(&length) : NULL;
}

static gboolean is_coincident(const TinkerBlockBatch *batch, const TinkerBatch *view)
{
    const TinkerConstraint *constraint = batch->block_class->physics->constraint;
    return constraint->coincident != 0 && constraint->rows == 2 && view->ends == 2 && constraint->angles == 0 &&
           constraint->prescribed_rate == NULL && constraint->unilateral == 0;
}

static void add_constraint_batch(TinkerModel *model, TinkerBlockBatch *batch)
{
    TinkerConstraints *all = &model->constraints;
    const TinkerConstraint *constraint = batch->block_class->physics->constraint;
    TinkerConstraintBatch added = {
        .batch = batch,
        .constraint = constraint,
        .end_points = tinker_model_end_points(model, batch),
        .first_row = all->rows,
        .row_count = batch->count * constraint->rows,
        .first_entry = all->entries,
        .angles = tinker_model_angles(model, batch),
        .view = tinker_block_batch_view(batch, 0.0),
    };
    memcpy(added.view.origin, model->origin, sizeof(model->origin));
    added.distances = distances_of(batch, &added.view);
    added.coincident = is_coincident(batch, &added.view);
    all->rows += added.row_count;
    all->entries += (added.angles != NULL ? 2 : 1) * batch->end_count * constraint->rows;
    g_array_append_val(all->batches, added);
}

static void number_entries(TinkerConstraints *all, const TinkerConstraintBatch *part)
{
    int32_t row = part->first_row, entry = part->first_entry;
    for (int32_t i = 0; i < part->batch->count; i++)
        for (int32_t r = 0; r < part->constraint->rows; r++, row++) {
            all->row_starts[row] = entry;
            all->blocks[row] = part->batch->ids[i];
            for (int32_t k = 0; k < ends_of(part->batch, i); k++, entry++) {
                all->row_of[entry] = row;
                all->ends_at[entry] = part->end_points[part->batch->end_offsets[i] + k];
            }
            for (int32_t k = 0; part->angles != NULL && k < ends_of(part->batch, i); k++, entry++) {
                all->row_of[entry] = row;
                all->ends_at[entry] = part->angles->turns[part->batch->end_offsets[i] + k];
            }
            all->two_entries &= entry - all->row_starts[row] == 2;
        }
    all->row_starts[row] = entry;
}

/* Rows that keep bars straight stand behind those of blocks. */
static void add_straight_rows(TinkerConstraints *all, GArray *straight)
{
    all->straight = straight;
    all->first_straight = all->rows;
    all->rows += (int32_t)straight->len;
    all->entries += 3 * (int32_t)straight->len;
}

static void number_straight_entries(TinkerConstraints *all)
{
    int32_t entry = all->entries - 3 * (int32_t)all->straight->len;
    for (guint i = 0; i < all->straight->len; i++) {
        const TinkerStraightRow *of = &g_array_index(all->straight, TinkerStraightRow, i);
        int32_t row = all->first_straight + (int32_t)i;
        all->blocks[row] = of->rod;
        all->scales[row] = of->length;
        all->inverse_scales[row] = 1 / of->length;
        for (int k = 0; k < 3; k++, entry++) {
            all->row_of[entry] = row;
            all->ends_at[entry] = k == 0 ? of->first : k == 1 ? of->between : of->last;
        }
        all->row_starts[row + 1] = entry;
        all->two_entries = FALSE;
    }
}

/* Where bodies turn: whom the entries belong to, and which of them turn their body. */
static gboolean number_turns(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    all->turns = ALLOT(model, TinkerTurnEntry, all->entries);
    all->turn_starts = ALLOT(model, int32_t, all->rows + 1);
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (int32_t e = 0; e < all->entries; e++) {
        const int32_t body = tinker_model_body_of(model, all->ends_at[e]);
        all->points[e] = body >= 0 ? body : all->ends_at[e];
        if (body < 0 || all->ends_at[e] == body) continue;
        const int32_t turn = model->turn_of[body];
        all->turns[all->turn_count++] = (TinkerTurnEntry){e, all->row_of[e], all->ends_at[e] - model->first_attachment,
                                                          turn, 2 * model->bodies + turn};
        all->turn_starts[all->row_of[e] + 1]++;
    }
    for (int32_t row = 0; row < all->rows; row++)
        all->turn_starts[row + 1] += all->turn_starts[row];
    all->jacobian_size += (gsize)all->turn_count;
    return TRUE;
}

static gboolean allot(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    gsize rows = (gsize)MAX(all->rows, 1), entries = (gsize)MAX(all->entries, 1);
    int32_t most_ends = 1;
    for (guint i = 0; i < all->batches->len; i++)
        most_ends = MAX(most_ends, g_array_index(all->batches, TinkerConstraintBatch, i).batch->end_count);
    all->row_starts = ALLOT(model, int32_t, rows + 1);
    all->points = ALLOT(model, int32_t, entries);
    all->ends_at = model->turning > 0 ? ALLOT(model, int32_t, entries) : all->points;
    all->row_of = ALLOT(model, int32_t, entries);
    all->scales = ALLOT(model, double, rows);
    all->inverse_scales = ALLOT(model, double, rows);
    all->asked = ALLOT(model, double, rows);
    all->idle = ALLOT(model, TinkerIdleRow, rows);
    all->blocks = ALLOT(model, TinkerBlockId, rows);
    all->ends = ALLOT(model, TinkerPoint, most_ends);
    all->g = ALLOT(model, double, rows);
    all->drift = ALLOT(model, double, rows);
    all->rate = ALLOT(model, double, rows);
    all->lambda = ALLOT(model, double, rows);
    all->residual = ALLOT(model, double, rows);
    all->correction = ALLOT(model, double, rows);
    all->displacement = ALLOT(model, double, (gsize)MAX(model->coordinates, 1));
    all->by_point = ALLOT(model, double, 2 * (gsize)MAX(model->points, 1));
    return !model->lacks_memory || tinker_constraints_lack_memory(model, error);
}

static gboolean allot_jacobians(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    double **jacobians[] = {&all->jacobian, &all->factored_jacobian, &all->kept_jacobian, &all->kept_factored_jacobian,
                            &all->turned};
    for (gsize i = 0; i < G_N_ELEMENTS(jacobians); i++)
        *jacobians[i] = ALLOT(model, double, all->jacobian_size);
    return !model->lacks_memory || tinker_constraints_lack_memory(model, error);
}

/* Where any row holds in one direction only. */
static gboolean allot_unilateral(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    gboolean any = FALSE;
    gsize rows = (gsize)all->rows;
    for (guint i = 0; i < all->batches->len; i++)
        any |= g_array_index(all->batches, TinkerConstraintBatch, i).constraint->unilateral != 0;
    if (!any) return TRUE;
    all->unilateral = ALLOT(model, gboolean, rows);
    all->slack = ALLOT(model, gboolean, rows);
    all->diagonal = ALLOT(model, int32_t, rows);
    all->own_g = ALLOT(model, double, rows);
    all->own_drift = ALLOT(model, double, rows);
    all->own_rate = ALLOT(model, double, rows);
    all->own_jacobian = ALLOT(model, double, all->jacobian_size);
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
            all->unilateral[row] = part->constraint->unilateral != 0;
            all->diagonal[row] = tinker_sparse_ldl_slot(all->ldl, row, row);
        }
    }
    return TRUE;
}

/* With these rows that keep bars straight. (transfer full) */
static gboolean compile_with(TinkerModel *model, GArray *straight, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    all->batches = g_array_new(FALSE, FALSE, sizeof(TinkerConstraintBatch));
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->constraint == NULL) continue;
        add_constraint_batch(model, batch);
        if (physics->constraint->prescribed_rate != NULL)
            model->has_book[TINKER_BOOK_MOTORS] = model->more_than_lines = TRUE;
    }
    add_straight_rows(all, straight);
    if (all->rows == 0) return TRUE;
    if (!allot(model, error)) return FALSE;
    all->two_entries = TRUE;
    all->shift = TINKER_PROXIMAL_SHIFT;
    for (guint i = 0; i < all->batches->len; i++)
        number_entries(all, &g_array_index(all->batches, TinkerConstraintBatch, i));
    number_straight_entries(all);
    all->jacobian_size = 2 * (gsize)all->entries;
    if (model->turning > 0 && !number_turns(model, error)) return FALSE;
    if (!allot_jacobians(model, error)) return FALSE;
    tinker_constraints_find_scales(model);
    if (!tinker_constraints_compile_pattern(model, error)) return FALSE;
    if (!allot_unilateral(model, error)) return FALSE;
    if (all->unilateral == NULL) all->chains = tinker_row_chains_new(model);
    if (all->unilateral == NULL && all->chains == NULL) all->pin_chains = tinker_pin_chains_new(model);
    return TRUE;
}

/* Of each batch, as bars have them. (transfer full) */
static GPtrArray *take_distances(TinkerConstraints *all)
{
    GPtrArray *distances = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; i < all->batches->len; i++)
        g_ptr_array_add(distances, g_steal_pointer(&g_array_index(all->batches, TinkerConstraintBatch, i).distances));
    return distances;
}

/* Bars are looked for where the supports stand at the start, and where the other rows hold straight what they hold,
 * they do without rows of their own. */
gboolean tinker_model_compile_constraints(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    if (!compile_with(model, g_array_new(FALSE, FALSE, sizeof(TinkerStraightRow)), error)) return FALSE;
    if (all->rows < 2 || tinker_model_set_time(model, 0.0) != TINKER_OK) return TRUE;
    tinker_model_set_state(model, model->q_start, model->v_start);
    int32_t fitted;
    g_autoptr(GArray) straight = tinker_straight_rows_find(model, &fitted);
    all->fitted = fitted;
    if (straight->len == 0 || !tinker_straight_rows_drop_held(model, straight) || straight->len == 0) return TRUE;
    g_autoptr(GPtrArray) distances = take_distances(all);
    tinker_constraints_clear(all);
    *all = (TinkerConstraints){0};
    if (!compile_with(model, g_array_ref(straight), error)) return FALSE;
    all->fitted = fitted;
    for (guint i = 0; i < all->batches->len; i++) {
        double **own = &g_array_index(all->batches, TinkerConstraintBatch, i).distances;
        g_free(*own);
        *own = g_steal_pointer(&distances->pdata[i]);
    }
    return TRUE;
}

void tinker_constraints_clear(TinkerConstraints *all)
{
    for (guint i = 0; all->batches != NULL && i < all->batches->len; i++)
        g_free(g_array_index(all->batches, TinkerConstraintBatch, i).distances);
    if (all->batches != NULL) g_array_unref(all->batches);
    if (all->straight != NULL) g_array_unref(all->straight);
    tinker_sparse_ldl_free(all->ldl);
    tinker_row_chains_free(all->chains);
    tinker_pin_chains_free(all->pin_chains);
    if (all->ends_at != all->points) g_free(all->ends_at);
    g_free(all->turn_starts);
    gpointer arrays[] = {all->turns,          all->turn_products,
                         all->row_starts,     all->products,
                         all->points,         all->scales,
                         all->blocks,         all->ends,
                         all->jacobian,       all->g,
                         all->drift,          all->rate,
                         all->lambda,         all->residual,
                         all->correction,     all->by_point,
                         all->turned,         all->displacement,
                         all->row_of,         all->body_starts,
                         all->body_entries,   all->factored_jacobian,
                         all->kept_jacobian,  all->kept_factored_jacobian,
                         all->inverse_scales, all->asked,
                         all->unilateral,     all->slack,
                         all->diagonal,       all->own_g,
                         all->own_drift,      all->own_rate,
                         all->own_jacobian,   all->idle,
                         all->hubs,           all->hub_entries,
                         all->hub_masses,     all->bordered,
                         all->repeated,       all->repeats};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
}
