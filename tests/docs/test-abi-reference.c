/* The pages about the plugin ABI are made from the headers without a complaint, and leave no struct and no member out.
 * usage: test-abi-reference DOXYGEN DOXYFILE PAGES */
#include <glib.h>
#include <string.h>

#include "program.h"

static char **command;

static char *header_text(const char *name)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), "sdk", "include", "tinker", name, NULL);
    return test_read_file(path);
}

static void make_pages(void)
{
    const char *const arguments[] = {command[1], command[2], NULL};
    g_autofree char *output = NULL, *error_output = NULL;
    g_autoptr(GError) error = NULL;
    int status = 0;
    g_mkdir_with_parents(command[3], 0755);
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_DEFAULT, NULL, NULL, &output, &error_output, &status, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(error_output, ==, "");
    g_assert_cmpint(status, ==, 0);
}

/* A page shows names in markup, so that "x, y" is two names there as here. */
static void check_members(const char *page, const char *body)
{
    g_autoptr(GRegex) member = g_regex_new("^ {4}[a-z][^;(/]*?[ *](\\w+)(\\[\\d+\\])?;", G_REGEX_MULTILINE, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    for (g_regex_match(member, body, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL)) {
        g_autofree char *name = g_match_info_fetch(match, 1);
        if (strstr(page, name) == NULL) g_test_message("no %s", name);
        g_assert_nonnull(strstr(page, name));
    }
}

static guint check_structs(const char *header)
{
    g_autofree char *text = header_text(header);
    g_autoptr(GRegex) structure =
        g_regex_new("^typedef struct (\\w+) \\{(.*?)^\\} \\1;", G_REGEX_MULTILINE | G_REGEX_DOTALL, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    guint count = 0;
    for (g_regex_match(structure, text, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL)) {
        g_autofree char *name = g_match_info_fetch(match, 1), *body = g_match_info_fetch(match, 2);
        g_autofree char *file = g_strdup_printf("struct%s.html", name);
        g_autofree char *path = g_build_filename(command[3], file, NULL);
        g_autofree char *page = test_read_file(path);
        check_members(page, body);
        count++;
    }
    return count;
}

static void test_pages(void)
{
    static const char *const headers[] = {"types.h",    "block.h", "physics.h", "render.h", "edit.h",
                                          "instance.h", "graph.h", "units.h",   "plugin.h", "integrator.h"};
    make_pages();
    for (gsize i = 0; i < G_N_ELEMENTS(headers); i++)
        g_assert_cmpuint(check_structs(headers[i]), >, 0);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    command = arguments;
    g_assert_cmpint(count, ==, 4);
    g_test_add_func("/docs/abi-reference", test_pages);
    return g_test_run();
}
