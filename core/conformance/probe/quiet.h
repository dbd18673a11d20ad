/* Watching what a library calls of the C library, by exchanging the addresses that it calls through. */
#ifndef TINKER_CONFORMANCE_QUIET_H
#define TINKER_CONFORMANCE_QUIET_H

#include <glib.h>

/* The objects that the loader has mapped now. (transfer full) */
GPtrArray *kit_objects_now(void);

/* From now on calls of functions that allot, lock, print or read are noticed, where they come from objects that are not
 * in `objects`: the library and what it brought. FALSE where the addresses could not be exchanged. */
gboolean kit_watch_calls(const GPtrArray *objects);

/* Begins and ends a stretch; answers the name of the first function that was called in it, or NULL. */
void kit_listen(void);
const char *kit_heard(void);

#endif
