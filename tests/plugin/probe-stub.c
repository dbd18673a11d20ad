/* The probe program of the tests: `probe-stub plugins describe --output - FILE` writes the manifest of FILE. Every
 * start adds a line to the file that TINKER_TEST_PROBE_LOG names, so that a test can count them. */
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "plugin/catalogue/catalogue.h"

/* Exit statuses, as the command line's contract has them. */
enum { STATUS_USAGE = 2, STATUS_REFUSED = 4, STATUS_FILE = 5 };

static void count_start(const char *path)
{
    const char *log = g_getenv("TINKER_TEST_PROBE_LOG");
    FILE *file = log == NULL ? NULL : fopen(log, "a");
    if (file == NULL) return;
    fprintf(file, "%s\n", path);
    fclose(file);
}

static gboolean is_describe(int count, char **arguments)
{
    return count == 6 && strcmp(arguments[1], "plugins") == 0 && strcmp(arguments[2], "describe") == 0 &&
           strcmp(arguments[3], "--output") == 0 && strcmp(arguments[4], "-") == 0;
}

int main(int count, char **arguments)
{
    // A sanitizer would report a crash and exit; a crash is to look like one.
    signal(SIGSEGV, SIG_DFL);
    if (!is_describe(count, arguments)) {
        fprintf(stderr, "probe-stub: usage: probe-stub plugins describe --output - FILE\n");
        return STATUS_USAGE;
    }
    count_start(arguments[5]);
    g_autoptr(GError) error = NULL;
    g_autofree char *manifest = tinker_plugin_describe(arguments[5], &error);
    if (manifest == NULL) {
        fprintf(stderr, "tinker: %s\n", error->message);
        return g_error_matches(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED) ? STATUS_REFUSED : STATUS_FILE;
    }
    puts(manifest);
    return 0;
}
