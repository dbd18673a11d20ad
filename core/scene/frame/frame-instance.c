/* A block as its plugin is handed it, to be drawn and asked. */
#include <math.h>

#include "scene/frame/frame-private.h"

/* Of the symbol size: the distance of two connectors side by side. */
#define LANE_SHARE 1.2

/* The lesser side of what an end is attached to; 0 where that has no size. */
static double least_side(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerFrameLocation *location = &frame->locations[block];
    if (location->batch == NULL) return 0;
    return fmin(tinker_block_batch_meaning(location->batch, location->row, TINKER_MEANING_WIDTH, 0, 0),
                tinker_block_batch_meaning(location->batch, location->row, TINKER_MEANING_HEIGHT, 0, 0));
}

/* Moves both ends of a connector into its lane: across the line between them, without changing its length. */
static void take_lane(TinkerFrame *frame, TinkerBlockId block, const TinkerSceneEnd *attached, TinkerInstance *instance)
{
    TinkerEnd *end = (TinkerEnd *)(void *)frame->ends->data;
    double dx = end[1].x - end[0].x, dy = end[1].y - end[0].y, length = hypot(dx, dy);
    if (!(length > 0)) return;
    double spacing = LANE_SHARE * tinker_instance_symbol_size(instance);
    for (int k = 0; k < 2; k++) {
        double side = least_side(frame, attached[k].block);
        if (side > 0) spacing = fmin(spacing, 0.5 * side);
    }
    double shift = frame->lanes[block] * spacing / length;
    for (int k = 0; k < 2; k++) {
        end[k].x -= shift * dy;
        end[k].y += shift * dx;
    }
    instance->x -= shift * dy;
    instance->y += shift * dx;
}

static void take_texts(TinkerFrame *frame, TinkerBlockId block, const TinkerBlockClass *block_class,
                       TinkerInstance *instance)
{
    for (int32_t property = 0; property < block_class->property_count; property++)
        if (block_class->properties[property].kind == TINKER_KIND_TEXT)
            frame->texts[instance->text_count++] = tinker_scene_get_text(frame->scene, block, property);
    instance->texts = frame->texts;
}

gboolean tinker_frame_instance(TinkerFrame *frame, TinkerBlockId block, TinkerInstance *instance)
{
    const TinkerFrameLocation *location = &frame->locations[block];
    *instance = (TinkerInstance){
        .struct_size = sizeof(TinkerInstance),
        .name = tinker_scene_block_name(frame->scene, block),
        .time = frame->time,
        .symbol_size = frame->symbol_size,
    };
    tinker_frame_centre(frame, block, &instance->x, &instance->y, &instance->orientation);
    if (location->batch == NULL) return FALSE;
    const TinkerBlockBatch *batch = location->batch;
    for (int32_t column = 0; column < batch->block_class->column_count; column++)
        frame->columns[column] = batch->columns[column][location->row];
    if (tinker_block_class_is_wound(batch->block_class))
        frame->columns[tinker_block_class_meaning_column(batch->block_class, TINKER_MEANING_LENGTH)] =
            tinker_frame_length(frame, block);
    int32_t first = batch->end_offsets[location->row];
    int32_t count = batch->end_offsets[location->row + 1] - first;
    g_array_set_size(frame->ends, (guint)count);
    for (int32_t k = 0; k < count; k++)
        tinker_frame_end_place(frame, &batch->end[first + k], &g_array_index(frame->ends, TinkerEnd, k));
    instance->columns = frame->columns;
    take_texts(frame, block, batch->block_class, instance);
    instance->ends = count;
    instance->point_list_count = batch->point_list_count;
    if (batch->point_lists != NULL)
        instance->point_lists = batch->point_lists + (gsize)location->row * (gsize)batch->point_list_count;
    instance->path = tinker_paths_of(frame->paths, block, frame->time, &instance->path_count);
    instance->span = tinker_spans_of(frame->spans, block);
    instance->end = count > 0 ? (const TinkerEnd *)(void *)frame->ends->data : NULL;
    if (frame->lanes[block] != 0) take_lane(frame, block, &batch->end[first], instance);
    return TRUE;
}
