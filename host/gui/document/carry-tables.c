/* Copies are made by GIO, which overwrites nothing. */
#include "gui/document/carry-tables.h"

#include <gio/gio.h>
#include <glib/gi18n-lib.h>
#include <glib/gstdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/value/table-source.h"

static gboolean same_contents(const char *a, const char *b)
{
    g_autofree char *a_text = NULL, *b_text = NULL;
    gsize a_length, b_length;
    GStatBuf a_status, b_status;
    if (g_stat(a, &a_status) != 0 || g_stat(b, &b_status) != 0 || a_status.st_size != b_status.st_size) return FALSE;
    return g_file_get_contents(a, &a_text, &a_length, NULL) && g_file_get_contents(b, &b_text, &b_length, NULL) &&
           a_length == b_length && memcmp(a_text, b_text, a_length) == 0;
}

/* Overwrites nothing. `name` and `folder` are what a message calls them. */
static gboolean copy_file(const char *source, const char *target, const char *name, const char *folder, GError **error)
{
    g_autoptr(GFile) source_file = g_file_new_for_path(source), target_file = g_file_new_for_path(target);
    g_autoptr(GError) reason = NULL;
    if (g_file_copy(source_file, target_file, G_FILE_COPY_NONE, NULL, NULL, NULL, &reason)) return TRUE;
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, _("The table “%s” cannot be copied to %s: %s"),
                name, folder, reason->message);
    return FALSE;
}

static gboolean carry(const char *file, const char *from, const char *to, GError **error)
{
    g_autofree char *source = g_build_filename(from, file, NULL), *target = g_build_filename(to, file, NULL);
    if (!g_file_test(source, G_FILE_TEST_EXISTS)) return TRUE;
    if (g_file_test(target, G_FILE_TEST_EXISTS)) {
        if (same_contents(source, target)) return TRUE;
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE,
                    _("The scene reads the table “%s”, and there is another file of that name in the folder %s. Choose "
                      "another folder."),
                    file, to);
        return FALSE;
    }
    g_autofree char *folder = g_path_get_dirname(target);
    g_mkdir_with_parents(folder, 0777);
    return copy_file(source, target, file, to, error);
}

gboolean carry_tables(TinkerScene *scene, const char *from, const char *to, GError **error)
{
    g_autofree char *from_folder = g_path_get_dirname(from), *to_folder = g_path_get_dirname(to);
    g_autofree char *from_plain = g_canonicalize_filename(from_folder, NULL);
    g_autofree char *to_plain = g_canonicalize_filename(to_folder, NULL);
    if (strcmp(from_plain, to_plain) == 0) return TRUE;
    g_autoptr(GPtrArray) files = tinker_scene_table_files(scene);
    for (guint i = 0; i < files->len; i++)
        if (!carry(g_ptr_array_index(files, i), from_plain, to_plain, error)) return FALSE;
    return TRUE;
}

/* One table -------------------------------------------------------------------------------------------------------- */

/* Both by their real places: a folder may have been reached through a link. */
char *table_name_in_scene(const char *scene, const char *table)
{
    g_autofree char *folder = g_path_get_dirname(scene);
    char *real_folder = realpath(folder, NULL), *real_table = realpath(table, NULL);
    g_autoptr(GFile) folder_file = g_file_new_for_path(real_folder != NULL ? real_folder : folder);
    g_autoptr(GFile) table_file = g_file_new_for_path(real_table != NULL ? real_table : table);
    free(real_folder);
    free(real_table);
    return g_file_get_relative_path(folder_file, table_file);
}

/* Whether a copy of the table can be made there, or is there already. */
static gboolean can_be_copy(const char *target, const char *table)
{
    if (g_file_test(target, G_FILE_TEST_IS_SYMLINK)) return FALSE;
    return !g_file_test(target, G_FILE_TEST_EXISTS) ||
           (g_file_test(target, G_FILE_TEST_IS_REGULAR) && same_contents(target, table));
}

char *table_name_of_copy(const char *scene, const char *table)
{
    g_autofree char *folder = g_path_get_dirname(scene), *bytes = g_path_get_basename(table);
    g_autofree char *own = g_utf8_make_valid(bytes, -1); /* a scene can name no other */
    const char *ending = strrchr(own, '.');
    if (ending == NULL || ending == own) ending = own + strlen(own);
    for (guint number = 1;; number++) {
        g_autofree char *name =
            number == 1 ? g_strdup(own) : g_strdup_printf("%.*s-%u%s", (int)(ending - own), own, number, ending);
        g_autofree char *target = g_build_filename(folder, name, NULL);
        if (can_be_copy(target, table)) return g_steal_pointer(&name);
    }
}

gboolean table_copy_beside(const char *scene, const char *table, const char *name, gboolean *made, GError **error)
{
    g_autofree char *folder = g_path_get_dirname(scene), *target = g_build_filename(folder, name, NULL);
    *made = !g_file_test(target, G_FILE_TEST_EXISTS);
    if (!*made && can_be_copy(target, table)) return TRUE;
    *made = copy_file(table, target, name, folder, error);
    return *made;
}
