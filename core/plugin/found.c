/* Found libraries: identified by what is cheapest, opened as late as possible. */
#include "plugin/found-private.h"

#include <string.h>

#include "plugin/manifest-private.h"
#include "plugin/permissions-private.h"
#include "plugin/probe-private.h"
#include "plugin/refuse-private.h"

static void replace(char **target, char **source)
{
    g_free(*target);
    *target = g_steal_pointer(source);
}

/* Takes over what a manifest says. */
static void take_manifest(TinkerLibraryEntry *entry, TinkerManifest *manifest)
{
    replace(&entry->id, &manifest->id);
    replace(&entry->title, &manifest->title);
    replace(&entry->version, &manifest->version);
    replace(&entry->licence, &manifest->licence);
    replace(&entry->home_page, &manifest->home_page);
    g_ptr_array_unref(entry->types);
    entry->types = g_ptr_array_ref(manifest->types);
    g_ptr_array_unref(entry->integrators);
    entry->integrators = g_ptr_array_ref(manifest->integrators);
}

static void forget(TinkerLibraryEntry *entry)
{
    g_clear_pointer(&entry->id, g_free);
    g_clear_pointer(&entry->title, g_free);
    g_clear_pointer(&entry->version, g_free);
    g_clear_pointer(&entry->licence, g_free);
    g_clear_pointer(&entry->home_page, g_free);
    g_clear_pointer(&entry->refused, g_free);
    g_ptr_array_unref(entry->types);
    g_ptr_array_unref(entry->integrators);
    entry->types = g_ptr_array_new();
    entry->integrators = g_ptr_array_new();
}

static void refuse(TinkerLibraryEntry *entry, const char *reason)
{
    g_free(entry->refused);
    entry->refused = g_strdup(reason);
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
    const char *path = found->entry.path;
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
        tinker_plugin_cache_look_up(prober->cache, found->entry.path, &found->identity, &refused);
    if (manifest != NULL) return manifest;
    if (refused == NULL) return probe(found, prober, error);
    tinker_refuse(error, "%s", refused);
    return NULL;
}

/* A file name suggests the type or method that it is named after: spring.so, libspring.so, tinker-spring.so. */
static gboolean is_named_after(const char *path, const char *id)
{
    static const char *const prefixes[] = {"", "lib", "tinker-", "libtinker-"};
    g_autofree char *name = g_path_get_basename(path);
    for (gsize i = 0; i < G_N_ELEMENTS(prefixes); i++) {
        g_autofree char *expected = g_strconcat(prefixes[i], id, ".so", NULL);
        if (strcmp(name, expected) == 0) return TRUE;
    }
    return FALSE;
}

TinkerFound *tinker_found_new(const char *path, const char *folder_kind)
{
    TinkerFound *found = g_new0(TinkerFound, 1);
    found->entry.path = g_strdup(path);
    found->entry.folder_kind = g_strdup(folder_kind);
    found->entry.types = g_ptr_array_new();
    found->entry.integrators = g_ptr_array_new();
    return found;
}

TinkerFound *tinker_found_opened(const TinkerLibrary *library, GError **error)
{
    cJSON *json = tinker_manifest_to_json(library);
    g_autoptr(TinkerManifest) manifest = tinker_manifest_from_json(json, error);
    cJSON_Delete(json);
    if (manifest == NULL) return NULL;
    TinkerFound *found = tinker_found_new(library->path, "command line");
    take_manifest(&found->entry, manifest);
    found->identity = library->identity;
    found->library = library;
    return found;
}

void tinker_found_free(gpointer data)
{
    TinkerFound *found = data;
    forget(&found->entry);
    g_ptr_array_unref(found->entry.types);
    g_ptr_array_unref(found->entry.integrators);
    g_free(found->entry.path);
    g_free(found->entry.folder_kind);
    g_free(found->entry.shadowed_by);
    g_free(found);
}

void tinker_found_identify(TinkerFound *found, const TinkerProber *prober)
{
    TinkerLibraryEntry *entry = &found->entry;
    forget(entry);
    // Even of a library that will be refused, its manifest is worth knowing: it says which type is missing, and why.
    g_autoptr(TinkerManifest) beside = tinker_manifest_beside(entry->path);
    g_autoptr(GError) error = NULL;
    if (!tinker_identity_read(entry->path, &found->identity, &error) ||
        !tinker_permissions_check(entry->path, &error)) {
        if (beside != NULL) take_manifest(entry, beside);
        refuse(entry, error->message);
        return;
    }
    if (beside != NULL && tinker_manifest_matches(beside, entry->path, &found->identity)) {
        take_manifest(entry, beside);
        return;
    }
    g_autoptr(TinkerManifest) probed = recall_or_probe(found, prober, &error);
    if (probed != NULL || beside != NULL) take_manifest(entry, probed != NULL ? probed : beside);
    if (probed == NULL) refuse(entry, error->message);
}

gboolean tinker_found_open(TinkerFound *found, const TinkerProber *prober, GError **error)
{
    TinkerLibraryEntry *entry = &found->entry;
    if (found->library != NULL) return TRUE;
    TinkerIdentity now;
    if (!tinker_identity_read(entry->path, &now, NULL) || !tinker_identity_same_file_time(&now, &found->identity))
        tinker_found_identify(found, prober);

    g_autoptr(GError) reason = NULL;
    const TinkerLibrary *library = entry->refused == NULL ? tinker_library_open(entry->path, &reason) : NULL;
    if (library != NULL && strcmp(library->plugin->id, entry->id) != 0)
        tinker_refuse(&reason,
                      "its manifest says \"%s\", the library itself says \"%s\"; its manifest has to be made anew",
                      entry->id, library->plugin->id);
    if (reason != NULL) refuse(entry, reason->message);
    if (entry->refused != NULL)
        return tinker_refuse(error, "the library \"%s\" was refused: %s", entry->path, entry->refused);
    found->library = library;
    return TRUE;
}

gboolean tinker_found_suggests(const TinkerFound *found, const char *id)
{
    const TinkerLibraryEntry *entry = &found->entry;
    if (entry->refused == NULL) return FALSE;
    for (guint i = 0; i < entry->types->len; i++) {
        const TinkerTypeEntry *type = entry->types->pdata[i];
        if (strcmp(type->id, id) == 0) return TRUE;
    }
    return g_ptr_array_find_with_equal_func(entry->integrators, id, g_str_equal, NULL) ||
           is_named_after(entry->path, id);
}
