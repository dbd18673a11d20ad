/* Plugins that never come back, or whose library goes away under them: the program ends when it is told to, and says
 * who was at work. */
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "crash-fixture.h"

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
    crash_write_scene(fixture, "hangs");
    g_autofree char *scene = cli_path(fixture, "a.json"), *csv = cli_path(fixture, "r.csv");
    const char *words[] = {
        g_getenv("TINKER_PROGRAM"), "run", scene, "--plugins", folder, "--csv", csv, "--columns", CRASH_COLUMNS, NULL};
    return start_and_wait(words, errors);
}

static void test_hanging_drawing(CliFixture *fixture, gconstpointer data)
{
    crash_write_scene(fixture, "hangs-in-drawing");
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
    crash_assert_record(fixture);
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
    g_autofree char *copy = crash_copy_exhibit(fixture, "hangs", "hangs.so");
    int errors;
    const GPid process = start_hanging(fixture, fixture->folder, &errors);
    g_assert_cmpint(truncate(copy, 0), ==, 0);
    expect_end_of_hanging(fixture, process, errors, SIGBUS, "crashed (SIGBUS)");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    const int signals[] = {SIGINT, SIGTERM};
    for (gsize i = 0; i < G_N_ELEMENTS(signals); i++) {
        g_autofree char *path = g_strdup_printf("/hangs/by/%s", sigabbrev_np(signals[i]));
        g_test_add(path, CliFixture, GINT_TO_POINTER(signals[i]), cli_fixture_set_up, test_hang, cli_fixture_tear_down);
    }
    cli_test_add("/hangs/hanging-drawing", test_hanging_drawing);
    cli_test_add("/hangs/overwritten", test_overwritten);
    return g_test_run();
}
