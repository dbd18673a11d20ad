/* The catalogue: the search, who comes first, and opening on demand. */
#include "plugin/catalogue/catalogue.h"

#include <string.h>

#include "plugin/catalogue/cache-private.h"
#include "plugin/catalogue/entry-private.h"
#include "plugin/catalogue/explain-private.h"
#include "plugin/catalogue/found-private.h"
#include "plugin/catalogue/manifest-private.h"
#include "plugin/catalogue/search.h"
#include "plugin/trust/refuse.h"

#define USUAL_PROBE_SECONDS 5.0

/* One thread at a time identifies and opens libraries, for seconds where one is probed. Whoever only wants to know what
 * there is waits for `lists` alone, which is held for a moment. */
struct _TinkerCatalogue {
    GMutex opening;   /* of what is written here: `found`, what is behind it, the cache */
    GPtrArray *found; /* of TinkerFound, in search order; none leaves it */
    TinkerPluginCache *cache;

    GMutex lists;            /* of what follows; changed only while `opening` is held as well */
    GPtrArray *libraries;    /* of TinkerLibraryEntry, in search order; replaced as a whole, never changed */
    GPtrArray *warnings;     /* of char * */
    GPtrArray *opened;       /* of char * */
    GHashTable *types;       /* id to TinkerFound, which is borrowed from `found` */
    GHashTable *integrators; /* likewise */

    /* As they were when it was made. */
    GPtrArray *folders; /* of TinkerSearchFolder */
    GPtrArray *bundles; /* of TinkerBundleEntry, borrowed from the folders */
    char *probe_program;
    double probe_seconds;
    char *(*method_fault)(TinkerCatalogue *catalogue, const char *id);
};

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

/* Lets others see what is known of the libraries by now. */
static void publish(TinkerCatalogue *catalogue)
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

static TinkerProber prober_of(const TinkerCatalogue *catalogue)
{
    return (TinkerProber){catalogue->probe_program, catalogue->probe_seconds, catalogue->cache};
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
    const TinkerProber prober = prober_of(catalogue);
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

/* A cache that cannot be written costs time at the next start, nothing else. */
static void write_cache(TinkerCatalogue *catalogue)
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

static TinkerFound *provider_of(TinkerCatalogue *catalogue, GHashTable *table, const char *id)
{
    g_mutex_lock(&catalogue->lists);
    TinkerFound *found = g_hash_table_lookup(table, id);
    g_mutex_unlock(&catalogue->lists);
    return found;
}

/* What opening it has changed: its entry, the cache, and the list of those that are open. */
static void note_opening(TinkerCatalogue *catalogue, const TinkerFound *found, const TinkerLibraryEntry *before)
{
    write_cache(catalogue);
    if (found->entry != before) publish(catalogue);
    if (found->library == NULL) return;
    g_mutex_lock(&catalogue->lists);
    g_ptr_array_add(catalogue->opened, g_strdup(found->entry->path));
    g_mutex_unlock(&catalogue->lists);
}

/* Opens the library that provides the id; NULL: there is none, or it was refused. Called with `opening` held. */
static TinkerFound *open_first(TinkerCatalogue *catalogue, GHashTable *table, const char *what, const char *id,
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
    const TinkerLibraryEntry *before = found->entry;
    const gboolean opened = tinker_found_open(found, &prober, error);
    note_opening(catalogue, found, before);
    return opened ? found : NULL;
}

/* The opened library that provides the id, or NULL. One that is open already does not wait for one that is being
 * probed. */
static TinkerFound *open_provider(TinkerCatalogue *catalogue, GHashTable *table, const char *what, const char *id,
                                  GError **error)
{
    TinkerFound *found = provider_of(catalogue, table, id);
    if (found != NULL && g_atomic_pointer_get(&found->library) != NULL) return found;
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    return open_first(catalogue, table, what, id, error);
}

/* The manifest promised something that the library does not have. */
static void refuse_broken_promise(const TinkerFound *found, const char *what, const char *id, GError **error)
{
    tinker_refuse(error, "the library \"%s\" has no %s \"%s\", though its manifest says so", found->entry->path, what,
                  id);
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
    publish(catalogue);
    write_cache(catalogue);
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

/* What it provides comes before all others of their ids. */
static void provide_first(TinkerCatalogue *catalogue, TinkerFound *found)
{
    const TinkerLibraryEntry *entry = found->entry;
    g_mutex_lock(&catalogue->lists);
    for (guint i = 0; i < entry->types->len; i++) {
        const TinkerTypeEntry *type = entry->types->pdata[i];
        g_hash_table_replace(catalogue->types, g_strdup(type->id), found);
    }
    for (guint i = 0; i < entry->integrators->len; i++)
        g_hash_table_replace(catalogue->integrators, g_strdup(entry->integrators->pdata[i]), found);
    g_mutex_unlock(&catalogue->lists);
}

const TinkerLibraryEntry *tinker_catalogue_add_file(TinkerCatalogue *catalogue, const char *path, GError **error)
{
    g_autoptr(GMutexLocker) locker = g_mutex_locker_new(&catalogue->opening);
    (void)locker;
    g_autofree char *absolute = g_canonicalize_filename(path, NULL);
    const TinkerLibrary *library = tinker_library_open(absolute, error);
    TinkerFound *found = library == NULL ? NULL : tinker_found_opened(library, error);
    if (found == NULL) return NULL;
    g_ptr_array_insert(catalogue->found, 0, found);
    provide_first(catalogue, found);
    note_opening(catalogue, found, NULL);
    return found->entry;
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
