/* Memory for what grows with the user's file: every request for it fails in turn. The error names the file and says that it is
 * memory that lacks; nothing is kept of what was read; with memory at hand the same file is read. */
#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixture.h"
#include "scene/scene-json.h"
#include "units/waveform.h"

#define ROWS 1000

static int requests, failing; /* from 1; 0: none */

/* The wrapper stands before GLib's function in what is linked here. */
#define REFUSING(name, parameters, arguments)                                                                          \
    gpointer __real_##name parameters;                                                                                 \
    __attribute__((visibility("default"))) gpointer __wrap_##name parameters;                                          \
    gpointer __wrap_##name parameters                                                                                  \
    {                                                                                                                  \
        return ++requests == failing ? NULL : __real_##name arguments;                                                 \
    }
REFUSING(g_try_realloc, (gpointer memory, gsize size), (memory, size))
REFUSING(g_try_realloc_n, (gpointer memory, gsize count, gsize size), (memory, count, size))
REFUSING(g_try_malloc0_n, (gsize count, gsize size), (count, size))

/* Reads a file; what was read is given back. */
typedef gboolean (*Read)(const char *path, GError **error);

/* Answers how many requests there were. */
static int try_each(Read read_file, const char *path)
{
    for (failing = 1;; failing++) {
        g_autoptr(GError) error = NULL;
        requests = 0;
        const gboolean good = read_file(path, &error);
        if (requests < failing) {
            g_assert_true(good);
            break;
        }
        g_assert_false(good);
        cli_assert_holds(error->message, path);
        cli_assert_holds(error->message, "there is no memory");
    }
    const int most = failing - 1;
    failing = 0;
    g_assert_true(read_file(path, NULL));
    return most;
}

static gboolean read_table(const char *path, GError **error)
{
    TinkerWaveform *waveform = tinker_waveform_new_table_file(path, 1, 1, TINKER_TABLE_ACCELERATION, error);
    if (waveform == NULL) return FALSE;
    TinkerTableFacts facts;
    g_assert_true(tinker_waveform_table_facts(waveform, &facts));
    g_assert_cmpuint(facts.rows, ==, ROWS);
    tinker_waveform_unref(waveform);
    return TRUE;
}

/* Its two columns, from 64 rows on doubled until there is room for all of them, and what they are integrated to. */
static void test_table(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(GString) text = g_string_new(NULL);
    for (int i = 0; i < ROWS; i++)
        g_string_append_printf(text, "%d,%d\n", i, i % 7);
    g_autofree char *path = cli_write(fixture, "motion.csv", text->str);
    g_assert_cmpint(try_each(read_table, path), ==, 2 * 5 + 2);
}

/* A pipe's end by its name, with the scene written into it by a child, since it holds more than a pipe does. */
static gboolean read_pipe(const char *path, GError **error)
{
    const TinkerCatalogueOptions options = {.probe_seconds = 5};
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&options);
    g_assert_cmpint(mkfifo(path, 0600), ==, 0);
    const pid_t writer = fork();
    g_assert_cmpint(writer, >=, 0);
    if (writer == 0) {
        const int file = open(path, O_WRONLY);
        static char spaces[100000];
        memset(spaces, ' ', sizeof spaces);
        const gboolean whole = write(file, spaces, sizeof spaces) == (gssize)sizeof spaces;
        _exit(whole && write(file, "{\"tinker\": 1, \"blocks\": []}", 27) == 27 ? 0 : 1);
    }
    TinkerScene *scene = tinker_scene_read_file(catalogue, path, NULL, error);
    while (waitpid(writer, NULL, 0) < 0)
        g_assert_cmpint(errno, ==, EINTR);
    g_remove(path);
    if (scene == NULL) return FALSE;
    tinker_scene_free(scene);
    return TRUE;
}

/* 64 KiB, and twice that. */
static void test_stream(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = cli_path(fixture, "scene.pipe");
    g_assert_cmpint(try_each(read_pipe, path), ==, 2);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/refused-memory/table", test_table);
    cli_test_add("/refused-memory/stream", test_stream);
    return g_test_run();
}
