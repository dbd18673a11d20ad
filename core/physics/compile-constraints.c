/* Compiling, third part: constraint rows, and the pattern of S = J M^-1 J^T. */
#include <math.h>

#include "physics/model-private.h"

static int32_t ends_of(const TinkerBlockBatch *batch, int32_t row)
{
    return batch->end_offsets[row + 1] - batch->end_offsets[row];
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
        .entry_count = batch->end_count * constraint->rows,
    };
    all->rows += added.row_count;
    all->entries += added.entry_count;
    g_array_append_val(all->batches, added);
}

static void add_entry(TinkerModel *model, int32_t entry, int32_t point)
{
    TinkerConstraints *all = &model->constraints;
    gboolean moves = point < model->bodies;
    all->points[entry] = point;
    all->targets[entry] = moves ? point : 0;
    all->weights[entry] = moves ? model->inverse_mass[point] : 0.0;
}

static void number_entries(TinkerModel *model, const TinkerConstraintBatch *part)
{
    TinkerConstraints *all = &model->constraints;
    int32_t row = part->first_row, entry = part->first_entry;
    for (int32_t i = 0; i < part->batch->count; i++)
        for (int32_t r = 0; r < part->constraint->rows; r++, row++) {
            all->row_starts[row] = entry;
            all->blocks[row] = part->batch->ids[i];
            for (int32_t k = 0; k < ends_of(part->batch, i); k++)
                add_entry(model, entry++, part->end_points[part->batch->end_offsets[i] + k]);
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
    all->targets = g_new0(int32_t, entries);
    all->weights = g_new0(double, entries);
    all->factored_jacobian = g_new0(double, 2 * entries);
    all->scales = g_new0(double, rows);
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
    gboolean told = part->constraint->scale != NULL && part->constraint->scale(&view, scale) == TINKER_OK;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
        if (told && all->scales[row] > 0) continue;
        double largest = 0;
        const TinkerPoint *first = &model->point[all->points[all->row_starts[row]]];
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            const TinkerPoint *other = &model->point[all->points[e]];
            largest = MAX(largest, hypot(other->x - first->x, other->y - first->y));
        }
        all->scales[row] = largest > 0 ? largest : 1.0;
    }
}

/* Entry numbers by body, as a list of lists. */
typedef struct {
    int32_t *starts, *entries;
} ByBody;

static ByBody entries_by_body(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    ByBody by = {g_new0(int32_t, model->bodies + 1), g_new0(int32_t, MAX(all->entries, 1))};
    g_autofree int32_t *next = g_new0(int32_t, model->bodies + 1);
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) by.starts[all->points[e] + 1]++;
    for (int32_t i = 0; i < model->bodies; i++)
        next[i + 1] = by.starts[i + 1] += by.starts[i];
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) by.entries[next[all->points[e]]++] = e;
    return by;
}

static gboolean compile_pattern(TinkerModel *model, const int32_t *row_of, const ByBody *by, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(int)), columns = g_array_new(FALSE, FALSE, sizeof(int));
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = by->starts[i]; p < by->starts[i + 1]; p++)
            for (int32_t q = p + 1; q < by->starts[i + 1]; q++) {
                int row = row_of[by->entries[p]], column = row_of[by->entries[q]];
                if (row == column) continue;
                g_array_append_val(rows, row);
                g_array_append_val(columns, column);
            }
    all->ldl = tinker_sparse_ldl_new(all->rows, (const int *)(const void *)rows->data,
                                     (const int *)(const void *)columns->data, rows->len);
    if (all->ldl != NULL) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                "the %d constraints are so entangled that their equations do not fit into memory (use springs for some)",
                all->rows);
    return FALSE;
}

static void list_products(TinkerModel *model, const int32_t *row_of, const ByBody *by)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = by->starts[i]; p < by->starts[i + 1]; p++)
            for (int32_t q = p; q < by->starts[i + 1]; q++) {
                int32_t e = by->entries[p], f = by->entries[q];
                double weight = model->inverse_mass[i];
                if (e != f && row_of[e] == row_of[f]) weight *= 2; /* both orders fall on the diagonal */
                TinkerProduct product = {tinker_sparse_ldl_slot(all->ldl, row_of[e], row_of[f]), e, f, weight};
                g_array_append_val(all->products, product);
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
        if (physics->constraint->unilateral) {
            g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_PLUGIN,
                        "the block type \"%s\" holds in one direction only, which this version cannot run",
                        batch->block_class->type->id);
            return FALSE;
        }
        add_constraint_batch(model, batch);
        if (physics->constraint->prescribed_rate != NULL) model->has_book[TINKER_BOOK_MOTORS] = TRUE;
    }
    allot(model);
    if (all->rows == 0) return TRUE;
    g_autofree int32_t *row_of = g_new(int32_t, all->entries);
    all->two_entries = TRUE;
    for (guint i = 0; i < all->batches->len; i++)
        number_entries(model, &g_array_index(all->batches, TinkerConstraintBatch, i));
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            row_of[e] = row;
    for (guint i = 0; i < all->batches->len; i++)
        measure(model, &g_array_index(all->batches, TinkerConstraintBatch, i));
    ByBody by = entries_by_body(model);
    gboolean compiled = compile_pattern(model, row_of, &by, error);
    if (compiled) list_products(model, row_of, &by);
    g_free(by.starts);
    g_free(by.entries);
    return compiled;
}

void tinker_constraints_clear(TinkerConstraints *all)
{
    if (all->batches != NULL) g_array_unref(all->batches);
    if (all->products != NULL) g_array_unref(all->products);
    tinker_sparse_ldl_free(all->ldl);
    gpointer arrays[] = {all->row_starts, all->points, all->scales,   all->blocks,     all->ends,    all->jacobian, all->g,
                         all->drift,      all->rate,   all->lambda,   all->residual,   all->correction, all->by_point,
                         all->turned,     all->displacement, all->targets, all->weights, all->factored_jacobian};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
}
