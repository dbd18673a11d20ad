/* Requests for memory fail, one of them or all from one on. Whatever fails: what was to be written is there, whole; or
 * the program ends with a status that is not 0 and says that there is no memory, what was there before is as it was
 * where it is replaced as a whole, and what is written as the run goes is there up to some place. And where it goes on
 * to its regular end, it has given back as much as it ever does. */
#include <glib/gstdio.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "operations.h"

/* Pieces that a program may keep to its end and has not kept without a fault: names of kinds of errors, which are
 * interned. */
#define INTERNED 2

/* How many of an operation's requests fail, evenly spread; TEST_MEMORY_EACH=1 in the environment: each. */
#define MOST_FAULTS 40

/* What the program told in the end; nothing where it did not come to its regular end. */
typedef struct {
    long requests, pieces;
} Told;

static Told read_mark(const CliFixture *fixture)
{
    g_autofree char *mark = fault_mark(fixture), *text = NULL;
    Told told = {0};
    if (!g_file_get_contents(mark, &text, NULL, NULL)) return told;
    g_assert_cmpint(sscanf(text, "%ld %ld", &told.requests, &told.pieces), ==, 2);
    g_remove(mark);
    return told;
}

/* GLib's words, the C library's, the dynamic linker's, and ours for a library that could not be opened for want of
 * memory. */
static void assert_told(const TestProgram *ended)
{
    static const char *const words[] = {"memory", "failed to allocate", "annot allocate", "cannot create shared object",
                                        "cannot open shared object"};
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++)
        if (strstr(ended->error, words[i]) != NULL) return;
    g_error("status %d and no word of memory: \"%s\"", ended->status, ended->error);
}

/* GLib aborts where it has no memory for its locks, or before 2.76 for pieces of some sizes that it kept apart; and
 * overflows the stack where it has none for the message about it. */
static void assert_ended_by_glib(const TestProgram *ended)
{
    g_assert_true(ended->signal == SIGABRT || ended->signal == SIGSEGV);
    cli_assert_holds(ended->error, "maybe for want of memory");
}

/* Whether the warnings of a summary tell it: of a library that could not be opened, of an error that could not be
 * estimated. */
static gboolean is_told_in_summary(GBytes *text)
{
    cJSON *summary = cJSON_ParseWithLength(g_bytes_get_data(text, NULL), g_bytes_get_size(text));
    const cJSON *warnings = cJSON_GetObjectItemCaseSensitive(summary, "warnings"), *warning;
    gboolean told = FALSE;
    for (warning = warnings != NULL ? warnings->child : NULL; warning != NULL; warning = warning->next)
        told |= strstr(warning->valuestring, "memory") != NULL;
    cJSON_Delete(summary);
    return told;
}

/* A library that could not be opened makes placeholders of its blocks, which are written as they were read, and it is
 * told: with the library at hand the scene is the same. */
static void assert_nothing_lost(const CliFixture *fixture, const FaultOperation *operation, const TestProgram *ended,
                                GBytes *reference)
{
    if (fault_is_whole(fixture, operation, reference)) return;
    g_autoptr(GBytes) now = fault_written(fixture, operation);
    if (fault_writes_report(operation) && is_told_in_summary(now)) return;
    assert_told(ended);
    g_assert_cmpstr(operation->name, ==, "convert");
    g_autoptr(TestProgram) again = cli_run_well(fixture, "convert @new.json -o @new.json");
    g_autoptr(GBytes) repaired = fault_written(fixture, operation);
    g_assert_true(g_bytes_equal(repaired, reference));
}

static gboolean is_beginning(GBytes *of, GBytes *whole)
{
    const gsize length = g_bytes_get_size(of);
    if (length > g_bytes_get_size(whole)) return FALSE;
    return length == 0 || memcmp(g_bytes_get_data(of, NULL), g_bytes_get_data(whole, NULL), length) == 0;
}

static void assert_as_it_was(const CliFixture *fixture, const FaultOperation *operation, GBytes *reference)
{
    if (operation->output == NULL) return;
    g_autoptr(GBytes) now = fault_written(fixture, operation);
    g_autoptr(GBytes) old = g_bytes_new_static(FAULT_OLD_TEXT, strlen(FAULT_OLD_TEXT));
    const gboolean begun = !operation->replaced && is_beginning(now, reference);
    g_assert_true(g_bytes_equal(now, old) || g_bytes_equal(now, reference) || begun);
}

static void try(const CliFixture *fixture, const FaultOperation *operation, const char *fault, Told good,
                GBytes *reference)
{
    fault_write_inputs(fixture, operation);
    g_autoptr(TestProgram) ended = fault_run(fixture, operation, g_getenv("TEST_MEMORY_SHIM"), fault);
    const Told told = read_mark(fixture);
    g_test_message("%s, %s: status %d, signal %d, %ld pieces: %s", operation->name, fault, ended->status, ended->signal,
                   told.pieces, ended->error);
    if (ended->signal != 0) assert_ended_by_glib(ended);
    if (ended->status == 0) {
        assert_nothing_lost(fixture, operation, ended, reference);
    } else {
        // 4: a library, or a folder of them, that could not be opened for want of memory provides nothing.
        g_assert_true(ended->status == 5 || ended->status == 4 || ended->signal != 0);
        assert_told(ended);
        assert_as_it_was(fixture, operation, reference);
    }
    g_assert_cmpint(told.pieces, <=, good.pieces + INTERNED);
    fault_assert_no_leftovers(fixture);
}

static void test_operation(CliFixture *fixture, gconstpointer data)
{
    static const char *const kinds[] = {"once", "later"};
    const FaultOperation *operation = data;
    fault_write_inputs(fixture, operation);
    g_autoptr(TestProgram) ended = fault_run(fixture, operation, g_getenv("TEST_MEMORY_SHIM"), NULL);
    if (ended->status != 0) g_error("%s", ended->error);
    g_autoptr(GBytes) reference = fault_written(fixture, operation);
    const Told good = read_mark(fixture);
    g_assert_cmpint(good.requests, >, 0);
    const long stride = g_getenv("TEST_MEMORY_EACH") != NULL ? 1 : MAX(1, good.requests / MOST_FAULTS);
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++) {
        for (long number = 1; number <= good.requests; number += stride) {
            g_autofree char *fault = g_strdup_printf("%ld %s", number, kinds[i]);
            try(fixture, operation, fault, good, reference);
        }
    }
}

int main(int argc, char **argv)
{
    // Cairo and the libraries of texts below it are beyond our reach.
    static const char *const drawn[] = {"graph-png", "graph-svg", "render-png", NULL};
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < fault_operation_count; i++) {
        if (g_strv_contains(drawn, fault_operations[i].name)) continue;
        g_autofree char *path = g_strconcat("/memory/", fault_operations[i].name, NULL);
        g_test_add(path, CliFixture, &fault_operations[i], cli_fixture_set_up, test_operation, cli_fixture_tear_down);
    }
    return g_test_run();
}
