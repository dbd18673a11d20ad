/* A plugin's author at work. */
#include "author.h"

#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "program.h"

static void link_to(const char *target, const char *folder, const char *name)
{
    g_autofree char *path = g_build_filename(folder, name, NULL);
    g_assert_cmpint(symlink(target, path), ==, 0);
}

/* The SDK as it will be installed: the package file of the build, with this folder as its prefix. */
static void stage_sdk(const char *folder)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *built = test_read_file(g_getenv("TINKER_SDK_PACKAGE"));
    g_autoptr(GRegex) prefix = g_regex_new("^prefix=.*$", G_REGEX_MULTILINE, 0, NULL);
    g_autofree char *here = g_strconcat("prefix=", folder, NULL);
    g_autofree char *package = g_regex_replace_literal(prefix, built, -1, 0, here, 0, NULL);
    g_autofree char *path = g_build_filename(folder, "tinker-sdk.pc", NULL);
    g_file_set_contents(path, package, -1, &error);
    g_assert_no_error(error);
    g_autofree char *headers = g_build_filename(g_getenv("TINKER_SOURCES"), "sdk", "include", NULL);
    link_to(headers, folder, "include");
}

char *test_author_folder(void)
{
    g_autoptr(GError) error = NULL;
    char *folder = g_dir_make_tmp("tinker-plugin-XXXXXX", &error);
    g_assert_no_error(error);
    stage_sdk(folder);
    g_autofree char *programs = g_build_filename(folder, "bin", NULL);
    g_assert_cmpint(g_mkdir(programs, 0755), ==, 0);
    link_to(g_getenv("TINKER_PROGRAM"), programs, "tinker");
    return folder;
}

void test_author_run(const char *folder, const char *data_home, const char *const *arguments)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_strdup_printf("%s/bin:%s", folder, g_getenv("PATH")), *output = NULL, *message = NULL;
    g_auto(GStrv) environment = g_environ_setenv(g_get_environ(), "PKG_CONFIG_LIBDIR", folder, TRUE);
    environment = g_environ_unsetenv(environment, "PKG_CONFIG_PATH");
    environment = g_environ_setenv(environment, "PATH", path, TRUE);
    if (data_home != NULL) environment = g_environ_setenv(environment, "XDG_DATA_HOME", data_home, TRUE);
    int wait_status = 0;
    g_spawn_sync(folder, (char **)arguments, environment, G_SPAWN_SEARCH_PATH, NULL, NULL, &output, &message,
                 &wait_status, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(message, ==, "");
    if (!g_spawn_check_wait_status(wait_status, NULL)) g_test_message("%s", output);
    g_assert_true(g_spawn_check_wait_status(wait_status, NULL));
}

void test_author_states_laws(const char *library)
{
    const char *check[] = {"plugins", "check", library, NULL};
    g_autoptr(TestProgram) program = test_program_run(check);
    if (program->status != 0 || strstr(program->output, "it states no law") != NULL)
        g_error("%s: %s%s", library, program->output, program->error);
}
