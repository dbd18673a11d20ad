/* Places are kept block by block, with one list of times for all. */
#include "scene/frame/paths.h"
#include "scene/frame/flagged.h"
#include "units/waveform/times.h"

#include <math.h>

struct _TinkerPaths {
    GArray *blocks;    /* of TinkerBlockId */
    GArray *times;     /* of double, ascending */
    GPtrArray *places; /* of GArray of double: x, y at each of the times, of each block */
};

TinkerPaths *tinker_paths_new(TinkerScene *scene)
{
    GArray *blocks = tinker_scene_flagged(scene, TINKER_LEAVES_PATH);
    if (blocks == NULL) return NULL;
    TinkerPaths *paths = g_new0(TinkerPaths, 1);
    paths->blocks = blocks;
    paths->times = g_array_new(FALSE, FALSE, sizeof(double));
    paths->places = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    for (guint i = 0; i < paths->blocks->len; i++)
        g_ptr_array_add(paths->places, g_array_new(FALSE, FALSE, sizeof(double)));
    return paths;
}

void tinker_paths_free(TinkerPaths *paths)
{
    if (paths == NULL) return;
    g_array_unref(paths->blocks);
    g_array_unref(paths->times);
    g_ptr_array_unref(paths->places);
    g_free(paths);
}

const TinkerBlockId *tinker_paths_blocks(const TinkerPaths *paths, int32_t *count)
{
    *count = paths == NULL ? 0 : (int32_t)paths->blocks->len;
    return paths == NULL ? NULL : (const TinkerBlockId *)(const void *)paths->blocks->data;
}

double tinker_paths_last(const TinkerPaths *paths)
{
    return paths->times->len == 0 ? -INFINITY : g_array_index(paths->times, double, paths->times->len - 1);
}

void tinker_paths_note(TinkerPaths *paths, double t, const double *places)
{
    g_array_append_val(paths->times, t);
    for (guint i = 0; i < paths->places->len; i++)
        g_array_append_vals((GArray *)g_ptr_array_index(paths->places, i), &places[2 * i], 2);
}

const double *tinker_paths_of(const TinkerPaths *paths, TinkerBlockId block, double t, int32_t *count)
{
    *count = 0;
    for (guint i = 0; paths != NULL && i < paths->blocks->len; i++) {
        if (g_array_index(paths->blocks, TinkerBlockId, i) != block) continue;
        *count = (int32_t)tinker_times_until((const double *)(const void *)paths->times->data, paths->times->len, t);
        return (const double *)(const void *)((const GArray *)g_ptr_array_index(paths->places, i))->data;
    }
    return NULL;
}
