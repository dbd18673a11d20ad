/* Bringing a model to a time and a state, and showing plugins their part of it. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/model/model-data.h"

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
        .time = model->time,
        .origin = {model->origin[0], model->origin[1]},
        .failed_instance = -1,
    };
}

TinkerStatus tinker_model_change_time(TinkerModel *model, double t)
{
    model->time = t;
    for (guint i = 0; i < model->waveform_batches->len; i++)
        tinker_block_batch_set_time(g_ptr_array_index(model->waveform_batches, i), t);
    if (model->moving_supports == 0) return TINKER_OK;
    if (!tinker_motions_evaluate(model->motions, t)) {
        model->time = NAN; /* some supports are there, others not */
        tinker_model_tell_failure(model, _("%s: its motion at t = %g s is not a number"),
                                  tinker_scene_block_name(model->scene, tinker_motions_failure(model->motions)), t);
        return TINKER_RETRY_SMALLER;
    }
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        if (!at->moving) continue;
        const TinkerPlace *place = tinker_motions_place(model->motions, at->block);
        model->point[point] = (TinkerPoint){at->x + place->x, at->y + place->y, place->vx, place->vy};
        model->point_acceleration[2 * point] = place->ax;
        model->point_acceleration[2 * point + 1] = place->ay;
    }
    return TINKER_OK;
}

typedef struct {
    TinkerPoint *point;
    const double *q, *v;
} Packing;

static void pack(void *data, int32_t first, int32_t end)
{
    const Packing *loop = data;
    TinkerPoint *restrict point = loop->point;
    const double *restrict q = loop->q, *restrict v = loop->v;
    for (int32_t i = first; i < end; i++)
        point[i] = (TinkerPoint){q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1]};
}

void tinker_model_share_state(TinkerModel *model, const double *q, const double *v)
{
    tinker_share_range(model->bodies, pack, &(Packing){model->point, q, v});
}
