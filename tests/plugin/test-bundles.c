/* Bundles: marked folders directly below a plugin folder, trusted by the rules of libraries. */
#include <glib/gstdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fixture.h"

#define MARKER "{\"bundle\": 1, \"title\": \"A Course\", \"summary\": \"Two blocks\"}"

/* (transfer full) */
static char *make_folder(const char *parent, const char *name)
{
    char *path = g_build_filename(parent, name, NULL);
    g_assert_cmpint(g_mkdir(path, 0755), ==, 0);
    return path;
}

/* A folder below the first one with a marker and a library. (transfer full) */
static char *make_bundle(Place *place, const char *name, const char *marker, const char *module)
{
    char *folder = make_folder(place->first, name);
    g_autofree char *written = install_text(marker, folder, "bundle.json");
    g_autofree char *library = install_module(module, folder, "library.so");
    return folder;
}

static void expect_type(TinkerCatalogue *catalogue, const char *type, const char *folder)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *library = g_build_filename(folder, "library.so", NULL);
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(block_class->path, ==, library);
}

static void expect_nothing(TinkerCatalogue *catalogue)
{
    g_assert_cmpuint(tinker_catalogue_bundles(catalogue)->len, ==, 0);
    g_assert_cmpuint(count_of(tinker_catalogue_libraries(catalogue)), ==, 0);
}

/* The one warning of a catalogue that finds nothing. */
static void expect_passed_over(Place *place, const char *folder, const char *reason)
{
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autofree char *warning = g_strdup_printf("the bundle \"%s\" (command line) is passed over: %s", folder, reason);
    expect_nothing(catalogue);
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 1);
    expect_text(tinker_catalogue_warnings(catalogue), 0, warning);
}

static void test_found(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *page = install_text("# A Course\n", folder, "page.md");
    g_autofree char *scenes = make_folder(folder, "scenes");
    g_autofree char *second = install_text("{}", scenes, "b.tinker.json"), *other = install_text("", scenes, "notes");
    g_autofree char *first = install_text("{}", scenes, "a.tinker.json");
    g_autofree char *hidden = install_text("{}", scenes, ".c.tinker.json");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 0);
    g_assert_cmpuint(tinker_catalogue_bundles(catalogue)->len, ==, 1);
    const TinkerBundleEntry *bundle = tinker_catalogue_bundles(catalogue)->pdata[0];
    g_assert_cmpstr(bundle->path, ==, folder);
    g_assert_cmpstr(bundle->title, ==, "A Course");
    g_assert_cmpstr(bundle->summary, ==, "Two blocks");
    g_assert_cmpstr(bundle->page, ==, page);
    g_assert_cmpuint(bundle->scenes->len, ==, 2);
    g_assert_cmpstr(bundle->scenes->pdata[0], ==, first);
    g_assert_cmpstr(bundle->scenes->pdata[1], ==, second);
    expect_type(catalogue, "pull", folder);
}

/* Behind the libraries of the plugin folder itself, before those of the next. */
static void test_order(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *later = install_module("good", place->second, "good.so");
    g_autoptr(TinkerCatalogue) before = tinker_catalogue_new(&place->options);
    expect_type(before, "pull", folder);
    g_autofree char *earlier = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) after = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(tinker_catalogue_type(after, "pull", NULL)->path, ==, earlier);
}

/* One level, marked, not hidden: else a folder is none, and no word is said. */
static void test_not_a_bundle(Place *place, gconstpointer data)
{
    g_autofree char *plain = make_folder(place->first, "plain"), *nested = make_folder(plain, "nested");
    g_autofree char *library = install_module("good", plain, "good.so");
    g_autofree char *marker = install_text(MARKER, nested, "bundle.json");
    g_autofree char *deep = install_module("good", nested, "good.so");
    g_autofree char *hidden = make_bundle(place, ".course", MARKER, "good");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    expect_nothing(catalogue);
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 0);
}

/* A bundle within a bundle, and libraries among its scenes, are not looked for. */
static void test_not_nested(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *inner = make_folder(folder, "inner"), *scenes = make_folder(folder, "scenes");
    g_autofree char *marker = install_text(MARKER, inner, "bundle.json");
    g_autofree char *one = install_module("other", inner, "other.so"), *two = install_module("other", scenes, "o.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(tinker_catalogue_bundles(catalogue)->len, ==, 1);
    g_assert_cmpuint(count_of(tinker_catalogue_libraries(catalogue)), ==, 1);
}

static void test_markers(Place *place, gconstpointer data)
{
    static const char *const bad[][2] = {
        {"", "bundle.json is not JSON"},
        {"{\"bundle\": 1", "bundle.json is not JSON"},
        {"[]", "bundle.json is not that of a bundle of format 1 (it would hold \"bundle\": 1)"},
        {"{\"bundle\": 2, \"title\": \"A\"}",
         "bundle.json is not that of a bundle of format 1 (it would hold \"bundle\": 1)"},
        {"{\"bundle\": 1}", "bundle.json has no text \"title\""},
        {"{\"bundle\": 1, \"title\": \"\"}", "its title is empty"},
        {"{\"bundle\": 1, \"title\": \"A\\u001b[2J\"}", "its title contains control characters"},
        {"{\"bundle\": 1, \"title\": \"A\", \"summary\": 3}", "the \"summary\" of bundle.json is not a text"},
    };
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autofree char *marker = install_text(bad[i][0], folder, "bundle.json");
        expect_passed_over(place, folder, bad[i][1]);
    }
    g_autofree char *long_text = g_strnfill(70000, ' '), *marker = install_text(long_text, folder, "bundle.json");
    expect_passed_over(place, folder, "bundle.json: it has 70000 bytes, at most 65536 are read");
    g_assert_cmpint(g_remove(marker) + g_mkdir(marker, 0755), ==, 0);
    expect_passed_over(place, folder, "bundle.json: it is not a regular file");
}

/* Whoever could change the bundle, its marker or the folder it lies in could change what is run. */
static void test_permissions(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *marker = g_build_filename(folder, "bundle.json", NULL);
    g_assert_cmpint(g_chmod(folder, 0777), ==, 0);
    expect_passed_over(place, folder, "it can be written by everybody (mode 0777); only its owner may");
    g_assert_cmpint(g_chmod(folder, 0755) + g_chmod(marker, 0666), ==, 0);
    expect_passed_over(place, folder, "bundle.json: it can be written by everybody (mode 0666); only its owner may");
    g_assert_cmpint(g_chmod(marker, 0644) + g_chmod(place->first, 0777), ==, 0);
    expect_passed_over(place, folder, "its folder can be written by everybody (mode 0777); only its owner may");
    g_assert_cmpint(g_chmod(place->first, 0755), ==, 0);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    expect_type(catalogue, "pull", folder);
}

/* A link to a bundle elsewhere is one, if what it leads to is trusted as well. */
static void test_links(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *outside = make_folder(place->root, "outside"), *moved = g_build_filename(outside, "course", NULL);
    g_assert_cmpint(g_rename(folder, moved) + symlink(moved, folder), ==, 0);
    {
        g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
        g_assert_cmpuint(tinker_catalogue_bundles(catalogue)->len, ==, 1);
        expect_type(catalogue, "pull", folder);
    }
    g_assert_cmpint(g_chmod(outside, 0777), ==, 0);
    g_autofree char *reason = g_strdup_printf(
        "it leads to \"%s\": its folder can be written by everybody (mode 0777); only its owner may", moved);
    expect_passed_over(place, folder, reason);
}

/* Nothing that the bundle offers to open lies behind a link; a link back to the plugin folder is no second one. */
static void test_links_within(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_autofree char *scenes = make_folder(folder, "scenes"), *secret = install_text("{}", place->root, "a.tinker.json");
    g_autofree char *link = g_build_filename(scenes, "a.tinker.json", NULL),
                    *page = g_strconcat(folder, "/page.md", NULL);
    g_autofree char *loop = g_build_filename(place->first, "loop", NULL);
    g_autofree char *marker = install_text(MARKER, place->first, "bundle.json");
    g_assert_cmpint(symlink(secret, link) + symlink(secret, page) + symlink(place->first, loop), ==, 0);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(tinker_catalogue_bundles(catalogue)->len, ==, 1);
    const TinkerBundleEntry *bundle = tinker_catalogue_bundles(catalogue)->pdata[0];
    g_assert_cmpuint(bundle->scenes->len, ==, 0);
    g_assert_null(bundle->page);
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 0);
}

static void test_safe_mode(Place *place, gconstpointer data)
{
    g_autofree char *folder = make_bundle(place, "course", MARKER, "good");
    g_setenv("TINKER_SAFE_MODE", "1", TRUE);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    expect_nothing(catalogue);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/bundles/found", test_found);
    add_place_test("/plugin/bundles/order", test_order);
    add_place_test("/plugin/bundles/not-a-bundle", test_not_a_bundle);
    add_place_test("/plugin/bundles/not-nested", test_not_nested);
    add_place_test("/plugin/bundles/markers", test_markers);
    add_place_test("/plugin/bundles/permissions", test_permissions);
    add_place_test("/plugin/bundles/links", test_links);
    add_place_test("/plugin/bundles/links-within", test_links_within);
    add_place_test("/plugin/bundles/safe-mode", test_safe_mode);
    return g_test_run();
}
