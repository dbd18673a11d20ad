/* The catalogue: the search, and who comes first. */
#include "plugin/catalogue/catalogue-private.h"
#include "plugin/catalogue/entry-private.h"
#include "plugin/catalogue/explain-private.h"
#include "plugin/catalogue/manifest-private.h"
#include "plugin/catalogue/search.h"

#define USUAL_PROBE_SECONDS 5.0

static void warn(TinkerCatalogue *catalogue, const char *format, ...) G_GNUC_PRINTF(2, 3);

static void warn(TinkerCatalogue *catalogue, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_mutex_lock(&catalogue->lists);
    g_ptr_array_add(catalogue->warnings, g_strdup_vprintf(format, arguments));
    g_mutex_unlock(&catalogue->lists);
    va_end(arguments);
}

void tinker_catalogue_publish(TinkerCatalogue *catalogue)
{
    g_autoptr(GPtrArray) libraries = tinker_library_entries_new();
    for (guint i = 0; i < catalogue->found->len; i++) {
        const TinkerFound *found = catalogue->found->pdata[i];
        g_ptr_array_add(libraries, tinker_library_entry_ref(found->entry));
    }
    g_mutex_lock(&catalogue->lists);
    GPtrArray *before = catalogue->libraries;
    catalogue->libraries = g_steal_pointer(&libraries);
    g_mutex_unlock(&catalogue->lists);
    g_clear_pointer(&before, g_ptr_array_unref);
}

/* What is in a list at present. (transfer full) */
static GPtrArray *copy_of_texts(TinkerCatalogue *catalogue, GPtrArray *texts)
{
    GPtrArray *copy = g_ptr_array_new_with_free_func(g_free);
    g_mutex_lock(&catalogue->lists);
    for (guint i = 0; i < texts->len; i++)
        g_ptr_array_add(copy, g_strdup(texts->pdata[i]));
    g_mutex_unlock(&catalogue->lists);
    return copy;
}

/* The library that provides the plugin of this id, or NULL. */
static TinkerFound *find_plugin(const TinkerCatalogue *catalogue, const char *id)
{
    for (guint i = 0; i < catalogue->found->len; i++) {
        TinkerFound *found = catalogue->found->pdata[i];
        const TinkerLibraryEntry *entry = found->entry;
        if (tinker_library_is_used(entry) && g_strcmp0(entry->id, id) == 0) return found;
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
        warn(catalogue, "the %s \"%s\" of \"%s\" is passed over: \"%s\" comes first", what, id, found->entry->path,
             first->entry->path);
    }
}

static void provide_all(TinkerCatalogue *catalogue, TinkerFound *found)
{
    for (guint i = 0; i < found->entry->types->len; i++) {
        TinkerTypeEntry *type = found->entry->types->pdata[i];
        provide(catalogue, catalogue->types, "block type", type->id, found);
    }
    for (guint i = 0; i < found->entry->integrators->len; i++)
        provide(catalogue, catalogue->integrators, "integrator", found->entry->integrators->pdata[i], found);
}

static void add_library(TinkerCatalogue *catalogue, const char *path, const char *folder_kind)
{
    const TinkerProber prober = tinker_catalogue_prober(catalogue);
    TinkerFound *found = tinker_found_new(path, folder_kind);
    tinker_found_identify(found, &prober);
    TinkerLibraryEntry *entry = found->entry;
    const TinkerFound *first = entry->refused == NULL ? find_plugin(catalogue, entry->id) : NULL;
    g_ptr_array_add(catalogue->found, found);
    if (entry->refused != NULL) {
        warn(catalogue, "the library \"%s\" was refused: %s", path, entry->refused);
    } else if (first != NULL) {
        entry->shadowed_by = g_strdup(first->entry->path);
        warn(catalogue, "the library \"%s\" is passed over: \"%s\" provides the plugin \"%s\" and comes first", path,
             first->entry->path, entry->id);
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

void tinker_catalogue_write_cache(TinkerCatalogue *catalogue)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *distrusted = tinker_plugin_cache_distrusted(catalogue->cache);
    if (distrusted != NULL) warn(catalogue, "what is remembered about plugins is not believed: %s", distrusted);
    if (!tinker_plugin_cache_write(catalogue->cache, &error))
        warn(catalogue, "what was found out about plugins is not remembered: %s", error->message);
}

static TinkerPluginCache *new_cache(const char *folder)
{
    g_autofree char *usual = g_build_filename(g_get_user_cache_dir(), "tinker", NULL);
    return tinker_plugin_cache_new(folder == NULL ? usual : folder);
}

TinkerCatalogue *tinker_catalogue_new(const TinkerCatalogueOptions *options)
{
    TinkerCatalogue *catalogue = g_new0(TinkerCatalogue, 1);
    g_mutex_init(&catalogue->opening);
    g_mutex_init(&catalogue->lists);
    catalogue->found = g_ptr_array_new_with_free_func(tinker_found_free);
    catalogue->warnings = g_ptr_array_new_with_free_func(g_free);
    catalogue->opened = g_ptr_array_new_with_free_func(g_free);
    catalogue->bundles = g_ptr_array_new();
    catalogue->types = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    catalogue->integrators = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    catalogue->cache = new_cache(options->cache_folder);
    catalogue->probe_program = g_strdup(options->probe_program);
    catalogue->probe_seconds = options->probe_seconds > 0 ? options->probe_seconds : USUAL_PROBE_SECONDS;
    catalogue->method_fault = options->method_fault;
    catalogue->folders = tinker_search_folders(options, catalogue->warnings);
    search(catalogue);
    tinker_catalogue_publish(catalogue);
    tinker_catalogue_write_cache(catalogue);
    return catalogue;
}

char *tinker_catalogue_method_fault(TinkerCatalogue *catalogue, const char *id)
{
    return catalogue->method_fault == NULL ? NULL : catalogue->method_fault(catalogue, id);
}

void tinker_catalogue_free(TinkerCatalogue *catalogue)
{
    if (catalogue == NULL) return;
    g_hash_table_unref(catalogue->types);
    g_hash_table_unref(catalogue->integrators);
    g_ptr_array_unref(catalogue->opened);
    g_ptr_array_unref(catalogue->bundles);
    g_ptr_array_unref(catalogue->libraries);
    g_ptr_array_unref(catalogue->found);
    g_ptr_array_unref(catalogue->warnings);
    g_ptr_array_unref(catalogue->folders);
    tinker_plugin_cache_free(catalogue->cache);
    g_free(catalogue->probe_program);
    g_mutex_clear(&catalogue->opening);
    g_mutex_clear(&catalogue->lists);
    g_free(catalogue);
}

GPtrArray *tinker_catalogue_libraries(TinkerCatalogue *catalogue)
{
    g_mutex_lock(&catalogue->lists);
    GPtrArray *libraries = g_ptr_array_ref(catalogue->libraries);
    g_mutex_unlock(&catalogue->lists);
    return libraries;
}

const GPtrArray *tinker_catalogue_bundles(TinkerCatalogue *catalogue)
{
    return catalogue->bundles;
}

GPtrArray *tinker_catalogue_warnings(TinkerCatalogue *catalogue)
{
    return copy_of_texts(catalogue, catalogue->warnings);
}

char *tinker_catalogue_explain_refused(TinkerCatalogue *catalogue, const char *id)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    gboolean sure;
    return tinker_explain_refused(libraries, id, &sure);
}

GPtrArray *tinker_catalogue_opened(TinkerCatalogue *catalogue)
{
    return copy_of_texts(catalogue, catalogue->opened);
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
