/* Runs one part of the core by its name, for faults that the command line cannot be brought to. */
#include "worker.h"

#include <stdio.h>

#include "physics/record/record.h"
#include "plugin/call/crash.h"
#include "plugin/catalogue/cache-private.h"

int worker_failed(const GError *error)
{
    fprintf(stderr, "%s\n", error->message);
    return 5;
}

/* Rows far beyond the memory that is allowed: all that was appended is read back, or an error is told. */
static int record(void)
{
    enum { ROWS = 3000, IN_MEMORY = 700 * sizeof(double) };
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerRecord) record = tinker_record_new(1, IN_MEMORY);
    for (int i = 0; i < ROWS; i++) {
        const double row = i;
        if (!tinker_record_append(record, &row, &error)) break;
    }
    const gsize rows = tinker_record_rows(record);
    if (error == NULL && rows != ROWS) g_error("%" G_GSIZE_FORMAT " rows were kept", rows);
    g_autofree double *values = g_new(double, rows);
    g_autoptr(GError) unread = NULL;
    if (!tinker_record_read(record, 0, rows, values, &unread)) return worker_failed(error != NULL ? error : unread);
    for (gsize i = 0; i < rows; i++)
        if (values[i] != (double)i) g_error("row %" G_GSIZE_FORMAT " reads back as %g", i, values[i]);
    return error == NULL ? 0 : worker_failed(error);
}

/* Remembers a refusal of a file that exists; the caller looks at what was written. */
static int cache(const char *folder)
{
    static const TinkerIdentity identity = {1, 2};
    static const char file[] = "/dev/null";
    g_autoptr(GError) error = NULL;
    TinkerPluginCache *cache = tinker_plugin_cache_new(folder);
    tinker_plugin_cache_remember_refusal(cache, file, &identity, "new");
    const gboolean written = tinker_plugin_cache_write(cache, &error);
    tinker_plugin_cache_free(cache);
    return written ? 0 : worker_failed(error);
}

/* A manifest that cannot be read counts as none; one that can is whole. */
static int manifest(const char *library)
{
    g_autoptr(TinkerManifest) manifest = tinker_manifest_beside(library);
    if (manifest != NULL && g_strcmp0(manifest->id, "org.tinker.test") != 0) g_error("half a manifest was taken");
    return 0;
}

int main(int argc, char **argv)
{
    tinker_crash_watch("fault-worker");
    tinker_crash_watch_memory();
    if (argc == 2 && g_str_equal(argv[1], "record")) return record();
#ifdef WITH_AUTOSAVE
    if (argc == 2 && g_str_equal(argv[1], "autosave")) return worker_autosave();
#endif
    if (argc == 3 && g_str_equal(argv[1], "cache")) return cache(argv[2]);
    if (argc == 3 && g_str_equal(argv[1], "manifest")) return manifest(argv[2]);
    return 2;
}
