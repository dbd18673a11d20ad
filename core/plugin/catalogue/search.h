/* Where libraries are looked for, and in which order. */
#ifndef TINKER_PLUGIN_SEARCH_H
#define TINKER_PLUGIN_SEARCH_H

#include "plugin/catalogue/catalogue.h"

typedef struct {
    char *path;
    const char *kind;          /* "command line", "TINKER_PLUGIN_PATH", "user", "installed" */
    TinkerBundleEntry *bundle; /* where the folder is a bundle, else NULL */
} TinkerSearchFolder;

/* The folders in search order, each once, and behind each its bundles by name; of TinkerSearchFolder. Adds to
 * `warnings` (of char *) what is passed over. (transfer full) */
GPtrArray *tinker_search_folders(const TinkerCatalogueOptions *options, GPtrArray *warnings);

/* Paths of the files in the folder whose names end with ".so", by name; of char *. A folder that cannot be read adds to
 * `warnings`. (transfer full) */
GPtrArray *tinker_search_libraries(const TinkerSearchFolder *folder, GPtrArray *warnings);

/* By name: the order in which a folder lists its files is an accident. */
void tinker_search_sort(GPtrArray *paths);

#endif
