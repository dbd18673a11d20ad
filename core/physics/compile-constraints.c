/* Compiling, third part: constraint rows, and the pattern of S = J M^-1 J^T. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/row-chains.h"

/* Beyond this many products a factorisation takes longer, and more memory, than anybody has. */
#define MOST_PRODUCTS 2e7

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
        .view = tinker_block_batch_view(batch, 0.0),
    };
    memcpy(added.view.origin, model->origin, sizeof(model->origin));
    added.distances = distances_of(batch, &added.view);
    all->rows += added.row_count;
    all->entries += batch->end_count * constraint->rows;
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
                all->points[entry] = part->end_points[part->batch->end_offsets[i] + k];
            }
            all->two_entries &= entry - all->row_starts[row] == 2;
        }
    all->row_starts[row] = entry;
}

static void allot(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    gsize rows = (gsize)MAX(all->rows, 1), entries = (gsize)MAX(all->entries, 1);
    int32_t most_ends = 1;
    for (guint i = 0; i < all->batches->len; i++)
        most_ends = MAX(most_ends, g_array_index(all->batches, TinkerConstraintBatch, i).batch->end_count);
    all->row_starts = g_new0(int32_t, rows + 1);
    all->points = g_new0(int32_t, entries);
    all->row_of = g_new0(int32_t, entries);
    all->factored_jacobian = g_new0(double, 2 * entries);
    all->scales = g_new0(double, rows);
    all->inverse_scales = g_new0(double, rows);
    all->asked = g_new0(double, rows);
    all->blocks = g_new0(TinkerBlockId, rows);
    all->ends = g_new0(TinkerPoint, most_ends);
    all->jacobian = g_new0(double, 2 * entries);
    all->g = g_new0(double, rows);
    all->drift = g_new0(double, rows);
    all->rate = g_new0(double, rows);
    all->lambda = g_new0(double, rows);
    all->residual = g_new0(double, rows);
    all->correction = g_new0(double, rows);
    all->turned = g_new0(double, 2 * entries);
    all->displacement = g_new0(double, 2 * (gsize)MAX(model->bodies, 1));
    all->by_point = g_new0(double, 2 * (gsize)MAX(model->points, 1));
}

/* The rows' lengths: the block's own word, else the largest distance between its ends at the start. */
static void measure(TinkerModel *model, const TinkerConstraintBatch *part)
{
    TinkerConstraints *all = &model->constraints;
    double *scale = all->scales + part->first_row;
    TinkerBatch view = tinker_block_batch_view(part->batch, 0.0);
    gboolean told = part->constraint->scale != NULL &&
                    TINKER_CALL_BATCH(part->batch, "scale", &view, part->constraint->scale(&view, scale)) == TINKER_OK;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
        all->inverse_scales[row] = 1.0 / all->scales[row];
        if (told && all->scales[row] > 0) continue;
        double largest = 0;
        const TinkerPoint *first = &model->point[all->points[all->row_starts[row]]];
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            const TinkerPoint *other = &model->point[all->points[e]];
            largest = MAX(largest, hypot(other->x - first->x, other->y - first->y));
        }
        all->scales[row] = largest > 0 ? largest : 1.0;
        all->inverse_scales[row] = 1.0 / all->scales[row];
    }
}

static void list_entries_by_body(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    all->body_starts = g_new0(int32_t, model->bodies + 1);
    all->body_entries = g_new0(int32_t, MAX(all->entries, 1));
    g_autofree int32_t *next = g_new0(int32_t, model->bodies + 1);
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) all->body_starts[all->points[e] + 1]++;
    for (int32_t i = 0; i < model->bodies; i++)
        next[i + 1] = all->body_starts[i + 1] += all->body_starts[i];
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) all->body_entries[next[all->points[e]]++] = e;
}

static gboolean refuse_entangled(const TinkerModel *model, GError **error)
{
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
        _("the %d constraints are so entangled that their equations do not fit into memory (use springs for some)"),
        model->constraints.rows);
    return FALSE;
}

/* Every two ends on one body are a product: of a hub with n rods there are n^2 / 2. */
static gboolean products_fit(const TinkerModel *model)
{
    const int32_t *starts = model->constraints.body_starts;
    double products = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        products += 0.5 * (starts[i + 1] - starts[i]) * (starts[i + 1] - starts[i] + 1.0);
    return products <= MOST_PRODUCTS;
}

static gboolean compile_pattern(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(int)), columns = g_array_new(FALSE, FALSE, sizeof(int));
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = all->body_starts[i]; p < all->body_starts[i + 1]; p++)
            for (int32_t q = p + 1; q < all->body_starts[i + 1]; q++) {
                int row = all->row_of[all->body_entries[p]], column = all->row_of[all->body_entries[q]];
                if (row == column) continue;
                g_array_append_val(rows, row);
                g_array_append_val(columns, column);
            }
    all->ldl = tinker_sparse_ldl_new(all->rows, (const int *)(const void *)rows->data,
                                     (const int *)(const void *)columns->data, rows->len);
    return all->ldl != NULL || refuse_entangled(model, error);
}

static void list_products(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = all->body_starts[i]; p < all->body_starts[i + 1]; p++)
            for (int32_t q = p; q < all->body_starts[i + 1]; q++) {
                int32_t e = all->body_entries[p], f = all->body_entries[q];
                double weight = model->inverse_mass[i];
                if (e != f && all->row_of[e] == all->row_of[f]) weight *= 2; /* both orders fall on the diagonal */
                TinkerProduct product = {tinker_sparse_ldl_slot(all->ldl, all->row_of[e], all->row_of[f]), e, f,
                                         weight};
                g_array_append_val(all->products, product);
            }
}

/* What falls on one slot stands together, so that it is added up in a register; the order within a slot is fixed, too. */
static int compare_products(const void *left, const void *right)
{
    const TinkerProduct *l = left, *r = right;
    if (l->slot != r->slot) return l->slot < r->slot ? -1 : 1;
    if (l->first_entry != r->first_entry) return l->first_entry < r->first_entry ? -1 : 1;
    return l->second_entry < r->second_entry ? -1 : 1;
}

/* Where any row holds in one direction only. */
static void allot_unilateral(TinkerConstraints *all)
{
    gboolean any = FALSE;
    gsize rows = (gsize)all->rows;
    for (guint i = 0; i < all->batches->len; i++)
        any |= g_array_index(all->batches, TinkerConstraintBatch, i).constraint->unilateral != 0;
    if (!any) return;
    all->unilateral = g_new0(gboolean, rows);
    all->slack = g_new0(gboolean, rows);
    all->diagonal = g_new0(int32_t, rows);
    all->own_g = g_new0(double, rows);
    all->own_drift = g_new0(double, rows);
    all->own_rate = g_new0(double, rows);
    all->own_jacobian = g_new0(double, 2 * (gsize)all->entries);
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
            all->unilateral[row] = part->constraint->unilateral != 0;
            all->diagonal[row] = tinker_sparse_ldl_slot(all->ldl, row, row);
        }
    }
}

gboolean tinker_model_compile_constraints(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    all->batches = g_array_new(FALSE, FALSE, sizeof(TinkerConstraintBatch));
    all->products = g_array_new(FALSE, FALSE, sizeof(TinkerProduct));
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->constraint == NULL) continue;
        add_constraint_batch(model, batch);
        if (physics->constraint->prescribed_rate != NULL)
            model->has_book[TINKER_BOOK_MOTORS] = model->more_than_lines = TRUE;
    }
    allot(model);
    if (all->rows == 0) return TRUE;
    all->two_entries = TRUE;
    for (guint i = 0; i < all->batches->len; i++)
        number_entries(all, &g_array_index(all->batches, TinkerConstraintBatch, i));
    for (guint i = 0; i < all->batches->len; i++)
        measure(model, &g_array_index(all->batches, TinkerConstraintBatch, i));
    list_entries_by_body(model);
    if (!products_fit(model)) return refuse_entangled(model, error);
    if (!compile_pattern(model, error)) return FALSE;
    list_products(model);
    g_array_sort(all->products, compare_products);
    allot_unilateral(all);
    if (all->unilateral == NULL) all->chains = tinker_row_chains_new(model);
    return TRUE;
}

void tinker_constraints_clear(TinkerConstraints *all)
{
    for (guint i = 0; all->batches != NULL && i < all->batches->len; i++)
        g_free(g_array_index(all->batches, TinkerConstraintBatch, i).distances);
    if (all->batches != NULL) g_array_unref(all->batches);
    if (all->products != NULL) g_array_unref(all->products);
    tinker_sparse_ldl_free(all->ldl);
    tinker_row_chains_free(all->chains);
    gpointer arrays[] = {all->row_starts,
                         all->points,
                         all->scales,
                         all->blocks,
                         all->ends,
                         all->jacobian,
                         all->g,
                         all->drift,
                         all->rate,
                         all->lambda,
                         all->residual,
                         all->correction,
                         all->by_point,
                         all->turned,
                         all->displacement,
                         all->row_of,
                         all->body_starts,
                         all->body_entries,
                         all->factored_jacobian,
                         all->inverse_scales,
                         all->asked,
                         all->unilateral,
                         all->slack,
                         all->diagonal,
                         all->own_g,
                         all->own_drift,
                         all->own_rate,
                         all->own_jacobian};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
}
