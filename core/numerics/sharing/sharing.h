/* Loops shared among threads.
 *
 * A loop is cut into parts that do not depend on the number of threads, and parts touch nothing of one another, so the
 * results have the same bits however many threads there are and whoever does which part. The caller works too: helpers
 * take parts from the same counter, and where they do not come, since other programs keep the processors busy, the
 * caller does all of it and loses next to nothing. */
#ifndef TINKER_CORE_SHARING_H
#define TINKER_CORE_SHARING_H

#include <stdint.h>

/* From so many elements of plain arithmetic on, handing out costs less than it brings. */
#define TINKER_SHARE_LEAST 32768

/* Among how many threads loops are shared, the caller included: 1 to 8. At first as many as there are processors. */
void tinker_share_set_threads(int threads);
int tinker_share_threads(void);

/* Part number `part` of a loop. */
typedef void (*TinkerShareWork)(void *data, int32_t part);

/* Calls `work` once for each of `parts` parts (65535 at most), in any order, on any thread, and returns when all are
 * done. A second caller at the same time does its own parts alone. */
void tinker_share(int32_t parts, TinkerShareWork work, void *data);

/* A loop over elements first to end - 1 that do not depend on one another. */
typedef void (*TinkerShareRange)(void *data, int32_t first, int32_t end);

/* The loop over 0 to count - 1, shared. */
void tinker_share_long_range(int32_t count, TinkerShareRange work, void *data);

/* Does a loop, shared among threads where it is long. */
static inline void tinker_share_range(int32_t count, TinkerShareRange work, void *data)
{
    if (count < TINKER_SHARE_LEAST)
        work(data, 0, count);
    else
        tinker_share_long_range(count, work, data);
}

#endif
