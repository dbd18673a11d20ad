/* Work that one thread finds and another does, in the order in which it was found.
 *
 * Items are written one after another into batches, and a batch that is full is handed over: so the two threads meet
 * once in a batch, not once an item. Where there is no second processor, and for the first batches, which a short
 * run does not fill, the finder does the work itself: what is done does not depend on who does it, or when. There are
 * four batches, and of large items as many more as the doer falls behind, up to a bound; with all of them full the
 * finder waits. */
#ifndef TINKER_CORE_RELAY_H
#define TINKER_CORE_RELAY_H

#include <glib.h>

typedef struct _TinkerRelay TinkerRelay;

/* Does an item, which is gone afterwards: on the finder's thread or on another, never on two at once. */
typedef void (*TinkerRelayWork)(void *data, const void *item);

/* Asked now and then by the finder while it waits: FALSE has it wait no longer. */
typedef gboolean (*TinkerRelayPatience)(void *data);

/* `beside` FALSE: the finder does all. `largest` is the size of the largest item (bytes). (transfer full) */
TinkerRelay *tinker_relay_new(gsize largest, gboolean beside, TinkerRelayWork work, void *data);

/* What is not done yet is left undone, but for the item that is being done. NULL is nothing to free. */
void tinker_relay_free(TinkerRelay *relay);

/* Room for the next item, to be filled before the relay is called again: aligned for doubles, not cleared. NULL
 * where the finder lost its patience, with the items so far kept. */
void *tinker_relay_add(TinkerRelay *relay, gsize bytes, TinkerRelayPatience patience, void *data);

/* Waits until all items are done; what the doer wrote may be read then. FALSE where the finder lost its patience
 * (NULL: never). */
gboolean tinker_relay_finish(TinkerRelay *relay, TinkerRelayPatience patience, void *data);

#endif
