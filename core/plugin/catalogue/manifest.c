/* Manifests. A manifest that is missing, damaged or out of date is no error: the library is probed instead. */
#include "plugin/catalogue/manifest-private.h"

#include <string.h>

#include "plugin/trust/permissions.h"
#include "plugin/trust/refuse.h"

#define MANIFEST_FORMAT 1
#define MOST_BYTES      (1 << 20)
#define MOST_QUOTED     40
#define LIBRARY_SUFFIX  ".so"
#define MANIFEST_SUFFIX ".manifest.json"

static void type_entry_free(gpointer data)
{
    TinkerTypeEntry *entry = data;
    g_free(entry->id);
    g_free(entry->title);
    g_free(entry->category);
    g_free(entry->summary);
    g_free(entry);
}

/* A member that is a text; NULL where it is missing or something else. */
static char *text_member(const cJSON *json, const char *name)
{
    return g_strdup(cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, name)));
}

static gboolean read_type(const cJSON *json, GPtrArray *types)
{
    TinkerTypeEntry *entry = g_new0(TinkerTypeEntry, 1);
    g_ptr_array_add(types, entry);
    entry->id = text_member(json, "id");
    entry->title = text_member(json, "title");
    entry->category = text_member(json, "category");
    entry->summary = text_member(json, "summary");
    return entry->id != NULL && entry->title != NULL && entry->category != NULL && entry->summary != NULL;
}

static gboolean read_types(const cJSON *json, GPtrArray *types, GError **error)
{
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "types");
    if (!cJSON_IsArray(list)) return tinker_fail_file(error, "the manifest has no list \"types\"");
    const cJSON *item;
    cJSON_ArrayForEach(item, list)
    {
        if (!read_type(item, types))
            return tinker_fail_file(error, "type %u of the manifest lacks its id, title, category or summary",
                                    types->len - 1);
    }
    return TRUE;
}

static gboolean read_integrators(const cJSON *json, GPtrArray *integrators, GError **error)
{
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "integrators");
    if (!cJSON_IsArray(list)) return tinker_fail_file(error, "the manifest has no list \"integrators\"");
    const cJSON *item;
    cJSON_ArrayForEach(item, list)
    {
        if (!cJSON_IsString(item)) return tinker_fail_file(error, "an integrator of the manifest is not a text");
        g_ptr_array_add(integrators, g_strdup(item->valuestring));
    }
    return TRUE;
}

static gboolean read_head(const cJSON *json, TinkerManifest *manifest, GError **error)
{
    const cJSON *format = cJSON_GetObjectItemCaseSensitive(json, "manifest");
    if (!cJSON_IsNumber(format) || format->valuedouble != MANIFEST_FORMAT)
        return tinker_fail_file(error, "it is not a manifest of format %d", MANIFEST_FORMAT);
    const cJSON *library = cJSON_GetObjectItemCaseSensitive(json, "library");
    if (!tinker_identity_from_json(library, &manifest->identity))
        return tinker_fail_file(error, "the manifest does not say the library's size and time");
    manifest->build_id = text_member(library, "build_id");
    manifest->id = text_member(json, "id");
    manifest->title = text_member(json, "title");
    manifest->version = text_member(json, "version");
    manifest->licence = text_member(json, "licence");
    manifest->home_page = text_member(json, "home_page");
    if (manifest->id == NULL || manifest->title == NULL || manifest->version == NULL || manifest->licence == NULL ||
        manifest->home_page == NULL)
        return tinker_fail_file(error, "the manifest lacks an id, title, version, licence or home_page");
    return TRUE;
}

static void add_types(const TinkerLibrary *library, cJSON *json)
{
    cJSON *types = cJSON_AddArrayToObject(json, "types");
    for (int32_t i = 0; i < library->class_count; i++) {
        const TinkerBlockType *type = library->classes[i]->type;
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "id", type->id);
        cJSON_AddStringToObject(item, "title", type->title);
        cJSON_AddStringToObject(item, "category", type->category);
        cJSON_AddStringToObject(item, "summary", type->summary);
        cJSON_AddItemToArray(types, item);
    }
    cJSON *integrators = cJSON_AddArrayToObject(json, "integrators");
    for (int32_t i = 0; i < library->integrator_count; i++)
        cJSON_AddItemToArray(integrators, cJSON_CreateString(library->integrators[i].id));
}

void tinker_manifest_free(TinkerManifest *manifest)
{
    if (manifest == NULL) return;
    g_free(manifest->build_id);
    g_free(manifest->id);
    g_free(manifest->title);
    g_free(manifest->version);
    g_free(manifest->licence);
    g_free(manifest->home_page);
    g_ptr_array_unref(manifest->types);
    g_ptr_array_unref(manifest->integrators);
    g_free(manifest);
}

cJSON *tinker_manifest_to_json(const TinkerLibrary *library)
{
    const TinkerPlugin *plugin = library->plugin;
    cJSON *json = cJSON_CreateObject();
    cJSON_AddNumberToObject(json, "manifest", MANIFEST_FORMAT);
    cJSON_AddStringToObject(json, "id", plugin->id);
    cJSON_AddStringToObject(json, "title", plugin->title);
    cJSON_AddStringToObject(json, "version", plugin->version);
    cJSON_AddStringToObject(json, "licence", plugin->licence);
    cJSON_AddStringToObject(json, "home_page", plugin->home_page);
    add_types(library, json);
    cJSON *file = cJSON_AddObjectToObject(json, "library");
    tinker_identity_add_to_json(&library->identity, file);
    g_autofree char *build_id = tinker_elf_build_id(library->path);
    if (build_id != NULL) cJSON_AddStringToObject(file, "build_id", build_id);
    return json;
}

TinkerManifest *tinker_manifest_from_json(const cJSON *json, GError **error)
{
    g_autoptr(TinkerManifest) manifest = g_new0(TinkerManifest, 1);
    manifest->types = g_ptr_array_new_with_free_func(type_entry_free);
    manifest->integrators = g_ptr_array_new_with_free_func(g_free);
    if (!read_head(json, manifest, error) || !read_types(json, manifest->types, error) ||
        !read_integrators(json, manifest->integrators, error))
        return NULL;
    return g_steal_pointer(&manifest);
}

TinkerManifest *tinker_manifest_parse(const char *text, GError **error)
{
    cJSON *json = cJSON_ParseWithOpts(text, NULL, TRUE);
    if (json == NULL) {
        g_autofree char *start = g_utf8_make_valid(text, (gssize)MIN(strcspn(text, "\n"), MOST_QUOTED));
        tinker_fail_file(error, "it is not JSON, it begins with \"%s\"", start);
        return NULL;
    }
    TinkerManifest *manifest = tinker_manifest_from_json(json, error);
    cJSON_Delete(json);
    return manifest;
}

TinkerManifest *tinker_manifest_beside(const char *library_path)
{
    if (!g_str_has_suffix(library_path, LIBRARY_SUFFIX)) return NULL;
    const gsize stem = strlen(library_path) - strlen(LIBRARY_SUFFIX);
    g_autofree char *path = g_strdup_printf("%.*s" MANIFEST_SUFFIX, (int)stem, library_path);
    g_autofree char *text = tinker_read_trusted(path, MOST_BYTES, NULL);
    return text == NULL ? NULL : tinker_manifest_parse(text, NULL);
}

gboolean tinker_manifest_matches(const TinkerManifest *manifest, const char *library_path,
                                 const TinkerIdentity *identity)
{
    if (tinker_identity_same_file_time(&manifest->identity, identity)) return TRUE;
    if (manifest->identity.size != identity->size || manifest->build_id == NULL) return FALSE;
    g_autofree char *build_id = tinker_elf_build_id(library_path);
    return g_strcmp0(build_id, manifest->build_id) == 0;
}

void tinker_identity_add_to_json(const TinkerIdentity *identity, cJSON *json)
{
    g_autofree char *time = g_strdup_printf("%" G_GINT64_FORMAT, identity->mtime_ns);
    cJSON_AddNumberToObject(json, "size", (double)identity->size);
    cJSON_AddStringToObject(json, "mtime_ns", time);
}

gboolean tinker_identity_from_json(const cJSON *json, TinkerIdentity *identity)
{
    const cJSON *size = cJSON_GetObjectItemCaseSensitive(json, "size");
    const char *time = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "mtime_ns"));
    if (!cJSON_IsNumber(size) || !(size->valuedouble >= 0 && size->valuedouble < 9e15) || time == NULL) return FALSE;
    identity->size = (gint64)size->valuedouble;
    return g_ascii_string_to_signed(time, 10, G_MININT64, G_MAXINT64, &identity->mtime_ns, NULL);
}
