/* Refused plugins are told of, with the reason, until they are forgotten. */
#include <glib/gstdio.h>
#include <string.h>

#include "files-fixture.h"
#include "gui/document/refusal-notices.h"

/* A folder of plugins with one that is no library, and a catalogue over it with a cache of its own. */
typedef struct {
    char *folder, *cache;
    const char *folders[2];
} Place;

static void open_place(Place *place)
{
    place->folder = files_fixture_folder();
    place->cache = files_fixture_folder();
    place->folders[0] = place->folder;
    place->folders[1] = NULL;
    g_autofree char *path = g_build_filename(place->folder, "broken.so", NULL);
    g_assert_true(g_file_set_contents(path, "#!/bin/sh\n", -1, NULL));
    g_assert_cmpint(g_chmod(path, 0644), ==, 0);
}

static void close_place(Place *place)
{
    g_free(place->folder);
    g_free(place->cache);
}

static TinkerCatalogue *search(const Place *place)
{
    const TinkerCatalogueOptions options = {
        .folders = place->folders,
        .user_folder = place->cache,
        .cache_folder = place->cache,
        .probe_program = g_getenv("TINKER_PROGRAM"),
    };
    return tinker_catalogue_new(&options);
}

static void test_refused(void)
{
    Place place;
    open_place(&place);
    g_unsetenv("TINKER_PLUGIN_PATH");
    g_autoptr(TinkerCatalogue) catalogue = search(&place);
    g_autoptr(GPtrArray) notices = tinker_refusal_notices(catalogue);
    g_assert_cmpuint(notices->len, ==, 1);
    const TinkerNotice *notice = g_ptr_array_index(notices, 0);
    g_assert_cmpstr(
        notice->text, ==,
        "The plugin broken.so was refused: it is no shared object: it begins with 23 21 2f 62, 7f 45 4c 46 was "
        "expected.");
    g_autofree char *cache = g_build_filename(place.cache, "plugins.json", NULL), *before = NULL, *after = NULL;
    g_assert_true(g_file_get_contents(cache, &before, NULL, NULL));
    g_assert_nonnull(strstr(before, "broken.so"));
    notice->cure(notice->data);
    g_assert_true(g_file_get_contents(cache, &after, NULL, NULL));
    g_assert_null(strstr(after, "broken.so"));
    close_place(&place);
}

static void test_none_refused(void)
{
    g_autoptr(GPtrArray) notices = tinker_refusal_notices(files_fixture_catalogue());
    g_assert_cmpuint(notices->len, ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/gui/refusal-notices/none", test_none_refused);
    g_test_add_func("/gui/refusal-notices/refused", test_refused);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
