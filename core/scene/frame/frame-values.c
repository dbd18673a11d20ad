/* The values of properties that are left out: "as placed" and "as shaped". */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "plugin/call/process-state.h"
#include "scene/frame/frame-private.h"

/* Of the path from end to end, in their order; NAN where there are not two. */
static double placed_length(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    TinkerEnd here, next;
    if (count < 2) return NAN;
    double length = 0;
    tinker_frame_end_place(frame, &ends[0], &here);
    for (int32_t k = 1; k < count; k++, here = next) {
        tinker_frame_end_place(frame, &ends[k], &next);
        length += hypot(next.x - here.x, next.y - here.y);
    }
    return length;
}

/* From what the first end is on to what the second is on; NAN where there are not two. */
static double placed_angle(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    TinkerEnd first, second;
    if (count < 2) return NAN;
    tinker_frame_end_place(frame, &ends[0], &first);
    tinker_frame_end_place(frame, &ends[1], &second);
    return second.angle - first.angle;
}

/* Of what the first end is on; NAN where that is not round. */
static double placed_radius(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    if (count < 1 || ends[0].block == TINKER_NO_BLOCK) return NAN;
    return tinker_frame_meaning(frame, ends[0].block, TINKER_MEANING_RADIUS, 0, NAN);
}

/* Of the tangent from a circle about the first end to the second; 0 where there is none. */
static double placed_tangent(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count, double radius)
{
    const double distance = placed_length(frame, ends, count);
    return distance <= radius ? 0 : sqrt((distance - radius) * (distance + radius));
}

static gboolean is_angle(TinkerDimension d)
{
    return d.mass == 0 && d.length == 0 && d.time == 0 && d.angle == 1;
}

static double placed_value(const TinkerFrame *frame, const TinkerBlockBatch *batch, int32_t row, int32_t property)
{
    const TinkerBlockClass *block_class = batch->block_class;
    const TinkerSceneEnd *ends = &batch->end[batch->end_offsets[row]];
    const int32_t count = batch->end_offsets[row + 1] - batch->end_offsets[row];
    const int32_t round = tinker_block_class_meaning_column(block_class, TINKER_MEANING_RADIUS);
    if (block_class->properties[property].meaning == TINKER_MEANING_RADIUS) return placed_radius(frame, ends, count);
    if (is_angle(block_class->properties[property].dimension)) return placed_angle(frame, ends, count);
    return round >= 0 ? placed_tangent(frame, ends, count, batch->columns[round][row])
                      : placed_length(frame, ends, count);
}

static void work_out_placed(TinkerFrame *frame, TinkerBlockBatch *batch, int32_t property)
{
    const TinkerBlockClass *block_class = batch->block_class;
    if (property < 0 || !(block_class->properties[property].flags & TINKER_DEFAULT_AS_PLACED)) return;
    double *column = batch->columns[block_class->first_columns[property]];
    for (int32_t row = 0; row < batch->count; row++)
        if (isnan(column[row])) column[row] = placed_value(frame, batch, row, property);
}

void tinker_frame_work_out_placed(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        work_out_placed(frame, batch, batch->block_class->meanings[TINKER_MEANING_RADIUS]);
        for (int32_t property = 0; property < batch->block_class->property_count; property++)
            work_out_placed(frame, batch, property);
    }
}

/* What bodies work out of their other properties where it is left out. */
static gboolean work_out_shaped(TinkerBlockBatch *batch, int32_t property, GError **error)
{
    const TinkerBlockClass *block_class = batch->block_class;
    const TinkerBody *body = block_class->physics->body;
    const int32_t first = block_class->first_columns[property];
    const int32_t width = tinker_kind_columns(block_class->properties[property].kind);
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    g_autofree double *values = g_new0(double, (gsize)width *(gsize)MAX(batch->count, 1));
    if (TINKER_CALL_BATCH(batch, "as_shaped", &view, body->as_shaped(&view, property, values)) != TINKER_OK) {
        g_autofree char *why = tinker_block_batch_refusal(batch, &view, _("its plugin refuses these properties"));
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, why);
        return FALSE;
    }
    for (int32_t row = 0; row < batch->count; row++)
        for (int32_t c = 0; c < width; c++)
            if (isnan(batch->columns[first + c][row])) batch->columns[first + c][row] = values[row * width + c];
    return TRUE;
}

static gboolean has_shape(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    return physics != NULL && physics->body != NULL && physics->body->as_shaped != NULL;
}

gboolean tinker_frame_work_out_shaped(TinkerFrame *frame, GError **error)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        const TinkerBlockClass *block_class = batch->block_class;
        for (int32_t p = 0; p < block_class->property_count; p++) {
            if (!(block_class->properties[p].flags & TINKER_DEFAULT_AS_SHAPED) || !has_shape(block_class)) continue;
            if (!work_out_shaped(batch, p, error)) return FALSE;
        }
    }
    return TRUE;
}
