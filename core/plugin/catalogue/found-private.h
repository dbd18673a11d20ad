/* A library that the search found: what is known of it before it is opened. */
#ifndef TINKER_PLUGIN_FOUND_PRIVATE_H
#define TINKER_PLUGIN_FOUND_PRIVATE_H

#include "plugin/call/library.h"
#include "plugin/catalogue/cache-private.h"
#include "plugin/catalogue/catalogue.h"

/* One thread at a time identifies and opens it. */
typedef struct {
    TinkerLibraryEntry *entry;    /* what is known of it at present; another one when that changes */
    TinkerIdentity identity;      /* of the file when it was identified */
    const TinkerLibrary *library; /* NULL until it is opened; from then on the entry stays */
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
 * in this order. Puts another entry in the place of the one before. */
void tinker_found_identify(TinkerFound *found, const TinkerProber *prober);

/* Opens the library; identifies it again where the file has changed since. FALSE with _REFUSED, and an entry that is
 * refused. */
gboolean tinker_found_open(TinkerFound *found, const TinkerProber *prober, GError **error);

#endif
