/* Poses of ends, for plugins that speak of angles. */
#include "physics/model/angles.h"
#include "physics/model/points.h"

#include <string.h>

#include "plugin/call/guarded.h"

TinkerAngles *tinker_angles_new(const TinkerBlockBatch *batch, const int32_t *end_points)
{
    if (!tinker_block_class_speaks_of_angles(batch->block_class) || batch->end_count == 0) return NULL;
    const TinkerConstraint *constraint = batch->block_class->physics->constraint;
    TinkerAngles *angles = g_new0(TinkerAngles, 1);
    const gsize ends = (gsize)batch->end_count;
    angles->turns = end_points + ends;
    angles->rows = constraint != NULL ? constraint->rows : 1;
    angles->poses = g_new0(TinkerPose, ends);
    angles->placed = g_new0(TinkerPoint, ends);
    angles->placed_poses = g_new0(TinkerPose, ends);
    angles->has_angle = g_new0(int32_t, ends);
    angles->columns = batch->block_class->column_count;
    angles->placed_columns = g_new0(double *, MAX(angles->columns, 1));
    angles->column_views = g_new0(const double *, MAX(angles->columns, 1));
    angles->angular = tinker_guarded_new((gsize)angles->rows * ends * sizeof(double), batch->block_class);
    angles->jacobian = tinker_guarded_new(2 * (gsize)angles->rows * ends * sizeof(double), batch->block_class);
    return angles;
}

void tinker_angles_free(TinkerAngles *angles)
{
    if (angles == NULL) return;
    g_free(angles->poses);
    g_free(angles->placed);
    g_free(angles->placed_poses);
    g_free(angles->has_angle);
    for (int32_t c = 0; c < angles->columns; c++)
        g_free(angles->placed_columns[c]);
    g_free(angles->placed_columns);
    g_free(angles->column_views);
    tinker_guarded_free(angles->angular);
    tinker_guarded_free(angles->jacobian);
    g_free(angles);
}

void tinker_model_place_angles(TinkerModel *model)
{
    for (guint i = 0; model->angles != NULL && i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const int32_t *points = model->end_points[i];
        TinkerAngles *angles = model->angles[i];
        if (angles == NULL) continue;
        for (int32_t e = 0; e < batch->end_count; e++) {
            angles->placed[e] = model->point[points[e]];
            angles->has_angle[e] = tinker_model_attachment(model, angles->turns[e])->block != TINKER_NO_BLOCK;
        }
        for (int32_t c = 0; c < angles->columns; c++) {
            g_free(angles->placed_columns[c]);
            angles->placed_columns[c] = g_memdup2(batch->columns[c], (gsize)MAX(batch->count, 1) * sizeof(double));
        }
        tinker_angles_gather(angles, model, 0, batch->end_count);
        memcpy(angles->placed_poses, angles->poses, (gsize)batch->end_count * sizeof(TinkerPose));
    }
}

TinkerAngles *tinker_model_angles(const TinkerModel *model, const TinkerBlockBatch *batch)
{
    guint number;
    if (model->angles == NULL || !g_ptr_array_find(model->batches, batch, &number)) return NULL;
    return model->angles[number];
}

void tinker_angles_gather(TinkerAngles *angles, const TinkerModel *model, int32_t from, int32_t count)
{
    for (int32_t e = from; e < from + count; e++) {
        const TinkerPoint *turn = &model->point[angles->turns[e]];
        const double known =
            angles->turns[e] >= model->first_support ? model->point_acceleration[2 * angles->turns[e]] : 0;
        angles->poses[e] = (TinkerPose){turn->x, turn->vx, known};
    }
}

void tinker_angles_show(TinkerAngles *angles, TinkerBatch *view, int32_t from, int32_t ends)
{
    view->poses = angles->poses + from;
    view->placed = angles->placed + from;
    view->placed_poses = angles->placed_poses + from;
    view->has_angle = angles->has_angle + from;
    for (int32_t c = 0; c < angles->columns; c++)
        angles->column_views[c] = angles->placed_columns[c] + view->first;
    view->placed_columns = angles->column_views;
    view->angular = angles->angular + (gsize)angles->rows * (gsize)from;
    memset(view->angular, 0, (gsize)angles->rows * (gsize)ends * sizeof(double));
}
