/* What a frame keeps of the times that it has been placed at: paths of bodies, and spans of ends. */
#include <math.h>

#include "scene/frame/frame-private.h"

gboolean tinker_frame_leaves_paths(const TinkerFrame *frame)
{
    return frame->paths != NULL;
}

void tinker_frame_note_paths(TinkerFrame *frame)
{
    int32_t count;
    const TinkerBlockId *blocks = tinker_paths_blocks(frame->paths, &count);
    if (count == 0 || frame->time <= tinker_paths_last(frame->paths)) return;
    g_autofree double *places = g_new(double, 2 * (gsize)count);
    for (int32_t i = 0; i < count; i++) {
        const TinkerFrameLocation *location = &frame->locations[blocks[i]];
        TinkerEnd end = {NAN, NAN, 0, 0};
        const int32_t first = location->batch->end_offsets[location->row];
        if (location->batch->end_offsets[location->row + 1] > first)
            tinker_frame_end_place(frame, &location->batch->end[first], &end);
        places[2 * i] = end.x;
        places[2 * i + 1] = end.y;
    }
    tinker_paths_note(frame->paths, frame->time, places);
}

gboolean tinker_frame_has_spans(const TinkerFrame *frame)
{
    return frame->spans != NULL;
}

gboolean tinker_frame_note_spans(TinkerFrame *frame)
{
    int32_t count;
    gboolean grew = FALSE;
    const TinkerBlockId *blocks = tinker_spans_blocks(frame->spans, &count);
    for (int32_t i = 0; i < count; i++) {
        const TinkerFrameLocation *location = &frame->locations[blocks[i]];
        if (location->batch == NULL) continue;
        const int32_t first = location->batch->end_offsets[location->row];
        TinkerEnd a, b;
        if (location->batch->end_offsets[location->row + 1] < first + 2) continue;
        tinker_frame_end_place(frame, &location->batch->end[first], &a);
        tinker_frame_end_place(frame, &location->batch->end[first + 1], &b);
        grew |= tinker_spans_note(frame->spans, blocks[i], hypot(b.x - a.x, b.y - a.y));
    }
    return grew;
}

void tinker_frame_note_spans_of(TinkerFrame *frame, const TinkerFrame *other)
{
    int32_t count;
    const TinkerBlockId *blocks = tinker_spans_blocks(frame->spans, &count);
    for (int32_t i = 0; i < count; i++)
        tinker_spans_note(frame->spans, blocks[i], tinker_spans_of(other->spans, blocks[i]));
}

void tinker_frame_forget_spans(TinkerFrame *frame)
{
    tinker_spans_forget(frame->spans);
}
