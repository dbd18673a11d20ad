/* Rows that count from how things were placed know the direction from their first end to their second but for whole
 * turns. So what is wound is placed anew whenever that direction has gone round by an eighth of a turn: as it is, with
 * the length that keeps g as it is,
 *
 *     l <- s - g,   s = (d^2 - R^2)^1/2 the free part,
 *
 * as a run that is continued from there would have it. */
#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/model/angles.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

#define AN_EIGHTH (G_PI / 4)

static double direction_of(const TinkerPoint *ends)
{
    return atan2(ends[1].y - ends[0].y, ends[1].x - ends[0].x);
}

static gboolean has_gone_round(const TinkerModel *model, const TinkerConstraintBatch *part, int32_t row)
{
    const int32_t *points = part->end_points + 2 * row;
    const TinkerPoint now[2] = {model->point[points[0]], model->point[points[1]]};
    return fabs(remainder(direction_of(now) - direction_of(&part->angles->placed[2 * row]), 2 * G_PI)) > AN_EIGHTH;
}

/* The length with which the row would have this g where its points are now; NAN where its second end is inside. */
static double length_by(const TinkerModel *model, const TinkerConstraintBatch *part, int32_t row, double g)
{
    const int32_t radius = tinker_block_class_meaning_column(part->batch->block_class, TINKER_MEANING_RADIUS);
    const int32_t *points = part->end_points + 2 * row;
    const TinkerPoint *a = &model->point[points[0]], *b = &model->point[points[1]];
    const double distance = hypot(b->x - a->x, b->y - a->y), R = part->batch->columns[radius][row];
    return distance > R ? sqrt((distance - R) * (distance + R)) - g : NAN;
}

static void place_anew(TinkerModel *model, const TinkerConstraintBatch *part, int32_t row)
{
    const TinkerBlockBatch *batch = part->batch;
    const int32_t column = tinker_block_class_meaning_column(batch->block_class, TINKER_MEANING_LENGTH);
    const int32_t *points = part->end_points + 2 * row;
    const double length = length_by(model, part, row, model->constraints.own_g[part->first_row + row]);
    TinkerAngles *angles = part->angles;
    if (isnan(length)) return;
    batch->columns[column][row] = length;
    tinker_angles_gather(angles, model, 2 * row, 2);
    for (int end = 0; end < 2; end++) {
        angles->placed[2 * row + end] = model->point[points[end]];
        angles->placed_poses[2 * row + end] = angles->poses[2 * row + end];
    }
}

static gboolean is_wound(const TinkerConstraintBatch *part)
{
    return tinker_block_class_is_wound(part->batch->block_class);
}

static G_NO_INLINE TinkerStatus rewind_all(TinkerModel *model, double t, const double *q, const double *v)
{
    const TinkerConstraints *all = &model->constraints;
    gboolean evaluated = FALSE;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (!is_wound(part)) continue;
        if (tinker_model_set_time(model, t) != TINKER_OK) return TINKER_FAILED;
        tinker_model_set_state(model, q, v);
        for (int32_t row = 0; row < part->batch->count; row++) {
            if (!has_gone_round(model, part, row)) continue;
            const TinkerStatus status = evaluated ? TINKER_OK : tinker_constraints_evaluate(model);
            if (status != TINKER_OK) return status;
            evaluated = TRUE;
            place_anew(model, part, row);
        }
    }
    return TINKER_OK;
}

TinkerStatus tinker_constraints_rewind(TinkerModel *model, double t, const double *q, const double *v)
{
    return model->constraints.unilateral == NULL ? TINKER_OK : rewind_all(model, t, q, v);
}

/* g alone, asked of its plugin beside the other rows. */
static double wound_length(TinkerModel *model, const TinkerConstraintBatch *part, int32_t row)
{
    const int32_t *points = part->end_points + 2 * row;
    const TinkerPoint ends[2] = {model->point[points[0]], model->point[points[1]]};
    double g = NAN, jacobian[8], drift;
    TinkerBatch view = tinker_model_view(model, part->batch, row, 1, model->column_views);
    tinker_angles_gather(part->angles, model, 2 * row, 2);
    if (tinker_constraints_ask(part, &view, ends, &g, jacobian, &drift) != TINKER_OK) return NAN;
    return length_by(model, part, row, g);
}

double tinker_constraints_wound_length(TinkerModel *model, double t, const double *q, const double *v,
                                       TinkerBlockId block)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        for (int32_t row = 0; is_wound(part) && row < part->batch->count; row++) {
            if (part->batch->ids[row] != block) continue;
            if (tinker_model_set_time(model, t) != TINKER_OK) return NAN;
            tinker_model_set_state(model, q, v);
            return wound_length(model, part, row);
        }
    }
    return NAN;
}
