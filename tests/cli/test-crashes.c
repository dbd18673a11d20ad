/* Plugins that go wrong in the middle of a run: who was at work is told, and what was recorded stays. */
#include <glib/gstdio.h>
#include <signal.h>
#include <sys/stat.h>

#include "crash-fixture.h"

typedef struct {
    const char *type;
    int signal; /* that ends the process; 0: it ends with status 1 */
    const char *how;
} Exhibit;

static const Exhibit exhibits[] = {
    {"segfaults", SIGSEGV, "crashed (SIGSEGV)"},
    {"overflows", SIGSEGV, "crashed (SIGSEGV, its stack overflowed)"},
    {"aborts", SIGABRT, "crashed (SIGABRT)"},
    {"traps", SIGILL, "crashed (SIGILL)"},
    {"exits", 0, "called exit()"},
};

static void test_exhibit(CliFixture *fixture, gconstpointer data)
{
    const Exhibit *exhibit = data;
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, exhibit->type, "0.125", CRASH_COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    /* each mass is an island of its own; the first asks at the first stage after t = 1 s */
    g_autofree char *message = g_strdup_printf(
        "tinker: the plugin org.example.%s %s in \"force\" of block type %s (block First) at t = 1.0625 s; "
        "what was recorded up to then is in %s\n",
        exhibit->type, exhibit->how, exhibit->type, csv);
    g_assert_cmpstr(program->error, ==, message);
    g_assert_cmpint(program->signal, ==, exhibit->signal);
    g_assert_cmpint(program->status, ==, exhibit->signal != 0 ? -1 : 1);
    crash_assert_record(fixture);
}

/* All rows are in the file already, as their text is longer than what is gathered: the message names it all the same.
 */
static void test_nothing_gathered(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(GString) columns = g_string_new("Mass 0.x");
    for (int i = 0; i < 6000; i++)
        g_string_append(columns, ",Mass 0.x");
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "segfaults", "2", columns->str);
    g_autofree char *csv = cli_path(fixture, "r.csv"), *text = cli_read(fixture, "r.csv");
    g_autofree char *end = g_strdup_printf("; what was recorded up to then is in %s\n", csv);
    g_assert_cmpint(program->signal, ==, SIGSEGV);
    g_assert_true(g_str_has_suffix(program->error, end));
    g_autoptr(TestTable) table = test_table_new(text);
    g_assert_cmpuint(table->rows, ==, 1);
    g_assert_cmpuint(table->columns, ==, 6002);
}

static void test_not_a_number(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "nan-force", "0.125", CRASH_COLUMNS);
    g_autofree char *scene = cli_path(fixture, "a.json");
    g_assert_cmpint(program->status, ==, 1);
    g_autofree char *message = g_strdup_printf(
        "tinker: %s: the run stopped at t = 1 s: First: its force at t = 1.0625 s is not a number (block "
        "type nan-force of the plugin org.example.nan-force); what was computed is to be believed up to "
        "t = 1 s\n",
        scene);
    g_assert_cmpstr(program->error, ==, message);
    crash_assert_record(fixture);
}

/* What a plugin says of its failure is one line of plain text. */
static void test_rough_words(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "rough-words", "0.125", CRASH_COLUMNS);
    g_autofree char *scene = cli_path(fixture, "a.json");
    g_assert_cmpint(program->status, ==, 1);
    g_autofree char *message = g_strdup_printf(
        "tinker: %s: the run stopped at t = 1 s: First: its force at t = 1.0625 s cannot be worked out: [31mtoo "
        "fast\xef\xbf\xbd; what was computed is to be believed up to t = 1 s\n",
        scene);
    g_assert_cmpstr(program->error, ==, message);
    crash_assert_record(fixture);
}

/* The reason is at an address that leads nowhere. */
static void test_wild_words(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "wild-words", "0.125", CRASH_COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    g_autofree char *message =
        g_strdup_printf("tinker: the plugin org.example.wild-words crashed (SIGSEGV) in \"failure\" of block type "
                        "wild-words; what was recorded up to then is in %s\n",
                        csv);
    g_assert_cmpint(program->signal, ==, SIGSEGV);
    g_assert_cmpstr(program->error, ==, message);
    crash_assert_record(fixture);
}

/* One byte beyond the scratch breaks nothing at once, and nothing that is computed can be relied on. */
static void test_overrun(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "overruns-scratch", "0.125", CRASH_COLUMNS);
    g_assert_cmpint(program->status, ==, 1);
    cli_assert_holds(program->error, "the plugin org.example.overruns-scratch wrote beyond the scratch of its block "
                                     "type overruns-scratch");
    cli_assert_holds(program->error, "to be believed up to t = 1 s");
}

/* Traps that a plugin leaves switched on hit the host, which knows who was there before. */
static void test_traps_left(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "leaves-traps", "0.125", CRASH_COLUMNS);
    g_assert_cmpint(program->signal, ==, SIGFPE);
    cli_assert_holds(program->error, "tinker itself crashed (SIGFPE)");
    cli_assert_holds(program->error, "after the plugin org.example.leaves-traps had come back from \"force\" of block "
                                     "type leaves-traps");
}

/* The run is done and its record written when the crash comes. */
static void test_crash_at_end(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "crashes-at-end", "0.125", CRASH_COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv"), *text = cli_read(fixture, "r.csv");
    g_autofree char *message = g_strdup_printf("tinker: the library %s/crashes-at-end-exhibit.so crashed (SIGSEGV) "
                                               "outside of any call, in a thread of its own "
                                               "or at the end of the program\n",
                                               g_getenv("TINKER_EXHIBITS"));
    g_autoptr(TestTable) table = test_table_new(text);
    g_assert_cmpint(program->signal, ==, SIGSEGV);
    g_assert_cmpstr(program->error, ==, message);
    g_assert_cmpuint(table->rows, ==, 25);
}

/* A plugin's `prepare` that changes locale, umask, rounding, traps and the answer to SIGTERM changes nothing for the
 * run: two masses fly as without it, the file may be read by whom the umask lets, and numbers have a point. */
static void test_changed_process(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = crash_run_exhibit(fixture, "changes-process", "0.125", CRASH_COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv"), *text = cli_read(fixture, "r.csv");
    g_autoptr(TestTable) table = test_table_new(text);
    GStatBuf about;
    const mode_t mask = umask(022);
    umask(mask);
    g_assert_cmpint(program->status, ==, 0);
    g_assert_cmpuint(table->rows, ==, 25);
    g_assert_cmpfloat(test_table_value(table, 24, "Mass 1.x"), ==, 6.0);
    g_assert_cmpint(g_stat(csv, &about), ==, 0);
    g_assert_cmpint(about.st_mode & 0777, ==, 0666 & ~mask);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(exhibits); i++) {
        g_autofree char *path = g_strconcat("/crashes/", exhibits[i].type, NULL);
        g_test_add(path, CliFixture, &exhibits[i], cli_fixture_set_up, test_exhibit, cli_fixture_tear_down);
    }
    cli_test_add("/crashes/nothing-gathered", test_nothing_gathered);
    cli_test_add("/crashes/not-a-number", test_not_a_number);
    cli_test_add("/crashes/rough-words", test_rough_words);
    cli_test_add("/crashes/wild-words", test_wild_words);
    cli_test_add("/crashes/overrun", test_overrun);
    cli_test_add("/crashes/traps-left", test_traps_left);
    cli_test_add("/crashes/crash-at-end", test_crash_at_end);
    cli_test_add("/crashes/changed-process", test_changed_process);
    return g_test_run();
}
