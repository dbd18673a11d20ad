/* What binaries ask the loader for: a plugin nothing of ours, the command line no desktop. */
#include <glib.h>
#include <string.h>

#include "source-text.h"

#define LEAST_PLUGINS 8 /* there are more */

/* The libraries that a binary asks the loader for; of char *. (transfer full) */
static GPtrArray *needed_libraries(const char *binary)
{
    g_autofree char *output = source_output_of((const char *[]){"readelf", "--dynamic", "--wide", binary, NULL});
    GPtrArray *needed = g_ptr_array_new_with_free_func(g_free);
    g_auto(GStrv) lines = g_strsplit(output, "\n", -1);
    for (char **line = lines; *line != NULL; line++) {
        const char *name = strchr(*line, '[');
        if (strstr(*line, "(NEEDED)") == NULL || name == NULL) continue;
        g_ptr_array_add(needed, g_strndup(name + 1, strcspn(name + 1, "]")));
    }
    return needed;
}

/* A plugin links to nothing of ours: the C library and the mathematics alone, and what a sanitizer adds. The method on
 * SUNDIALS links to that. */
static void test_plugins_link_to_c_alone(void)
{
    static const char *const allowed[] = {"libc.so", "libm.so", "libasan.so", "libubsan.so", "libtsan.so", NULL};
    const char *folder = g_getenv("TINKER_TEST_PLUGINS");
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    guint seen = 0;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, ".so")) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        g_autoptr(GPtrArray) needed = needed_libraries(path);
        for (guint i = 0; i < needed->len; i++)
            if (!source_begins_with_one_of(needed->pdata[i], allowed) &&
                !(strcmp(name, "tinker-cvode-bdf.so") == 0 && g_str_has_prefix(needed->pdata[i], "libsundials_"))) {
                g_test_message("%s links to %s", name, (char *)needed->pdata[i]);
                g_test_fail();
            }
        seen++;
    }
    g_assert_cmpuint(seen, >=, LEAST_PLUGINS);
}

/* The command line runs where there is no display and no desktop. */
static void test_program_links_to_no_desktop(void)
{
    static const char *const desktop[] = {"libgtk", "libadwaita", "libgdk", "libX11", "libwayland", "libtinker", NULL};
    g_autoptr(GPtrArray) needed = needed_libraries(g_getenv("TINKER_PROGRAM"));
    g_assert_cmpuint(needed->len, >, 0);
    for (guint i = 0; i < needed->len; i++)
        g_assert_false(source_begins_with_one_of(needed->pdata[i], desktop));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/links/plugins", test_plugins_link_to_c_alone);
    g_test_add_func("/links/program", test_program_links_to_no_desktop);
    return g_test_run();
}
