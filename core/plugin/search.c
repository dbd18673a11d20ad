/* The search order. Nothing is opened here but folders. */
#include "plugin/search-private.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#define KIND_COMMAND_LINE "command line"
#define KIND_ENVIRONMENT  "TINKER_PLUGIN_PATH"
#define KIND_USER         "user"
#define KIND_INSTALLED    "installed"

static void folder_free(gpointer data)
{
    TinkerSearchFolder *folder = data;
    g_free(folder->path);
    g_free(folder);
}

static void warn(GPtrArray *warnings, const char *format, ...) G_GNUC_PRINTF(2, 3);

static void warn(GPtrArray *warnings, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(warnings, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

/* The same folder by two names would shadow its own libraries. */
static gboolean is_listed(const GPtrArray *folders, const struct stat *status)
{
    for (guint i = 0; i < folders->len; i++) {
        const TinkerSearchFolder *folder = folders->pdata[i];
        struct stat other;
        if (stat(folder->path, &other) == 0 && other.st_dev == status->st_dev && other.st_ino == status->st_ino)
            return TRUE;
    }
    return FALSE;
}

/* Adds a folder. One that the user named has to exist; the user's own folder need not. */
static void add_folder(GPtrArray *folders, const char *path, const char *kind, GPtrArray *warnings)
{
    struct stat status;
    if (!g_path_is_absolute(path)) {
        warn(warnings, "the plugin folder \"%s\" (%s) is passed over: an absolute path was expected", path, kind);
        return;
    }
    if (stat(path, &status) != 0) {
        const int reason = errno;
        if (strcmp(kind, KIND_USER) != 0 || reason != ENOENT)
            warn(warnings, "the plugin folder \"%s\" (%s) is passed over: %s", path, kind, g_strerror(reason));
        return;
    }
    if (!S_ISDIR(status.st_mode)) {
        warn(warnings, "the plugin folder \"%s\" (%s) is passed over: it is not a folder", path, kind);
        return;
    }
    if (is_listed(folders, &status)) return;
    TinkerSearchFolder *folder = g_new0(TinkerSearchFolder, 1);
    folder->path = g_canonicalize_filename(path, "/");
    folder->kind = kind;
    g_ptr_array_add(folders, folder);
}

static gboolean is_safe_mode(void)
{
    const char *value = g_getenv("TINKER_SAFE_MODE");
    return value != NULL && value[0] != '\0' && strcmp(value, "0") != 0;
}

static void add_environment_folders(GPtrArray *folders, GPtrArray *warnings)
{
    const char *value = g_getenv("TINKER_PLUGIN_PATH");
    if (value == NULL) return;
    g_auto(GStrv) paths = g_strsplit(value, ":", -1);
    for (char **path = paths; *path != NULL; path++) {
        if ((*path)[0] != '\0') add_folder(folders, *path, KIND_ENVIRONMENT, warnings);
    }
}

static void add_user_folder(GPtrArray *folders, const char *given, GPtrArray *warnings)
{
    g_autofree char *usual = g_build_filename(g_get_user_data_dir(), "tinker", "plugins", NULL);
    add_folder(folders, given == NULL ? usual : given, KIND_USER, warnings);
}

static int compare_paths(gconstpointer a, gconstpointer b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

GPtrArray *tinker_search_folders(const TinkerCatalogueOptions *options, GPtrArray *warnings)
{
    GPtrArray *folders = g_ptr_array_new_with_free_func(folder_free);
    if (!is_safe_mode()) {
        for (const char *const *path = options->folders; path != NULL && *path != NULL; path++)
            add_folder(folders, *path, KIND_COMMAND_LINE, warnings);
        add_environment_folders(folders, warnings);
        add_user_folder(folders, options->user_folder, warnings);
    } else {
        warn(warnings, "safe mode (TINKER_SAFE_MODE): plugins are taken from the installed folder alone");
    }
    if (options->installed_folder != NULL) add_folder(folders, options->installed_folder, KIND_INSTALLED, warnings);
    return folders;
}

GPtrArray *tinker_search_libraries(const TinkerSearchFolder *folder, GPtrArray *warnings)
{
    GPtrArray *paths = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) directory = g_dir_open(folder->path, 0, &error);
    if (directory == NULL) {
        warn(warnings, "the plugin folder \"%s\" (%s) is passed over: %s", folder->path, folder->kind, error->message);
        return paths;
    }
    for (const char *name = g_dir_read_name(directory); name != NULL; name = g_dir_read_name(directory)) {
        // A leading point marks what a copying program has not finished yet.
        if (name[0] != '.' && g_str_has_suffix(name, ".so"))
            g_ptr_array_add(paths, g_build_filename(folder->path, name, NULL));
    }
    // The order in which a folder lists its files is an accident; the search order is not.
    g_ptr_array_sort(paths, compare_paths);
    return paths;
}
