/* Every file is kept under a key that two names share where they mean the same one. */
#include "common/program/file-set.h"

#include <errno.h>
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "common/program/exit-status.h"
#include "scene/value/table-source.h"

#define MOST_LINKS 40 /* as the system follows */

typedef enum { FILE_SCENE, FILE_TABLE, FILE_LIBRARY, FILE_OUTPUT } FilePart;

typedef struct {
    FilePart part;
    char *name; /* as messages call it */
} NamedFile;

struct _TinkerFileSet {
    GHashTable *by_key; /* of NamedFile * */
};

static void named_file_free(gpointer data)
{
    NamedFile *file = data;
    g_free(file->name);
    g_free(file);
}

TinkerFileSet *tinker_file_set_new(void)
{
    TinkerFileSet *files = g_new0(TinkerFileSet, 1);
    files->by_key = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, named_file_free);
    return files;
}

void tinker_file_set_free(TinkerFileSet *files)
{
    g_hash_table_unref(files->by_key);
    g_free(files);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

static char *key_of_inode(const GStatBuf *status)
{
    return g_strdup_printf("%ju:%ju", (uintmax_t)status->st_dev, (uintmax_t)status->st_ino);
}

/* Of a file that is not there yet. */
static char *key_in_folder(const char *path)
{
    g_autofree char *folder = g_path_get_dirname(path), *name = g_path_get_basename(path);
    GStatBuf status;
    if (g_stat(folder, &status) != 0) return NULL;
    g_autofree char *inode = key_of_inode(&status);
    return g_strdup_printf("%s/%s", inode, name);
}

/* What a link says, as a path from here; NULL where it is no link. (transfer full) */
static char *target_of_link(const char *path)
{
    g_autofree char *target = g_file_read_link(path, NULL);
    if (target == NULL || g_path_is_absolute(target)) return g_steal_pointer(&target);
    g_autofree char *folder = g_path_get_dirname(path);
    return g_build_filename(folder, target, NULL);
}

/* NULL where any number of outputs may go there, or it cannot be told, as where the folder is missing. (transfer full)
 */
static char *key_of_path(const char *path)
{
    GStatBuf status;
    if (g_stat(path, &status) == 0) return S_ISREG(status.st_mode) ? key_of_inode(&status) : NULL;
    g_autofree char *place = g_strdup(path);
    for (int links = 0; links < MOST_LINKS; links++) {
        char *target = target_of_link(place);
        if (target == NULL) return key_in_folder(place);
        g_free(place);
        place = target;
    }
    return NULL;
}

/* The shell may have put a file in a stream's place. */
static char *key_of_stream(int descriptor)
{
    GStatBuf status;
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) ? key_of_inode(&status) : NULL;
}

/* Adding ----------------------------------------------------------------------------------------------------------- */

static gboolean is_stream(const char *path)
{
    return strcmp(path, "-") == 0;
}

/* Takes the key. */
static void add(TinkerFileSet *files, char *key, FilePart part, const char *name)
{
    if (key == NULL) return;
    NamedFile *file = g_new(NamedFile, 1);
    *file = (NamedFile){part, g_strdup(name)};
    g_hash_table_replace(files->by_key, key, file);
}

void tinker_file_set_add_scene(TinkerFileSet *files, const char *path)
{
    char *key = is_stream(path) ? key_of_stream(STDIN_FILENO) : key_of_path(path);
    add(files, key, FILE_SCENE, is_stream(path) ? _("standard input") : path);
}

void tinker_file_set_add_library(TinkerFileSet *files, const char *path)
{
    add(files, key_of_path(path), FILE_LIBRARY, path);
}

void tinker_file_set_add_sources(TinkerFileSet *files, TinkerScene *scene, const char *base)
{
    g_autoptr(GPtrArray) tables = base != NULL ? tinker_scene_table_files(scene) : g_ptr_array_new();
    g_autofree char *folder = base != NULL ? g_path_get_dirname(base) : NULL;
    for (guint i = 0; i < tables->len; i++) {
        g_autofree char *table = g_build_filename(folder, g_ptr_array_index(tables, i), NULL);
        add(files, key_of_path(table), FILE_TABLE, table);
    }
    g_autoptr(GPtrArray) libraries = tinker_catalogue_opened(tinker_scene_catalogue(scene));
    for (guint i = 0; i < libraries->len; i++)
        tinker_file_set_add_library(files, g_ptr_array_index(libraries, i));
}

static gboolean refuse(const NamedFile *other, const char *output, GError **error)
{
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                other->part == FILE_SCENE     ? _("%s: is the scene itself, %s (choose another output)")
                : other->part == FILE_TABLE   ? _("%s: is a table that the scene reads, %s (choose another output)")
                : other->part == FILE_LIBRARY ? _("%s: is a plugin that is read, %s (choose another output)")
                                              : _("%s: is the same file as %s (give each a file of its own)"),
                output, other->name);
    return FALSE;
}

gboolean tinker_file_set_add_output(TinkerFileSet *files, const char *option, const char *path, GError **error)
{
    const char *name = is_stream(path) ? _("standard output") : path;
    g_autofree char *output = option != NULL ? g_strdup_printf("%s %s", option, name) : g_strdup(name);
    // Streams have a key of their own: two outputs in one pipe could not be told apart by whoever reads it.
    g_autofree char *stream = is_stream(path) ? g_strdup("-") : NULL;
    g_autofree char *key = is_stream(path) ? key_of_stream(STDOUT_FILENO) : key_of_path(path);
    const char *const keys[] = {stream, key};
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++) {
        const NamedFile *other = keys[i] != NULL ? g_hash_table_lookup(files->by_key, keys[i]) : NULL;
        if (other != NULL) return refuse(other, output, error);
    }
    add(files, g_steal_pointer(&stream), FILE_OUTPUT, output);
    add(files, g_steal_pointer(&key), FILE_OUTPUT, output);
    return TRUE;
}
