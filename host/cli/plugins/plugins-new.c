/* tinker plugins new, new-bundle: the verbs, the roles, and which names may be given. */
#include "cli/plugins/plugins-new.h"

#include <stdio.h>
#include <string.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/plugins/template-folder.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "numerics/methods/integrators.h"

#define MOST_NAME 40

/* A role and the template of the same name. The sentence completes "with one line law: ...". */
typedef struct {
    const char *id, *words, *sentence;
} Role;

static const Role roles[] = {
    {"line-law", "line law", "a connector whose force acts along the line between its two ends"},
    {"force-element", "force element", "any other force on the bodies at its ends"},
    {"field", "field", "forces on all bodies, as of water, air or gravity"},
    {"constraint", "constraint", "something that must stay as it is, as the distance along a rod"},
    {"joint", "joint", "a constraint on how bodies are turned, as a belt or a gear"},
    {"torque", "torque", "a force element that turns a body, as a brake or a fan"},
    {"motion", "motion", "where a support is at every time"},
    {"body", "body", "something that moves, and that connectors attach to"},
    {"integrator", "integrator", "a method that takes the motion from one time to the next"},
};

static const TinkerVerbHelp new_help = {
    .verb = "plugins new",
    .operands = "[NAME]",
    .summary =
        "Writes a folder NAME with a small plugin that works: a block of the role, or a method, a scene that uses\n"
        "it, a test against a closed form, and how to build it. Without --role it lists the roles.",
    .examples = "  tinker plugins new\n"
                "  tinker plugins new rubber-band --role line-law",
    .most_operands = 1,
};

static const TinkerVerbHelp new_bundle_help = {
    .verb = "plugins new-bundle",
    .operands = "NAME",
    .summary =
        "Writes a folder NAME with a small bundle that works: several blocks, their scenes and tests, and a page,\n"
        "as for a course. Installed, it is one folder among the user's plugins.",
    .examples = "  tinker plugins new-bundle mechanics-1",
    .least_operands = 1,
    .most_operands = 1,
};

static gboolean refuse(GError **error, const char *format, ...) G_GNUC_PRINTF(2, 3);
static gboolean refuse(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_propagate_error(error, g_error_new_valist(TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, format, arguments));
    va_end(arguments);
    return FALSE;
}

/* Roles ---------------------------------------------------------------------------------------------------------- */

static void list_roles(void)
{
    tinker_print_line(stdout, "The roles that --role takes:");
    for (gsize i = 0; i < G_N_ELEMENTS(roles); i++)
        tinker_print_line(stdout, "  %-15s %s", roles[i].id, roles[i].sentence);
}

static const Role *find_role(const char *id, GError **error)
{
    const char *ids[G_N_ELEMENTS(roles) + 1] = {NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(roles); i++) {
        if (strcmp(roles[i].id, id) == 0) return &roles[i];
        ids[i] = roles[i].id;
    }
    g_autofree char *hint = tinker_did_you_mean(id, ids), *list = g_strjoinv(", ", (char **)ids);
    refuse(error, "--role \"%s\": there is no such role%s; the roles are %s", id, hint, list);
    return NULL;
}

/* Names ---------------------------------------------------------------------------------------------------------- */

/* Names become those of files and block types. */
static gboolean check_letters(const char *name, GError **error)
{
    const gsize length = strlen(name);
    gboolean fine = length <= MOST_NAME && g_ascii_islower(name[0]) && name[length - 1] != '-';
    for (const char *letter = name; *letter != '\0' && fine; letter++)
        fine = g_ascii_islower(*letter) || g_ascii_isdigit(*letter) || (*letter == '-' && letter[1] != '-');
    if (fine) return TRUE;
    return refuse(
        error,
        "the name \"%s\" is not one of at most %d lower-case letters, digits and single hyphens between them, "
        "with a letter first (as \"rubber-band\")",
        name, MOST_NAME);
}

static gboolean provides(const TinkerLibraryEntry *library, const char *id)
{
    for (guint i = 0; i < library->types->len; i++)
        if (strcmp(((const TinkerTypeEntry *)library->types->pdata[i])->id, id) == 0) return TRUE;
    return g_ptr_array_find_with_equal_func(library->integrators, id, g_str_equal, NULL);
}

/* What has the name already would hide the new one, or be hidden by it. */
static gboolean check_free(const char *name, TinkerCatalogue *catalogue, GError **error)
{
    if (strcmp(name, "auto") == 0 || tinker_integrator_builtin(name) != NULL)
        return refuse(error, "the name \"%s\" is taken: a built-in method has it (choose another)", name);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = libraries->pdata[i];
        g_autofree char *id = g_strconcat("org.example.", name, NULL);
        if (provides(library, name) || g_strcmp0(library->id, id) == 0)
            return refuse(error, "the name \"%s\" is taken: the plugin \"%s\" has it (choose another)", name,
                          library->path);
    }
    return TRUE;
}

/* "rubber-band" as "Rubber Band". (transfer full) */
static char *title_of(const char *name)
{
    g_auto(GStrv) words = g_strsplit(name, "-", -1);
    for (char **word = words; *word != NULL; word++)
        (*word)[0] = g_ascii_toupper((*word)[0]);
    return g_strjoinv(" ", words);
}

/* Files ---------------------------------------------------------------------------------------------------------- */

static void add_template(GPtrArray *files, const char *template_name, const char *name, const Role *role,
                         const char *scene_folder)
{
    g_autofree char *title = title_of(name);
    const TinkerTemplateWords words = {
        .name = name,
        .title = title,
        .role = role == NULL ? "" : role->words,
        .sentence = role == NULL ? "" : role->sentence,
    };
    tinker_template_files_add(files, template_name, &words, scene_folder);
}

/* Writes the files, and says what comes next: to build and test, and to run this scene. */
static gboolean write_and_tell(GPtrArray *files, const char *folder, const char *scene, GError **error)
{
    if (!tinker_template_files_write(files, folder, error)) return FALSE;
    for (guint i = 0; i < files->len; i++) {
        g_autofree char *path = g_build_filename(folder, ((TinkerTemplateFile *)files->pdata[i])->path, NULL);
        tinker_print_line(stdout, "wrote %s", path);
    }
    g_autofree char *quoted = g_shell_quote(folder);
    const gboolean plain =
        strspn(folder, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./") == strlen(folder);
    fputs("\nNext:\n", stdout);
    tinker_print_line(stdout, "  cd %s", plain ? folder : quoted);
    fputs("  meson setup build && meson test -C build\n", stdout);
    tinker_print_line(stdout, "  tinker run %s --plugins build", scene);
    return TRUE;
}

static gboolean write_plugin(const char *name, const char *role_id, const char *folder, char **plugin_folders,
                             GError **error)
{
    const Role *role = find_role(role_id, error);
    if (role == NULL || !check_letters(name, error)) return FALSE;
    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(plugin_folders);
    if (!check_free(name, catalogue, error)) return FALSE;
    g_autoptr(GPtrArray) files = tinker_template_files_new();
    g_autofree char *scene = g_strconcat(name, ".tinker.json", NULL);
    add_template(files, "shared", name, role, NULL);
    add_template(files, "plugin", name, role, NULL);
    add_template(files, role->id, name, role, NULL);
    return write_and_tell(files, folder, scene, error);
}

static gboolean write_bundle(const char *name, const char *folder, char **plugin_folders, GError **error)
{
    g_autofree char *band = g_strconcat(name, "-band", NULL), *drag = g_strconcat(name, "-drag", NULL);
    if (!check_letters(name, error)) return FALSE;
    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(plugin_folders);
    if (!check_free(band, catalogue, error) || !check_free(drag, catalogue, error)) return FALSE;
    g_autoptr(GPtrArray) files = tinker_template_files_new();
    g_autofree char *scene = g_strconcat("scenes/", name, ".tinker.json", NULL);
    add_template(files, "shared", name, NULL, NULL);
    add_template(files, "bundle", name, NULL, "scenes");
    add_template(files, "line-law", band, NULL, "scenes");
    add_template(files, "field", drag, NULL, "scenes");
    return write_and_tell(files, folder, scene, error);
}

/* Verbs ---------------------------------------------------------------------------------------------------------- */

#define OUTPUT_ENTRY(output)                                                                                           \
    {                                                                                                                  \
        "output", 'o', 0, G_OPTION_ARG_FILENAME, &(output), "Write to the folder DIR, which must not exist (NAME)",    \
            "DIR"                                                                                                      \
    }

int tinker_plugins_new(int argc, char **argv)
{
    g_autofree char *role = NULL, *output = NULL;
    const GOptionEntry entries[] = {
        {"role", 0, 0, G_OPTION_ARG_FILENAME, &role, "What the block is to be; without it the roles are listed",
         "ROLE"},
        OUTPUT_ENTRY(output),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &new_help, entries, argc, argv, &status)) return status;
    const char *name = line.operands[0];
    if (role == NULL) list_roles();
    if (role == NULL && name == NULL) return TINKER_EXIT_DONE;
    g_autoptr(GError) error = NULL;
    if (role == NULL)
        refuse(&error, "plugins new: --role is missing, and nothing was written");
    else if (name == NULL)
        refuse(&error, "plugins new: the name is missing, as in tinker plugins new rubber-band --role %s", role);
    else
        write_plugin(name, role, output != NULL ? output : name, line.plugin_folders, &error);
    return error == NULL ? TINKER_EXIT_DONE : tinker_report_error(NULL, error);
}

int tinker_plugins_new_bundle(int argc, char **argv)
{
    g_autofree char *output = NULL;
    const GOptionEntry entries[] = {OUTPUT_ENTRY(output), G_OPTION_ENTRY_NULL};
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &new_bundle_help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    const char *name = line.operands[0];
    if (write_bundle(name, output != NULL ? output : name, line.plugin_folders, &error)) return TINKER_EXIT_DONE;
    return tinker_report_error(NULL, error);
}
