/* The user's cache: manifests of libraries that have none beside them, and remembered refusals.
 *
 * One file, plugins.json. It is read when the first library needs it and written at once, by renaming a new file over
 * the old one. All in it can be found again by probing: a damaged cache is an empty one.
 */
#ifndef TINKER_PLUGIN_CACHE_PRIVATE_H
#define TINKER_PLUGIN_CACHE_PRIVATE_H

#include "plugin/catalogue/manifest-private.h"

typedef struct _TinkerPluginCache TinkerPluginCache;

/* A cache in this folder, which need not exist. (transfer full) */
TinkerPluginCache *tinker_plugin_cache_new(const char *folder);
void tinker_plugin_cache_free(TinkerPluginCache *cache);

/* What is remembered of the file as it is now: a manifest, or in *refused the reason of its refusal; neither where
 * nothing is known. Both (transfer full). */
TinkerManifest *tinker_plugin_cache_look_up(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                            char **refused);

/* Remembers the manifest that this JSON text is, or a refusal. */
void tinker_plugin_cache_remember_manifest(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                           const char *manifest);
void tinker_plugin_cache_remember_refusal(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                          const char *reason);

/* Why what the file said was not believed: others could have written it. Told once; NULL otherwise. (transfer full) */
char *tinker_plugin_cache_distrusted(TinkerPluginCache *cache);

/* Forgets all refusals. */
void tinker_plugin_cache_clear_refused(TinkerPluginCache *cache);

/* Writes the file where anything changed; _FILE on failure. */
gboolean tinker_plugin_cache_write(TinkerPluginCache *cache, GError **error);

#endif
