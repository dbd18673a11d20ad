/* Finding the plugins of the build; see the header. */
#include "build-catalogue.h"

#include <glib.h>

TinkerCatalogue *test_build_catalogue(void)
{
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    g_autofree char *folder = g_path_get_dirname(program);
    g_autofree char *plugins = g_build_filename(folder, "..", "..", "plugins", NULL);
    g_autofree char *installed = g_canonicalize_filename(plugins, "/");
    TinkerCatalogueOptions options = {.installed_folder = installed};
    return tinker_catalogue_new(&options);
}
