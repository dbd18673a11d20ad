/* Table by table, column by column: values are the same where their bits are. */
#include "scene/history/difference.h"

#include <string.h>

#include "scene/store/scene-data.h"

static gboolean same_run(const TinkerRunSettings *a, const TinkerRunSettings *b)
{
    return a->duration == b->duration && a->interval == b->interval && a->step == b->step &&
           a->tolerance == b->tolerance && a->accuracy == b->accuracy && a->spectral_radius == b->spectral_radius &&
           g_strcmp0(a->method, b->method) == 0 && g_strcmp0(a->contacts, b->contacts) == 0 &&
           g_strcmp0(a->until, b->until) == 0 && g_strcmp0(a->impact_law, b->impact_law) == 0;
}

static gboolean same_blocks(const TinkerScene *a, const TinkerScene *b)
{
    if (a->tables->len > b->tables->len || a->slots->len > b->slots->len) return FALSE;
    for (guint id = 0; id < b->slots->len; id++) {
        int32_t before = id < a->slots->len ? scene_slot(a, (TinkerBlockId)id)->table : SCENE_REMOVED;
        if (before != scene_slot(b, (TinkerBlockId)id)->table) return FALSE;
    }
    return TRUE;
}

static gboolean same_ends(const SceneTable *a, const SceneTable *b)
{
    if (memcmp(a->end_offsets, b->end_offsets, ((gsize)a->count + 1) * sizeof(int32_t)) != 0) return FALSE;
    for (int32_t end = 0; end < a->end_offsets[a->count]; end++)
        if (a->ends[end].block != b->ends[end].block || a->ends[end].x != b->ends[end].x ||
            a->ends[end].y != b->ends[end].y)
            return FALSE;
    return TRUE;
}

/* A NaN is a length "as placed". */
static gboolean same_values(const double *a, const double *b, int32_t count)
{
    return count == 0 || memcmp(a, b, (gsize)count * sizeof(double)) == 0;
}

static gboolean same_property(const SceneTable *a, const SceneTable *b, int32_t property)
{
    const TinkerBlockClass *block_class = a->block_class;
    int32_t first = block_class->first_columns[property];
    if (block_class->properties[property].kind == TINKER_KIND_WAVEFORM)
        return memcmp(a->waveforms[property], b->waveforms[property], (gsize)a->count * sizeof(gpointer)) == 0;
    for (int32_t c = 0; c < tinker_kind_columns(block_class->properties[property].kind); c++)
        if (!same_values(a->columns[first + c], b->columns[first + c], a->count)) return FALSE;
    return TRUE;
}

static TinkerDifference table_difference(const SceneTable *a, const SceneTable *b)
{
    TinkerDifference difference = TINKER_DIFFERENCE_DRAWING;
    if (a->count == 0) return difference;
    if (!same_ends(a, b)) return TINKER_DIFFERENCE_START;
    for (int32_t p = 0; p < a->block_class->property_count; p++) {
        if (same_property(a, b, p)) continue;
        if (a->block_class->properties[p].meaning == TINKER_MEANING_LOCAL_ORIGIN) continue; /* moves nothing */
        gboolean tunable = a->block_class->properties[p].variability == TINKER_TUNABLE;
        difference = MAX(difference, tunable ? TINKER_DIFFERENCE_TUNABLE : TINKER_DIFFERENCE_START);
    }
    return difference;
}

TinkerDifference tinker_scene_difference(const TinkerScene *before, const TinkerScene *after)
{
    if (!same_run(&before->head.run, &after->head.run) || !same_blocks(before, after)) return TINKER_DIFFERENCE_START;
    TinkerDifference difference = TINKER_DIFFERENCE_DRAWING;
    for (guint t = 0; t < before->tables->len; t++)
        difference = MAX(difference,
                         table_difference(g_ptr_array_index(before->tables, t), g_ptr_array_index(after->tables, t)));
    return difference;
}
