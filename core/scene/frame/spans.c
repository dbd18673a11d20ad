/* One greatest distance a block, whatever the time: it only grows, so that what is drawn by it stays as it is. */
#include "scene/frame/spans.h"
#include "scene/frame/flagged.h"

#include <string.h>

struct _TinkerSpans {
    GArray *blocks;    /* of TinkerBlockId */
    double *distances; /* m, by block id: every picture asks for those of all blocks */
    int32_t limit;     /* of ids */
};

TinkerSpans *tinker_spans_new(TinkerScene *scene)
{
    GArray *blocks = tinker_scene_flagged(scene, TINKER_HAS_SPAN);
    if (blocks == NULL) return NULL;
    TinkerSpans *spans = g_new0(TinkerSpans, 1);
    spans->blocks = blocks;
    spans->limit = tinker_scene_id_limit(scene);
    spans->distances = g_new0(double, spans->limit);
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
    if (spans != NULL) memset(spans->distances, 0, (gsize)spans->limit * sizeof(double));
}

const TinkerBlockId *tinker_spans_blocks(const TinkerSpans *spans, int32_t *count)
{
    *count = spans == NULL ? 0 : (int32_t)spans->blocks->len;
    return spans == NULL ? NULL : (const TinkerBlockId *)(const void *)spans->blocks->data;
}

gboolean tinker_spans_note(TinkerSpans *spans, TinkerBlockId block, double distance)
{
    if (!(distance > spans->distances[block])) return FALSE;
    spans->distances[block] = distance;
    return TRUE;
}

double tinker_spans_of(const TinkerSpans *spans, TinkerBlockId block)
{
    return spans != NULL && block < spans->limit ? spans->distances[block] : 0;
}
