/* Found libraries: identified by what is cheapest, opened as late as possible. */
#include "plugin/catalogue/found-private.h"

#include <string.h>

#include "plugin/catalogue/entry-private.h"
#include "plugin/catalogue/manifest-private.h"
#include "plugin/catalogue/probe-private.h"
#include "plugin/trust/permissions.h"
#include "plugin/trust/refuse.h"

/* Puts another entry in the place of what was known. */
static void take_entry(TinkerFound *found, TinkerLibraryEntry *entry)
{
    tinker_library_entry_unref(found->entry);
    found->entry = entry;
}

static void refuse(TinkerFound *found, const char *reason)
{
    take_entry(found, tinker_library_entry_refused(found->entry, reason));
}

/* Reads what the probe wrote; it has to speak of the file as it was before the probe. */
static TinkerManifest *read_probed(const char *text, const TinkerFound *found, GError **error)
{
    TinkerManifest *manifest = tinker_manifest_parse(text, error);
    if (manifest == NULL) {
        g_autofree char *reason = g_strdup((*error)->message);
        g_clear_error(error);
        tinker_refuse(error, "what it wrote while it was probed is not a manifest: %s", reason);
        return NULL;
    }
    if (tinker_identity_same_file_time(&manifest->identity, &found->identity)) return manifest;
    tinker_manifest_free(manifest);
    tinker_fail_file(error, "it was changed while it was probed");
    return NULL;
}

static TinkerManifest *probe(const TinkerFound *found, const TinkerProber *prober, GError **error)
{
    const char *path = found->entry->path;
    if (prober->program == NULL) {
        tinker_fail_file(error, "it has no manifest that matches it, and there is no program to probe it with");
        return NULL;
    }
    g_autofree char *text = tinker_probe(prober->program, path, prober->seconds, error);
    TinkerManifest *manifest = text == NULL ? NULL : read_probed(text, found, error);
    if (manifest != NULL)
        tinker_plugin_cache_remember_manifest(prober->cache, path, &found->identity, text);
    else if (g_error_matches(*error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED))
        tinker_plugin_cache_remember_refusal(prober->cache, path, &found->identity, (*error)->message);
    return manifest;
}

static TinkerManifest *recall_or_probe(const TinkerFound *found, const TinkerProber *prober, GError **error)
{
    g_autofree char *refused = NULL;
    TinkerManifest *manifest =
        tinker_plugin_cache_look_up(prober->cache, found->entry->path, &found->identity, &refused);
    if (manifest != NULL) return manifest;
    if (refused == NULL) return probe(found, prober, error);
    tinker_refuse(error, "%s", refused);
    return NULL;
}

TinkerFound *tinker_found_new(const char *path, const char *folder_kind)
{
    TinkerFound *found = g_new0(TinkerFound, 1);
    found->entry = tinker_library_entry_new(path, folder_kind);
    return found;
}

TinkerFound *tinker_found_opened(const TinkerLibrary *library, GError **error)
{
    cJSON *json = tinker_manifest_to_json(library);
    g_autoptr(TinkerManifest) manifest = tinker_manifest_from_json(json, error);
    cJSON_Delete(json);
    if (manifest == NULL) return NULL;
    TinkerFound *found = tinker_found_new(library->path, "command line");
    tinker_library_entry_take(found->entry, manifest);
    found->identity = library->identity;
    found->library = library;
    return found;
}

void tinker_found_free(gpointer data)
{
    TinkerFound *found = data;
    tinker_library_entry_unref(found->entry);
    g_free(found);
}

/* The manifest by which the library is known, NULL with the reason why it is refused. (transfer full) */
static TinkerManifest *manifest_of(TinkerFound *found, const TinkerProber *prober, TinkerManifest **beside,
                                   GError **error)
{
    const char *path = found->entry->path;
    if (!tinker_identity_read(path, &found->identity, error) || !tinker_permissions_check(path, error)) return NULL;
    if (*beside != NULL && tinker_manifest_matches(*beside, path, &found->identity)) return g_steal_pointer(beside);
    return recall_or_probe(found, prober, error);
}

void tinker_found_identify(TinkerFound *found, const TinkerProber *prober)
{
    TinkerLibraryEntry *entry = tinker_library_entry_anew(found->entry);
    // Even of a library that will be refused, its manifest is worth knowing: it says which type is missing, and why.
    g_autoptr(TinkerManifest) beside = tinker_manifest_beside(entry->path);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerManifest) own = manifest_of(found, prober, &beside, &error);
    if (own != NULL || beside != NULL) tinker_library_entry_take(entry, own != NULL ? own : beside);
    if (own == NULL) entry->refused = g_strdup(error->message);
    take_entry(found, entry);
}

gboolean tinker_found_open(TinkerFound *found, const TinkerProber *prober, GError **error)
{
    if (found->library != NULL) return TRUE;
    TinkerIdentity now;
    if (!tinker_identity_read(found->entry->path, &now, NULL) ||
        !tinker_identity_same_file_time(&now, &found->identity))
        tinker_found_identify(found, prober);

    const TinkerLibraryEntry *entry = found->entry;
    g_autoptr(GError) reason = NULL;
    const TinkerLibrary *library = entry->refused == NULL ? tinker_library_open(entry->path, &reason) : NULL;
    if (library != NULL && strcmp(library->plugin->id, entry->id) != 0)
        tinker_refuse(&reason,
                      "its manifest says \"%s\", the library itself says \"%s\"; its manifest has to be made anew",
                      entry->id, library->plugin->id);
    if (reason != NULL) refuse(found, reason->message);
    if (found->entry->refused != NULL)
        return tinker_refuse(error, "the library \"%s\" was refused: %s", found->entry->path, found->entry->refused);
    g_atomic_pointer_set(&found->library, library); // read by those who need not wait
    return TRUE;
}
