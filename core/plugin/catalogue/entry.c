/* Entries: counted references, and copies that differ in what is new. */
#include "plugin/catalogue/entry-private.h"

#include <string.h>

TinkerLibraryEntry *tinker_library_entry_new(const char *path, const char *folder_kind)
{
    TinkerLibraryEntry *entry = g_atomic_rc_box_new0(TinkerLibraryEntry);
    entry->path = g_strdup(path);
    entry->folder_kind = g_strdup(folder_kind);
    entry->types = g_ptr_array_new();
    entry->integrators = g_ptr_array_new();
    return entry;
}

TinkerLibraryEntry *tinker_library_entry_ref(TinkerLibraryEntry *entry)
{
    return g_atomic_rc_box_acquire(entry);
}

static void clear(gpointer data)
{
    TinkerLibraryEntry *entry = data;
    char *texts[] = {entry->path,      entry->id,          entry->title,   entry->version,    entry->licence,
                     entry->home_page, entry->folder_kind, entry->refused, entry->shadowed_by};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_ptr_array_unref(entry->types);
    g_ptr_array_unref(entry->integrators);
}

void tinker_library_entry_unref(TinkerLibraryEntry *entry)
{
    if (entry != NULL) g_atomic_rc_box_release_full(entry, clear);
}

GPtrArray *tinker_library_entries_new(void)
{
    return g_ptr_array_new_with_free_func((GDestroyNotify)tinker_library_entry_unref);
}

TinkerLibraryEntry *tinker_library_entry_anew(const TinkerLibraryEntry *entry)
{
    TinkerLibraryEntry *copy = tinker_library_entry_new(entry->path, entry->folder_kind);
    copy->shadowed_by = g_strdup(entry->shadowed_by);
    return copy;
}

static void replace_array(GPtrArray **target, GPtrArray *source)
{
    g_ptr_array_unref(*target);
    *target = g_ptr_array_ref(source);
}

TinkerLibraryEntry *tinker_library_entry_refused(const TinkerLibraryEntry *entry, const char *reason)
{
    TinkerLibraryEntry *copy = tinker_library_entry_anew(entry);
    copy->id = g_strdup(entry->id);
    copy->title = g_strdup(entry->title);
    copy->version = g_strdup(entry->version);
    copy->licence = g_strdup(entry->licence);
    copy->home_page = g_strdup(entry->home_page);
    copy->refused = g_strdup(reason);
    replace_array(&copy->types, entry->types);
    replace_array(&copy->integrators, entry->integrators);
    return copy;
}

void tinker_library_entry_take(TinkerLibraryEntry *entry, TinkerManifest *manifest)
{
    entry->id = g_steal_pointer(&manifest->id);
    entry->title = g_steal_pointer(&manifest->title);
    entry->version = g_steal_pointer(&manifest->version);
    entry->licence = g_steal_pointer(&manifest->licence);
    entry->home_page = g_steal_pointer(&manifest->home_page);
    replace_array(&entry->types, manifest->types);
    replace_array(&entry->integrators, manifest->integrators);
}

gboolean tinker_library_is_used(const TinkerLibraryEntry *library)
{
    return library->refused == NULL && library->shadowed_by == NULL;
}

GPtrArray *tinker_libraries_types(const GPtrArray *libraries)
{
    GPtrArray *types = g_ptr_array_new();
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = libraries->pdata[i];
        if (tinker_library_is_used(library)) g_ptr_array_extend(types, library->types, NULL, NULL);
    }
    return types;
}

GPtrArray *tinker_libraries_integrators(const GPtrArray *libraries)
{
    GPtrArray *ids = g_ptr_array_new();
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = libraries->pdata[i];
        if (tinker_library_is_used(library)) g_ptr_array_extend(ids, library->integrators, NULL, NULL);
    }
    return ids;
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

gboolean tinker_library_entry_suggests(const TinkerLibraryEntry *entry, const char *id)
{
    if (entry->refused == NULL) return FALSE;
    for (guint i = 0; i < entry->types->len; i++) {
        const TinkerTypeEntry *type = entry->types->pdata[i];
        if (strcmp(type->id, id) == 0) return TRUE;
    }
    return g_ptr_array_find_with_equal_func(entry->integrators, id, g_str_equal, NULL) ||
           is_named_after(entry->path, id);
}
