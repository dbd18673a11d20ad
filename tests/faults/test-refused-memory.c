/* Memory for what grows with the user's file: every request for it fails in turn. The error names the file, or what of
 * the scene it is for, and says that it is memory that lacks; nothing is kept of what was read; with memory at hand the
 * same file is read. */
#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "fixture.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "scene/read/scene-json.h"
#include "units/waveform/waveform.h"

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
REFUSING(g_try_malloc, (gsize size), (size))
REFUSING(g_try_malloc0_n, (gsize count, gsize size), (count, size))
REFUSING(g_try_malloc_n, (gsize count, gsize size), (count, size))

/* Reads a file; what was read is given back. */
typedef gboolean (*Read)(const char *path, GError **error);

/* Each request fails in turn until the call no longer comes to it; then all is well. `named` is what the message names.
 * Answers how many requests there were. */
static int try_each(Read read_file, const char *path, const char *named)
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
        cli_assert_holds(error->message, named);
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
    g_assert_cmpint(try_each(read_table, path, path), ==, 2 * 5 + 2);
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
    g_assert_cmpint(try_each(read_pipe, path, path), ==, 2);
}

/* Reading it, of which the tests above tell, fails in nothing and is not counted. (transfer full) */
static TinkerScene *read_scene(const char *path)
{
    static TinkerCatalogue *catalogue;
    const char *folders[] = {g_getenv("TINKER_TEST_PLUGINS"), NULL};
    const TinkerCatalogueOptions options = {.folders = folders, .probe_program = g_getenv("TINKER_PROGRAM")};
    const int from = failing, before = requests;
    g_autoptr(GError) error = NULL;
    failing = 0;
    if (catalogue == NULL) catalogue = tinker_catalogue_new(&options);
    TinkerScene *scene = tinker_scene_read_file(catalogue, path, NULL, &error);
    g_assert_no_error(error);
    failing = from;
    requests = before;
    return scene;
}

/* Memory that lacks is what the error is about, whatever was asked for. */
static gboolean judge(gboolean good, GError **error)
{
    if (!good) g_assert_true(error == NULL || g_error_matches(*error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY));
    return good;
}

static gboolean compile_scene(const char *path, GError **error)
{
    TinkerScene *scene = read_scene(path);
    TinkerModel *model = tinker_model_new(scene, error);
    const gboolean good = judge(model != NULL, error);
    tinker_model_free(model);
    tinker_scene_free(scene);
    return good;
}

/* A scene's equations: a frame of rods with a diagonal, so that they hang together in cycles, a spring, a damper and a
 * force. */
static void test_equations(CliFixture *fixture, gconstpointer data)
{
    static const char frame[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"mass\", \"position\": [1, 0]},\n"
        " {\"type\": \"mass\", \"position\": [1, 1]}, {\"type\": \"mass\", \"position\": [0, 1]},\n"
        " {\"type\": \"rod\", \"ends\": [\"Mass 0\", \"Mass 1\"]}, {\"type\": \"rod\", \"ends\": [\"Mass 1\", \"Mass "
        "2\"]},\n"
        " {\"type\": \"rod\", \"ends\": [\"Mass 2\", \"Mass 3\"]}, {\"type\": \"rod\", \"ends\": [\"Mass 3\", \"Mass "
        "0\"]},\n"
        " {\"type\": \"rod\", \"ends\": [\"Mass 0\", \"Mass 2\"]},\n"
        " {\"type\": \"spring\", \"ends\": [\"Mass 1\", \"Mass 3\"]}, {\"type\": \"damper\", \"ends\": [\"Mass 1\", "
        "\"Mass 3\"]},\n"
        " {\"type\": \"motor\", \"ends\": [\"Mass 0\"], \"waveform\": \"sine\", \"frequency\": 1}]}\n";
    g_autofree char *path = cli_write(fixture, "frame.json", frame);
    g_assert_cmpint(try_each(compile_scene, path, "no memory for the"), >, 20);
}

static gboolean impulses;

/* Requests of the compiling are left to the test above. */
static gboolean run_scene(const char *path, GError **error)
{
    const int from = failing;
    TinkerScene *scene = read_scene(path);
    failing = 0;
    g_autoptr(GError) refusal = NULL;
    TinkerModel *model = tinker_model_new(scene, &refusal);
    g_assert_no_error(refusal);
    failing = from;
    requests = 0;
    const TinkerRunOptions options = {
        .duration = 0.5, .interval = 0.1, .method = "dop853", .step = 0.01, .tolerance = 1e-9, .impulses = impulses};
    TinkerSimulation *simulation = tinker_simulation_new(model, &options, error);
    const gboolean good =
        judge(simulation != NULL && tinker_simulation_run(simulation, NULL, NULL, NULL, error), error);
    tinker_simulation_free(simulation);
    tinker_model_free(model);
    tinker_scene_free(scene);
    return good;
}

/* Contacts that are decided together: a chain of rods that falls flat on a rough floor and slides there, beside a mass
 * that does so by itself, so that the whole model's contacts are gathered from its islands. Answers how many requests
 * there were. */
static int try_contacts(CliFixture *fixture, gboolean as_impulses)
{
    enum { MASSES = 12 };
    g_autoptr(GString) text = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},\n"
                                           " {\"type\": \"support\", \"width\": 100, \"restitution\": 0.3,\n"
                                           "  \"static_friction\": 0.3, \"dynamic_friction\": 0.2}");
    for (int i = 0; i < MASSES; i++)
        g_string_append_printf(
            text, ",\n {\"type\": \"mass\", \"name\": \"M%d\", \"position\": [%d, 1], \"velocity\": [1, 0]}", i, i);
    for (int i = 0; i < MASSES - 2; i++)
        g_string_append_printf(text, ",\n {\"type\": \"rod\", \"ends\": [\"M%d\", \"M%d\"]}", i, i + 1);
    g_string_append(text, "]}\n");
    g_autofree char *path = cli_write(fixture, "chain.json", text->str);
    impulses = as_impulses;
    return try_each(run_scene, path, "no memory for the");
}

static void test_contacts(CliFixture *fixture, gconstpointer data)
{
    g_assert_cmpint(try_contacts(fixture, FALSE), >, 20);
}

static void test_impulses(CliFixture *fixture, gconstpointer data)
{
    g_assert_cmpint(try_contacts(fixture, TRUE), >=, 1);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/refused-memory/table", test_table);
    cli_test_add("/refused-memory/stream", test_stream);
    cli_test_add("/refused-memory/equations", test_equations);
    cli_test_add("/refused-memory/contacts", test_contacts);
    cli_test_add("/refused-memory/contacts-as-impulses", test_impulses);
    return g_test_run();
}
