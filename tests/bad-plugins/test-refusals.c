/* Refusals are remembered until the file changes or the user clears them. */
#include "fixture.h"

/* Finds everything anew and answers how many probes that took. */
static guint probes_of_search(const Place *place)
{
    const guint before = probe_count(place);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    return probe_count(place) - before;
}

/* A difference in the last digit of a time in ns counts. */
static void test_time_in_nanoseconds(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("no-symbol", place->first, "no-symbol.so");
    set_mtime(path, 1700000000 * G_GINT64_CONSTANT(1000000000) + 123456788);
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_assert_cmpuint(probes_of_search(place), ==, 0);
    set_mtime(path, 1700000000 * G_GINT64_CONSTANT(1000000000) + 123456789);
    g_assert_cmpuint(probes_of_search(place), ==, 1);
}

static void test_remembered_refusal(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("wrong-magic", place->first, "pull.so");
    g_assert_cmpuint(probes_of_search(place), ==, 1);
    g_autoptr(TinkerCatalogue) again = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(probe_count(place), ==, 1);
    g_assert_cmpstr(entry_of(again, path)->refused, ==, "its magic number is 0xdeadbeef, 0x544e4b52 was expected");

    // Mended: it is looked at anew.
    g_autofree char *mended = install_module("good", place->first, "pull.so");
    g_autoptr(TinkerCatalogue) after = tinker_catalogue_new(&place->options);
    g_assert_cmpuint(probe_count(place), ==, 2);
    g_assert_null(entry_of(after, path)->refused);
    g_assert_nonnull(tinker_catalogue_type(after, "pull", NULL));
}

static void test_clear_refused(Place *place, gconstpointer data)
{
    g_autofree char *bad = install_module("wrong-magic", place->first, "bad.so");
    g_autofree char *good = install_module("good", place->first, "good.so");
    g_assert_cmpuint(probes_of_search(place), ==, 2);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_catalogue_clear_refused(catalogue, &error));
    g_assert_no_error(error);
    g_assert_cmpuint(probes_of_search(place), ==, 1);
}

/* Between finding and opening a library is replaced by a bad one. */
static void test_changed_before_opening(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autofree char *same = install_module("crash-in-entry", place->first, "good.so");
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, "pull", &error));
    g_autofree char *message =
        g_strdup_printf("the library \"%s\" was refused: it crashed while it was probed: SIGSEGV", path);
    g_assert_cmpstr(error->message, ==, message);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/refusals/nanoseconds", test_time_in_nanoseconds);
    add_place_test("/plugin/refusals/remembered", test_remembered_refusal);
    add_place_test("/plugin/refusals/clear", test_clear_refused);
    add_place_test("/plugin/refusals/changed-before-opening", test_changed_before_opening);
    return g_test_run();
}
