/* What the files of the catalogue share. */
#ifndef TINKER_CORE_CATALOGUE_PRIVATE_H
#define TINKER_CORE_CATALOGUE_PRIVATE_H

#include "plugin/catalogue/cache-private.h"
#include "plugin/catalogue/catalogue.h"
#include "plugin/catalogue/found-private.h"

/* One thread at a time identifies and opens libraries, for seconds where one is probed. Whoever only wants to know what
 * there is waits for `lists` alone, which is held for a moment. */
struct _TinkerCatalogue {
    GMutex opening;   /* of what is written here: `found`, what is behind it, the cache */
    GPtrArray *found; /* of TinkerFound, in search order; none leaves it */
    TinkerPluginCache *cache;

    GMutex lists;            /* of what follows; changed only while `opening` is held as well */
    GPtrArray *libraries;    /* of TinkerLibraryEntry, in search order; replaced as a whole, never changed */
    GPtrArray *warnings;     /* of char * */
    GPtrArray *opened;       /* of char * */
    GHashTable *types;       /* id to TinkerFound, which is borrowed from `found` */
    GHashTable *integrators; /* likewise */

    /* As they were when it was made. */
    GPtrArray *folders; /* of TinkerSearchFolder */
    GPtrArray *bundles; /* of TinkerBundleEntry, borrowed from the folders */
    char *probe_program;
    double probe_seconds;
    char *(*method_fault)(TinkerCatalogue *catalogue, const char *id);
};

static inline TinkerProber tinker_catalogue_prober(const TinkerCatalogue *catalogue)
{
    return (TinkerProber){catalogue->probe_program, catalogue->probe_seconds, catalogue->cache};
}

/* Lets others see what is known of the libraries by now. */
void tinker_catalogue_publish(TinkerCatalogue *catalogue);

/* A cache that cannot be written costs time at the next start, nothing else: it is warned of. */
void tinker_catalogue_write_cache(TinkerCatalogue *catalogue);

#endif
