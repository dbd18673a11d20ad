/* A refused library is passed over by palette and panels; here is where its user learns why. */
#include "gui/document/refusal-notices.h"

#include <glib/gi18n-lib.h>

/* Where the cache cannot be written, the same notice comes again at the next start. */
static void forget(void *catalogue)
{
    (void)tinker_catalogue_clear_refused(catalogue, NULL);
}

GPtrArray *tinker_refusal_notices(TinkerCatalogue *catalogue)
{
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (library->refused == NULL) continue;
        g_autofree char *name = g_path_get_basename(library->path);
        g_autofree char *text = g_strdup_printf(_("The plugin %s was refused: %s."), name, library->refused);
        g_ptr_array_add(notices, tinker_notice_new(TINKER_NOTICE_WARNING, text, _("Look Again at the Next Start"),
                                                   forget, catalogue, NULL));
    }
    return notices;
}
