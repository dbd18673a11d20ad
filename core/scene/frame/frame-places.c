/* Where blocks are in a frame, and what their properties are. */
#include <math.h>

#include "scene/frame/frame-private.h"

static gboolean stands(const TinkerFrame *frame, TinkerBlockId block)
{
    return tinker_block_class_stands(tinker_scene_block_class(frame->scene, block));
}

void tinker_frame_end_place(const TinkerFrame *frame, const TinkerSceneEnd *end, TinkerEnd *out)
{
    *out = (TinkerEnd){end->x, end->y, 0, 0, 0};
    if (end->block == TINKER_NO_BLOCK) return;
    const TinkerFramePose *pose = &frame->poses[end->block];
    double c = cos(pose->orientation), s = sin(pose->orientation);
    *out = (TinkerEnd){pose->x + c * end->x - s * end->y, pose->y + s * end->x + c * end->y,
                       stands(frame, end->block) ? TINKER_ATTACHED_TO_SUPPORT : 1, 0, pose->orientation};
}

void tinker_frame_place(TinkerFrame *frame, TinkerBlockId block, double x, double y, double orientation)
{
    frame->poses[block] = (TinkerFramePose){x, y, orientation};
    frame->placings++;
}

void tinker_frame_lay(TinkerFrame *frame, TinkerBlockId block, double orientation)
{
    frame->poses[block].orientation = orientation;
}

const TinkerBlockId *tinker_frame_wound(const TinkerFrame *frame, int32_t *count)
{
    *count = (int32_t)frame->wound->len;
    return (const TinkerBlockId *)(gpointer)frame->wound->data;
}

static gboolean is_wound(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockBatch *batch = block < frame->limit ? frame->locations[block].batch : NULL;
    return batch != NULL && tinker_block_class_is_wound(batch->block_class);
}

void tinker_frame_set_length(TinkerFrame *frame, TinkerBlockId block, double length)
{
    if (is_wound(frame, block)) frame->lengths[block] = (TinkerWoundLength){length, frame->placings};
}

double tinker_frame_length(const TinkerFrame *frame, TinkerBlockId block)
{
    if (!is_wound(frame, block) || frame->lengths[block].placings != frame->placings) return NAN;
    return frame->lengths[block].length;
}

void tinker_frame_centre(const TinkerFrame *frame, TinkerBlockId block, double *x, double *y, double *orientation)
{
    const TinkerFrameLocation *location = &frame->locations[block];
    *x = frame->poses[block].x;
    *y = frame->poses[block].y;
    *orientation = frame->poses[block].orientation;
    if (!isnan(*x) || location->batch == NULL) return;
    int32_t first = location->batch->end_offsets[location->row];
    int32_t count = location->batch->end_offsets[location->row + 1] - first;
    if (count == 0) return;
    *x = *y = 0;
    for (int32_t k = 0; k < count; k++) {
        TinkerEnd end;
        tinker_frame_end_place(frame, &location->batch->end[first + k], &end);
        *x += end.x / count;
        *y += end.y / count;
    }
}

const TinkerPlace *tinker_frame_motion(const TinkerFrame *frame, TinkerBlockId block)
{
    return tinker_motions_moves(frame->motions, block) ? tinker_motions_place(frame->motions, block) : NULL;
}

void tinker_frame_to_own(const TinkerFrame *frame, TinkerBlockId block, const double place[2], double own[2])
{
    double x, y, orientation;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    const double dx = place[0] - x, dy = place[1] - y;
    own[0] = dx * cos(orientation) + dy * sin(orientation);
    own[1] = dy * cos(orientation) - dx * sin(orientation);
}

void tinker_frame_to_world(const TinkerFrame *frame, TinkerBlockId block, const double own[2], double place[2])
{
    double x, y, orientation;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    place[0] = x + own[0] * cos(orientation) - own[1] * sin(orientation);
    place[1] = y + own[0] * sin(orientation) + own[1] * cos(orientation);
}

void tinker_frame_set_symbol_size(TinkerFrame *frame, double symbol_size)
{
    frame->symbol_size = symbol_size;
}

double tinker_frame_column(const TinkerFrame *frame, TinkerBlockId block, int32_t column)
{
    const TinkerFrameLocation *location = &frame->locations[block];
    return location->batch == NULL ? NAN : location->batch->columns[column][location->row];
}

double tinker_frame_meaning(const TinkerFrame *frame, TinkerBlockId block, int32_t meaning, int32_t component,
                            double otherwise)
{
    const TinkerFrameLocation *location = &frame->locations[block];
    if (location->batch == NULL) return otherwise;
    return tinker_block_batch_meaning(location->batch, location->row, meaning, component, otherwise);
}

void tinker_frame_end(const TinkerFrame *frame, TinkerSceneEnd end, double place[2])
{
    TinkerEnd at;
    tinker_frame_end_place(frame, &end, &at);
    place[0] = at.x;
    place[1] = at.y;
}
