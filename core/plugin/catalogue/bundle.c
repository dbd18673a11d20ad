/* Bundles. All names in one are fixed (bundle.json, page.md, scenes), so that no text in the marker can lead out of the
 * folder; links in it are not followed for scenes and page, which nobody checks when they are opened. */
#include "plugin/catalogue/bundle-private.h"

#include <cjson/cJSON.h>
#include <sys/stat.h>

#include "plugin/catalogue/search.h"
#include "plugin/descriptor/text-check.h"
#include "plugin/trust/permissions.h"
#include "plugin/trust/refuse.h"

#define BUNDLE_FORMAT 1
#define MARKER        "bundle.json"
#define PAGE          "page.md"
#define SCENE_FOLDER  "scenes"
#define SCENE_ENDING  ".tinker.json"
#define MOST_BYTES    (1 << 16)

/* What lies at the path itself, not behind a link; 0: nothing. */
static mode_t kind_of(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 ? status.st_mode & S_IFMT : 0;
}

static gboolean read_texts(TinkerBundleEntry *bundle, const cJSON *json, GError **error)
{
    const cJSON *format = cJSON_GetObjectItemCaseSensitive(json, "bundle");
    if (!cJSON_IsNumber(format) || format->valuedouble != BUNDLE_FORMAT)
        return tinker_refuse(error, "%s is not that of a bundle of format %d (it would hold \"bundle\": %d)", MARKER,
                             BUNDLE_FORMAT, BUNDLE_FORMAT);
    const cJSON *title = cJSON_GetObjectItemCaseSensitive(json, "title");
    const cJSON *summary = cJSON_GetObjectItemCaseSensitive(json, "summary");
    if (!cJSON_IsString(title)) return tinker_refuse(error, "%s has no text \"title\"", MARKER);
    if (summary != NULL && !cJSON_IsString(summary))
        return tinker_refuse(error, "the \"summary\" of %s is not a text", MARKER);
    if (!tinker_check_id(title->valuestring, "its title", "", error)) return FALSE;
    if (summary != NULL && !tinker_check_text(summary->valuestring, "its summary", TRUE, error)) return FALSE;
    bundle->title = g_strdup(title->valuestring);
    bundle->summary = g_strdup(summary != NULL ? summary->valuestring : "");
    return TRUE;
}

static gboolean read_marker(TinkerBundleEntry *bundle, GError **error)
{
    g_autofree char *path = g_build_filename(bundle->path, MARKER, NULL);
    g_autofree char *text = tinker_read_trusted(path, MOST_BYTES, error);
    if (text == NULL) {
        g_prefix_error(error, "%s: ", MARKER);
        return FALSE;
    }
    cJSON *json = cJSON_ParseWithOpts(text, NULL, TRUE);
    const gboolean read =
        json == NULL ? tinker_refuse(error, "%s is not JSON", MARKER) : read_texts(bundle, json, error);
    cJSON_Delete(json);
    return read;
}

static void find_scenes(TinkerBundleEntry *bundle)
{
    g_autofree char *folder = g_build_filename(bundle->path, SCENE_FOLDER, NULL);
    g_autoptr(GDir) directory = kind_of(folder) == S_IFDIR ? g_dir_open(folder, 0, NULL) : NULL;
    const char *name;
    while (directory != NULL && (name = g_dir_read_name(directory)) != NULL) {
        g_autofree char *path = g_build_filename(folder, name, NULL);
        if (name[0] != '.' && g_str_has_suffix(name, SCENE_ENDING) && kind_of(path) == S_IFREG)
            g_ptr_array_add(bundle->scenes, g_steal_pointer(&path));
    }
    tinker_search_sort(bundle->scenes);
}

gboolean tinker_bundle_is_marked(const char *folder)
{
    g_autofree char *marker = g_build_filename(folder, MARKER, NULL);
    return kind_of(marker) != 0;
}

TinkerBundleEntry *tinker_bundle_read(const char *folder, GError **error)
{
    // The check of a path is one of its folder as well: here of the plugin folder, with the marker of the bundle's.
    if (!tinker_permissions_check(folder, error)) return NULL;
    TinkerBundleEntry *bundle = g_new0(TinkerBundleEntry, 1);
    bundle->path = g_strdup(folder);
    bundle->scenes = g_ptr_array_new_with_free_func(g_free);
    if (!read_marker(bundle, error)) {
        tinker_bundle_free(bundle);
        return NULL;
    }
    g_autofree char *page = g_build_filename(folder, PAGE, NULL);
    if (kind_of(page) == S_IFREG) bundle->page = g_steal_pointer(&page);
    find_scenes(bundle);
    return bundle;
}

void tinker_bundle_free(gpointer data)
{
    TinkerBundleEntry *bundle = data;
    if (bundle == NULL) return;
    g_free(bundle->path);
    g_free(bundle->title);
    g_free(bundle->summary);
    g_free(bundle->page);
    g_ptr_array_unref(bundle->scenes);
    g_free(bundle);
}
