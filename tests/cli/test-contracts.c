/* Methods and drawings that do not keep to their contract, and types that look like files: the run stops or the picture
 * is mended, and the one at fault is named. */
#include "crash-fixture.h"

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

/* Times of a step that are not those of its contract, or none for no reason: the run stops, and names the method. A
 * mass would hang in the air otherwise, with an error that is said to be nothing. */
static void test_wrong_times(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *method, *fault;
    } methods[] = {
        {"past-limit", "past the limit of"}, {"short-of-limit", "was to step to t ="},
        {"other-step", "reports a step of"}, {"no-step", "the time stands still"},
        {"no-reason", "does not say why"},
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
    g_autofree char *copy = crash_copy_exhibit(fixture, "aborts", "evil.so");
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
    cli_test_add("/contracts/lost-state", test_lost_state);
    cli_test_add("/contracts/method", test_method);
    cli_test_add("/contracts/wrong-times", test_wrong_times);
    cli_test_add("/contracts/drawings", test_drawings);
    cli_test_add("/contracts/type-like-a-path", test_type_like_a_path);
    return g_test_run();
}
