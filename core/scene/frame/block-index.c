/* Ids that lie close together are looked up in a table, others by bisection: a part of a scene may hold its first block
 * and its last. */
#include "scene/frame/block-index.h"

#include <stdlib.h>

/* A table has at most so many places for each id. */
#define MOST_PLACES 4

typedef struct {
    TinkerBlockId block;
    int32_t number;
} Entry;

struct _TinkerBlockIndex {
    int32_t count;
    TinkerBlockId first; /* of the table, ... */
    int32_t span;        /* ... which has so many places; 0: there is none */
    int32_t *numbers;
    Entry *entries; /* where there is no table: sorted by id and number */
};

static int compare(const void *left, const void *right)
{
    const Entry *l = left, *r = right;
    if (l->block != r->block) return l->block < r->block ? -1 : 1;
    return l->number - r->number;
}

static void fill_table(TinkerBlockIndex *index, const TinkerBlockId *ids)
{
    index->numbers = g_new(int32_t, index->span);
    for (int32_t i = 0; i < index->span; i++)
        index->numbers[i] = -1;
    for (int32_t i = index->count - 1; i >= 0; i--)
        index->numbers[ids[i] - index->first] = i;
}

static void sort_entries(TinkerBlockIndex *index, const TinkerBlockId *ids)
{
    index->entries = g_new(Entry, MAX(index->count, 1));
    for (int32_t i = 0; i < index->count; i++)
        index->entries[i] = (Entry){ids[i], i};
    qsort(index->entries, (gsize)index->count, sizeof(Entry), compare);
}

TinkerBlockIndex *tinker_block_index_new(const TinkerBlockId *ids, int32_t count)
{
    TinkerBlockIndex *index = g_new0(TinkerBlockIndex, 1);
    TinkerBlockId least = count > 0 ? ids[0] : 0, most = least;
    index->count = count;
    for (int32_t i = 1; i < count; i++) {
        least = MIN(least, ids[i]);
        most = MAX(most, ids[i]);
    }
    if (count > 0 && (gint64)most - least < MOST_PLACES * (gint64)count) {
        index->first = least;
        index->span = most - least + 1;
        fill_table(index, ids);
    } else {
        sort_entries(index, ids);
    }
    return index;
}

TinkerBlockIndex *tinker_block_index_of_batches(const GPtrArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += ((const TinkerBlockBatch *)g_ptr_array_index(batches, i))->count;
    g_autofree TinkerBlockId *ids = g_new(TinkerBlockId, MAX(count, 1));
    count = 0;
    for (guint i = 0; i < batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            ids[count++] = batch->ids[row];
    }
    return tinker_block_index_new(ids, count);
}

void tinker_block_index_free(TinkerBlockIndex *index)
{
    if (index == NULL) return;
    g_free(index->numbers);
    g_free(index->entries);
    g_free(index);
}

int32_t tinker_block_index_count(const TinkerBlockIndex *index)
{
    return index->count;
}

int32_t tinker_block_index_find(const TinkerBlockIndex *index, TinkerBlockId block)
{
    if (index->span > 0)
        return block >= index->first && block - index->first < index->span ? index->numbers[block - index->first] : -1;
    int32_t from = 0, end = index->count;
    while (from < end) {
        int32_t middle = from + (end - from) / 2;
        if (index->entries[middle].block < block)
            from = middle + 1;
        else
            end = middle;
    }
    return from < index->count && index->entries[from].block == block ? index->entries[from].number : -1;
}
