/* One greatest distance a block, whatever the time: it only grows, so that what is drawn by it stays as it is. */
#include "scene/frame/spans.h"

struct _TinkerSpans {
    GArray *blocks;    /* of TinkerBlockId */
    double *distances; /* m, by their numbers */
};

TinkerSpans *tinker_spans_new(TinkerScene *scene)
{
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class != NULL && (block_class->type->flags & TINKER_HAS_SPAN) != 0) g_array_append_val(blocks, block);
    }
    if (blocks->len == 0) return NULL;
    TinkerSpans *spans = g_new0(TinkerSpans, 1);
    spans->distances = g_new0(double, blocks->len);
    spans->blocks = g_steal_pointer(&blocks);
    return spans;
}

void tinker_spans_free(TinkerSpans *spans)
{
    if (spans == NULL) return;
    g_array_unref(spans->blocks);
    g_free(spans->distances);
    g_free(spans);
}

void tinker_spans_forget(TinkerSpans *spans)
{
    for (guint i = 0; spans != NULL && i < spans->blocks->len; i++)
        spans->distances[i] = 0;
}

const TinkerBlockId *tinker_spans_blocks(const TinkerSpans *spans, int32_t *count)
{
    *count = spans == NULL ? 0 : (int32_t)spans->blocks->len;
    return spans == NULL ? NULL : (const TinkerBlockId *)(const void *)spans->blocks->data;
}

gboolean tinker_spans_note(TinkerSpans *spans, int32_t number, double distance)
{
    if (!(distance > spans->distances[number])) return FALSE;
    spans->distances[number] = distance;
    return TRUE;
}

double tinker_spans_of(const TinkerSpans *spans, TinkerBlockId block)
{
    for (guint i = 0; spans != NULL && i < spans->blocks->len; i++)
        if (g_array_index(spans->blocks, TinkerBlockId, i) == block) return spans->distances[i];
    return 0;
}
