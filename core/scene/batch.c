/* Snapshots of tables. Property columns are copied; the three columns of each waveform property are filled by evaluators,
 * one for every block, built from the block's own amplitude, frequency and phase. */
#include "scene/batch.h"

#include <math.h>

/* No break of a waveform lies between `from` and `next`, and none up to `horizon` where next is infinite. */
struct _TinkerPiece {
    double from, next, horizon;
    gboolean entered; /* the evaluator's switches are those of this piece */
};

static double column_or(const TinkerBlockBatch *batch, const char *property_id, int32_t row, double otherwise)
{
    if (property_id == NULL) return otherwise;
    int32_t property = tinker_block_class_property(batch->block_class, property_id);
    if (property < 0) return otherwise;
    return batch->columns[batch->block_class->first_columns[property]][row];
}

/* A displacement is differentiated twice by whoever rides on it, so its value tables are read as C2 splines. */
static gboolean drives_a_place(const TinkerBlockClass *block_class)
{
    return block_class->physics != NULL && block_class->physics->motion != NULL;
}

static void add_evaluators(TinkerBlockBatch *batch, TinkerScene *scene, int32_t property)
{
    const TinkerPropertyType *type = &batch->block_class->properties[property];
    gboolean smooth = drives_a_place(batch->block_class);
    for (int32_t row = 0; row < batch->count; row++) {
        TinkerWaveform *waveform = tinker_scene_get_waveform(scene, batch->ids[row], property);
        g_ptr_array_add(batch->evaluators,
                        tinker_waveform_evaluator_new(waveform, column_or(batch, type->amplitude, row, 1.0),
                                                      column_or(batch, type->frequency, row, 0.0),
                                                      column_or(batch, type->phase, row, 0.0), smooth));
    }
}

static void copy_waveforms(TinkerBlockBatch *batch, TinkerScene *scene)
{
    const TinkerBlockClass *block_class = batch->block_class;
    batch->evaluators = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_waveform_evaluator_free);
    batch->waveform_columns = g_new0(int32_t, MAX(block_class->property_count, 1));
    for (int32_t property = 0; property < block_class->property_count; property++) {
        if (block_class->properties[property].kind != TINKER_KIND_WAVEFORM) continue;
        batch->waveform_columns[batch->waveforms++] = block_class->first_columns[property];
        add_evaluators(batch, scene, property);
    }
    batch->pieces = g_new(struct _TinkerPiece, MAX(batch->evaluators->len, 1));
    for (guint i = 0; i < batch->evaluators->len; i++)
        batch->pieces[i] = (struct _TinkerPiece){NAN, NAN, NAN, FALSE};
}

static void copy_ends(TinkerBlockBatch *batch, const TinkerSceneTable *table)
{
    batch->end_offsets = g_memdup2(table->end_offsets, (gsize)(table->count + 1) * sizeof(int32_t));
    batch->end_count = table->end_offsets[table->count];
    batch->end = g_memdup2(table->ends, (gsize)batch->end_count * sizeof(TinkerSceneEnd));
    const TinkerBlockType *type = table->block_class->type;
    batch->ends = type->least_ends == type->most_ends ? type->least_ends : -1;
}

static void block_batch_free(TinkerBlockBatch *batch)
{
    for (int32_t column = 0; column < batch->block_class->column_count; column++)
        g_free(batch->columns[column]);
    g_free(batch->columns);
    g_free(batch->ids);
    g_free(batch->end_offsets);
    g_free(batch->end);
    g_free(batch->waveform_columns);
    g_free(batch->pieces);
    g_free(batch->scratch);
    g_ptr_array_unref(batch->evaluators);
    g_free(batch);
}

static TinkerBlockBatch *block_batch_new(TinkerScene *scene, const TinkerSceneTable *table)
{
    TinkerBlockBatch *batch = g_new0(TinkerBlockBatch, 1);
    const TinkerBlockClass *block_class = table->block_class;
    gsize bytes = (gsize)table->count * sizeof(double);
    batch->block_class = block_class;
    batch->count = table->count;
    batch->ids = g_memdup2(table->ids, (gsize)table->count * sizeof(TinkerBlockId));
    batch->columns = g_new0(double *, MAX(block_class->column_count, 1));
    for (int32_t column = 0; column < block_class->column_count; column++)
        batch->columns[column] = g_memdup2(table->columns[column], bytes);
    copy_ends(batch, table);
    copy_waveforms(batch, scene);
    if (block_class->physics != NULL && block_class->physics->scratch_size > 0)
        batch->scratch = g_malloc0((gsize)block_class->physics->scratch_size);
    return batch;
}

GPtrArray *tinker_batches_new(TinkerScene *scene)
{
    GPtrArray *batches = g_ptr_array_new_with_free_func((GDestroyNotify)block_batch_free);
    for (int32_t number = 0; number < tinker_scene_table_count(scene); number++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, number, &table);
        if (table.count > 0) g_ptr_array_add(batches, block_batch_new(scene, &table));
    }
    return batches;
}

TinkerBatch tinker_block_batch_view(TinkerBlockBatch *batch, double t)
{
    return (TinkerBatch){
        .struct_size = sizeof(TinkerBatch),
        .count = batch->count,
        .ends = batch->ends,
        .end_offsets = batch->ends < 0 ? batch->end_offsets : NULL,
        .columns = (const double *const *)batch->columns,
        .scratch = batch->scratch,
        .time = t,
        .failed_instance = -1,
    };
}

static TinkerWaveformEvaluator *evaluator_of(const TinkerBlockBatch *batch, int32_t waveform, int32_t row)
{
    return g_ptr_array_index(batch->evaluators, (guint)(waveform * batch->count + row));
}

void tinker_block_batch_set_time(TinkerBlockBatch *batch, double t)
{
    for (int32_t waveform = 0; waveform < batch->waveforms; waveform++) {
        double **columns = batch->columns + batch->waveform_columns[waveform];
        for (int32_t row = 0; row < batch->count; row++) {
            double result[3];
            tinker_waveform_evaluate(evaluator_of(batch, waveform, row), t, result);
            for (int derivative = 0; derivative < 3; derivative++)
                columns[derivative][row] = result[derivative];
        }
    }
}

void tinker_block_batch_enter_piece(TinkerBlockBatch *batch, double inside)
{
    for (guint i = 0; i < batch->evaluators->len; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        if (piece->entered && piece->from < inside && inside < piece->next) continue;
        piece->entered = TRUE;
        tinker_waveform_enter_piece(g_ptr_array_index(batch->evaluators, i), inside);
    }
}

double tinker_block_batch_next_break(TinkerBlockBatch *batch, double t, double horizon)
{
    double next = INFINITY;
    for (guint i = 0; i < batch->evaluators->len; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        gboolean known = piece->from <= t && t < piece->next && (isfinite(piece->next) || horizon <= piece->horizon);
        if (!known) {
            double at = tinker_waveform_next_break(g_ptr_array_index(batch->evaluators, i), t, horizon);
            *piece = (struct _TinkerPiece){t, at, horizon, FALSE};
        }
        next = MIN(next, piece->next);
    }
    return next <= horizon ? next : INFINITY;
}
