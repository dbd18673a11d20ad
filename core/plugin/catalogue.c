/* The catalogue: the search, who comes first, and opening on demand. */
#include "plugin/catalogue.h"

#include <string.h>

#include "plugin/cache-private.h"
#include "plugin/explain-private.h"
#include "plugin/found-private.h"
#include "plugin/manifest-private.h"
#include "plugin/refuse-private.h"
#include "plugin/search-private.h"

#define USUAL_PROBE_SECONDS 5.0

struct _TinkerCatalogue {
    GMutex opening;          /* held while a library is looked for and opened: runs in several threads may ask */
    GPtrArray *libraries;    /* of TinkerFound, in search order */
    GPtrArray *warnings;     /* of char * */
    GPtrArray *opened;       /* of char *, borrowed from the libraries */
    GPtrArray *folders;      /* of TinkerSearchFolder */
    GPtrArray *bundles;      /* of TinkerBundleEntry, borrowed from the folders */
    GHashTable *types;       /* id to TinkerFound, which is borrowed from the libraries */
    GHashTable *integrators; /* likewise */
    TinkerPluginCache *cache;
    char *probe_program;
    double probe_seconds;
};

static void warn(TinkerCatalogue *catalogue, const char *format, ...) G_GNUC_PRINTF(2, 3);

static void warn(TinkerCatalogue *catalogue, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(catalogue->warnings, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

static TinkerProber prober_of(const TinkerCatalogue *catalogue)
{
    return (TinkerProber){catalogue->probe_program, catalogue->probe_seconds, catalogue->cache};
}

/* The library that provides the plugin of this id, or NULL. */
static TinkerFound *find_plugin(const TinkerCatalogue *catalogue, const char *id)
{
    for (guint i = 0; i < catalogue->libraries->len; i++) {
        TinkerFound *found = catalogue->libraries->pdata[i];
        if (found->entry.refused == NULL && found->entry.shadowed_by == NULL && g_strcmp0(found->entry.id, id) == 0)
            return found;
    }
    return NULL;
}

/* Enters an id into a table, where the first one stays. */
static void provide(TinkerCatalogue *catalogue, GHashTable *table, const char *what, const char *id, TinkerFound *found)
{
    const TinkerFound *first = g_hash_table_lookup(table, id);
    if (first == NULL) {
        g_hash_table_insert(table, g_strdup(id), found);
    } else if (first != found) {
        warn(catalogue, "the %s \"%s\" of \"%s\" is passed over: \"%s\" comes first", what, id, found->entry.path,
             first->entry.path);
    }
}

static void provide_all(TinkerCatalogue *catalogue, TinkerFound *found)
{
    for (guint i = 0; i < found->entry.types->len; i++) {
        TinkerTypeEntry *type = found->entry.types->pdata[i];
        provide(catalogue, catalogue->types, "block type", type->id, found);
    }
    for (guint i = 0; i < found->entry.integrators->len; i++)
        provide(catalogue, catalogue->integrators, "integrator", found->entry.integrators->pdata[i], found);
}

static void add_library(TinkerCatalogue *catalogue, const char *path, const char *folder_kind)
{
    const TinkerProber prober = prober_of(catalogue);
    TinkerFound *found = tinker_found_new(path, folder_kind);
    tinker_found_identify(found, &prober);
    const TinkerFound *first = found->entry.refused == NULL ? find_plugin(catalogue, found->entry.id) : NULL;
    g_ptr_array_add(catalogue->libraries, found);
    if (found->entry.refused != NULL) {
        warn(catalogue, "the library \"%s\" was refused: %s", path, found->entry.refused);
    } else if (first != NULL) {
        found->entry.shadowed_by = g_strdup(first->entry.path);
        warn(catalogue, "the library \"%s\" is passed over: \"%s\" provides the plugin \"%s\" and comes first", path,
             first->entry.path, found->entry.id);
    } else {
        provide_all(catalogue, found);
    }
}

static void search(TinkerCatalogue *catalogue)
{
    for (guint i = 0; i < catalogue->folders->len; i++) {
        const TinkerSearchFolder *folder = catalogue->folders->pdata[i];
        if (folder->bundle != NULL) g_ptr_array_add(catalogue->bundles, folder->bundle);
        g_autoptr(GPtrArray) paths = tinker_search_libraries(folder, catalogue->warnings);
        for (guint k = 0; k < paths->len; k++)
            add_library(catalogue, paths->pdata[k], folder->kind);
    }
}

/* A cache that cannot be written costs time at the next start, nothing else. */
static void write_cache(TinkerCatalogue *catalogue)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_plugin_cache_write(catalogue->cache, &error))
        warn(catalogue, "what was found out about plugins is not remembered: %s", error->message);
}

static TinkerPluginCache *new_cache(const char *folder)
{
    g_autofree char *usual = g_build_filename(g_get_user_cache_dir(), "tinker", NULL);
    return tinker_plugin_cache_new(folder == NULL ? usual : folder);
}

/* The opened library that provides the id, or NULL; called with the lock held. */
static TinkerFound *open_locked(TinkerCatalogue *catalogue, GHashTable *table, const char *what, const char *id,
                                GError **error)
{
    TinkerFound *found = g_hash_table_lookup(table, id);
    if (found == NULL) {
        g_autofree char *explanation = tinker_explain_missing(catalogue->libraries, table, id);
        g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING, "no plugin provides the %s \"%s\"%s", what,
                    id, explanation);
        return NULL;
    }
    if (found->library != NULL) return found;
    const TinkerProber prober = prober_of(catalogue);
    const gboolean opened = tinker_found_open(found, &prober, error);
    write_cache(catalogue);
    if (!opened) return NULL;
    g_ptr_array_add(catalogue->opened, found->entry.path);
    return found;
}

static TinkerFound *open_provider(TinkerCatalogue *catalogue, GHashTable *table, const char *what, const char *id,
                                  GError **error)
{
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    return open_locked(catalogue, table, what, id, error);
}

/* The manifest promised something that the library does not have. */
static void refuse_broken_promise(const TinkerFound *found, const char *what, const char *id, GError **error)
{
    tinker_refuse(error, "the library \"%s\" has no %s \"%s\", though its manifest says so", found->entry.path, what,
                  id);
}

TinkerCatalogue *tinker_catalogue_new(const TinkerCatalogueOptions *options)
{
    TinkerCatalogue *catalogue = g_new0(TinkerCatalogue, 1);
    g_mutex_init(&catalogue->opening);
    catalogue->libraries = g_ptr_array_new_with_free_func(tinker_found_free);
    catalogue->warnings = g_ptr_array_new_with_free_func(g_free);
    catalogue->opened = g_ptr_array_new();
    catalogue->bundles = g_ptr_array_new();
    catalogue->types = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    catalogue->integrators = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    catalogue->cache = new_cache(options->cache_folder);
    catalogue->probe_program = g_strdup(options->probe_program);
    catalogue->probe_seconds = options->probe_seconds > 0 ? options->probe_seconds : USUAL_PROBE_SECONDS;
    catalogue->folders = tinker_search_folders(options, catalogue->warnings);
    search(catalogue);
    write_cache(catalogue);
    return catalogue;
}

void tinker_catalogue_free(TinkerCatalogue *catalogue)
{
    if (catalogue == NULL) return;
    g_hash_table_unref(catalogue->types);
    g_hash_table_unref(catalogue->integrators);
    g_ptr_array_unref(catalogue->opened);
    g_ptr_array_unref(catalogue->bundles);
    g_ptr_array_unref(catalogue->libraries);
    g_ptr_array_unref(catalogue->warnings);
    g_ptr_array_unref(catalogue->folders);
    tinker_plugin_cache_free(catalogue->cache);
    g_free(catalogue->probe_program);
    g_mutex_clear(&catalogue->opening);
    g_free(catalogue);
}

const GPtrArray *tinker_catalogue_libraries(TinkerCatalogue *catalogue)
{
    return catalogue->libraries;
}

const GPtrArray *tinker_catalogue_bundles(TinkerCatalogue *catalogue)
{
    return catalogue->bundles;
}

const GPtrArray *tinker_catalogue_warnings(TinkerCatalogue *catalogue)
{
    return catalogue->warnings;
}

const TinkerLibraryEntry *tinker_catalogue_add_file(TinkerCatalogue *catalogue, const char *path, GError **error)
{
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    g_autofree char *absolute = g_canonicalize_filename(path, NULL);
    const TinkerLibrary *library = tinker_library_open(absolute, error);
    TinkerFound *found = library == NULL ? NULL : tinker_found_opened(library, error);
    if (found == NULL) return NULL;
    g_ptr_array_insert(catalogue->libraries, 0, found);
    g_ptr_array_add(catalogue->opened, found->entry.path);
    for (guint i = 0; i < found->entry.types->len; i++) {
        const TinkerTypeEntry *type = found->entry.types->pdata[i];
        g_hash_table_replace(catalogue->types, g_strdup(type->id), found);
    }
    for (guint i = 0; i < found->entry.integrators->len; i++)
        g_hash_table_replace(catalogue->integrators, g_strdup(found->entry.integrators->pdata[i]), found);
    return &found->entry;
}

const TinkerBlockClass *tinker_catalogue_type(TinkerCatalogue *catalogue, const char *id, GError **error)
{
    const TinkerFound *found = open_provider(catalogue, catalogue->types, "block type", id, error);
    if (found == NULL) return NULL;
    for (int32_t i = 0; i < found->library->class_count; i++) {
        if (strcmp(found->library->classes[i]->type->id, id) == 0) return found->library->classes[i];
    }
    refuse_broken_promise(found, "block type", id, error);
    return NULL;
}

const TinkerIntegrator *tinker_catalogue_integrator(TinkerCatalogue *catalogue, const char *id, GError **error)
{
    const TinkerFound *found = open_provider(catalogue, catalogue->integrators, "integrator", id, error);
    if (found == NULL) return NULL;
    for (int32_t i = 0; i < found->library->integrator_count; i++) {
        if (strcmp(found->library->integrators[i].id, id) == 0) return &found->library->integrators[i];
    }
    refuse_broken_promise(found, "integrator", id, error);
    return NULL;
}

char *tinker_catalogue_explain_refused(TinkerCatalogue *catalogue, const char *id)
{
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    gboolean sure;
    return tinker_explain_refused(catalogue->libraries, id, &sure);
}

const GPtrArray *tinker_catalogue_opened(TinkerCatalogue *catalogue)
{
    return catalogue->opened;
}

gboolean tinker_catalogue_clear_refused(TinkerCatalogue *catalogue, GError **error)
{
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    tinker_plugin_cache_clear_refused(catalogue->cache);
    return tinker_plugin_cache_write(catalogue->cache, error);
}

char *tinker_plugin_describe(const char *path, GError **error)
{
    g_autofree char *absolute = g_canonicalize_filename(path, NULL);
    const TinkerLibrary *library = tinker_library_open(absolute, error);
    if (library == NULL) {
        g_prefix_error(error, "%s: ", path);
        return NULL;
    }
    cJSON *json = tinker_manifest_to_json(library);
    char *text = cJSON_Print(json);
    char *owned = g_strdup(text);
    cJSON_free(text);
    cJSON_Delete(json);
    return owned;
}
