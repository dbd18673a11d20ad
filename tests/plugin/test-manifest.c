/* Manifests and the cache: when a library is probed, and when what is known of it suffices. */
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fixture.h"
#include "plugin/trust/identity.h"

static const gint64 one_second = 1000000000;

static TinkerCatalogue *fresh(const Place *place)
{
    return tinker_catalogue_new(&place->options);
}

/* Finds everything anew and answers how many probes that took. */
static guint probes_of_search(const Place *place)
{
    const guint before = probe_count(place);
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    return probe_count(place) - before;
}

static char *install_with_manifest(const Place *place)
{
    char *path = install_module("good", place->first, "good.so");
    g_autofree char *manifest = describe(path);
    g_autofree char *beside = install_text(manifest, place->first, "good.manifest.json");
    return path;
}

/* The linker was told which id to write into the module. */
static void test_build_id(void)
{
    g_autofree char *path = built_module("good");
    g_autofree char *build_id = tinker_elf_build_id(path);
    g_assert_cmpstr(build_id, ==, "0123456789abcdef0123456789abcdef");
    g_assert_null(tinker_elf_build_id("/dev/null"));
}

/* A file cut off anywhere is no reason to read beyond its end. */
static void test_build_id_of_torn_file(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *bytes = NULL;
    gsize length;
    g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
    for (gsize cut = 0; cut < MIN(length, 1024); cut += 7) {
        g_assert_true(g_file_set_contents(path, bytes, (gssize)cut, NULL));
        g_autofree char *build_id = tinker_elf_build_id(path);
        g_assert_true(build_id == NULL || strcmp(build_id, "0123456789abcdef0123456789abcdef") == 0);
    }
}

static void test_manifest_spares_probe(Place *place, gconstpointer data)
{
    g_autofree char *path = install_with_manifest(place);
    place->options.probe_program = NULL;
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_assert_null(entry_of(catalogue, path)->refused);
    g_assert_nonnull(tinker_catalogue_type(catalogue, "pull", NULL));
    g_assert_false(g_file_test(place->cache, G_FILE_TEST_EXISTS));
}

/* A copy that did not keep the time is known by its build id; another time and another content are not. */
static void test_manifest_mismatch(Place *place, gconstpointer data)
{
    g_autofree char *path = install_with_manifest(place);
    g_assert_cmpuint(probes_of_search(place), ==, 0);
    set_mtime(path, 1234567890 * one_second + 987654321);
    g_assert_cmpuint(probes_of_search(place), ==, 0);

    g_autofree char *other = install_module("other", place->first, "good.so");
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_assert_cmpuint(probe_count(place), ==, 1);
    g_assert_cmpstr(entry_of(catalogue, path)->id, ==, "org.tinker.test.other");
}

static void test_damaged_manifest(Place *place, gconstpointer data)
{
    static const char *const damaged[] = {
        "",
        "{",
        "[]",
        "null",
        "{\"manifest\": 2}",
        "{\"manifest\": 1, \"library\": 7}",
        "{\"manifest\": 1, \"library\": {\"size\": -1, \"mtime_ns\": \"0\"}}",
        "{\"manifest\": 1, \"library\": {\"size\": 1e300, \"mtime_ns\": \"0\"}}",
        "{\"manifest\": 1, \"library\": {\"size\": 1, \"mtime_ns\": \"99999999999999999999\"}}",
    };
    g_autofree char *path = install_module("good", place->first, "good.so");
    for (gsize i = 0; i < G_N_ELEMENTS(damaged); i++) {
        g_autofree char *beside = install_text(damaged[i], place->first, "good.manifest.json");
        g_autoptr(TinkerCatalogue) catalogue = fresh(place);
        g_assert_cmpstr(entry_of(catalogue, path)->id, ==, "org.tinker.test.good");
    }
    g_assert_cmpuint(probe_count(place), ==, 1);
}

/* Every manifest that lacks one of its members is passed over, and the library probed. */
static void test_incomplete_manifest(Place *place, gconstpointer data)
{
    static const char *const members[] = {"\"id\"",    "\"title\"",   "\"version\"",     "\"licence\"", "\"home_page\"",
                                          "\"types\"", "\"summary\"", "\"integrators\"", "\"size\"",    "\"mtime_ns\""};
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *whole = describe(path);
    for (gsize i = 0; i < G_N_ELEMENTS(members); i++) {
        g_auto(GStrv) parts = g_strsplit(whole, members[i], 2);
        g_assert_nonnull(parts[1]);
        g_autofree char *text = g_strjoinv("\"renamed\"", parts);
        g_autofree char *beside = install_text(text, place->first, "good.manifest.json");
        g_autofree char *cached = g_build_filename(place->cache, "plugins.json", NULL);
        g_remove(cached);
        g_assert_cmpuint(probes_of_search(place), ==, 1);
    }
}

/* The manifest speaks of another plugin than the library is: it opens no door. */
static void test_wrong_manifest(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *manifest = describe(path);
    g_auto(GStrv) parts = g_strsplit(manifest, "org.tinker.test.good", -1);
    g_autofree char *forged = g_strjoinv("org.tinker.spring", parts);
    g_autofree char *beside = install_text(forged, place->first, "good.manifest.json");
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, "pull", &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED);
    g_autofree char *message =
        g_strdup_printf("the library \"%s\" was refused: its manifest says \"org.tinker.spring\", the library itself "
                        "says \"org.tinker.test.good\"; its manifest has to be made anew",
                        path);
    g_assert_cmpstr(error->message, ==, message);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 0);
}

static void test_cached_manifest(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_assert_cmpuint(probes_of_search(place), ==, 0);
    place->options.probe_program = NULL;
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_assert_cmpstr(entry_of(catalogue, path)->version, ==, "1.2.3");
}

static void test_damaged_cache(Place *place, gconstpointer data)
{
    static const char *const damaged[] = {"", "[1]", "{\"cache\": 1, \"abi_minor\": 0, \"libraries\": 3}"};
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_mkdir_with_parents(place->cache, 0755);
    for (gsize i = 0; i < G_N_ELEMENTS(damaged); i++) {
        g_autofree char *file = install_text(damaged[i], place->cache, "plugins.json");
        g_assert_cmpuint(probes_of_search(place), ==, 1);
        g_assert_cmpuint(probes_of_search(place), ==, 0);
    }
}

/* A claim in the cache that the library provides what it does not, which somebody else wrote: it is not believed, and
 * what is found out instead stands in a file that nobody else may write. */
static void expect_distrusted(Place *place, const char *file, const char *reason)
{
    const guint before = probe_count(place);
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_autofree char *warning =
        g_strdup_printf("what is remembered about plugins is not believed: \"%s\": %s", file, reason);
    g_assert_true(has_warning(catalogue, warning));
    g_assert_nonnull(tinker_catalogue_type(catalogue, "pull", NULL));
    g_assert_null(tinker_catalogue_type(catalogue, "spring", NULL));
    g_assert_cmpuint(probe_count(place), ==, before + 1);
}

/* A cache in which the library's type has another name. */
static void forge(const char *file)
{
    g_autofree char *text = NULL;
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_get_contents(file, &text, NULL, NULL));
    g_auto(GStrv) parts = g_strsplit(text, "\"pull\"", 2);
    g_assert_nonnull(parts[1]);
    g_autofree char *forged = g_strjoinv("\"spring\"", parts);
    g_assert_true(g_file_set_contents_full(file, forged, -1, G_FILE_SET_CONTENTS_NONE, 0600, &error));
}

static void test_cache_of_everybody(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_autofree char *file = g_build_filename(place->cache, "plugins.json", NULL);
    forge(file);
    g_assert_cmpint(g_chmod(file, 0666), ==, 0);
    expect_distrusted(place, file, "it can be written by everybody (mode 0666); only its owner may");
    struct stat status;
    g_assert_cmpint(stat(file, &status), ==, 0);
    g_assert_cmpuint(status.st_mode & 0777, ==, 0600);
    g_assert_cmpuint(probes_of_search(place), ==, 0);
}

/* Who may write to its folder can put any file there. */
static void test_cache_in_open_folder(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_autofree char *file = g_build_filename(place->cache, "plugins.json", NULL);
    forge(file);
    g_assert_cmpint(g_chmod(place->cache, 0777), ==, 0);
    expect_distrusted(place, file, "its folder can be written by everybody (mode 0777); only its owner may");
    g_assert_cmpint(g_chmod(place->cache, 0700), ==, 0);
    g_assert_cmpuint(probes_of_search(place), ==, 0);
}

static void test_cache_of_another_owner(Place *place, gconstpointer data)
{
    if (geteuid() != 0) {
        g_test_skip("only the superuser can give files away");
        return;
    }
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_autofree char *file = g_build_filename(place->cache, "plugins.json", NULL);
    forge(file);
    g_assert_cmpint(chown(file, 4242, (gid_t)-1), ==, 0);
    expect_distrusted(place, file,
                      "it belongs to the user 4242, not to root, to you (0) or to the owner of this program (0)");
    g_assert_cmpuint(probes_of_search(place), ==, 0);
}

/* What another host found out may not hold for this one. */
static void test_cache_of_another_host(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_autofree char *file = g_build_filename(place->cache, "plugins.json", NULL);
    g_autofree char *text = NULL;
    g_assert_true(g_file_get_contents(file, &text, NULL, NULL));
    g_auto(GStrv) parts = g_strsplit(text, "\"abi_minor\":\t0", 2);
    g_assert_nonnull(parts[1]);
    g_autofree char *foreign = g_strjoinv("\"abi_minor\":\t77", parts);
    g_autofree char *same = install_text(foreign, place->cache, "plugins.json");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
}

/* A file where the cache's folder should be. */
static void test_unwritable_cache(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *obstacle = install_text("", place->root, "cache");
    g_autoptr(TinkerCatalogue) catalogue = fresh(place);
    g_autofree char *warning = g_strdup_printf(
        "what was found out about plugins is not remembered: the folder \"%s\" cannot be made: Not a directory",
        obstacle);
    g_assert_true(has_warning(catalogue, warning));
    g_assert_nonnull(tinker_catalogue_type(catalogue, "pull", NULL));
}

/* A library that is open stays as it was opened; a new file in its place is not taken for it. */
static void test_changed_after_opening(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) before = fresh(place);
    g_assert_nonnull(tinker_catalogue_type(before, "pull", NULL));
    g_autofree char *same = install_module("rival", place->first, "good.so");
    g_assert_nonnull(tinker_catalogue_type(before, "pull", NULL));
    g_autoptr(TinkerCatalogue) after = fresh(place);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(after, "rivalry", &error));
    g_autofree char *message =
        g_strdup_printf("the library \"%s\" was refused: it was changed after this program opened "
                        "it; the new one is used after a restart",
                        path);
    g_assert_cmpstr(error->message, ==, message);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    g_test_add_func("/plugin/manifest/build-id", test_build_id);
    add_place_test("/plugin/manifest/build-id-of-torn-file", test_build_id_of_torn_file);
    add_place_test("/plugin/manifest/spares-probe", test_manifest_spares_probe);
    add_place_test("/plugin/manifest/mismatch", test_manifest_mismatch);
    add_place_test("/plugin/manifest/damaged", test_damaged_manifest);
    add_place_test("/plugin/manifest/incomplete", test_incomplete_manifest);
    add_place_test("/plugin/manifest/wrong", test_wrong_manifest);
    add_place_test("/plugin/cache/manifest", test_cached_manifest);
    add_place_test("/plugin/cache/damaged", test_damaged_cache);
    add_place_test("/plugin/cache/another-host", test_cache_of_another_host);
    add_place_test("/plugin/cache/unwritable", test_unwritable_cache);
    add_place_test("/plugin/cache/of-everybody", test_cache_of_everybody);
    add_place_test("/plugin/cache/in-open-folder", test_cache_in_open_folder);
    add_place_test("/plugin/cache/of-another-owner", test_cache_of_another_owner);
    add_place_test("/plugin/changed/after-opening", test_changed_after_opening);
    return g_test_run();
}
