/* Folders that tests make. */
#include "folders.h"

#include <glib.h>
#include <glib/gstdio.h>

void test_remove_all(const char *path)
{
    if (g_file_test(path, G_FILE_TEST_IS_DIR) && !g_file_test(path, G_FILE_TEST_IS_SYMLINK)) {
        g_autoptr(GDir) dir = g_dir_open(path, 0, NULL);
        for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
            g_autofree char *inside = g_build_filename(path, name, NULL);
            test_remove_all(inside);
        }
    }
    g_assert_cmpint(g_remove(path), ==, 0);
}
