/* Connected parts by union and find, then two counting sorts. */
#include "numerics/exact/linear-parts.h"

#include "numerics/solve/disjoint-sets.h"

/* The first of a set stands for it, so that parts are numbered in the order of their first coordinates. */
static void unite(const TinkerLinearSystem *system, int32_t *parent)
{
    tinker_sets_begin(parent, system->size);
    for (int32_t e = 0; e < system->edge_count; e++) {
        const TinkerLinearEdge *edge = &system->edges[e];
        if (edge->a >= 0 && edge->b >= 0) tinker_sets_join(parent, edge->a, edge->b);
    }
}

static void number_parts(TinkerLinearParts *parts, int32_t size, int32_t *parent)
{
    for (int32_t i = 0; i < size; i++) {
        int32_t root = tinker_sets_first(parent, i);
        parts->part_of[i] = root == i ? parts->count++ : parts->part_of[root];
    }
}

static void add_up(int32_t *starts, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        starts[i + 1] += starts[i];
}

static void sort_members(TinkerLinearParts *parts, int32_t size)
{
    parts->starts = g_new0(int32_t, parts->count + 1);
    for (int32_t i = 0; i < size; i++)
        parts->starts[parts->part_of[i] + 1]++;
    add_up(parts->starts, parts->count);
    g_autofree int32_t *filled = g_new0(int32_t, parts->count + 1);
    for (int32_t i = 0; i < size; i++) {
        int32_t part = parts->part_of[i];
        parts->local[i] = filled[part]++;
        parts->members[parts->starts[part] + parts->local[i]] = i;
    }
}

/* -1 where both its ends are anchors. */
static int32_t part_of_edge(const TinkerLinearParts *parts, const TinkerLinearEdge *edge)
{
    if (edge->a >= 0) return parts->part_of[edge->a];
    return edge->b >= 0 ? parts->part_of[edge->b] : -1;
}

static void sort_edges(TinkerLinearParts *parts, const TinkerLinearSystem *system)
{
    parts->edge_starts = g_new0(int32_t, parts->count + 1);
    for (int32_t e = 0; e < system->edge_count; e++) {
        int32_t part = part_of_edge(parts, &system->edges[e]);
        if (part >= 0) parts->edge_starts[part + 1]++;
    }
    add_up(parts->edge_starts, parts->count);
    g_autofree int32_t *filled = g_new0(int32_t, parts->count + 1);
    for (int32_t e = 0; e < system->edge_count; e++) {
        int32_t part = part_of_edge(parts, &system->edges[e]);
        if (part >= 0) parts->edges[parts->edge_starts[part] + filled[part]++] = e;
    }
}

TinkerLinearParts *tinker_linear_parts_new(const TinkerLinearSystem *system)
{
    TinkerLinearParts *parts = g_new0(TinkerLinearParts, 1);
    parts->part_of = g_new0(int32_t, system->size);
    parts->local = g_new0(int32_t, system->size);
    parts->members = g_new0(int32_t, system->size);
    parts->edges = g_new0(int32_t, system->edge_count);
    g_autofree int32_t *parent = g_new(int32_t, system->size);
    unite(system, parent);
    number_parts(parts, system->size, parent);
    sort_members(parts, system->size);
    sort_edges(parts, system);
    return parts;
}

void tinker_linear_parts_free(TinkerLinearParts *parts)
{
    if (!parts) return;
    g_free(parts->part_of);
    g_free(parts->local);
    g_free(parts->starts);
    g_free(parts->members);
    g_free(parts->edge_starts);
    g_free(parts->edges);
    g_free(parts);
}
