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

/* `starts` counts what each part has, one place ahead; then says where that begins. */
static void add_up(int32_t *starts, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        starts[i + 1] += starts[i];
}

/* `starts` was moved on by as much as each part has. */
static void move_back(int32_t *starts, int32_t count)
{
    for (int32_t i = count; i > 0; i--)
        starts[i] = starts[i - 1];
    starts[0] = 0;
}

static void sort_members(TinkerLinearParts *parts, int32_t size)
{
    for (int32_t i = 0; i < size; i++)
        parts->local[i] = parts->starts[parts->part_of[i] + 1]++;
    add_up(parts->starts, parts->count);
    for (int32_t i = 0; i < size; i++)
        parts->members[parts->starts[parts->part_of[i]] + parts->local[i]] = i;
}

/* -1 where both its ends are anchors. */
static int32_t part_of_edge(const TinkerLinearParts *parts, const TinkerLinearEdge *edge)
{
    if (edge->a >= 0) return parts->part_of[edge->a];
    return edge->b >= 0 ? parts->part_of[edge->b] : -1;
}

static void sort_edges(TinkerLinearParts *parts, const TinkerLinearSystem *system)
{
    for (int32_t e = 0; e < system->edge_count; e++) {
        int32_t part = part_of_edge(parts, &system->edges[e]);
        if (part >= 0) parts->edge_starts[part + 1]++;
    }
    add_up(parts->edge_starts, parts->count);
    for (int32_t e = 0; e < system->edge_count; e++) {
        int32_t part = part_of_edge(parts, &system->edges[e]);
        if (part >= 0) parts->edges[parts->edge_starts[part]++] = e;
    }
    move_back(parts->edge_starts, parts->count);
}

TinkerLinearParts *tinker_linear_parts_new(const TinkerLinearSystem *system)
{
    const gsize n = (gsize)system->size, room = 6 * n + 2 + (gsize)system->edge_count;
    TinkerLinearParts *parts = g_malloc0(sizeof(TinkerLinearParts) + room * sizeof(int32_t));
    parts->part_of = (int32_t *)(gpointer)(parts + 1);
    parts->local = parts->part_of + n;
    parts->members = parts->local + n;
    parts->starts = parts->members + n;
    parts->edge_starts = parts->starts + n + 1;
    int32_t *parent = parts->edge_starts + n + 1;
    parts->edges = parent + n;
    unite(system, parent);
    number_parts(parts, system->size, parent);
    sort_members(parts, system->size);
    sort_edges(parts, system);
    return parts;
}

void tinker_linear_parts_free(TinkerLinearParts *parts)
{
    g_free(parts);
}
