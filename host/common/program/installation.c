/* A program finds its installation from where it lies itself, so that a moved one works, and so does a build tree. */
#include "common/program/installation.h"
#include "physics/plan/run-options.h"

/* A folder of a build tree relative to the program's folder; the same below a prefix; and where it was configured to
 * be. */
typedef struct {
    const char *in_build_tree, *in_prefix, *configured;
} Place;

static const Place plugins = {"../../plugins", TINKER_PLUGIN_FOLDER_IN_PREFIX, TINKER_PLUGIN_FOLDER};
static const Place scenes = {"../scenes", TINKER_SCENE_FOLDER_IN_PREFIX, TINKER_SCENE_FOLDER};
static const Place documents = {"../../docs/handbook", TINKER_DOCUMENT_FOLDER_IN_PREFIX, TINKER_DOCUMENT_FOLDER};
static const Place locale = {"../po", TINKER_LOCALE_FOLDER_IN_PREFIX, TINKER_LOCALE_FOLDER};

/* The folder the program lies in, without links. NULL where the system does not tell. */
static char *program_folder(void)
{
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    return program != NULL ? g_path_get_dirname(program) : NULL;
}

static gboolean is_in_build_tree(const char *folder)
{
    return g_str_has_suffix(folder, "/host/cli") || g_str_has_suffix(folder, "/host/gui");
}

static char *folder_of(const Place *place)
{
    g_autofree char *program = program_folder();
    if (program != NULL) {
        g_autofree char *near_program = is_in_build_tree(program)
                                            ? g_build_filename(program, place->in_build_tree, NULL)
                                            : g_build_filename(program, "..", place->in_prefix, NULL);
        g_autofree char *plain = g_canonicalize_filename(near_program, "/");
        if (g_file_test(plain, G_FILE_TEST_IS_DIR)) return g_steal_pointer(&plain);
    }
    return g_strdup(place->configured);
}

/* The program that probes plugins in a child: the one without a window, whichever of the two asks. */
static char *probe_program(void)
{
    g_autofree char *folder = program_folder();
    if (folder == NULL) return NULL;
    return g_build_filename(folder, is_in_build_tree(folder) ? "../cli/tinker" : "tinker", NULL);
}

TinkerCatalogue *tinker_installation_catalogue(const char *const *plugin_folders)
{
    g_autofree char *installed = folder_of(&plugins), *probe = probe_program();
    TinkerCatalogueOptions options = {
        .folders = plugin_folders,
        .installed_folder = installed,
        .probe_program = probe,
        .method_fault = tinker_method_fault,
    };
    return tinker_catalogue_new(&options);
}

char *tinker_installation_scene_folder(void)
{
    return folder_of(&scenes);
}

char *tinker_installation_scene(const char *name)
{
    g_autofree char *folder = tinker_installation_scene_folder();
    return g_build_filename(folder, name, NULL);
}

char *tinker_installation_document_folder(void)
{
    return folder_of(&documents);
}

char *tinker_installation_locale_folder(void)
{
    return folder_of(&locale);
}
