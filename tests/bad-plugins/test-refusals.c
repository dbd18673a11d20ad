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

static void expect_message(TinkerCatalogue *catalogue, const char *type, const char *format, ...) G_GNUC_PRINTF(3, 4);

static void expect_message(TinkerCatalogue *catalogue, const char *type, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *expected = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, type, &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING);
    g_assert_cmpstr(error->message, ==, expected);
}

#define WRONG_MAGIC "its magic number is 0xdeadbeef, 0x544e4b52 was expected"
#define EMPTY       "it is empty, a shared object was expected"

/* Neither manifest nor file name tells what a refused library has: it may be what is missing, and that is said instead
 * of where libraries belong. */
static void test_may_be_refused(Place *place, gconstpointer data)
{
    g_autofree char *good = install_module("good", place->first, "good.so");
    g_autofree char *bad = install_module("wrong-magic", place->first, "tinker-bad.so");
    g_autoptr(TinkerCatalogue) one = tinker_catalogue_new(&place->options);
    expect_message(one, "dipole",
                   "no plugin provides the block type \"dipole\"; it may be in a refused one: the library \"%s\" was "
                   "refused: " WRONG_MAGIC,
                   bad);
    expect_message(one, "pulll",
                   "no plugin provides the block type \"pulll\" (did you mean \"pull\"?); it may be in a refused one: "
                   "the library \"%s\" was refused: " WRONG_MAGIC,
                   bad);

    // Of several the first is told of, unless one is named after what is missing.
    g_autofree char *dipole = install_text("", place->second, "tinker-dipole.so");
    g_autoptr(TinkerCatalogue) two = tinker_catalogue_new(&place->options);
    expect_message(two, "magnet",
                   "no plugin provides the block type \"magnet\"; it may be in one of 2 that were refused: the library "
                   "\"%s\" was refused: " WRONG_MAGIC,
                   bad);
    expect_message(two, "dipole",
                   "no plugin provides the block type \"dipole\": the library \"%s\" was refused: " EMPTY, dipole);
}

static void test_refused_method(Place *place, gconstpointer data)
{
    g_autofree char *path = install_text("", place->first, "tinker-heun.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_integrator(catalogue, "heun", &error));
    g_autofree char *reason = g_strdup_printf(": the library \"%s\" was refused: " EMPTY, path);
    g_autofree char *message = g_strconcat("no plugin provides the integrator \"heun\"", reason, NULL);
    g_assert_cmpstr(error->message, ==, message);
    g_autofree char *explanation = tinker_catalogue_explain_refused(catalogue, "heun");
    g_assert_cmpstr(explanation, ==, reason);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/refusals/nanoseconds", test_time_in_nanoseconds);
    add_place_test("/plugin/refusals/remembered", test_remembered_refusal);
    add_place_test("/plugin/refusals/clear", test_clear_refused);
    add_place_test("/plugin/refusals/changed-before-opening", test_changed_before_opening);
    add_place_test("/plugin/refusals/may-be-refused", test_may_be_refused);
    add_place_test("/plugin/refusals/method", test_refused_method);
    return g_test_run();
}
