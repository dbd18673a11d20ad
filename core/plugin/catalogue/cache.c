/* The cache file: {"cache": 1, "abi_minor": 0, "libraries": {PATH: {"size", "mtime_ns", "manifest" or "refused"}}}. */
#include "plugin/catalogue/cache-private.h"

#include <errno.h>
#include <glib/gstdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/replace-file.h"
#include "plugin/trust/permissions.h"
#include "plugin/trust/refuse.h"

#define CACHE_FORMAT 1
#define CACHE_FILE   "plugins.json"
#define MOST_BYTES   (64 << 20)

struct _TinkerPluginCache {
    char *folder;
    cJSON *json;      /* NULL until it is needed */
    cJSON *libraries; /* borrowed from json */
    gboolean changed;
    char *distrusted; /* why the file was not believed, until somebody is told; or NULL */
};

static gboolean number_is(const cJSON *json, const char *name, double expected)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(json, name);
    return cJSON_IsNumber(item) && item->valuedouble == expected;
}

/* A cache of another format or another host says nothing: what one host refuses, a newer one may take. */
static gboolean is_usable(const cJSON *json)
{
    return number_is(json, "cache", CACHE_FORMAT) && number_is(json, "abi_minor", TINKER_ABI_MINOR) &&
           cJSON_IsObject(cJSON_GetObjectItemCaseSensitive(json, "libraries"));
}

static cJSON *new_json(void)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "cache", CACHE_FORMAT);
    cJSON_AddNumberToObject(json, "abi_minor", TINKER_ABI_MINOR);
    cJSON_AddObjectToObject(json, "libraries");
    return json;
}

/* What the file says; NULL: nothing. One that others may write to is not believed, or they could claim any type for any
 * library; it goes, so that the next has permissions of its own. (transfer full) */
static char *read_file(TinkerPluginCache *cache)
{
    g_autofree char *path = g_build_filename(cache->folder, CACHE_FILE, NULL);
    g_autoptr(GError) error = NULL;
    struct stat status;
    if (lstat(path, &status) != 0) return NULL;
    char *text = tinker_read_trusted(path, MOST_BYTES, &error);
    if (text != NULL) return text;
    // One that cannot be read stays until there is another to take its place.
    if (!g_error_matches(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED)) return NULL;
    cache->distrusted = g_strdup_printf("\"%s\": %s", path, error->message);
    cache->changed = TRUE;
    (void)unlink(path);
    return NULL;
}

static void load(TinkerPluginCache *cache)
{
    if (cache->json != NULL) return;
    g_autofree char *text = read_file(cache);
    if (text != NULL) cache->json = cJSON_Parse(text);
    if (!is_usable(cache->json)) {
        cJSON_Delete(cache->json);
        cache->json = new_json();
    }
    cache->libraries = cJSON_GetObjectItemCaseSensitive(cache->json, "libraries");
}

static void remember(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity, const char *member,
                     cJSON *value)
{
    load(cache);
    cJSON *item = cJSON_CreateObject();
    tinker_identity_add_to_json(identity, item);
    cJSON_AddItemToObject(item, member, value);
    cJSON_DeleteItemFromObjectCaseSensitive(cache->libraries, path);
    cJSON_AddItemToObject(cache->libraries, path, item);
    cache->changed = TRUE;
}

/* Deletes the entries of which `unwanted` is true. */
static void delete_entries(TinkerPluginCache *cache, gboolean (*unwanted)(const cJSON *entry))
{
    cJSON *next = NULL;
    for (cJSON *entry = cache->libraries->child; entry != NULL; entry = next) {
        next = entry->next;
        if (!unwanted(entry)) continue;
        cJSON_Delete(cJSON_DetachItemViaPointer(cache->libraries, entry));
        cache->changed = TRUE;
    }
}

static gboolean is_gone(const cJSON *entry)
{
    return !g_file_test(entry->string, G_FILE_TEST_EXISTS);
}

static gboolean is_refused(const cJSON *entry)
{
    return cJSON_HasObjectItem(entry, "refused");
}

TinkerPluginCache *tinker_plugin_cache_new(const char *folder)
{
    TinkerPluginCache *cache = g_new0(TinkerPluginCache, 1);
    cache->folder = g_strdup(folder);
    return cache;
}

void tinker_plugin_cache_free(TinkerPluginCache *cache)
{
    cJSON_Delete(cache->json);
    g_free(cache->distrusted);
    g_free(cache->folder);
    g_free(cache);
}

TinkerManifest *tinker_plugin_cache_look_up(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                            char **refused)
{
    load(cache);
    *refused = NULL;
    const cJSON *entry = cJSON_GetObjectItemCaseSensitive(cache->libraries, path);
    TinkerIdentity known;
    if (!tinker_identity_from_json(entry, &known) || !tinker_identity_same_file_time(&known, identity)) return NULL;
    *refused = g_strdup(cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(entry, "refused")));
    if (*refused != NULL) return NULL;
    return tinker_manifest_from_json(cJSON_GetObjectItemCaseSensitive(entry, "manifest"), NULL);
}

void tinker_plugin_cache_remember_manifest(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                           const char *manifest)
{
    cJSON *json = cJSON_Parse(manifest);
    if (json != NULL) remember(cache, path, identity, "manifest", json);
}

void tinker_plugin_cache_remember_refusal(TinkerPluginCache *cache, const char *path, const TinkerIdentity *identity,
                                          const char *reason)
{
    remember(cache, path, identity, "refused", cJSON_CreateString(reason));
}

char *tinker_plugin_cache_distrusted(TinkerPluginCache *cache)
{
    return g_steal_pointer(&cache->distrusted);
}

void tinker_plugin_cache_clear_refused(TinkerPluginCache *cache)
{
    load(cache);
    delete_entries(cache, is_refused);
}

gboolean tinker_plugin_cache_write(TinkerPluginCache *cache, GError **error)
{
    if (!cache->changed) return TRUE;
    delete_entries(cache, is_gone);
    if (g_mkdir_with_parents(cache->folder, 0700) != 0)
        return tinker_fail_file(error, "the folder \"%s\" cannot be made: %s", cache->folder, g_strerror(errno));
    g_autofree char *path = g_build_filename(cache->folder, CACHE_FILE, NULL);
    char *text = cJSON_Print(cache->json);
    g_autoptr(GError) reason = NULL;
    const gboolean written = tinker_replace_file(path, text, strlen(text), 0600, &reason);
    cJSON_free(text);
    if (!written) return tinker_fail_file(error, "%s: the file cannot be written: %s", path, reason->message);
    cache->changed = FALSE;
    return TRUE;
}
