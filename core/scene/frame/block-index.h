/* Numbers of things that block ids stand for. Its memory goes with the number of ids, whatever the ids are. */
#ifndef TINKER_CORE_BLOCK_INDEX_H
#define TINKER_CORE_BLOCK_INDEX_H

#include "scene/frame/batch.h"

typedef struct _TinkerBlockIndex TinkerBlockIndex;

/* The place of each id in the list; of one that stands there several times, the first. (transfer full) */
TinkerBlockIndex *tinker_block_index_new(const TinkerBlockId *ids, int32_t count);

/* All blocks of the batches, numbered batch by batch, row by row. (transfer full) */
TinkerBlockIndex *tinker_block_index_of_batches(const GPtrArray *batches);
void tinker_block_index_free(TinkerBlockIndex *index);

/* How many ids were listed. */
int32_t tinker_block_index_count(const TinkerBlockIndex *index);

/* -1 where the id was not listed. */
int32_t tinker_block_index_find(const TinkerBlockIndex *index, TinkerBlockId block);

#endif
