/* How far apart the ends of blocks with a span (TINKER_HAS_SPAN) have been. */
#ifndef TINKER_CORE_SPANS_H
#define TINKER_CORE_SPANS_H

#include "scene/store/scene.h"

typedef struct _TinkerSpans TinkerSpans;

/* One for each block of the scene that has a span, of 0 m; NULL where there is none. (transfer full) */
TinkerSpans *tinker_spans_new(TinkerScene *scene);
void tinker_spans_free(TinkerSpans *spans);

/* All are 0 m again. `spans` may be NULL. */
void tinker_spans_forget(TinkerSpans *spans);

/* The blocks, in the order of the scene. Borrowed. */
const TinkerBlockId *tinker_spans_blocks(const TinkerSpans *spans, int32_t *count);

/* The ends of one of the blocks are so far apart (m): TRUE where that is more than all noted before; of any block the
 * most noted: 0 where it has no span. */
gboolean tinker_spans_note(TinkerSpans *spans, TinkerBlockId block, double distance);
double tinker_spans_of(const TinkerSpans *spans, TinkerBlockId block);

#endif
