/* The catalogue: which block types and integrators are installed, in which library, and the way to open them.
 *
 * Finding is by manifest: a small JSON file beside each library (or in the user's cache) that the probe wrote. A
 * library is opened only when one of its types is asked for. What a plugin declares is copied into structs of this
 * host's own size, so that the rest of the core reads members without asking how old the plugin is.
 */
#ifndef TINKER_CORE_CATALOGUE_H
#define TINKER_CORE_CATALOGUE_H

#include "plugin/descriptor/block-class.h"
#include "plugin/trust/plugin-error.h"

/* What a manifest tells, without opening the library. */
typedef struct {
    char *id;
    char *title;
    char *category;
    char *summary;
} TinkerTypeEntry;

/* What is known of a library at one time; it never changes. */
typedef struct {
    char *path;
    char *id;
    char *title;
    char *version;
    char *licence;
    char *home_page;
    char *folder_kind;      /* "command line", "TINKER_PLUGIN_PATH", "user", "installed" */
    char *refused;          /* why it was refused, else NULL */
    char *shadowed_by;      /* path of the library whose id came first, else NULL */
    GPtrArray *types;       /* of TinkerTypeEntry */
    GPtrArray *integrators; /* of char *: their ids */
} TinkerLibraryEntry;

/* A folder of libraries, scenes and a page that belong together, as for a course. */
typedef struct {
    char *path; /* of the folder */
    char *title;
    char *summary;     /* may be empty */
    char *page;        /* path of its page; NULL: it has none */
    GPtrArray *scenes; /* of char *: paths of its scenes, by name */
} TinkerBundleEntry;

typedef struct _TinkerCatalogue TinkerCatalogue;

typedef struct {
    const char *const *folders;   /* of the command line, NULL-terminated, searched first; or NULL */
    const char *user_folder;      /* NULL: g_get_user_data_dir()/tinker/plugins */
    const char *installed_folder; /* NULL: none */
    const char *cache_folder;     /* NULL: g_get_user_cache_dir()/tinker */
    const char *probe_program; /* run as `PROGRAM plugins describe --output - FILE` in a child; NULL: libraries without
                                     a manifest are refused */
    double probe_seconds;      /* time limit of a probe; 0: 5 */
    /* What is wrong with a method that a scene names, be it built in or of a library: "there is no method ...", or NULL
     * where nothing is (transfer full). NULL: it is not looked at when a scene is read. */
    char *(*method_fault)(TinkerCatalogue *catalogue, const char *id);
} TinkerCatalogueOptions;

/* Finds the libraries in search order: the command line's folders, TINKER_PLUGIN_PATH, the user's, the installed one;
 * with TINKER_SAFE_MODE=1 the installed one alone; behind each folder the bundles directly below it. Relative folders
 * are passed over with a warning. (transfer full) */
TinkerCatalogue *tinker_catalogue_new(const TinkerCatalogueOptions *options);

/* As its options have it. (transfer full) */
char *tinker_catalogue_method_fault(TinkerCatalogue *catalogue, const char *id);
void tinker_catalogue_free(TinkerCatalogue *catalogue);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerCatalogue, tinker_catalogue_free)

/* All libraries found, in search order, with the refused and shadowed ones, as they are known at present; of const
 * TinkerLibraryEntry, which live as long as the array. It is shared and not to be changed. A library that was rebuilt
 * is identified anew when it is opened: hold the array while an id of it is used. Any thread. (transfer full) */
GPtrArray *tinker_catalogue_libraries(TinkerCatalogue *catalogue);

/* Of those of `libraries` that are neither refused nor shadowed, in their order: the types, TinkerTypeEntry, and the
 * ids of integrators, char *. They are borrowed from the libraries. (transfer container) */
GPtrArray *tinker_libraries_types(const GPtrArray *libraries);
GPtrArray *tinker_libraries_integrators(const GPtrArray *libraries);
gboolean tinker_library_is_used(const TinkerLibraryEntry *library);

/* The bundles found, in search order; of TinkerBundleEntry. Their libraries are among the others. (transfer none) */
const GPtrArray *tinker_catalogue_bundles(TinkerCatalogue *catalogue);

/* Messages for the user from the search (relative folder, shadowed id, refused library); of char *. Any thread.
 * (transfer full) */
GPtrArray *tinker_catalogue_warnings(TinkerCatalogue *catalogue);

/* Opens one library file, wherever it lies, without looking at its owner or a manifest; its types and integrators come
 * before all others of their ids. Runs the plugin's code in this process. NULL with _REFUSED (the message is the reason
 * alone) or _FILE. (transfer none: lives as long as the catalogue) */
const TinkerLibraryEntry *tinker_catalogue_add_file(TinkerCatalogue *catalogue, const char *path, GError **error);

/* The type of this id; opens its library if it is not open yet. NULL with TINKER_PLUGIN_ERROR_MISSING (the message
 * names the nearest type, and the reason where a library was refused that has it or may have it) or _REFUSED. May be
 * called from any thread, also at the same time. (transfer none) */
const TinkerBlockClass *tinker_catalogue_type(TinkerCatalogue *catalogue, const char *id, GError **error);

/* The integrator of a plugin with this id, opened and refused as a type is. */
const TinkerIntegrator *tinker_catalogue_integrator(TinkerCatalogue *catalogue, const char *id, GError **error);

/* What refused libraries have to do with an id that nobody provides, to be put behind a message about it: ": the
 * library
 * ... was refused: REASON" where one has it by its manifest or file name, "; it may be in a refused one: ..." where
 * that cannot be told, "" where none was refused. (transfer full) */
char *tinker_catalogue_explain_refused(TinkerCatalogue *catalogue, const char *id);

/* Paths of the libraries that have been opened through this catalogue, in the order of opening; of char *. Any
 * thread. (transfer full) */
GPtrArray *tinker_catalogue_opened(TinkerCatalogue *catalogue);

/* Forgets the remembered refusals. */
gboolean tinker_catalogue_clear_refused(TinkerCatalogue *catalogue, GError **error);

/* Files in a folder that a search of it would look at, those of bundles last; of char *, none where it cannot be read.
 * (transfer full) */
GPtrArray *tinker_plugin_folder_libraries(const char *folder);

/* Opens a library, makes all checks, and writes its manifest as JSON text. Runs the plugin's code in this process: call
 * it in a child only. (transfer full) */
char *tinker_plugin_describe(const char *path, GError **error);

#endif
