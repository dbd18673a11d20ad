/* Templates are texts with words to be put in. They are all read from the program itself, so nothing of them can be
 * missing, and nothing is written before all is known. */
#include "cli/plugins/template-folder.h"

#include <errno.h>
#include <gio/gio.h>
#include <glib/gstdio.h>
#include <stdio.h>
#include <string.h>

#include "common/program/exit-status.h"

#define ROOT         "/tinker/templates/"
#define SCENE_ENDING ".tinker.json"

static void file_free(gpointer data)
{
    TinkerTemplateFile *file = data;
    g_free(file->path);
    g_free(file->text);
    g_free(file);
}

/* (transfer full) */
static char *text_of(const char *resource, const TinkerTemplateWords *words)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GBytes) bytes = g_resources_lookup_data(resource, G_RESOURCE_LOOKUP_FLAGS_NONE, &error);
    g_assert_no_error(error);
    gsize length;
    const char *data = g_bytes_get_data(bytes, &length);
    GString *text = g_string_new_len(data, (gssize)length);
    g_string_replace(text, "@name@", words->name, 0);
    g_string_replace(text, "@title@", words->title, 0);
    g_string_replace(text, "@role@", words->role, 0);
    g_string_replace(text, "@sentence@", words->sentence, 0);
    return g_string_free(text, FALSE);
}

/* "name.c", "test-name.c" with the name. (transfer full) */
static char *file_name(const char *in_template, const char *name)
{
    if (g_str_has_prefix(in_template, "name.")) return g_strconcat(name, in_template + strlen("name"), NULL);
    if (g_str_has_prefix(in_template, "test-name."))
        return g_strconcat("test-", name, in_template + strlen("test-name"), NULL);
    return g_strdup(in_template);
}

GPtrArray *tinker_template_files_new(void)
{
    return g_ptr_array_new_with_free_func(file_free);
}

void tinker_template_files_add(GPtrArray *files, const char *template_name, const TinkerTemplateWords *words,
                               const char *scene_folder)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *folder = g_strconcat(ROOT, template_name, NULL);
    g_auto(GStrv) names = g_resources_enumerate_children(folder, G_RESOURCE_LOOKUP_FLAGS_NONE, &error);
    g_assert_no_error(error);
    for (char **name = names; *name != NULL; name++) {
        g_autofree char *resource = g_strconcat(folder, "/", *name, NULL);
        g_autofree char *plain = file_name(*name, words->name);
        const gboolean below = scene_folder != NULL && g_str_has_suffix(plain, SCENE_ENDING);
        TinkerTemplateFile *file = g_new(TinkerTemplateFile, 1);
        file->path = below ? g_build_filename(scene_folder, plain, NULL) : g_strdup(plain);
        file->text = text_of(resource, words);
        g_ptr_array_add(files, file);
    }
}

static gboolean fail(const char *path, int reason, GError **error)
{
    g_autofree char *parent = g_path_get_dirname(path);
    if (reason == EEXIST)
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE,
                    "%s: exists already, and nothing is overwritten (choose another name, or another folder with "
                    "--output)",
                    path);
    else if (reason == ENOENT && !g_file_test(parent, G_FILE_TEST_EXISTS))
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: cannot be made: the folder %s does not exist",
                    path, parent);
    else
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: cannot be made: %s", path, g_strerror(reason));
    return FALSE;
}

static gboolean make_folder(const char *path, GPtrArray *made, GError **error)
{
    if (g_mkdir(path, 0777) != 0) return fail(path, errno, error);
    g_ptr_array_add(made, g_strdup(path));
    return TRUE;
}

/* The folder of a file within the new folder, where it is not made yet. */
static gboolean make_parent(const char *path, GPtrArray *made, GError **error)
{
    g_autofree char *parent = g_path_get_dirname(path);
    return g_ptr_array_find_with_equal_func(made, parent, g_str_equal, NULL) || make_folder(parent, made, error);
}

static gboolean write_file(const char *path, const char *text, GPtrArray *made, GError **error)
{
    FILE *file = fopen(path, "wxe"); /* x: what is there already is not opened */
    if (file == NULL) return fail(path, errno, error);
    g_ptr_array_add(made, g_strdup(path));
    const int reason = fputs(text, file) >= 0 ? 0 : errno;
    if (fclose(file) == 0 && reason == 0) return TRUE;
    return fail(path, reason != 0 ? reason : errno, error);
}

static gint compare_files(gconstpointer a, gconstpointer b)
{
    const TinkerTemplateFile *first = *(TinkerTemplateFile *const *)a, *second = *(TinkerTemplateFile *const *)b;
    return strcmp(first->path, second->path);
}

gboolean tinker_template_files_write(GPtrArray *files, const char *folder, GError **error)
{
    g_autoptr(GPtrArray) made = g_ptr_array_new_with_free_func(g_free); /* in the order of making */
    g_autofree char *root = g_canonicalize_filename(folder, NULL);
    g_ptr_array_sort(files, compare_files);
    if (g_mkdir(folder, 0777) != 0) return fail(folder, errno, error);
    g_ptr_array_add(made, g_strdup(root));
    gboolean done = TRUE;
    for (guint i = 0; i < files->len && done; i++) {
        const TinkerTemplateFile *file = files->pdata[i];
        g_autofree char *path = g_build_filename(root, file->path, NULL);
        done = make_parent(path, made, error) && write_file(path, file->text, made, error);
    }
    for (guint i = made->len; i > 0 && !done; i--)
        g_remove(made->pdata[i - 1]);
    return done;
}
