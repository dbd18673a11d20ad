/* A package's installation (DESTDIR) of the desktop's files. The tools see it through XDG_DATA_DIRS, before the
 * system's data: what they answer is what a desktop with the package would answer. */
#include "installed.h"

#include <sys/wait.h>

static char *package; /* the root of the installation */

static char **tool_environment(void)
{
    g_autofree char *share = test_installed_path(""), *data = g_strconcat(share, ":/usr/share", NULL);
    return g_environ_setenv(g_get_environ(), "XDG_DATA_DIRS", data, TRUE);
}

int test_tool_run(const char *const *arguments, char **output)
{
    g_auto(GStrv) environment = tool_environment();
    g_autofree char *said = NULL, *complained = NULL;
    g_autoptr(GError) error = NULL;
    int wait_status = 0;
    g_spawn_sync(NULL, (char **)arguments, environment, G_SPAWN_SEARCH_PATH, NULL, NULL, &said, &complained,
                 &wait_status, &error);
    g_assert_no_error(error);
    if (output != NULL) *output = g_strconcat(said, complained, NULL);
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : -1;
}

char *test_tool_output(const char *const *arguments)
{
    char *output = NULL;
    const int status = test_tool_run(arguments, &output);
    if (status != 0) {
        g_autofree char *command = g_strjoinv(" ", (char **)arguments);
        g_test_message("%s: status %d\n%s", command, status, output);
        g_test_fail();
    }
    return output;
}

char *test_installed_path(const char *relative)
{
    return g_build_filename(package, g_getenv("TINKER_SHARE"), relative, NULL);
}

char *test_installed_text(const char *relative)
{
    g_autofree char *path = test_installed_path(relative);
    g_autoptr(GError) error = NULL;
    char *text = NULL;
    g_file_get_contents(path, &text, NULL, &error);
    g_assert_no_error(error);
    return text;
}

void test_installed_set_up(void)
{
    g_autoptr(GError) error = NULL;
    package = g_dir_make_tmp("tinker-package-XXXXXX", &error);
    g_assert_no_error(error);
    const char *build = g_getenv("TINKER_BUILD");
    const char *install[] = {"meson",  "install",      "-C",        build,   "--no-rebuild",
                             "--tags", "desktop,i18n", "--destdir", package, NULL};
    g_autofree char *installed = test_tool_output(install), *mime = test_installed_path("mime");
    const char *update[] = {"update-mime-database", mime, NULL};
    g_autofree char *updated = test_tool_output(update);
}

void test_installed_tear_down(void)
{
    const char *delete[] = {"rm", "-r", package, NULL};
    g_autofree char *deleted = test_tool_output(delete);
    g_clear_pointer(&package, g_free);
}
