/* The museum of bad plugins: each is refused with its exact message, and the host goes on. */
#include <string.h>

#include "fixture.h"

typedef struct {
    const char *module;
    const char *message;
    double seconds; /* time limit of the probe; 0: generous */
} Exhibit;

static const Exhibit exhibits[] = {
    {"no-symbol", "it exports no \"tinker_plugin_v1\", the entry of a plugin", 0},
    {"other-major", "it exports \"tinker_plugin_v2\" of ABI 2, this host needs \"tinker_plugin_v1\" of ABI 1", 0},
    {"null-descriptor", "its entry answered NULL, a descriptor was expected", 0},
    {"wrong-magic", "its magic number is 0xdeadbeef, 0x544e4b52 was expected", 0},
    {"short-struct", "its TinkerPlugin has 64 bytes, this host needs at least 120", 0},
    {"wrong-sizes", "its double has 4 bytes and its index 8, this host's have 8 and 4", 0},
    {"newer-minor", "it needs a host of ABI 1.99 or newer, this host has ABI 1.0", 0},
    {"unknown-service",
     "it needs the service \"org.example.teleport/1\", this host offers \"tinker.log/1\", \"tinker.typed-laws/1\"", 0},
    {"unknown-flag", "integrator \"exhibit\": its flags 0x80000002 have bits that this version does not know", 0},
    {"duplicate-types", "its block types 0 and 2 both have the id \"exhibit\"", 0},
    {"duplicate-property", "block type \"exhibit\": two properties have the id \"weight\"", 0},
    {"negative-count", "block type \"exhibit\": the number of properties is -3, 0 to 10000 was expected", 0},
    {"short-stride", "the stride of block types is 16 bytes, at least 120 are needed", 0},
    {"no-blocks", "it declares neither block types nor integrators", 0},
    {"undefined-symbol", "it cannot be opened: undefined symbol: exhibit_missing_function", 0},
    {"crash-in-entry", "it crashed while it was probed: SIGSEGV", 0},
    {"abort-in-init", "it crashed while it was probed: SIGABRT", 0},
    {"exit-in-entry", "it ended the program that probed it, with status 7", 0},
    {"failing-init", "its init answered 2, 0 (ready) was expected", 0},
    {"floods", "it wrote more than 1048576 bytes while it was probed", 0},
    {"talks", "what it wrote while it was probed is not a manifest: it is not JSON, it begins with \"Hello!\"", 0},
    {"hang-in-entry", "it hung: it was not ready within the time limit of 0.3 s", 0.3},
    {"hang-in-init", "it hung: it was not ready within the time limit of 0.3 s", 0.3},
};

static void expect_refused(Place *place, const char *path, const char *message)
{
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(entry_of(catalogue, path)->refused, ==, message);
    g_autofree char *warning = g_strdup_printf("the library \"%s\" was refused: %s", path, message);
    g_assert_true(has_warning(catalogue, warning));

    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, "exhibit", &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING);
    g_autofree char *missing = g_strdup_printf("no plugin provides the block type \"exhibit\": %s", warning);
    g_assert_cmpstr(error->message, ==, missing);
    g_assert_cmpuint(count_of(tinker_catalogue_opened(catalogue)), ==, 0);
}

static void test_exhibit(gconstpointer data)
{
    const Exhibit *exhibit = data;
    Place place = {0};
    place_set_up(&place, NULL);
    if (exhibit->seconds > 0) place.options.probe_seconds = exhibit->seconds;
    g_autofree char *path = install_module(exhibit->module, place.first, "exhibit.so");
    expect_refused(&place, path, exhibit->message);
    place_tear_down(&place, NULL);
}

static void test_not_elf(Place *place, gconstpointer data)
{
    g_autofree char *path = install_text("#!/bin/sh\nexit 0\n", place->first, "exhibit.so");
    expect_refused(place, path, "it is no shared object: it begins with 23 21 2f 62, 7f 45 4c 46 was expected");
}

static void test_empty(Place *place, gconstpointer data)
{
    g_autofree char *path = install_text("", place->first, "exhibit.so");
    expect_refused(place, path, "it is empty, a shared object was expected");
}

/* One bad library does not keep the good one beside it away. */
static void test_neighbour(Place *place, gconstpointer data)
{
    g_autofree char *bad = install_module("crash-in-entry", place->first, "bad.so");
    g_autofree char *good = install_module("good", place->first, "good.so");
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(tinker_catalogue_type(catalogue, "pull", &error));
    g_assert_no_error(error);
    g_assert_nonnull(entry_of(catalogue, bad)->refused);
    g_assert_null(entry_of(catalogue, good)->refused);
}

/* A program that does not know the verb says nothing about the library, so nothing is remembered. */
static void test_probe_is_at_fault(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "good.so");
    place->options.probe_program = "/nonexistent/tinker";
    g_autoptr(TinkerCatalogue) without = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(entry_of(without, path)->refused, ==,
                    "it could not be probed: Failed to execute child process “/nonexistent/tinker” (No such file or "
                    "directory)");
    place->options.probe_program = place->probe_program;
    g_autoptr(TinkerCatalogue) with = tinker_catalogue_new(&place->options);
    g_assert_null(entry_of(with, path)->refused);
}

/* What a library needs and does not find may be installed later: it is looked at anew each time. One that fails its own
 * checks is not. */
static void test_remembered(Place *place, gconstpointer data)
{
    g_free(install_module("undefined-symbol", place->first, "lacks.so"));
    g_free(install_module("failing-init", place->first, "fails.so"));
    tinker_catalogue_free(tinker_catalogue_new(&place->options));
    g_assert_cmpuint(probe_count(place), ==, 2);
    tinker_catalogue_free(tinker_catalogue_new(&place->options));
    g_assert_cmpuint(probe_count(place), ==, 3);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(exhibits); i++) {
        g_autofree char *path = g_strconcat("/plugin/museum/", exhibits[i].module, NULL);
        g_test_add_data_func(path, &exhibits[i], test_exhibit);
    }
    add_place_test("/plugin/museum/not-elf", test_not_elf);
    add_place_test("/plugin/museum/empty", test_empty);
    add_place_test("/plugin/museum/remembered", test_remembered);
    add_place_test("/plugin/museum/neighbour", test_neighbour);
    add_place_test("/plugin/museum/probe-is-at-fault", test_probe_is_at_fault);
    return g_test_run();
}
