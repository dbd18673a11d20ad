#include "german.h"

#include <glib.h>
#include <libintl.h>
#include <locale.h>

static char *locale_folder;

void german_run_tool(const char *const *arguments, char **output)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *complained = NULL;
    int status = 0;
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, output, &complained, &status, &error);
    g_assert_no_error(error);
    if (!g_spawn_check_wait_status(status, &error)) g_error("%s: %s\n%s", arguments[0], error->message, complained);
}

void german_begin(void)
{
    g_autoptr(GError) error = NULL;
    locale_folder = g_dir_make_tmp("tinker-locale-XXXXXX", &error);
    g_assert_no_error(error);
    g_autofree char *target = g_build_filename(locale_folder, GERMAN_LOCALE, NULL), *output = NULL;
    const char *compile[] = {"localedef", "--quiet", "-i", "de_DE", "-f", "UTF-8", target, NULL};
    german_run_tool(compile, &output);
    g_setenv("LOCPATH", locale_folder, TRUE);
    g_setenv("LC_ALL", GERMAN_LOCALE, TRUE);
    g_unsetenv("LANGUAGE");
    /* As main.c of the window. */
    g_assert_nonnull(setlocale(LC_CTYPE, ""));
    g_assert_cmpstr(setlocale(LC_MESSAGES, ""), ==, GERMAN_LOCALE);
    bindtextdomain("tinker", g_getenv("TINKER_LOCALE_FOLDER"));
    bind_textdomain_codeset("tinker", "UTF-8");
    textdomain("tinker");
}

void german_end(void)
{
    const char *remove[] = {"rm", "-r", locale_folder, NULL};
    g_autofree char *output = NULL;
    german_run_tool(remove, &output);
    g_free(locale_folder);
}

const char *german_folder(void)
{
    return locale_folder;
}
