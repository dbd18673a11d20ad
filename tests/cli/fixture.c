/* A folder of its own for a test, and the program run there. */
#include "fixture.h"
#include "folders.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>

void cli_fixture_set_up(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(GError) error = NULL;
    fixture->folder = g_dir_make_tmp("tinker-cli-XXXXXX", &error);
    g_assert_no_error(error);
}

void cli_fixture_tear_down(CliFixture *fixture, gconstpointer data)
{
    test_remove_all(fixture->folder);
    g_free(fixture->folder);
}

char *cli_path(const CliFixture *fixture, const char *name)
{
    return g_build_filename(fixture->folder, name, NULL);
}

char *cli_write(const CliFixture *fixture, const char *name, const char *text)
{
    g_autoptr(GError) error = NULL;
    char *path = cli_path(fixture, name);
    g_file_set_contents(path, text, -1, &error);
    g_assert_no_error(error);
    return path;
}

char *cli_read(const CliFixture *fixture, const char *name)
{
    g_autofree char *path = cli_path(fixture, name);
    return test_read_file(path);
}

/* (transfer full) */
static char **split(const CliFixture *fixture, const char *words)
{
    g_autoptr(GError) error = NULL;
    char **arguments = NULL;
    if (words[0] == '\0')
        arguments = g_new0(char *, 1);
    else
        g_shell_parse_argv(words, NULL, &arguments, &error);
    g_assert_no_error(error);
    for (char **word = arguments; *word != NULL; word++) {
        if ((*word)[0] != '@') continue;
        char *path = cli_path(fixture, *word + 1);
        g_free(*word);
        *word = path;
    }
    return arguments;
}

TestProgram *cli_run(const CliFixture *fixture, const char *words)
{
    g_auto(GStrv) arguments = split(fixture, words);
    return test_program_run((const char *const *)arguments);
}

GPid cli_start(const CliFixture *fixture, const char *words)
{
    g_auto(GStrv) arguments = split(fixture, words);
    g_autoptr(GPtrArray) all = g_ptr_array_new();
    g_ptr_array_add(all, (gpointer)g_getenv("TINKER_PROGRAM"));
    for (char **word = arguments; *word != NULL; word++)
        g_ptr_array_add(all, *word);
    g_ptr_array_add(all, NULL);
    const GSpawnFlags flags = G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_STDOUT_TO_DEV_NULL | G_SPAWN_STDERR_TO_DEV_NULL;
    g_autoptr(GError) error = NULL;
    GPid process = 0;
    g_spawn_async(NULL, (char **)all->pdata, NULL, flags, NULL, NULL, &process, &error);
    g_assert_no_error(error);
    return process;
}

int cli_interrupt(GPid process)
{
    int status = 0;
    kill(process, SIGINT);
    g_assert_cmpint(waitpid(process, &status, 0), ==, process);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TestProgram *cli_run_well(const CliFixture *fixture, const char *words)
{
    return cli_run_badly(fixture, words, 0);
}

TestProgram *cli_run_badly(const CliFixture *fixture, const char *words, int status)
{
    TestProgram *program = cli_run(fixture, words);
    if (program->status != status)
        g_error("tinker %s: exit status %d instead of %d: %s", words, program->status, status, program->error);
    return program;
}

void cli_assert_holds(const char *text, const char *part)
{
    if (strstr(text, part) == NULL) g_error("\"%s\" is not in:\n%s", part, text);
}

void cli_assert_begins(const CliFixture *fixture, const char *name, const char *magic)
{
    g_autofree char *path = cli_path(fixture, name);
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
    g_assert_cmpuint(length, >, strlen(magic));
    g_assert_cmpmem(bytes, strlen(magic), magic, strlen(magic));
}

/* Width and height stand big-endian at bytes 16 and 20. */
void cli_assert_png_size(const CliFixture *fixture, const char *name, guint width, guint height)
{
    cli_assert_begins(fixture, name, CLI_PNG_BEGINS);
    g_autofree char *path = cli_path(fixture, name);
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
    g_assert_cmpuint(length, >, 24);
    guint32 sides[2];
    memcpy(sides, bytes + 16, sizeof sides);
    g_assert_cmpuint(GUINT32_FROM_BE(sides[0]), ==, width);
    g_assert_cmpuint(GUINT32_FROM_BE(sides[1]), ==, height);
}

void cli_test_add(const char *path, void (*test)(CliFixture *fixture, gconstpointer data))
{
    g_test_add(path, CliFixture, NULL, cli_fixture_set_up, test, cli_fixture_tear_down);
}
