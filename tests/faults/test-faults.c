/* Every call on a file fails in turn, in every way that a disk has, until the operation no longer comes to it. Whatever fails:
 * what was to be written is there, whole, and the program says so; or it ends with the status of files, names the file and the
 * reason, and what was there before is as it was where it is replaced as a whole. */
#include <errno.h>
#include <glib/gstdio.h>
#include <string.h>

#include "fixture.h"

#define MOST_CALLS 200
#define OLD_TEXT   "what was there before\n"

/* An operation: the words of a command line, "@" standing for the folder; and the file that it writes. */
typedef struct {
    const char *name;
    gboolean worker; /* a part of the core, see worker.c; else the program */
    const char *words;
    const char *output; /* in the folder; NULL: none that stays */
    gboolean replaced;  /* as a whole: what was there before is not lost */
    const char *named;  /* part of what a message names; "@": the folder; NULL: the output */
} Operation;

static const Operation operations[] = {
    {"convert", FALSE, "convert @scene.json -o @new.json", "new.json", TRUE, NULL},
    {"csv", FALSE, "run @scene.json --csv @new.csv", "new.csv", FALSE, NULL},
    {"json", FALSE, "run @scene.json --json @new.json", "new.json", FALSE, NULL},
    {"graph-csv", FALSE, "graph @scene.json -o @new.csv", "new.csv", FALSE, NULL},
    {"graph-png", FALSE, "graph @scene.json -o @new.png", "new.png", FALSE, NULL},
    {"graph-svg", FALSE, "graph @scene.json -o @new.svg", "new.svg", FALSE, NULL},
    {"render-png", FALSE, "render @scene.json -o @new.png", "new.png", FALSE, NULL},
    {"table", FALSE, "run @table.json --csv @new.csv", "new.csv", FALSE, "motion.csv"},
    {"record", TRUE, "record", NULL, FALSE, "@"},
    {"cache", TRUE, "cache @", "plugins.json", TRUE, NULL},
    {"manifest", TRUE, "manifest @library.so", NULL, FALSE, NULL},
#ifdef WITH_AUTOSAVE
    {"autosave", TRUE, "autosave", NULL, FALSE, "autosave"},
#endif
};

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

static char *words_in(const CliFixture *fixture, const Operation *operation)
{
    g_autofree char *folder = g_strconcat(fixture->folder, "/", NULL);
    GString *words = g_string_new(operation->words);
    g_string_replace(words, "@", folder, 0);
    return g_string_free(words, FALSE);
}

/* Only the child may have these, so they are set for as long as it starts and runs. */
static void set_environment(const CliFixture *fixture, const char *fault)
{
    g_autofree char *state = cli_path(fixture, "state");
    g_autofree char *mark = g_strconcat(fixture->folder, ".reached", NULL);
    const char *sanitizer = g_getenv("ASAN_OPTIONS");
    g_autofree char *options = g_strconcat(sanitizer == NULL ? "" : sanitizer, ":verify_asan_link_order=0", NULL);
    g_setenv("ASAN_OPTIONS", options, TRUE);
    g_setenv("LD_PRELOAD", g_getenv("TEST_FAULT_SHIM"), TRUE);
    g_setenv("TEST_FAULT_FOLDER", fixture->folder, TRUE);
    g_setenv("TEST_FAULT_REACHED", mark, TRUE);
    g_setenv("TMPDIR", fixture->folder, TRUE);
    g_setenv("XDG_STATE_HOME", state, TRUE);
    if (fault != NULL) g_setenv("TEST_FAULT", fault, TRUE);
}

/* Runs the operation, with a fault or (NULL) without. (transfer full) */
static TestProgram *run(const CliFixture *fixture, const Operation *operation, const char *fault)
{
    g_autofree char *words = words_in(fixture, operation);
    g_auto(GStrv) arguments = g_strsplit(words, " ", -1), before = g_get_environ();
    g_autofree char *program = g_strdup(g_getenv(operation->worker ? "TEST_FAULT_WORKER" : "TINKER_PROGRAM"));
    set_environment(fixture, fault);
    g_autofree char *own = g_strdup(g_getenv("TINKER_PROGRAM"));
    g_setenv("TINKER_PROGRAM", program, TRUE);
    TestProgram *ended = test_program_run((const char *const *)arguments);
    g_setenv("TINKER_PROGRAM", own, TRUE);
    static const char *const names[] = {"ASAN_OPTIONS",       "LD_PRELOAD", "TEST_FAULT",     "TEST_FAULT_FOLDER",
                                        "TEST_FAULT_REACHED", "TMPDIR",     "XDG_STATE_HOME", NULL};
    for (const char *const *name = names; *name != NULL; name++) {
        const char *value = g_environ_getenv(before, *name);
        if (value != NULL)
            g_setenv(*name, value, TRUE);
        else
            g_unsetenv(*name);
    }
    return ended;
}

static void write_inputs(const CliFixture *fixture, const Operation *operation)
{
    static const char table[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\",\n"
        " \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": \"motion.csv\", \"column\": 1}}]}\n";
    static const char manifest[] =
        "{\"manifest\": 1, \"id\": \"org.tinker.test\", \"title\": \"T\", \"version\": \"1\", \"licence\": \"MIT\", "
        "\"home_page\": \"\", \"types\": [], \"integrators\": [], \"library\": {\"size\": 1, \"mtime_ns\": \"1\"}}\n";
    g_free(cli_write(fixture, "scene.json", FREE_FALL));
    g_free(cli_write(fixture, "table.json", table));
    g_free(cli_write(fixture, "motion.csv", "0,1\n1,2\n"));
    g_free(cli_write(fixture, "library.manifest.json", manifest));
    if (operation->output != NULL) g_free(cli_write(fixture, operation->output, OLD_TEXT));
}

/* The checksum of bytes. (transfer full) */
static char *checksum_of(const char *bytes, gsize length)
{
    return g_compute_checksum_for_data(G_CHECKSUM_SHA256, (const guint8 *)bytes, length);
}

/* The checksum of what an operation wrote; of nothing where there is no file. (transfer full) */
static char *written(const CliFixture *fixture, const Operation *operation)
{
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_autofree char *path = cli_path(fixture, operation->output != NULL ? operation->output : "none");
    if (!g_file_get_contents(path, &bytes, &length, NULL)) length = 0;
    return checksum_of(bytes, length);
}

/* A summary tells how long the run took, and the autosave's files are named anew each time. */
static void assert_whole(const CliFixture *fixture, const Operation *operation, const char *reference)
{
    g_autofree char *now = written(fixture, operation), *path = cli_path(fixture, "new.json");
    if (!g_str_equal(operation->name, "json"))
        g_assert_cmpstr(now, ==, reference);
    else
        cJSON_Delete(test_read_json(path));
}

/* A scene that cannot be read, and a table that a scene names, are told of as such. */
static void assert_told(const CliFixture *fixture, const Operation *operation, const Fault *fault,
                        const TestProgram *ended)
{
    const gboolean of_input = strstr(ended->error, "scene.json") != NULL || strstr(ended->error, "table.json") != NULL;
    const char *part = g_strcmp0(operation->named, "@") == 0 ? fixture->folder : operation->named;
    const char *names[] = {operation->output, part};
    gboolean named = of_input;
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        named = named || (names[i] != NULL && strstr(ended->error, names[i]) != NULL);
    g_assert_true(named);
    g_assert_true(ended->status == 5 || (of_input && ended->status == 3));
    if (fault->reason != NULL) cli_assert_holds(ended->error, fault->reason);
}

/* Nothing is left lying about: temporary files would be. */
static void assert_no_leftovers(const CliFixture *fixture)
{
    g_autoptr(GDir) folder = g_dir_open(fixture->folder, 0, NULL);
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder)) {
        const char *tail = strrchr(name, '.');
        if (g_str_has_prefix(name, "tinker-record-")) g_error("%s is left", name);
        if (tail != NULL && strlen(tail) == 7 && g_ascii_isupper(tail[1]) && g_ascii_isupper(tail[2]))
            g_error("%s is left", name);
    }
}

/* One fault at one call; FALSE where the operation ended before it came. */
static gboolean try(const CliFixture *fixture, const Operation *operation, const Fault *fault, int number,
                    const char *reference)
{
    g_autofree char *text = g_strdup_printf("%s %d %s", fault->call, number, fault->kind);
    g_autofree char *mark = g_strconcat(fixture->folder, ".reached", NULL);
    g_autofree char *old = checksum_of(OLD_TEXT, strlen(OLD_TEXT));
    write_inputs(fixture, operation);
    g_autoptr(TestProgram) ended = run(fixture, operation, text);
    const gboolean reached = g_remove(mark) == 0;
    if (reached) g_test_message("%s, %s: %d %s", operation->name, text, ended->status, ended->error);
    if (ended->status == 0) {
        assert_whole(fixture, operation, reference);
    } else {
        g_autofree char *now = written(fixture, operation);
        g_assert_true(reached);
        assert_told(fixture, operation, fault, ended);
        if (operation->replaced && operation->output != NULL)
            g_assert_true(g_str_equal(now, old) || g_str_equal(now, reference));
    }
    assert_no_leftovers(fixture);
    return reached;
}

static void test_operation(CliFixture *fixture, gconstpointer data)
{
    const Operation *operation = data;
    int reached = 0;
    write_inputs(fixture, operation);
    g_autoptr(TestProgram) good = run(fixture, operation, NULL);
    if (good->status != 0) g_error("%s", good->error);
    g_autofree char *reference = written(fixture, operation);
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
    for (gsize i = 0; i < G_N_ELEMENTS(operations); i++) {
        g_autofree char *path = g_strconcat("/faults/", operations[i].name, NULL);
        g_test_add(path, CliFixture, &operations[i], cli_fixture_set_up, test_operation, cli_fixture_tear_down);
    }
    return g_test_run();
}
