/* The copy of unsaved work. */
#include "worker.h"

#include <stdio.h>
#include <string.h>

#include "gui/document/autosave.h"

static void on_failed(TinkerAutosave *autosave, const char *message, gpointer data)
{
    fprintf(stderr, "%s\n", message);
}

int worker_autosave(void)
{
    static const char scene[] = "{\"tinker\": 1}";
    g_autoptr(GError) error = NULL;
    const char *folders[] = {g_getenv("TINKER_TEST_PLUGINS"), NULL};
    const TinkerCatalogueOptions options = {.folders = folders};
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&options);
    g_autoptr(GPtrArray) warnings = tinker_catalogue_warnings(catalogue);
    for (guint i = 0; i < warnings->len; i++)
        fprintf(stderr, "%s\n", (char *)g_ptr_array_index(warnings, i));
    g_autoptr(TinkerDocument) document = tinker_document_new(catalogue);
    if (!tinker_document_start(document, scene, strlen(scene), NULL, &error)) return worker_failed(error);
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_signal_connect(autosave, "failed", G_CALLBACK(on_failed), NULL);
    tinker_document_begin(document, "Add", NULL);
    const TinkerBlockClass *mass = tinker_catalogue_type(catalogue, "mass", &error);
    if (mass != NULL) tinker_history_add_block(tinker_document_history(document), mass, "Kept", &error);
    tinker_document_end(document);
    if (error != NULL) return worker_failed(error);
    return tinker_autosave_now(autosave) ? 0 : 5;
}
