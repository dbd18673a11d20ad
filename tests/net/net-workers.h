/* Running many scenes in several processes: what goes wrong in one is told with its scene, and methods with state of
 * their own cannot meet. */
#ifndef NET_WORKERS_H
#define NET_WORKERS_H

#include <glib.h>

/* The lines of all these scenes (of NetScene *), sorted; `wanted` and `store` as for net_run_scene. (transfer full) */
GPtrArray *net_run_all(const GPtrArray *scenes, GHashTable *wanted, const char *store, int processes, GError **error);

#endif
