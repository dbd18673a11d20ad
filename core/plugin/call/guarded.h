/* Memory of the host that plugins write to, with a band behind it that nobody is to write to. A band that was written
 * to tells whose mistake a broken heap is: a look at it costs a few comparisons, and the handler of crashes looks at
 * all. */
#ifndef TINKER_CORE_GUARDED_H
#define TINKER_CORE_GUARDED_H

#include "plugin/descriptor/block-class.h"

/* Zeroed memory for plugins, aligned for any number. `owner` is the class whose plugin
 * alone writes to it, or NULL for memory that all plugins of a model write to in turn. (transfer full) */
void *tinker_guarded_new(gsize bytes, const TinkerBlockClass *owner);
/* Guarded memory whose size grows with the scene: NULL where there is none. */
void *tinker_guarded_try_new(gsize bytes, const TinkerBlockClass *owner);

/* NULL is nothing to free. */
void tinker_guarded_free(void *memory);

/* Whether the band behind the memory is as it was; TRUE for NULL. */
gboolean tinker_guarded_is_whole(const void *memory);

/* For the handler of crashes: whether any band was written to, and whose; NULL for memory that many write to. Reads
 * memory alone; what is wrong may be wrong because the list itself was overwritten. */
gboolean tinker_guarded_find_broken(const TinkerBlockClass **owner);

#endif
