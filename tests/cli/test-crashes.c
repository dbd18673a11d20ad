/* Plugins that go wrong in the middle of a run: who was at work is told, and what was recorded stays. */
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixture.h"

#define COLUMNS "Mass 0.x,Mass 1.x"

/* Two blocks of the exhibit's type on two masses that fly at 1 and 2 m/s; after t = 1 s the exhibit misbehaves. */
static void write_scene(const CliFixture *fixture, const char *type)
{
    g_autofree char *text =
        g_strdup_printf("{\"tinker\": 1, \"run\": {\"duration\": 3, \"interval\": 0.125, \"method\": \"rk4\", "
                        "\"step\": 0.125}, \"blocks\": [{\"type\": \"mass\", \"velocity\": [1, 0]},\n"
                        "{\"type\": \"mass\", \"position\": [0, 1], \"velocity\": [2, 0]},\n"
                        "{\"type\": \"%s\", \"name\": \"First\", \"ends\": [\"Mass 0\"]},\n"
                        "{\"type\": \"%s\", \"name\": \"Second\", \"ends\": [\"Mass 1\"]}]}\n",
                        type, type);
    g_autofree char *path = cli_write(fixture, "a.json", text);
}

static TestProgram *run_exhibit(const CliFixture *fixture, const char *type, const char *interval, const char *columns)
{
    write_scene(fixture, type);
    g_autofree char *words = g_strdup_printf("run @a.json --plugins '%s' --csv @r.csv --interval %s --columns '%s'",
                                             g_getenv("TINKER_EXHIBITS"), interval, columns);
    return cli_run(fixture, words);
}

/* Rows of 0, 0.125, ... 1 s, and nothing after them: x = v t. */
static void assert_record(const CliFixture *fixture)
{
    g_autofree char *text = cli_read(fixture, "r.csv");
    g_assert_true(g_str_has_suffix(text, "\n"));
    g_autoptr(TestTable) table = test_table_new(text);
    g_assert_cmpuint(table->rows, ==, 9);
    g_assert_cmpuint(table->columns, ==, 3);
    for (gsize row = 0; row < table->rows; row++) {
        double t = (double)row / 8;
        g_assert_cmpfloat(test_table_value(table, row, "time"), ==, t);
        g_assert_cmpfloat(test_table_value(table, row, "Mass 0.x"), ==, t);
        g_assert_cmpfloat(test_table_value(table, row, "Mass 1.x"), ==, 2 * t);
    }
}

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
    g_autoptr(TestProgram) program = run_exhibit(fixture, exhibit->type, "0.125", COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    /* each mass is an island of its own; the first asks at the first stage after t = 1 s */
    g_autofree char *message = g_strdup_printf(
        "tinker: the plugin org.example.%s %s in \"force\" of block type %s (block First) at t = 1.0625 s; "
        "what was recorded up to then is in %s\n",
        exhibit->type, exhibit->how, exhibit->type, csv);
    g_assert_cmpstr(program->error, ==, message);
    g_assert_cmpint(program->signal, ==, exhibit->signal);
    g_assert_cmpint(program->status, ==, exhibit->signal != 0 ? -1 : 1);
    assert_record(fixture);
}

/* All rows are in the file already, as their text is longer than what is gathered: the message names it all the same. */
static void test_nothing_gathered(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(GString) columns = g_string_new("Mass 0.x");
    for (int i = 0; i < 6000; i++)
        g_string_append(columns, ",Mass 0.x");
    g_autoptr(TestProgram) program = run_exhibit(fixture, "segfaults", "2", columns->str);
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
    g_autoptr(TestProgram) program = run_exhibit(fixture, "nan-force", "0.125", COLUMNS);
    g_autofree char *scene = cli_path(fixture, "a.json");
    g_assert_cmpint(program->status, ==, 1);
    g_autofree char *message = g_strdup_printf(
        "tinker: %s: the run stopped at t = 1 s: First: its force at t = 1.0625 s is not a number (block "
        "type nan-force of the plugin org.example.nan-force); what was computed is to be believed up to "
        "t = 1 s\n",
        scene);
    g_assert_cmpstr(program->error, ==, message);
    assert_record(fixture);
}

/* Waits until a signal that was sent to a process is being answered. */
static void wait_until_taken(GPid process, int signal_number)
{
    g_autofree char *path = g_strdup_printf("/proc/%d/status", process);
    for (gboolean pending = TRUE; pending; g_usleep(1000)) {
        g_autofree char *text = test_read_file(path);
        const char *line = strstr(text, "\nShdPnd:");
        g_assert_nonnull(line);
        pending = (g_ascii_strtoull(line + strlen("\nShdPnd:"), NULL, 16) >> (signal_number - 1) & 1) != 0;
    }
}

/* An exhibit's library under another name in the test's folder. (transfer full) */
static char *copy_exhibit(const CliFixture *fixture, const char *exhibit, const char *name)
{
    g_autofree char *file = g_strconcat(exhibit, "-exhibit.so", NULL), *contents = NULL;
    g_autofree char *library = g_build_filename(g_getenv("TINKER_EXHIBITS"), file, NULL);
    char *copy = cli_path(fixture, name);
    gsize size = 0;
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_get_contents(library, &contents, &size, &error));
    g_assert_true(g_file_set_contents(copy, contents, (gssize)size, &error));
    return copy;
}

/* Starts a run with the plugin of that folder that never comes back, and waits until it is at that. */
static GPid start_hanging(const CliFixture *fixture, const char *folder, int *errors)
{
    write_scene(fixture, "hangs");
    g_autofree char *scene = cli_path(fixture, "a.json"), *csv = cli_path(fixture, "r.csv");
    const char *words[] = {
        g_getenv("TINKER_PROGRAM"), "run", scene, "--plugins", folder, "--csv", csv, "--columns", COLUMNS, NULL};
    GPid process;
    int output;
    char text[1024] = "";
    g_autoptr(GError) error = NULL;
    g_spawn_async_with_pipes(NULL, (char **)words, NULL, G_SPAWN_DO_NOT_REAP_CHILD, NULL, NULL, &process, NULL, &output,
                             errors, &error);
    g_assert_no_error(error);
    g_assert_cmpint(read(output, text, sizeof text - 1), ==, strlen("hangs\n"));
    close(output);
    return process;
}

/* Waits for the end by that signal, with these words about the plugin. */
static void expect_end_of_hanging(const CliFixture *fixture, GPid process, int errors, int signal_number,
                                  const char *how)
{
    int status = 0;
    char text[1024] = "";
    g_assert_cmpint(waitpid(process, &status, 0), ==, process);
    g_assert_true(WIFSIGNALED(status));
    g_assert_cmpint(WTERMSIG(status), ==, signal_number);
    g_assert_cmpint(read(errors, text, sizeof text - 1), >, 0);
    close(errors);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    g_autofree char *message =
        g_strdup_printf("tinker: the plugin org.example.hangs %s in \"force\" of block type hangs "
                        "(block First) at t = 1.0625 s; what was recorded up to then is in %s\n",
                        how, csv);
    g_assert_cmpstr(text, ==, message);
    assert_record(fixture);
}

/* A plugin that never comes back: the second Ctrl-C, or SIGTERM, ends the program all the same. */
static void test_hang(CliFixture *fixture, gconstpointer data)
{
    const int signal_number = GPOINTER_TO_INT(data);
    int errors;
    const GPid process = start_hanging(fixture, g_getenv("TINKER_EXHIBITS"), &errors);
    kill(process, signal_number);
    if (signal_number == SIGINT) {
        wait_until_taken(process, SIGINT);
        kill(process, SIGINT);
    }
    expect_end_of_hanging(fixture, process, errors, signal_number, "was interrupted");
}

/* The first thing that cp does to a file it overwrites takes the library's code away while it runs, and its texts. */
static void test_overwritten(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *copy = copy_exhibit(fixture, "hangs", "hangs.so");
    int errors;
    const GPid process = start_hanging(fixture, fixture->folder, &errors);
    g_assert_cmpint(truncate(copy, 0), ==, 0);
    expect_end_of_hanging(fixture, process, errors, SIGBUS, "crashed (SIGBUS)");
}

/* A method is a plugin's, too. */
static void test_method(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autofree char *words =
        g_strdup_printf("run @a.json --plugins '%s' --method crashing-method", g_getenv("TINKER_EXHIBITS"));
    g_autoptr(TestProgram) program = cli_run_badly(fixture, words, -1);
    g_assert_cmpint(program->signal, ==, SIGSEGV);
    g_assert_cmpstr(program->error, ==,
                    "tinker: the plugin org.example.crashing-method crashed (SIGSEGV) in \"step\" of the method "
                    "crashing-method\n");
}

/* A scene names types. What looks like a file is a type that nobody has: nothing is opened, though the file is there. */
static void test_type_like_a_path(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *copy = copy_exhibit(fixture, "aborts", "evil.so");
    const char *types[] = {copy, "../evil.so", "./evil", "evil", "../../evil"};
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"library\": \"evil.so\", \"plugins\": [\"%s\"], "
                                                "\"blocks\": [{\"type\": \"%s\", \"library\": \"%s\"}]}",
                                                copy, types[i], copy);
        g_autofree char *scene = cli_write(fixture, "a.json", text);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, "run @a.json", 4);
        g_autofree char *message = g_strdup_printf("no plugin provides the block type \"%s\"", types[i]);
        cli_assert_holds(program->error, message);
    }
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
    const int signals[] = {SIGINT, SIGTERM};
    for (gsize i = 0; i < G_N_ELEMENTS(signals); i++) {
        g_autofree char *path = g_strdup_printf("/crashes/hang/%s", sigabbrev_np(signals[i]));
        g_test_add(path, CliFixture, GINT_TO_POINTER(signals[i]), cli_fixture_set_up, test_hang, cli_fixture_tear_down);
    }
    cli_test_add("/crashes/overwritten", test_overwritten);
    cli_test_add("/crashes/method", test_method);
    cli_test_add("/crashes/type-like-a-path", test_type_like_a_path);
    return g_test_run();
}
