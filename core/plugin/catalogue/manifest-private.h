/* Manifests: what a library declares, as JSON, so that finding blocks opens no library.
 *
 * `spring.so` has its manifest in `spring.manifest.json` beside it; it can also lie in the user's cache.
 */
#ifndef TINKER_PLUGIN_MANIFEST_PRIVATE_H
#define TINKER_PLUGIN_MANIFEST_PRIVATE_H

#include <cjson/cJSON.h>

#include "plugin/call/library.h"
#include "plugin/catalogue/catalogue.h"
#include "plugin/trust/identity.h"

typedef struct {
    TinkerIdentity identity; /* of the library it was made from */
    char *build_id;          /* or NULL */
    char *id, *title, *version, *licence, *home_page;
    GPtrArray *types;       /* of TinkerTypeEntry */
    GPtrArray *integrators; /* of char * */
} TinkerManifest;

void tinker_manifest_free(TinkerManifest *manifest);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerManifest, tinker_manifest_free)

/* The manifest of an opened library, as JSON. (transfer full) */
cJSON *tinker_manifest_to_json(const TinkerLibrary *library);

/* Reads a manifest; NULL with _FILE, and a message that says which member is missing or wrong. (transfer full) */
TinkerManifest *tinker_manifest_from_json(const cJSON *json, GError **error);
TinkerManifest *tinker_manifest_parse(const char *text, GError **error);

/* The manifest beside the library, whether it matches or not. NULL where there is none or none that can be read or
 * trusted: the library is then probed, so there is nothing to report. (transfer full) */
TinkerManifest *tinker_manifest_beside(const char *library_path);

/* Whether the manifest was made from the file as it is now: size and time agree; or size and build id, as after a copy
 * that did not keep the time. */
gboolean tinker_manifest_matches(const TinkerManifest *manifest, const char *library_path,
                                 const TinkerIdentity *identity);

/* Times in ns have more digits than a double: JSON has them as text. */
void tinker_identity_add_to_json(const TinkerIdentity *identity, cJSON *json);
gboolean tinker_identity_from_json(const cJSON *json, TinkerIdentity *identity);

#endif
