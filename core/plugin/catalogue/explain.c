/* What is said of a type or method that nobody provides. */
#include "plugin/catalogue/explain-private.h"

#include "plugin/catalogue/entry-private.h"
#include "units/quantity/units.h"

/* The refused library that has the id by its manifest or its file name; else, where nobody can tell, the first that was
 * refused, and `others` tells how many more there are. NULL: none was refused. */
static const TinkerLibraryEntry *find_refused(const GPtrArray *libraries, const char *id, gboolean *sure, guint *others)
{
    const TinkerLibraryEntry *first = NULL;
    *sure = FALSE;
    *others = 0;
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *entry = libraries->pdata[i];
        if (entry->refused == NULL) continue;
        *sure = tinker_library_entry_suggests(entry, id);
        if (*sure) return entry;
        if (first == NULL)
            first = entry;
        else
            (*others)++;
    }
    return first;
}

char *tinker_explain_refused(const GPtrArray *libraries, const char *id, gboolean *sure)
{
    guint others;
    const TinkerLibraryEntry *entry = find_refused(libraries, id, sure, &others);
    if (entry == NULL) return g_strdup("");
    g_autofree char *which =
        others == 0 ? g_strdup("a refused one") : g_strdup_printf("one of %u that were refused", others + 1);
    g_autofree char *begin = *sure ? g_strdup(": ") : g_strdup_printf("; it may be in %s: ", which);
    return g_strdup_printf("%sthe library \"%s\" was refused: %s", begin, entry->path, entry->refused);
}

char *tinker_explain_missing(const GPtrArray *libraries, GHashTable *provided, const char *id)
{
    if (libraries->len == 0) return g_strdup(" (no plugin was found at all)");
    guint count;
    gboolean sure;
    g_autofree const char **known = (const char **)g_hash_table_get_keys_as_array(provided, &count);
    g_autofree char *refused = tinker_explain_refused(libraries, id, &sure);
    const char *nearest = sure ? NULL : tinker_nearest_word(id, known);
    if (nearest != NULL) return g_strdup_printf(" (did you mean \"%s\"?)%s", nearest, refused);
    if (refused[0] != '\0') return g_steal_pointer(&refused);
    return g_strdup(" (its library belongs into a plugin folder, or into one named by --plugins)");
}
