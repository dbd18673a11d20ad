/* The search order. Nothing is opened here but folders. */
#include "plugin/catalogue/search.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "plugin/catalogue/bundle-private.h"

#define KIND_COMMAND_LINE "command line"
#define KIND_ENVIRONMENT  "TINKER_PLUGIN_PATH"
#define KIND_USER         "user"
#define KIND_INSTALLED    "installed"

static void folder_free(gpointer data)
{
    TinkerSearchFolder *folder = data;
    g_free(folder->path);
    tinker_bundle_free(folder->bundle);
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

/* A folder that is found by two names would shadow its own libraries. */
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

/* Lists a folder: files that end in ".so", or sub-folders that are marked as bundles; paths by name. */
static void list_folder(const char *folder, GDir *directory, gboolean bundles, GPtrArray *paths)
{
    for (const char *name = g_dir_read_name(directory); name != NULL; name = g_dir_read_name(directory)) {
        // A leading point marks what a copying program has not finished yet.
        if (name[0] == '.') continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        if (bundles ? tinker_bundle_is_marked(path) : g_str_has_suffix(name, ".so"))
            g_ptr_array_add(paths, g_steal_pointer(&path));
    }
    tinker_search_sort(paths);
}

/* Adds what list_folder finds in a folder, where it can be read. */
static void list_path(const char *folder, gboolean bundles, GPtrArray *paths)
{
    g_autoptr(GDir) directory = g_dir_open(folder, 0, NULL);
    if (directory != NULL) list_folder(folder, directory, bundles, paths);
}

static void take_folder(GPtrArray *folders, const char *path, const char *kind, TinkerBundleEntry *bundle)
{
    TinkerSearchFolder *folder = g_new0(TinkerSearchFolder, 1);
    folder->path = g_canonicalize_filename(path, "/");
    folder->kind = kind;
    folder->bundle = bundle;
    g_ptr_array_add(folders, folder);
}

/* Adds the bundles that lie directly in a folder. One that others could have changed is passed over with all that is in
 * it; a folder that cannot be read is told of when its libraries are listed. */
static void add_bundles(GPtrArray *folders, const char *folder, const char *kind, GPtrArray *warnings)
{
    g_autoptr(GPtrArray) paths = g_ptr_array_new_with_free_func(g_free);
    list_path(folder, TRUE, paths);
    for (guint i = 0; i < paths->len; i++) {
        const char *path = paths->pdata[i];
        struct stat status;
        if (stat(path, &status) != 0 || is_listed(folders, &status)) continue;
        g_autoptr(GError) error = NULL;
        TinkerBundleEntry *bundle = tinker_bundle_read(path, &error);
        if (bundle != NULL)
            take_folder(folders, path, kind, bundle);
        else
            warn(warnings, "the bundle \"%s\" (%s) is passed over: %s", path, kind, error->message);
    }
}

/* Adds a folder with its bundles. One that the user named has to exist; the user's own folder need not. */
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
    take_folder(folders, path, kind, NULL);
    g_autofree char *plain = g_canonicalize_filename(path, "/");
    add_bundles(folders, plain, kind, warnings);
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
    list_folder(folder->path, directory, FALSE, paths);
    return paths;
}

GPtrArray *tinker_plugin_folder_libraries(const char *folder)
{
    GPtrArray *libraries = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GPtrArray) bundles = g_ptr_array_new_with_free_func(g_free);
    list_path(folder, FALSE, libraries);
    list_path(folder, TRUE, bundles);
    for (guint i = 0; i < bundles->len; i++)
        list_path(bundles->pdata[i], FALSE, libraries);
    return libraries;
}
