/* Folders of plugins: what a user may have meant who names another one. */
#include "common/program/plugin-folders.h"

#include "common/program/exit-status.h"
#include "plugin/catalogue/catalogue.h"

/* Where meson puts the library of a project. (transfer full) */
static char *build_folder(const char *project)
{
    return g_build_filename(project, "build", NULL);
}

static void warn_of_empty(const char *folder)
{
    g_autoptr(GPtrArray) libraries = tinker_plugin_folder_libraries(folder);
    if (libraries->len > 0) return;
    g_autofree char *build = build_folder(folder);
    g_autoptr(GPtrArray) built = tinker_plugin_folder_libraries(build);
    if (built->len > 0)
        tinker_report_warning(
            "--plugins \"%s\": no plugin library (*.so) lies in this folder (a project's is in its build "
            "folder: did you mean \"%s\"?)",
            folder, build);
    else
        tinker_report_warning(
            "--plugins \"%s\": no plugin library (*.so) lies in this folder (a project's is in its build "
            "folder)",
            folder);
}

static gboolean check_folder(const char *path)
{
    if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
        warn_of_empty(path);
        return TRUE;
    }
    if (g_file_test(path, G_FILE_TEST_EXISTS)) {
        g_autofree char *folder = g_path_get_dirname(path);
        tinker_report_warning("--plugins \"%s\": this is a file; give the folder it lies in, \"%s\"", path, folder);
    } else {
        tinker_report_warning("--plugins \"%s\": no such folder", path);
    }
    return FALSE;
}

char **tinker_plugin_folders(char **given)
{
    if (given == NULL) return NULL;
    g_autoptr(GStrvBuilder) absolute = g_strv_builder_new();
    for (char **folder = given; *folder != NULL; folder++) {
        if (!check_folder(*folder)) continue;
        g_autofree char *path = g_canonicalize_filename(*folder, NULL);
        g_strv_builder_add(absolute, path);
    }
    return g_strv_builder_end(absolute);
}

char *tinker_plugin_folder_hint(const char *folder)
{
    g_autofree char *build = build_folder(folder);
    g_autoptr(GPtrArray) here = tinker_plugin_folder_libraries(folder);
    g_autoptr(GPtrArray) built = tinker_plugin_folder_libraries(build);
    GPtrArray *libraries = here->len > 0 ? here : built;
    if (libraries->len == 0) return g_strdup("no plugin library (*.so) lies in it");
    g_ptr_array_add(libraries, NULL);
    g_autofree char *list = g_strjoinv(", ", (char **)libraries->pdata);
    return g_strdup_printf("check one of its libraries: %s", list);
}
