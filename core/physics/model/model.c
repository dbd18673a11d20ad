/* What can be asked of a compiled model, and what plugins are shown of it. */
#include "physics/model/model-data.h"

/* Two runs may fail on two threads at once, and what G_DEFINE_QUARK keeps would be written by both. */
GQuark tinker_model_error_quark(void)
{
    return g_quark_from_static_string("tinker-model-error-quark");
}

const GPtrArray *tinker_model_warnings(const TinkerModel *model)
{
    return model->warnings;
}

const int32_t *tinker_model_end_points(const TinkerModel *model, const TinkerBlockBatch *batch)
{
    guint number;
    if (!g_ptr_array_find(model->batches, batch, &number)) return NULL;
    return model->end_points[number];
}

TinkerBatch tinker_model_view(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                              const double **columns)
{
    for (int32_t column = 0; column < batch->block_class->column_count; column++)
        columns[column] = batch->columns[column] + first;
    for (int32_t i = 0; batch->ends < 0 && i <= count; i++)
        model->chunk_offsets[i] = batch->end_offsets[first + i] - batch->end_offsets[first];
    return (TinkerBatch){
        .struct_size = sizeof(TinkerBatch),
        .first = first,
        .count = count,
        .ends = batch->ends,
        .end_offsets = batch->ends < 0 ? model->chunk_offsets : NULL,
        .columns = columns,
        .scratch = batch->scratch,
        .time = tinker_block_batch_inside(batch, model->time),
        .origin = {model->origin[0], model->origin[1]},
        .failed_instance = -1,
        .law_count = batch->law_count,
        .point_list_count = batch->point_list_count,
        .point_lists =
            batch->point_lists != NULL ? batch->point_lists + (gsize)first * (gsize)batch->point_list_count : NULL,
        .end_masses = batch->end_masses != NULL ? batch->end_masses + batch->end_offsets[first] : NULL,
        .laws = batch->laws != NULL
                    ? (const struct TinkerTypedLaw *const *)batch->laws + (gsize)first * (gsize)batch->law_count
                    : NULL,
    };
}

int32_t tinker_model_book_index(const TinkerModel *model, TinkerBook book)
{
    int32_t index = 0;
    for (TinkerBook before = 0; before < book; before++)
        if (model->has_book[before]) index++;
    return model->has_book[book] ? index : -1;
}

static int32_t count_asked(const GArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return count;
}

TinkerModelSizes tinker_model_sizes(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    return (TinkerModelSizes){
        .bodies = model->bodies,
        .turning = model->turning,
        .coordinates = model->coordinates,
        .degrees_of_freedom = model->coordinates - (all->rows - all->idle_count - all->redundant),
        .constraint_rows = all->rows - all->idle_count,
        .redundant_rows = all->redundant,
        .merged_lines = model->lines.count,
        .nonlinear_lines = count_asked(model->asked_lines),
        .moving_supports = model->moving_supports,
    };
}
