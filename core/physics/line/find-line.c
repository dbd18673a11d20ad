/* Whether everything of a model lies and moves on one line. */
#include <math.h>

#include "physics/line/linear-form-data.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

typedef struct {
    double x, y;
} Place;

static Place place_of(const TinkerModel *model, int32_t point)
{
    double place[2];
    tinker_model_start_place(model, point, place);
    return (Place){place[0], place[1]};
}

/* Along the line from a point to the one farthest from it; along an axis where it is one but for rounding. */
static gboolean find_direction(const TinkerModel *model, TinkerLine *line, double *extent)
{
    const TinkerMergedLines *lines = &model->lines;
    Place from = place_of(model, lines->a[0]);
    double dx = 0, dy = 0;
    for (int32_t i = 0; i < lines->count; i++) {
        for (int end = 0; end < 2; end++) {
            Place to = place_of(model, end == 0 ? lines->a[i] : lines->b[i]);
            if (hypot(to.x - from.x, to.y - from.y) <= hypot(dx, dy)) continue;
            dx = to.x - from.x;
            dy = to.y - from.y;
        }
    }
    *extent = hypot(dx, dy);
    if (!(*extent > 0)) return FALSE;
    line->direction[0] = fabs(dx) <= TINKER_LINE_ACROSS * *extent ? 0 : dx / *extent;
    line->direction[1] = fabs(dy) <= TINKER_LINE_ACROSS * *extent ? 0 : dy / *extent;
    for (int k = 0; k < 2; k++)
        if (line->direction[1 - k] == 0) line->direction[k] = 1;
    double along = from.x * line->direction[0] + from.y * line->direction[1];
    line->offset[0] = from.x - along * line->direction[0];
    line->offset[1] = from.y - along * line->direction[1];
    return TRUE;
}

static gboolean lies_on(const TinkerModel *model, const TinkerLine *line, double extent)
{
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < model->bodies; i++)
        if (tinker_line_across(line, model->q_start[2 * i] - line->offset[0],
                               model->q_start[2 * i + 1] - line->offset[1]) > TINKER_LINE_ACROSS * extent)
            return FALSE;
    for (int32_t i = 0; i < lines->count; i++) {
        for (int end = 0; end < 2; end++) {
            Place at = place_of(model, end == 0 ? lines->a[i] : lines->b[i]);
            if (tinker_line_across(line, at.x - line->offset[0], at.y - line->offset[1]) > TINKER_LINE_ACROSS * extent)
                return FALSE;
        }
        Place a = place_of(model, lines->a[i]), b = place_of(model, lines->b[i]);
        gboolean has_length = lines->length[i] != 0 || lines->tension[i] != 0;
        if (has_length && hypot(b.x - a.x, b.y - a.y) <= TINKER_LINE_ACROSS * extent) return FALSE;
    }
    return TRUE;
}

/* Pairs of coordinates, one a body. */
static gboolean points_along(const TinkerModel *model, const TinkerLine *line, const double *vectors)
{
    double most = 0, most_across = 0;
    for (int32_t i = 0; i < model->bodies; i++) {
        most = MAX(most, hypot(vectors[2 * i], vectors[2 * i + 1]));
        most_across = MAX(most_across, tinker_line_across(line, vectors[2 * i], vectors[2 * i + 1]));
    }
    return most_across <= TINKER_LINE_ACROSS * most;
}

static gboolean drives_along(const TinkerModel *model, const TinkerLine *line)
{
    for (guint i = 0; i < model->driven->len; i++) {
        const double *direction = g_array_index(model->driven, TinkerDrivenForce, i).direction;
        if (tinker_line_across(line, direction[0], direction[1]) >
            TINKER_LINE_ACROSS * hypot(direction[0], direction[1]))
            return FALSE;
    }
    return TRUE;
}

gboolean tinker_motion_directions(const TinkerBlockBatch *batch, double *direction, int32_t *columns)
{
    const TinkerMotion *motion = batch->block_class->physics->motion;
    TinkerBatch view = tinker_block_batch_view((TinkerBlockBatch *)batch, 0.0);
    if (motion->linear == NULL || motion->rotation != NULL ||
        TINKER_CALL_BATCH(batch, "linear", &view, motion->linear(&view, direction, columns)) != TINKER_OK)
        return FALSE;
    for (int32_t row = 0; row < batch->count; row++)
        if (tinker_block_batch_evaluator(batch, columns[row], row) == NULL) return FALSE;
    return TRUE;
}

/* Only supports that something hangs on matter. */
static gboolean moves_along(const TinkerModel *model, const TinkerLine *line)
{
    if (model->moving_supports == 0) return TRUE;
    g_autoptr(GHashTable) used = g_hash_table_new(NULL, NULL);
    for (int32_t point = model->first_support; point < model->points; point++)
        if (model->point_used[point])
            g_hash_table_add(used, GINT_TO_POINTER(tinker_model_attachment(model, point)->block));
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->block_class->physics == NULL || batch->block_class->physics->motion == NULL) continue;
        g_autofree double *direction = g_new0(double, 2 * (gsize)batch->count);
        g_autofree int32_t *columns = g_new0(int32_t, batch->count);
        if (!tinker_motion_directions(batch, direction, columns)) return FALSE;
        for (int32_t row = 0; row < batch->count; row++) {
            TinkerBlockId support = batch->end[batch->end_offsets[row]].block;
            const double *d = &direction[2 * row];
            if (!g_hash_table_contains(used, GINT_TO_POINTER(support))) continue;
            if (tinker_line_across(line, d[0], d[1]) > TINKER_LINE_ACROSS * hypot(d[0], d[1])) return FALSE;
        }
    }
    return TRUE;
}

gboolean tinker_model_find_line(TinkerModel *model, TinkerLine *line)
{
    double extent;
    if (model->lines.count == 0 || model->bodies == 0 || tinker_model_is_struck(model)) return FALSE;
    return find_direction(model, line, &extent) && lies_on(model, line, extent) &&
           points_along(model, line, model->v_start) && points_along(model, line, model->constant_acceleration) &&
           drives_along(model, line) && moves_along(model, line);
}
