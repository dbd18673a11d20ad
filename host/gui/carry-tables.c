/* Which files a scene names is read from its text, where every table stands as {"table": "FILE", ...}. */
#include "carry-tables.h"

#include <cjson/cJSON.h>
#include <gio/gio.h>
#include <glib/gi18n-lib.h>
#include <string.h>

#include "scene/scene-json.h"

static void collect_tables(const cJSON *json, GHashTable *files)
{
    for (const cJSON *child = json->child; child != NULL; child = child->next) {
        if (child->string != NULL && strcmp(child->string, "table") == 0 && cJSON_IsString(child))
            g_hash_table_add(files, g_strdup(child->valuestring));
        collect_tables(child, files);
    }
}

static gboolean same_contents(const char *a, const char *b)
{
    g_autofree char *a_text = NULL, *b_text = NULL;
    gsize a_length, b_length;
    return g_file_get_contents(a, &a_text, &a_length, NULL) && g_file_get_contents(b, &b_text, &b_length, NULL) &&
           a_length == b_length && memcmp(a_text, b_text, a_length) == 0;
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
    g_autoptr(GFile) source_file = g_file_new_for_path(source), target_file = g_file_new_for_path(target);
    g_autoptr(GError) reason = NULL;
    if (g_file_copy(source_file, target_file, G_FILE_COPY_NONE, NULL, NULL, NULL, &reason)) return TRUE;
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, _("The table “%s” cannot be copied to %s: %s"),
                file, to, reason->message);
    return FALSE;
}

gboolean carry_tables(TinkerScene *scene, const char *from, const char *to, GError **error)
{
    g_autofree char *from_folder = g_path_get_dirname(from), *to_folder = g_path_get_dirname(to);
    g_autofree char *from_plain = g_canonicalize_filename(from_folder, NULL);
    g_autofree char *to_plain = g_canonicalize_filename(to_folder, NULL);
    if (strcmp(from_plain, to_plain) == 0) return TRUE;
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_autoptr(GHashTable) files = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    cJSON *json = cJSON_Parse(text);
    if (json != NULL) collect_tables(json, files);
    cJSON_Delete(json);
    GHashTableIter iter;
    gpointer file;
    g_hash_table_iter_init(&iter, files);
    while (g_hash_table_iter_next(&iter, &file, NULL))
        if (!carry(file, from_plain, to_plain, error)) return FALSE;
    return TRUE;
}
