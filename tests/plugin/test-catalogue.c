/* The search: order, shadowing, safe mode, laziness, and what is said of a type that is missing. */
#include <string.h>

#include "fixture.h"

#define NOT_THERE " (its library belongs into a plugin folder, or into one named by --plugins)"

static guint ready_count;

/* The good plugin logs "ready" from its init. */
static void count_ready(const char *domain, GLogLevelFlags level, const char *message, gpointer data)
{
    ready_count += g_str_has_suffix(message, ": ready");
    g_assert_true(level == G_LOG_LEVEL_INFO);
}

static const char *provider(TinkerCatalogue *catalogue, const char *type)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
    g_assert_no_error(error);
    return block_class->path;
}

static void expect_message(TinkerCatalogue *catalogue, const char *type, const char *message)
{
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, type, &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING);
    g_assert_cmpstr(error->message, ==, message);
}

static void test_entry(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    const TinkerLibraryEntry *entry = entry_of(catalogue, path);
    g_assert_cmpstr(entry->id, ==, "org.tinker.test.good");
    g_assert_cmpstr(entry->title, ==, "Good");
    g_assert_cmpstr(entry->version, ==, "1.2.3");
    g_assert_cmpstr(entry->licence, ==, "MIT");
    g_assert_cmpstr(entry->home_page, ==, "https://example.org/good");
    g_assert_cmpstr(entry->folder_kind, ==, "command line");
    g_assert_null(entry->refused);
    g_assert_null(entry->shadowed_by);
    g_assert_cmpuint(entry->types->len, ==, 1);
    const TinkerTypeEntry *type = entry->types->pdata[0];
    g_assert_cmpstr(type->id, ==, "pull");
    g_assert_cmpstr(type->title, ==, "Pull");
    g_assert_cmpstr(type->category, ==, "connector");
    g_assert_cmpstr(type->summary, ==, "Pulls.");
    g_assert_cmpuint(entry->integrators->len, ==, 1);
    g_assert_cmpstr(entry->integrators->pdata[0], ==, "pull-method");
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 0);
}

static void test_lazy(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *other = install_module("other", place->first, "other.so");
    ready_count = 0;
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 0);
    g_assert_cmpuint(ready_count, ==, 0);

    g_assert_cmpstr(provider(catalogue, "pull"), ==, path);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 1);
    expect_text(tinker_catalogue_opened(catalogue), 0, path);
    g_assert_cmpuint(ready_count, ==, 1);

    g_assert_cmpstr(provider(catalogue, "pull"), ==, path);
    g_assert_nonnull(tinker_catalogue_integrator(catalogue, "pull-method", NULL));
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 1);

    g_assert_nonnull(tinker_catalogue_integrator(catalogue, "push-method", NULL));
    expect_text(tinker_catalogue_opened(catalogue), 1, other);
}

/* A second catalogue of the process gets the same class, and init is not called again. */
static void test_init_once(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    ready_count = 0;
    g_autoptr(TinkerCatalogue) one = tinker_catalogue_new(&place->options);
    g_autoptr(TinkerCatalogue) two = tinker_catalogue_new(&place->options);
    g_assert_true(tinker_catalogue_type(one, "pull", NULL) == tinker_catalogue_type(two, "pull", NULL));
    g_assert_cmpuint(ready_count, ==, 1);
}

static void test_order(Place *place, gconstpointer data)
{
    g_autofree char *environment = g_build_filename(place->root, "environment", NULL);
    const char *const folders[] = {place->first, NULL};
    const char *const places[] = {place->first, environment, place->options.user_folder, place->installed};
    const char *const kinds[] = {"command line", "TINKER_PLUGIN_PATH", "user", "installed"};
    place->options.folders = folders;
    g_setenv("TINKER_PLUGIN_PATH", environment, TRUE);
    // The last place is filled first: each library that is added comes before all the others.
    for (int i = 3; i >= 0; i--) {
        g_mkdir_with_parents(places[i], 0755);
        g_autofree char *path = install_module("good", places[i], "good.so");
        g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
        g_assert_cmpstr(provider(catalogue, "pull"), ==, path);
        g_assert_cmpstr(entry_of(catalogue, path)->folder_kind, ==, kinds[i]);
        g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
        g_assert_cmpuint(libraries->len, ==, 4 - (guint)i);
        for (guint k = 1; k < libraries->len; k++)
            g_assert_cmpstr(((TinkerLibraryEntry *)libraries->pdata[k])->shadowed_by, ==, path);
    }
}

static void test_shadowed(Place *place, gconstpointer data)
{
    g_autofree char *first = install_module("good", place->first, "z.so");
    g_autofree char *second = install_module("rival", place->second, "a.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autofree char *warning = g_strdup_printf("the library \"%s\" is passed over: \"%s\" provides the plugin "
                                               "\"org.tinker.test.good\" and comes first",
                                               second, first);
    g_assert_true(has_warning(catalogue, warning));
    g_assert_cmpstr(entry_of(catalogue, second)->shadowed_by, ==, first);
    // All of a shadowed library is, what only it provides too.
    expect_message(catalogue, "rivalry", "no plugin provides the block type \"rivalry\"" NOT_THERE);
}

static void test_same_type(Place *place, gconstpointer data)
{
    g_autofree char *first = install_module("good", place->first, "a.so");
    g_autofree char *second = install_module("twin", place->first, "b.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(provider(catalogue, "pull"), ==, first);
    g_assert_null(entry_of(catalogue, second)->shadowed_by);
    g_autofree char *warning =
        g_strdup_printf("the block type \"pull\" of \"%s\" is passed over: \"%s\" comes first", second, first);
    g_assert_true(has_warning(catalogue, warning));
}

static void test_safe_mode(Place *place, gconstpointer data)
{
    g_autofree char *first = install_module("good", place->first, "good.so");
    g_autofree char *installed = install_module("other", place->installed, "other.so");
    g_setenv("TINKER_PLUGIN_PATH", place->second, TRUE);
    g_setenv("TINKER_SAFE_MODE", "1", TRUE);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(count_of(tinker_catalogue_libraries(catalogue)), ==, 1);
    g_assert_cmpstr(provider(catalogue, "push"), ==, installed);
    g_assert_true(
        has_warning(catalogue, "safe mode (TINKER_SAFE_MODE): plugins are taken from the installed folder alone"));
}

static void test_folders(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autofree char *hidden = install_module("other", place->first, ".other.so");
    g_autofree char *link = g_strconcat(place->first, "/../first/", NULL);
    const char *const folders[] = {"plugins", place->first, link, "/nonexistent/folder", NULL};
    place->options.folders = folders;
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_true(has_warning(
        catalogue, "the plugin folder \"plugins\" (command line) is passed over: an absolute path was expected"));
    g_assert_true(has_warning(catalogue, "the plugin folder \"/nonexistent/folder\" (command line) is passed over: "
                                         "No such file or directory"));
    // The same folder by another name, a folder of the user's that is not there, and a hidden file: no word of them.
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 2);
    g_assert_cmpuint(count_of(tinker_catalogue_libraries(catalogue)), ==, 1);
}

static void test_missing(Place *place, gconstpointer data)
{
    g_autoptr(TinkerCatalogue) empty = tinker_catalogue_new(&place->options);
    expect_message(empty, "pull", "no plugin provides the block type \"pull\" (no plugin was found at all)");

    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    expect_message(catalogue, "pulll", "no plugin provides the block type \"pulll\" (did you mean \"pull\"?)");
    expect_message(catalogue, "thermonuclear", "no plugin provides the block type \"thermonuclear\"" NOT_THERE);

    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_integrator(catalogue, "pull-methd", &error));
    g_assert_cmpstr(error->message, ==,
                    "no plugin provides the integrator \"pull-methd\" (did you mean \"pull-method\"?)");
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    g_log_set_handler("tinker-plugin", G_LOG_LEVEL_MASK, count_ready, NULL);
    add_place_test("/plugin/catalogue/entry", test_entry);
    add_place_test("/plugin/catalogue/lazy", test_lazy);
    add_place_test("/plugin/catalogue/init-once", test_init_once);
    add_place_test("/plugin/catalogue/order", test_order);
    add_place_test("/plugin/catalogue/shadowed", test_shadowed);
    add_place_test("/plugin/catalogue/same-type", test_same_type);
    add_place_test("/plugin/catalogue/safe-mode", test_safe_mode);
    add_place_test("/plugin/catalogue/folders", test_folders);
    add_place_test("/plugin/catalogue/missing", test_missing);
    return g_test_run();
}
