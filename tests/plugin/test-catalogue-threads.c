/* What is known of libraries changes while others read it: an id stays what it is for as long as its list is held. */
#include <glib/gstdio.h>
#include <string.h>

#include "fixture.h"

#define ROUNDS 200

static char *install_known(const Place *place, const char *module)
{
    char *path = install_module(module, place->first, "lib.so");
    g_autofree char *manifest = describe(path);
    g_free(install_text(manifest, place->first, "lib.manifest.json"));
    return path;
}

static const char *first_method(const GPtrArray *libraries)
{
    return ((const TinkerLibraryEntry *)libraries->pdata[0])->integrators->pdata[0];
}

/* The library is rebuilt between the search and its opening, by the id that the search found. */
static void test_rebuilt(Place *place, gconstpointer data)
{
    g_autofree char *path = install_known(place, "good");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GPtrArray) found = tinker_catalogue_libraries(catalogue);
    set_mtime(path, 1234567890 * (gint64)1000000000);
    const TinkerIntegrator *method = tinker_catalogue_integrator(catalogue, first_method(found), NULL);
    g_assert_nonnull(method);
    g_assert_cmpstr(method->id, ==, "pull-method");
    g_assert_cmpstr(first_method(found), ==, "pull-method");
}

/* By another one, with other ids. */
static void test_replaced(Place *place, gconstpointer data)
{
    g_autofree char *path = install_known(place, "good");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GPtrArray) before = tinker_catalogue_libraries(catalogue);
    g_autofree char *same = install_known(place, "rival");
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_integrator(catalogue, first_method(before), &error));
    g_autofree char *message =
        g_strdup_printf("the library \"%s\" has no integrator \"pull-method\", though its manifest says so", path);
    g_assert_cmpstr(error->message, ==, message);
    g_autoptr(GPtrArray) after = tinker_catalogue_libraries(catalogue);
    g_assert_cmpstr(first_method(before), ==, "pull-method");
    g_assert_cmpstr(first_method(after), ==, "rivalry-method");
}

typedef struct {
    TinkerCatalogue *catalogue;
    const char *path;
    gint done; /* atomic */
} Rebuilder;

/* Each time the library is another one, which others could have written: it is identified, and never opened. */
static gpointer rebuild(gpointer data)
{
    Rebuilder *rebuilder = data;
    for (int i = 1; i <= ROUNDS; i++) {
        set_mtime(rebuilder->path, i * (gint64)1000000000);
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_catalogue_type(rebuilder->catalogue, "pull", &error));
        g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED);
    }
    g_atomic_int_set(&rebuilder->done, TRUE);
    return NULL;
}

/* What any list says of the library: it was found, and may be refused for one reason. */
static void look(TinkerCatalogue *catalogue, const char *path)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    const TinkerLibraryEntry *entry = libraries->pdata[0];
    g_assert_cmpstr(entry->path, ==, path);
    g_assert_cmpstr(entry->id, ==, "org.tinker.test.good");
    g_assert_cmpstr(((const TinkerTypeEntry *)entry->types->pdata[0])->id, ==, "pull");
    g_assert_cmpstr(first_method(libraries), ==, "pull-method");
    if (entry->refused != NULL)
        g_assert_cmpstr(entry->refused, ==, "it can be written by everybody (mode 0666); only its owner may");
    g_autofree char *explanation = tinker_catalogue_explain_refused(catalogue, "pull");
    g_assert_true(entry->refused == NULL || strstr(explanation, path) != NULL);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 0);
    g_assert_cmpuint(count_of(tinker_catalogue_warnings(catalogue)), ==, 0);
}

static void test_walked_while_identified(Place *place, gconstpointer data)
{
    g_autofree char *path = install_known(place, "good");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpint(g_chmod(path, 0666), ==, 0);
    Rebuilder rebuilder = {catalogue, path, FALSE};
    GThread *thread = g_thread_new("rebuild", rebuild, &rebuilder);
    while (!g_atomic_int_get(&rebuilder.done))
        look(catalogue, path);
    g_thread_join(thread);
    look(catalogue, path);
}

/* Both threads want both types at once: each library is opened once, and neither misses one. */
static gpointer open_both(gpointer data)
{
    TinkerCatalogue *catalogue = data;
    for (int i = 0; i < ROUNDS; i++) {
        g_assert_nonnull(tinker_catalogue_type(catalogue, i % 2 == 0 ? "pull" : "push", NULL));
        g_assert_nonnull(tinker_catalogue_integrator(catalogue, i % 2 == 0 ? "push-method" : "pull-method", NULL));
    }
    return NULL;
}

static void test_opened_at_the_same_time(Place *place, gconstpointer data)
{
    g_autofree char *one = install_module("good", place->first, "good.so");
    g_autofree char *two = install_module("other", place->first, "other.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    GThread *threads[] = {g_thread_new("one", open_both, catalogue), g_thread_new("two", open_both, catalogue)};
    for (gsize i = 0; i < G_N_ELEMENTS(threads); i++)
        g_thread_join(threads[i]);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 2);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/changed/rebuilt", test_rebuilt);
    add_place_test("/plugin/changed/replaced", test_replaced);
    add_place_test("/plugin/threads/walked-while-identified", test_walked_while_identified);
    add_place_test("/plugin/threads/opened-at-the-same-time", test_opened_at_the_same_time);
    return g_test_run();
}
