/* Every call on a file fails in turn, in every way that a disk has, until the operation no longer comes to it. Whatever
 * fails: what was to be written is there, whole, and the program says so; or it ends with the status of files, names
 * the file and the reason, and what was there before is as it was where it is replaced as a whole. */
#include <errno.h>
#include <glib/gstdio.h>
#include <string.h>

#include "operations.h"

#define MOST_CALLS 200

typedef struct {
    const char *call, *kind, *reason;
} Fault;

static const Fault faults[] = {
    {"open", "EACCES", "Permission denied"},
    {"open", "EIO", "Input/output error"},
    {"read", "EIO", "Input/output error"},
    {"read", "once", "Interrupted system call"},
    {"read", "short", NULL},
    {"write", "ENOSPC", "No space left on device"},
    {"write", "EIO", "Input/output error"},
    {"write", "EDQUOT", "Disk quota exceeded"},
    {"write", "once", "Interrupted system call"},
    {"write", "short", NULL},
    {"fsync", "EIO", "Input/output error"},
    {"close", "EIO", "Input/output error"},
    {"rename", "EACCES", "Permission denied"},
};

/* A scene that cannot be read, and a table that a scene names, are told of as such. */
static void assert_told(const CliFixture *fixture, const FaultOperation *operation, const Fault *fault,
                        const TestProgram *ended)
{
    static const char *const inputs[] = {"scene.json", "rich.json", "chain.json", "table.json"};
    gboolean of_input = FALSE;
    for (gsize i = 0; i < G_N_ELEMENTS(inputs); i++)
        of_input |= strstr(ended->error, inputs[i]) != NULL;
    const char *part = g_strcmp0(operation->named, "@") == 0 ? fixture->folder : operation->named;
    const char *names[] = {operation->output, part};
    gboolean named = of_input;
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        named = named || (names[i] != NULL && strstr(ended->error, names[i]) != NULL);
    g_assert_true(named);
    g_assert_true(ended->status == 5 || (of_input && ended->status == 3));
    if (fault->reason != NULL) cli_assert_holds(ended->error, fault->reason);
}

/* One fault at one call; FALSE where the operation ended before it came. */
static gboolean try(const CliFixture *fixture, const FaultOperation *operation, const Fault *fault, int number,
                    GBytes *reference)
{
    g_autofree char *text = g_strdup_printf("%s %d %s", fault->call, number, fault->kind);
    g_autofree char *mark = fault_mark(fixture);
    g_autoptr(GBytes) old = g_bytes_new_static(FAULT_OLD_TEXT, strlen(FAULT_OLD_TEXT));
    fault_write_inputs(fixture, operation);
    g_autoptr(TestProgram) ended = fault_run(fixture, operation, g_getenv("TEST_FAULT_SHIM"), text);
    const gboolean reached = g_remove(mark) == 0;
    if (reached) g_test_message("%s, %s: %d %s", operation->name, text, ended->status, ended->error);
    if (ended->status == 0) {
        g_assert_true(fault_is_whole(fixture, operation, reference));
    } else {
        g_autoptr(GBytes) now = fault_written(fixture, operation);
        g_assert_true(reached);
        assert_told(fixture, operation, fault, ended);
        if (operation->replaced && operation->output != NULL)
            g_assert_true(g_bytes_equal(now, old) || g_bytes_equal(now, reference));
    }
    fault_assert_no_leftovers(fixture);
    return reached;
}

static void test_operation(CliFixture *fixture, gconstpointer data)
{
    const FaultOperation *operation = data;
    int reached = 0;
    fault_write_inputs(fixture, operation);
    g_autoptr(TestProgram) good = fault_run(fixture, operation, g_getenv("TEST_FAULT_SHIM"), NULL);
    if (good->status != 0) g_error("%s", good->error);
    g_autoptr(GBytes) reference = fault_written(fixture, operation);
    for (gsize i = 0; i < G_N_ELEMENTS(faults); i++) {
        int number = 1;
        while (try(fixture, operation, &faults[i], number, reference)) {
            number++;
            g_assert_cmpint(number, <, MOST_CALLS);
        }
        reached += number - 1;
    }
    g_test_message("%s: %d faults", operation->name, reached);
    // A sweep that reaches nothing has shown nothing.
    g_assert_cmpint(reached, >, 0);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < fault_operation_count; i++) {
        g_autofree char *path = g_strconcat("/faults/", fault_operations[i].name, NULL);
        g_test_add(path, CliFixture, &fault_operations[i], cli_fixture_set_up, test_operation, cli_fixture_tear_down);
    }
    return g_test_run();
}
