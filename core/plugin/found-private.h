/* A library that the search found: what is known of it before it is opened. */
#ifndef TINKER_PLUGIN_FOUND_PRIVATE_H
#define TINKER_PLUGIN_FOUND_PRIVATE_H

#include "plugin/cache-private.h"
#include "plugin/catalogue.h"
#include "plugin/library-private.h"

typedef struct {
    TinkerLibraryEntry entry;     /* first, so that a found library is a library entry */
    TinkerIdentity identity;      /* of the file when it was identified */
    const TinkerLibrary *library; /* NULL until it is opened */
} TinkerFound;

/* What a library without a manifest is probed with. */
typedef struct {
    const char *program; /* NULL: none */
    double seconds;
    TinkerPluginCache *cache;
} TinkerProber;

/* (transfer full) */
TinkerFound *tinker_found_new(const char *path, const char *folder_kind);
void tinker_found_free(gpointer found);

/* A library that is open already, with what it says itself. (transfer full) */
TinkerFound *tinker_found_opened(const TinkerLibrary *library, GError **error);

/* Finds out what the library provides, or why it is refused: permissions, the manifest beside it, the cache, the probe,
 * in this order. Fills in the entry; what it knew before is forgotten. */
void tinker_found_identify(TinkerFound *found, const TinkerProber *prober);

/* Opens the library; identifies it again where the file has changed since. FALSE with _REFUSED, and entry.refused set. */
gboolean tinker_found_open(TinkerFound *found, const TinkerProber *prober, GError **error);

/* Whether a refused library's manifest or file name says that it has the type or integrator. */
gboolean tinker_found_suggests(const TinkerFound *found, const char *id);

#endif
