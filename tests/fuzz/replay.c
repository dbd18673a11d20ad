/* Stands in for libFuzzer: gives a target each file of the folders that are named, once, as a test of its own. A
 * finding ends the program, so the file is named before it is tried. */
#include <glib.h>
#include <stdio.h>

#include "fuzz-target.h"

/* Present only where a target has something to prepare. */
__attribute__((weak)) int LLVMFuzzerInitialize(int *argc, char ***argv);

static void replay(const char *path)
{
    g_autoptr(GError) error = NULL;
    char *bytes = NULL;
    gsize length = 0;
    if (!g_file_get_contents(path, &bytes, &length, &error)) g_error("%s", error->message);
    // Of the very size, so that the address sanitizer sees a read beyond the end.
    uint8_t *exact = g_memdup2(bytes, length);
    g_free(bytes);
    printf("# %s\n", path);
    fflush(stdout);
    LLVMFuzzerTestOneInput(exact, length);
    g_free(exact);
}

static int by_name(gconstpointer a, gconstpointer b)
{
    return g_strcmp0(*(char *const *)a, *(char *const *)b);
}

/* The files of a folder, by name; of char *. */
static GPtrArray *files_of(const char *folder)
{
    g_autoptr(GError) error = NULL;
    GDir *dir = g_dir_open(folder, 0, &error);
    if (dir == NULL) g_error("%s", error->message);
    GPtrArray *files = g_ptr_array_new_with_free_func(g_free);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
        g_ptr_array_add(files, g_build_filename(folder, name, NULL));
    g_dir_close(dir);
    g_ptr_array_sort(files, by_name);
    return files;
}

int main(int argc, char **argv)
{
    if (LLVMFuzzerInitialize != NULL) LLVMFuzzerInitialize(&argc, &argv);
    int number = 0;
    for (int i = 1; i < argc; i++) {
        g_autoptr(GPtrArray) files = files_of(argv[i]);
        for (guint f = 0; f < files->len; f++) {
            replay(g_ptr_array_index(files, f));
            g_autofree char *name = g_path_get_basename(g_ptr_array_index(files, f));
            printf("ok %d - %s\n", ++number, name);
        }
    }
    if (number == 0) g_error("no file to replay");
    printf("1..%d\n", number);
    return 0;
}
