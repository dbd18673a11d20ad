/* One run of the net. */
#ifndef NET_RUN_H
#define NET_RUN_H

#include "net-scenes.h"
#include "plugin/catalogue/catalogue.h"

/* The names of the ways in which every scene is run, ended by NULL: each method, "auto" among them, with contact by
 * events; "impulse", `auto` with contact as impulses; "own", as the scene says, with its accuracy. (transfer full) */
GStrv net_methods_new(TinkerCatalogue *catalogue);

/* Runs a scene by each of the methods that `wanted` (a set of "SCENE\tMETHOD"; NULL: all) names, and adds a line each
 * to `table`. What was hashed is put into the folder `store` (NULL: nowhere), each under its hash. */
gboolean net_run_scene(TinkerCatalogue *catalogue, const NetScene *scene, GHashTable *wanted, const char *store,
                       GPtrArray *table, GError **error);

#endif
