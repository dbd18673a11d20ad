/* Sets of numbered things that are joined pair by pair: each knows another of its set, and by steps the first of them,
 * which stands for the set. */
#ifndef TINKER_CORE_DISJOINT_SETS_H
#define TINKER_CORE_DISJOINT_SETS_H

#include <glib.h>

/* Every one of `count` things is a set of its own. */
static inline void tinker_sets_begin(int32_t *parent, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        parent[i] = i;
}

/* The first of the set that a thing belongs to. */
static inline int32_t tinker_sets_first(int32_t *parent, int32_t number)
{
    while (parent[number] != number) {
        parent[number] = parent[parent[number]];
        number = parent[number];
    }
    return number;
}

static inline void tinker_sets_join(int32_t *parent, int32_t a, int32_t b)
{
    int32_t first = tinker_sets_first(parent, a), second = tinker_sets_first(parent, b);
    parent[MAX(first, second)] = MIN(first, second);
}

/* Each knows the first of its set by itself, so that two are of one set where their entries are the same. */
static inline void tinker_sets_settle(int32_t *parent, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        parent[i] = tinker_sets_first(parent, i);
}

#endif
