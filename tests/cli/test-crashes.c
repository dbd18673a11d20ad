/* Plugins that go wrong in the middle of a run: who was at work is told, and what was recorded stays. */
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
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

/* All rows are in the file already, as their text is longer than what is gathered: the message names it all the same.
 */
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

/* What a plugin says of its failure is one line of plain text. */
static void test_rough_words(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = run_exhibit(fixture, "rough-words", "0.125", COLUMNS);
    g_autofree char *scene = cli_path(fixture, "a.json");
    g_assert_cmpint(program->status, ==, 1);
    g_autofree char *message = g_strdup_printf(
        "tinker: %s: the run stopped at t = 1 s: First: its force at t = 1.0625 s cannot be worked out: [31mtoo "
        "fast\xef\xbf\xbd; what was computed is to be believed up to t = 1 s\n",
        scene);
    g_assert_cmpstr(program->error, ==, message);
    assert_record(fixture);
}

/* The reason is at an address that leads nowhere. */
static void test_wild_words(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = run_exhibit(fixture, "wild-words", "0.125", COLUMNS);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    g_autofree char *message =
        g_strdup_printf("tinker: the plugin org.example.wild-words crashed (SIGSEGV) in \"failure\" of block type "
                        "wild-words; what was recorded up to then is in %s\n",
                        csv);
    g_assert_cmpint(program->signal, ==, SIGSEGV);
    g_assert_cmpstr(program->error, ==, message);
    assert_record(fixture);
}

/* One byte beyond the scratch breaks nothing at once, and nothing that is computed can be relied on. */
static void test_overrun(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = run_exhibit(fixture, "overruns-scratch", "0.125", COLUMNS);
    g_assert_cmpint(program->status, ==, 1);
    cli_assert_holds(program->error, "the plugin org.example.overruns-scratch wrote beyond the scratch of its block "
                                     "type overruns-scratch");
    cli_assert_holds(program->error, "to be believed up to t = 1 s");
}

/* Traps that a plugin leaves switched on hit the host, which knows who was there before. */
static void test_traps_left(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = run_exhibit(fixture, "leaves-traps", "0.125", COLUMNS);
    g_assert_cmpint(program->signal, ==, SIGFPE);
    cli_assert_holds(program->error, "tinker itself crashed (SIGFPE)");
    cli_assert_holds(program->error, "after the plugin org.example.leaves-traps had come back from \"force\" of block "
                                     "type leaves-traps");
}

/* The run is done and its record written when the crash comes. */
static void test_crash_at_end(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = run_exhibit(fixture, "crashes-at-end", "0.125", COLUMNS);
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
    g_autoptr(TestProgram) program = run_exhibit(fixture, "changes-process", "0.125", COLUMNS);
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

/* Starts the program with these words, and waits until a plugin is at it that never comes back. */
static GPid start_and_wait(const char *const *words, int *errors)
{
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

static GPid start_hanging(const CliFixture *fixture, const char *folder, int *errors)
{
    write_scene(fixture, "hangs");
    g_autofree char *scene = cli_path(fixture, "a.json"), *csv = cli_path(fixture, "r.csv");
    const char *words[] = {
        g_getenv("TINKER_PROGRAM"), "run", scene, "--plugins", folder, "--csv", csv, "--columns", COLUMNS, NULL};
    return start_and_wait(words, errors);
}

static void test_hanging_drawing(CliFixture *fixture, gconstpointer data)
{
    write_scene(fixture, "hangs-in-drawing");
    g_autofree char *scene = cli_path(fixture, "a.json"), *picture = cli_path(fixture, "a.png");
    const char *words[] = {g_getenv("TINKER_PROGRAM"),  "render", scene,   "--plugins",
                           g_getenv("TINKER_EXHIBITS"), "-o",     picture, NULL};
    int errors, status = 0;
    char text[1024] = "";
    const GPid process = start_and_wait(words, &errors);
    kill(process, SIGTERM);
    g_assert_cmpint(waitpid(process, &status, 0), ==, process);
    g_assert_true(WIFSIGNALED(status));
    g_assert_cmpint(WTERMSIG(status), ==, SIGTERM);
    g_assert_cmpint(read(errors, text, sizeof text - 1), >, 0);
    close(errors);
    g_assert_cmpstr(text, ==,
                    "tinker: the plugin org.example.hangs-in-drawing was interrupted in \"draw\" of block type "
                    "hangs-in-drawing (block First) at t = 0 s\n");
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

/* A method that puts other arrays into the state is stopped before anybody reads them. */
static void test_lost_state(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autofree char *words =
        g_strdup_printf("run @a.json --plugins '%s' --method loses-state", g_getenv("TINKER_EXHIBITS"));
    g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 1);
    cli_assert_holds(program->error, "the method put other arrays in the place of those of the state");
}

/* Times of a step that are not those of its contract: the run stops, and names the method. A mass would hang in the air
 * otherwise, with an error that is said to be nothing. */
static void test_wrong_times(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *method, *fault;
    } methods[] = {
        {"past-limit", "past the limit of"},
        {"short-of-limit", "was to step to t ="},
        {"other-step", "reports a step of"},
        {"no-step", "the time stands still"},
    };
    g_free(cli_write(fixture, "a.json", FREE_FALL));
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autofree char *words =
            g_strdup_printf("run @a.json --plugins '%s' --method %s", g_getenv("TINKER_EXHIBITS"), methods[i].method);
        g_autofree char *named = g_strdup_printf("the method %s ", methods[i].method);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 1);
        cli_assert_holds(program->error, named);
        cli_assert_holds(program->error, methods[i].fault);
        cli_assert_holds(program->error, "its plugin is at fault");
    }
}

/* A drawing that leaves its context otherwise than it was spoils nothing of what is drawn after it: the picture is that
 * of a block that draws the same and behaves. The block is named. */
static void test_drawings(CliFixture *fixture, gconstpointer data)
{
    static const char *const types[] = {"draws-line", "draws-saved", "draws-restored", "draws-group", "draws-broken"};
    static const char *const faults[] = {NULL, "differently often", "differently often", "leaves a group open",
                                         "leaves cairo in the state"};
    g_autoptr(GBytes) right = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": "
                                                "\"gravity\"}, {\"type\": \"mass\", \"position\": "
                                                "[2, 1]}, {\"type\": \"%s\", \"name\": \"Bad\", \"ends\": [\"Mass "
                                                "0\"]}, {\"type\": \"spring\", \"ends\": [\"Mass "
                                                "0\", \"Mass 1\"]}]}",
                                                types[i]);
        g_free(cli_write(fixture, "a.json", text));
        g_autofree char *words =
            g_strdup_printf("render @a.json --plugins '%s' -o @a.png", g_getenv("TINKER_EXHIBITS"));
        g_autoptr(TestProgram) program = cli_run_well(fixture, words);
        g_autofree char *path = cli_path(fixture, "a.png");
        char *bytes = NULL;
        gsize length = 0;
        g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
        g_autoptr(GBytes) picture = g_bytes_new_take(bytes, length);
        if (i == 0) {
            g_assert_cmpstr(program->error, ==, "");
            right = g_bytes_ref(picture);
        } else {
            cli_assert_holds(program->error, "warning: Bad: its drawing");
            cli_assert_holds(program->error, types[i]);
            cli_assert_holds(program->error, faults[i]);
            g_assert_true(g_bytes_equal(picture, right));
        }
    }
}

/* A scene names types. What looks like a file is a type that nobody has: nothing is opened, though the file is there.
 */
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
    cli_test_add("/crashes/hanging-drawing", test_hanging_drawing);
    cli_test_add("/crashes/rough-words", test_rough_words);
    cli_test_add("/crashes/wild-words", test_wild_words);
    cli_test_add("/crashes/overrun", test_overrun);
    cli_test_add("/crashes/traps-left", test_traps_left);
    cli_test_add("/crashes/crash-at-end", test_crash_at_end);
    cli_test_add("/crashes/changed-process", test_changed_process);
    cli_test_add("/crashes/lost-state", test_lost_state);
    cli_test_add("/crashes/overwritten", test_overwritten);
    cli_test_add("/crashes/method", test_method);
    cli_test_add("/crashes/wrong-times", test_wrong_times);
    cli_test_add("/crashes/drawings", test_drawings);
    cli_test_add("/crashes/type-like-a-path", test_type_like_a_path);
    return g_test_run();
}
