/* Opening on demand: the library of a type or a method when it is asked for, or a file that is named. */
#include <string.h>

#include "plugin/catalogue/catalogue-private.h"
#include "plugin/catalogue/entry-private.h"
#include "plugin/catalogue/explain-private.h"
#include "plugin/trust/refuse.h"

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
    tinker_catalogue_write_cache(catalogue);
    if (found->entry != before) tinker_catalogue_publish(catalogue);
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
    const TinkerProber prober = tinker_catalogue_prober(catalogue);
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
