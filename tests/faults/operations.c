/* The table of operations, and running them. */
#include "operations.h"

#include <string.h>

const FaultOperation fault_operations[] = {
    {"convert", FALSE, "convert @rich.json -o @new.json", "new.json", TRUE, NULL},
    {"csv", FALSE, "run @scene.json --interval 0.0005 --csv @new.csv", "new.csv", FALSE, NULL},
    {"json", FALSE, "run @scene.json --json @new.json", "new.json", FALSE, NULL},
    {"automatic", FALSE, "run @chain.json --json @new.json", "new.json", FALSE, NULL},
    {"modes", FALSE, "modes @chain.json --json @new.json", "new.json", FALSE, NULL},
    {"equations", FALSE, "equations @chain.json --as json -o @new.json", "new.json", FALSE, NULL},
    {"books", FALSE, "books @scene.json --to 0.1 --as json -o @new.json", "new.json", FALSE, NULL},
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

const gsize fault_operation_count = G_N_ELEMENTS(fault_operations);

static char *words_in(const CliFixture *fixture, const FaultOperation *operation)
{
    g_autofree char *folder = g_strconcat(fixture->folder, "/", NULL);
    GString *words = g_string_new(operation->words);
    g_string_replace(words, "@", folder, 0);
    return g_string_free(words, FALSE);
}

/* Only the child may have these, so they are set for as long as it starts and runs. */
static void set_environment(const CliFixture *fixture, const char *shim, const char *fault)
{
    g_autofree char *state = cli_path(fixture, "state");
    g_autofree char *mark = fault_mark(fixture);
    const char *sanitizer = g_getenv("ASAN_OPTIONS");
    /* the shim would be loaded into the sanitizer's symbolizer, too, which cannot start then: whoever writes to it as
     * it ends is ended by SIGPIPE */
    g_autofree char *options =
        g_strconcat(sanitizer == NULL ? "" : sanitizer, ":verify_asan_link_order=0:symbolize=0", NULL);
    g_setenv("ASAN_OPTIONS", options, TRUE);
    g_setenv("LD_PRELOAD", shim, TRUE);
    g_setenv("TEST_FAULT_FOLDER", fixture->folder, TRUE);
    g_setenv("TEST_FAULT_REACHED", mark, TRUE);
    g_setenv("TMPDIR", fixture->folder, TRUE);
    g_setenv("XDG_STATE_HOME", state, TRUE);
    if (fault != NULL) g_setenv("TEST_FAULT", fault, TRUE);
}

TestProgram *fault_run(const CliFixture *fixture, const FaultOperation *operation, const char *shim, const char *fault)
{
    g_autofree char *words = words_in(fixture, operation);
    g_auto(GStrv) arguments = g_strsplit(words, " ", -1), before = g_get_environ();
    g_autofree char *program = g_strdup(g_getenv(operation->worker ? "TEST_FAULT_WORKER" : "TINKER_PROGRAM"));
    set_environment(fixture, shim, fault);
    g_setenv("TINKER_PROGRAM", program, TRUE);
    TestProgram *ended = test_program_run((const char *const *)arguments);
    static const char *const names[] = {"ASAN_OPTIONS",       "LD_PRELOAD", "TEST_FAULT",     "TEST_FAULT_FOLDER",
                                        "TEST_FAULT_REACHED", "TMPDIR",     "TINKER_PROGRAM", "XDG_STATE_HOME"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        const char *value = g_environ_getenv(before, names[i]);
        if (value != NULL)
            g_setenv(names[i], value, TRUE);
        else
            g_unsetenv(names[i]);
    }
    return ended;
}

void fault_write_inputs(const CliFixture *fixture, const FaultOperation *operation)
{
    static const char table[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\",\n"
        " \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": \"motion.csv\", \"column\": 1}}]}\n";
    static const char manifest[] =
        "{\"manifest\": 1, \"id\": \"org.tinker.test\", \"title\": \"T\", \"version\": \"1\", \"licence\": \"MIT\", "
        "\"home_page\": \"\", \"types\": [], \"integrators\": [], \"library\": {\"size\": 1, \"mtime_ns\": \"1\"}}\n";
    // What a reader keeps in different ways: a missing type, escapes in keys and texts, a waveform, ends, a graph.
    static const char rich[] =
        "{\"tinker\": 1, \"title\": \"caf\\u00e9\", \"run\": {\"durati\\u006fn\": 1}, \"blocks\": [\n"
        " {\"type\": \"support\"}, {\"type\": \"mass\", \"name\": \"A \\\"1\\\"\", \"position\": [\"3 ft\", 0]},\n"
        " {\"type\": \"spring\", \"ends\": [\"Support 0\", {\"block\": \"A \\\"1\\\"\"}], \"stiffness\": \"100 "
        "N/m\"},\n"
        " {\"type\": \"motor\", \"ends\": [\"A \\\"1\\\"\"], \"waveform\": {\"expression\": \"2 * sin(t)\"}},\n"
        " {\"type\": \"widget\", \"ends\": [\"Support 0\"], \"any\": [1, {\"of\": \"it\"}]}],\n"
        " \"graphs\": [{\"block\": \"A \\\"1\\\"\", \"quantity\": \"y\"}]}\n";
    g_free(cli_write(fixture, "rich.json", rich));
    // Linear, so that the method exact is taken, damped, and driven; with modes.
    static const char chain[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"support\"},\n"
        " {\"type\": \"mass\", \"position\": [0, -1]}, {\"type\": \"mass\", \"position\": [0, -2]},\n"
        " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100},\n"
        " {\"type\": \"spring\", \"ends\": [\"Mass 0\", \"Mass 1\"], \"stiffness\": 100},\n"
        " {\"type\": \"damper\", \"ends\": [\"Mass 0\", \"Mass 1\"], \"damping\": 1},\n"
        " {\"type\": \"motor\", \"ends\": [\"Mass 1\"], \"waveform\": \"sine\", \"frequency\": 3}]}\n";
    g_free(cli_write(fixture, "chain.json", chain));
    g_free(cli_write(fixture, "scene.json", FREE_FALL));
    g_free(cli_write(fixture, "table.json", table));
    g_free(cli_write(fixture, "motion.csv", "0,1\n1,2\n"));
    g_free(cli_write(fixture, "library.manifest.json", manifest));
    if (operation->output != NULL) g_free(cli_write(fixture, operation->output, FAULT_OLD_TEXT));
}

char *fault_mark(const CliFixture *fixture)
{
    return g_strconcat(fixture->folder, ".reached", NULL);
}

GBytes *fault_written(const CliFixture *fixture, const FaultOperation *operation)
{
    char *bytes = NULL;
    gsize length = 0;
    g_autofree char *path = cli_path(fixture, operation->output != NULL ? operation->output : "none");
    if (!g_file_get_contents(path, &bytes, &length, NULL)) length = 0;
    return g_bytes_new_take(bytes, length);
}

/* A report of the program, without how long a run took. (transfer full) */
static cJSON *report_of(GBytes *text)
{
    cJSON *summary = cJSON_ParseWithLength(g_bytes_get_data(text, NULL), g_bytes_get_size(text));
    cJSON_DeleteItemFromObjectCaseSensitive(summary, "wall_s");
    cJSON_DeleteItemFromObjectCaseSensitive(summary, "real_time_factor");
    return summary;
}

gboolean fault_writes_report(const FaultOperation *operation)
{
    return strstr(operation->words, "--json") != NULL;
}

gboolean fault_is_whole(const CliFixture *fixture, const FaultOperation *operation, GBytes *reference)
{
    g_autoptr(GBytes) now = fault_written(fixture, operation);
    if (!fault_writes_report(operation)) return g_bytes_equal(now, reference);
    cJSON *summary = report_of(now), *whole = report_of(reference);
    const gboolean same = cJSON_Compare(summary, whole, TRUE);
    cJSON_Delete(summary);
    cJSON_Delete(whole);
    return same;
}

void fault_assert_no_leftovers(const CliFixture *fixture)
{
    g_autoptr(GDir) folder = g_dir_open(fixture->folder, 0, NULL);
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder)) {
        if (g_str_has_prefix(name, "tinker-record-") || g_str_has_prefix(name, ".tinker-part-"))
            g_error("%s is left", name);
    }
}
