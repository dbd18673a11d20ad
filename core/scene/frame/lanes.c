/* Connectors are sorted by the places of their ends; runs of equal ones share the room. */
#include "scene/frame/lanes.h"

#include <stdlib.h>

typedef struct {
    TinkerSceneEnd low, high; /* ends, the one with the lower block first */
    TinkerBlockId id;
    double sign; /* -1 where the connector's own order is the other one */
} Connector;

static int compare_ends(const TinkerSceneEnd *l, const TinkerSceneEnd *r)
{
    if (l->block != r->block) return l->block < r->block ? -1 : 1;
    if (l->x != r->x) return l->x < r->x ? -1 : 1;
    if (l->y != r->y) return l->y < r->y ? -1 : 1;
    return 0;
}

static int compare_places(const Connector *l, const Connector *r)
{
    int low = compare_ends(&l->low, &r->low);
    return low != 0 ? low : compare_ends(&l->high, &r->high);
}

static int compare(const void *left, const void *right)
{
    const Connector *l = left, *r = right;
    int places = compare_places(l, r);
    if (places != 0) return places;
    return l->id < r->id ? -1 : 1;
}

static void add_table(const TinkerSceneTable *table, GArray *connectors)
{
    for (int32_t row = 0; row < table->count; row++) {
        int32_t first = table->end_offsets[row];
        if (table->end_offsets[row + 1] - first != 2) continue;
        const TinkerSceneEnd *a = &table->ends[first], *b = a + 1;
        if (a->block == TINKER_NO_BLOCK || b->block == TINKER_NO_BLOCK) continue;
        gboolean turned = compare_ends(a, b) > 0;
        Connector connector = {turned ? *b : *a, turned ? *a : *b, table->ids[row], turned ? -1.0 : 1.0};
        g_array_append_val(connectors, connector);
    }
}

double *tinker_lanes_new(TinkerScene *scene)
{
    double *lanes = g_new0(double, tinker_scene_id_limit(scene) + 1);
    g_autoptr(GArray) connectors = g_array_new(FALSE, FALSE, sizeof(Connector));
    for (int32_t number = 0; number < tinker_scene_table_count(scene); number++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, number, &table);
        add_table(&table, connectors);
    }
    if (connectors->len == 0) return lanes;
    Connector *all = (Connector *)(void *)connectors->data;
    qsort(all, connectors->len, sizeof(Connector), compare);
    for (guint first = 0, end = 0; first < connectors->len; first = end) {
        while (end < connectors->len && compare_places(&all[first], &all[end]) == 0)
            end++;
        for (guint i = first; i < end; i++)
            lanes[all[i].id] = all[i].sign * ((double)(i - first) - 0.5 * (double)(end - first - 1));
    }
    return lanes;
}
