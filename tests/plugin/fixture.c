/* Temporary places and copies of modules. */
#include "fixture.h"
#include "folders.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>

/* More than any probe of a well-behaved library can take on a busy machine. */
#define GENEROUS_SECONDS 120

static char *make_folder(const char *root, const char *name)
{
    char *path = g_build_filename(root, name, NULL);
    g_assert_cmpint(g_mkdir(path, 0755), ==, 0);
    return path;
}

void place_set_up(Place *place, gconstpointer data)
{
    g_autoptr(GError) error = NULL;
    g_unsetenv("TINKER_PLUGIN_PATH");
    g_unsetenv("TINKER_SAFE_MODE");
    place->root = g_dir_make_tmp("tinker-plugin-XXXXXX", &error);
    g_assert_no_error(error);
    place->first = make_folder(place->root, "first");
    place->second = make_folder(place->root, "second");
    place->installed = make_folder(place->root, "installed");
    place->cache = g_build_filename(place->root, "cache", NULL);
    place->probe_log = g_build_filename(place->root, "probes", NULL);
    place->probe_program = g_test_build_filename(G_TEST_BUILT, "probe-stub", NULL);
    g_setenv("TINKER_TEST_PROBE_LOG", place->probe_log, TRUE);
    place->folders[0] = place->first;
    place->folders[1] = place->second;
    place->options = (TinkerCatalogueOptions){
        .folders = place->folders,
        .user_folder = g_build_filename(place->root, "user", NULL),
        .installed_folder = place->installed,
        .cache_folder = place->cache,
        .probe_program = place->probe_program,
        .probe_seconds = GENEROUS_SECONDS,
    };
}

void place_tear_down(Place *place, gconstpointer data)
{
    test_remove_all(place->root);
    g_free((char *)place->options.user_folder);
    g_free(place->probe_program);
    g_free(place->root);
    g_free(place->first);
    g_free(place->second);
    g_free(place->installed);
    g_free(place->cache);
    g_free(place->probe_log);
}

char *built_module(const char *name)
{
    g_autofree char *file = g_strconcat(name, ".so", NULL);
    char *path = g_test_build_filename(G_TEST_BUILT, file, NULL);
    if (g_file_test(path, G_FILE_TEST_EXISTS)) return path;
    g_free(path);
    return g_test_build_filename(G_TEST_BUILT, "..", "bad-plugins", file, NULL);
}

char *install_module(const char *module, const char *folder, const char *name)
{
    g_autofree char *source = built_module(module);
    char *target = g_build_filename(folder, name, NULL);
    g_autofree char *bytes = NULL;
    gsize length;
    g_autoptr(GError) error = NULL;
    g_file_get_contents(source, &bytes, &length, &error);
    g_assert_no_error(error);
    // A new file rather than the old one overwritten: a library may be mapped.
    g_file_set_contents_full(target, bytes, (gssize)length, G_FILE_SET_CONTENTS_CONSISTENT, 0644, &error);
    g_assert_no_error(error);
    return target;
}

char *install_text(const char *text, const char *folder, const char *name)
{
    char *target = g_build_filename(folder, name, NULL);
    g_autoptr(GError) error = NULL;
    g_file_set_contents_full(target, text, -1, G_FILE_SET_CONTENTS_CONSISTENT, 0644, &error);
    g_assert_no_error(error);
    return target;
}

char *describe(const char *path)
{
    g_autofree char *stub = g_test_build_filename(G_TEST_BUILT, "probe-stub", NULL);
    const char *const arguments[] = {stub, "plugins", "describe", "--output", "-", path, NULL};
    char *output = NULL;
    int status = -1;
    g_autoptr(GError) error = NULL;
    g_auto(GStrv) environment = g_environ_unsetenv(g_get_environ(), "TINKER_TEST_PROBE_LOG");
    g_spawn_sync(NULL, (char **)arguments, environment, G_SPAWN_DEFAULT, NULL, NULL, &output, NULL, &status, &error);
    g_assert_no_error(error);
    g_assert_cmpint(status, ==, 0);
    return output;
}

guint probe_count(const Place *place)
{
    g_autofree char *text = NULL;
    if (!g_file_get_contents(place->probe_log, &text, NULL, NULL)) return 0;
    guint lines = 0;
    for (const char *p = text; *p != '\0'; p++)
        lines += *p == '\n';
    return lines;
}

const TinkerLibraryEntry *entry_of(TinkerCatalogue *catalogue, const char *path)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *entry = libraries->pdata[i];
        if (strcmp(entry->path, path) == 0) return entry;
    }
    g_error("no library %s", path);
}

guint count_of(GPtrArray *list)
{
    const guint count = list->len;
    g_ptr_array_unref(list);
    return count;
}

void expect_text(GPtrArray *texts, guint number, const char *text)
{
    g_assert_cmpuint(number, <, texts->len);
    g_assert_cmpstr(texts->pdata[number], ==, text);
    g_ptr_array_unref(texts);
}

void set_mtime(const char *path, gint64 mtime_ns)
{
    const struct timespec time = {mtime_ns / 1000000000, mtime_ns % 1000000000};
    const struct timespec times[2] = {time, time};
    g_assert_cmpint(utimensat(AT_FDCWD, path, times, 0), ==, 0);
}

gboolean has_warning(TinkerCatalogue *catalogue, const char *text)
{
    g_autoptr(GPtrArray) warnings = tinker_catalogue_warnings(catalogue);
    for (guint i = 0; i < warnings->len; i++) {
        if (strcmp(warnings->pdata[i], text) == 0) return TRUE;
        g_test_message("warning: %s", (const char *)warnings->pdata[i]);
    }
    return FALSE;
}
