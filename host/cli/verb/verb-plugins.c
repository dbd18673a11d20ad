/* tinker plugins: what is installed. The verb has verbs of its own: list, show, check, describe, refused, new,
 * new-bundle. */
#include "cli/verb/verbs.h"

#include <stdio.h>
#include <string.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/plugins/plugins-check.h"
#include "cli/plugins/plugins-new.h"
#include "cli/plugins/plugins-show.h"
#include "cli/report/text-table.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "files/replace-file.h"
#include "numerics/methods/integrators.h"
#include "units/quantity/units.h"

#define LIST_HELP                                                                                                      \
    "Lists the installed blocks by plugin: type, title, category, version and licence, the\n"                          \
    "integrators, the bundles with their scenes, and what was refused or passed over. Other verbs:\n\n"                \
    "  show TYPE         the properties, quantities and interfaces of a block, or what a method is\n"                  \
    "  check FILE.so     tries every rule of the contract on a plugin file\n"                                          \
    "  describe FILE.so  writes the manifest of a plugin file\n"                                                       \
    "  refused           lists the refused libraries; refused --clear forgets the refusals\n"                          \
    "  new NAME          writes a small plugin to begin with; new alone lists the roles\n"                             \
    "  new-bundle NAME   writes a small bundle of blocks, scenes and a page, as for a course"

static const TinkerVerbHelp list_help = {
    .verb = "plugins",
    .operands = "[list|show|check|describe|refused|new|new-bundle]",
    .summary = LIST_HELP,
    .examples = "  tinker plugins\n"
                "  tinker plugins show spring\n"
                "  tinker plugins --plugins ./my-blocks",
};

static const TinkerVerbHelp show_help = {
    .verb = "plugins show",
    .operands = "TYPE...",
    .summary =
        "Shows block types: properties with units, defaults and ranges, quantities, formula and interfaces; and\n"
        "integration methods, of plugins and built-in ones: order, limits of stability, source.",
    .examples = "  tinker plugins show spring\n"
                "  tinker plugins show mass support\n"
                "  tinker plugins show rk4",
    .least_operands = 1,
    .most_operands = -1,
};

static const TinkerVerbHelp describe_help = {
    .verb = "plugins describe",
    .operands = "FILE.so",
    .summary =
        "Opens a plugin file, makes all checks and writes its manifest, by which blocks are found without opening\n"
        "their libraries. The plugin's code runs in this process.",
    .examples = "  tinker plugins describe ./pulley.so\n"
                "  tinker plugins describe ./pulley.so --output -",
    .least_operands = 1,
    .most_operands = 1,
};

static const TinkerVerbHelp refused_help = {
    .verb = "plugins refused",
    .operands = "",
    .summary =
        "Lists the libraries that were refused, and why, in the folders that are searched: --plugins adds one. A\n"
        "refusal is remembered until the file changes, or is forgotten by --clear.",
    .examples = "  tinker plugins refused\n"
                "  tinker plugins refused --clear",
};

static void list_library(const TinkerLibraryEntry *library, TinkerTextTable *table)
{
    for (guint i = 0; i < library->types->len; i++) {
        const TinkerTypeEntry *type = g_ptr_array_index(library->types, i);
        tinker_text_table_add(table, type->id);
        tinker_text_table_add(table, type->title);
        tinker_text_table_add(table, type->category);
        tinker_text_table_add(table, library->version);
        tinker_text_table_add(table, library->licence);
        tinker_text_table_add(table, library->path);
    }
    for (guint i = 0; i < library->integrators->len; i++) {
        tinker_text_table_add(table, g_ptr_array_index(library->integrators, i));
        tinker_text_table_add(table, library->title);
        tinker_text_table_add(table, "integrator");
        tinker_text_table_add(table, library->version);
        tinker_text_table_add(table, library->licence);
        tinker_text_table_add(table, library->path);
    }
}

static void list_built_in(TinkerTextTable *table)
{
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        const char *const cells[] = {(*method)->id, (*method)->title, "integrator", "", "", "built in"};
        for (gsize i = 0; i < G_N_ELEMENTS(cells); i++)
            tinker_text_table_add(table, cells[i]);
    }
}

/* An integrator with the id of a built-in one cannot be named. */
static void warn_of_built_in(const TinkerLibraryEntry *library)
{
    for (guint i = 0; i < library->integrators->len; i++) {
        const char *id = g_ptr_array_index(library->integrators, i);
        if (tinker_integrator_builtin(id) != NULL)
            tinker_report_warning("the integrator \"%s\" of \"%s\" is never used: a built-in method has that id", id,
                                  library->path);
    }
}

/* A bundle, with what it holds besides libraries by the names within it. */
static void list_bundle(const TinkerBundleEntry *bundle)
{
    fputc('\n', stdout);
    tinker_print_line(stdout, "bundle \"%s\": %s", bundle->title, bundle->path);
    if (bundle->summary[0] != '\0') tinker_print_line(stdout, "  %s", bundle->summary);
    if (bundle->page != NULL) tinker_print_line(stdout, "  %s", bundle->page + strlen(bundle->path) + 1);
    for (guint i = 0; i < bundle->scenes->len; i++)
        tinker_print_line(stdout, "  %s", (const char *)bundle->scenes->pdata[i] + strlen(bundle->path) + 1);
}

static int list(int argc, char **argv)
{
    const GOptionEntry entries[] = {G_OPTION_ENTRY_NULL};
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &list_help, entries, argc, argv, &status)) return status;

    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(line.plugin_folders);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("llllll", 0);
    static const char *const headings[] = {"TYPE", "TITLE", "CATEGORY", "VERSION", "LICENCE", "LIBRARY"};
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    guint shown = 0;
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (!tinker_library_is_used(library)) continue;
        list_library(library, table);
        warn_of_built_in(library);
        shown++;
    }
    list_built_in(table);
    if (shown > 0)
        tinker_text_table_write(table, stdout);
    else
        tinker_print_line(stdout, "no plugins are installed");
    const GPtrArray *bundles = tinker_catalogue_bundles(catalogue);
    for (guint i = 0; i < bundles->len; i++)
        list_bundle(bundles->pdata[i]);
    g_autoptr(GPtrArray) warnings = tinker_catalogue_warnings(catalogue);
    for (guint i = 0; i < warnings->len; i++)
        tinker_report_warning("%s", (const char *)g_ptr_array_index(warnings, i));
    return TINKER_EXIT_DONE;
}

/* The library that provides an integrator, or NULL. */
static const TinkerLibraryEntry *integrator_library(const GPtrArray *libraries, const char *id)
{
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (!tinker_library_is_used(library)) continue;
        if (g_ptr_array_find_with_equal_func(library->integrators, id, g_str_equal, NULL)) return library;
    }
    return NULL;
}

/* The method that may be meant by an id that nobody has, or NULL. */
static const char *nearest_method(const GPtrArray *libraries, const char *id)
{
    g_autoptr(GPtrArray) known = g_ptr_array_new();
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++)
        g_ptr_array_add(known, (gpointer)(*method)->id);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        for (guint k = 0; k < library->integrators->len; k++)
            g_ptr_array_add(known, g_ptr_array_index(library->integrators, k));
    }
    g_ptr_array_add(known, NULL);
    return tinker_nearest_word(id, (const char *const *)known->pdata);
}

/* A block type, a built-in method or one of a plugin. */
static gboolean show_one(TinkerCatalogue *catalogue, const char *id, GError **error)
{
    const TinkerIntegrator *integrator = tinker_integrator_builtin(id);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    const TinkerLibraryEntry *library = integrator == NULL ? integrator_library(libraries, id) : NULL;
    if (library != NULL) {
        integrator = tinker_catalogue_integrator(catalogue, id, error);
        if (integrator == NULL) return FALSE;
    }
    if (integrator != NULL) {
        tinker_plugins_show_integrator(integrator, library, stdout);
        return TRUE;
    }
    g_autoptr(GError) missing = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, id, &missing);
    if (block_class != NULL) {
        tinker_plugins_show(block_class, stdout);
        return TRUE;
    }
    const char *method = nearest_method(libraries, id);
    if (method != NULL && g_error_matches(missing, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING))
        g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING,
                    "there is neither a block type nor a method \"%s\" (did you mean the method \"%s\"?)", id, method);
    else
        g_propagate_error(error, g_steal_pointer(&missing));
    return FALSE;
}

static int show(int argc, char **argv)
{
    const GOptionEntry entries[] = {G_OPTION_ENTRY_NULL};
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &show_help, entries, argc, argv, &status)) return status;

    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(line.plugin_folders);
    for (char **id = line.operands; *id != NULL; id++) {
        g_autoptr(GError) error = NULL;
        if (id != line.operands) putchar('\n');
        if (!show_one(catalogue, *id, &error)) status = tinker_report_error(NULL, error);
    }
    return status;
}

/* "pulley.manifest.json" beside "pulley.so". (transfer full) */
static char *manifest_beside(const char *library)
{
    const char *stem_end = g_str_has_suffix(library, ".so") ? library + strlen(library) - 3 : library + strlen(library);
    return g_strdup_printf("%.*s.manifest.json", (int)(stem_end - library), library);
}

static gboolean write_manifest(const char *library, const char *output, GError **error)
{
    g_autofree char *usual = manifest_beside(library);
    const TinkerAskedOutput outputs[] = {{"--output", output != NULL ? output : usual}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_file_set_new();
    tinker_file_set_add_library(files, library);
    if (!tinker_outputs_add(files, outputs, error)) return FALSE;
    g_autofree char *text = tinker_plugin_describe(library, error);
    if (text == NULL) return FALSE;
    if (tinker_is_standard_stream(output)) {
        tinker_print_text(stdout, text);
        return TRUE;
    }
    const char *path = output != NULL ? output : usual;
    g_autofree char *line = g_strconcat(text, "\n", NULL);
    if (!tinker_replace_file(path, line, strlen(line), 0644, error)) {
        g_prefix_error(error, "%s: cannot be written: ", path);
        return FALSE;
    }
    /* what is no file, as /dev/stdout, is for what it is given alone */
    if (g_file_test(path, G_FILE_TEST_IS_REGULAR)) tinker_print_line(stdout, "wrote %s", path);
    return TRUE;
}

static int describe(int argc, char **argv)
{
    g_autofree char *output = NULL;
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &output, "Write to FILE (beside the library, .manifest.json for .so)",
         "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &describe_help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    return write_manifest(line.operands[0], output, &error) ? TINKER_EXIT_DONE : tinker_report_error(NULL, error);
}

static int refused(int argc, char **argv)
{
    gboolean clear = FALSE;
    const GOptionEntry entries[] = {
        {"clear", 0, 0, G_OPTION_ARG_NONE, &clear, "Forget the refusals: the libraries are probed again", NULL},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &refused_help, entries, argc, argv, &status)) return status;

    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(line.plugin_folders);
    g_autoptr(GError) error = NULL;
    if (clear) {
        if (!tinker_catalogue_clear_refused(catalogue, &error)) return tinker_report_error(NULL, error);
        tinker_print_line(stdout, "the refusals are forgotten");
        return TINKER_EXIT_DONE;
    }
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    guint count = 0;
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (library->refused == NULL) continue;
        tinker_print_line(stdout, "%s: %s", library->path, library->refused);
        count++;
    }
    if (count == 0) tinker_print_line(stdout, "no library was refused in the folders that are searched");
    return TINKER_EXIT_DONE;
}

static const struct {
    const char *name;
    int (*run)(int argc, char **argv);
} sub_verbs[] = {
    {"list", list},
    {"show", show},
    {"check", tinker_plugins_check},
    {"describe", describe},
    {"refused", refused},
    {"new", tinker_plugins_new},
    {"new-bundle", tinker_plugins_new_bundle},
};

int tinker_verb_plugins(int argc, char **argv)
{
    if (argc < 2 || (argv[1][0] == '-' && argv[1][1] != '\0')) return list(argc, argv);
    const char *names[G_N_ELEMENTS(sub_verbs) + 1] = {NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(sub_verbs); i++) {
        if (strcmp(argv[1], sub_verbs[i].name) == 0) return sub_verbs[i].run(argc - 1, argv + 1);
        names[i] = sub_verbs[i].name;
    }
    g_autofree char *hint = tinker_did_you_mean(argv[1], names);
    tinker_report_note("plugins: unknown verb \"%s\"%s", argv[1],
                       hint[0] != '\0' ? hint : " (see tinker plugins --help)");
    return TINKER_EXIT_USAGE;
}
