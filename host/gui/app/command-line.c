/* Options come as a dictionary; what goes together is checked here, before anything is opened. */
#include "gui/app/command-line.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common/program/plugin-folders.h"

#define GREATEST_SIZE 16384

static const GOptionEntry entries[] = {
    {"version", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Tell the version"), NULL},
    {"new", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Begin with a new scene"), NULL},
    {"plugins", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, NULL, N_("Look for blocks in this folder, too; may be repeated"),
     N_("FOLDER")},
    {"screenshot", 0, 0, G_OPTION_ARG_FILENAME, NULL, N_("Write a picture of the window (PNG), and end"), N_("FILE")},
    {"scene", 0, 0, G_OPTION_ARG_FILENAME, NULL, N_("The scene in the picture"), N_("FILE")},
    {"time", 0, 0, G_OPTION_ARG_STRING, NULL, N_("Run the scene to this time first"), N_("SECONDS")},
    {"size", 0, 0, G_OPTION_ARG_STRING, NULL, N_("Size of the window in the picture: 1280x800"), N_("WxH")},
    {"theme", 0, 0, G_OPTION_ARG_STRING, NULL, N_("light, dark, contrast-light or contrast-dark"), N_("THEME")},
    {"select", 0, 0, G_OPTION_ARG_STRING, NULL, N_("The block that is selected in the picture"), N_("NAME")},
    {"page", 0, 0, G_OPTION_ARG_STRING, NULL, N_("model, graphs or accuracy"), N_("PAGE")},
    {"panel", 0, 0, G_OPTION_ARG_STRING, NULL,
     N_("What the panel beside the canvas shows: scene, properties, start or equations"), N_("PANEL")},
    {"forces", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Show the forces as arrows"), NULL},
    {"velocity", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Show the velocity of what can move"), NULL},
    {"acceleration", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Show its acceleration"), NULL},
    {"net-force", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Show the sum of the forces on it"), NULL},
    {"trail", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Show where it has been, at equal times"), NULL},
    {"measure", 0, 0, G_OPTION_ARG_NONE, NULL, N_("Measure speed and accuracy first"), NULL},
    {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
};

void tinker_command_line_add(GApplication *application)
{
    g_application_add_main_option_entries(application, entries);
    g_application_set_option_context_parameter_string(application, _("[SCENE…]"));
    g_application_set_option_context_description(
        application,
        _("Exit status of --screenshot: 0 done, 1 the run failed, 2 usage, 3 the scene is wrong, 4 a plugin "
          "is missing or refused, 5 a file could not be read or written, or there was not enough memory."));
}

static gboolean wrong(GError **error, const char *option, const char *text, const char *right)
{
    g_set_error(error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE, _("--%s: “%s” is not %s"), option, text, right);
    return FALSE;
}

static gboolean read_time(const char *text, double *time, GError **error)
{
    char *end;
    *time = g_ascii_strtod(text, &end);
    if (end > text && *end == '\0' && isfinite(*time) && *time >= 0) return TRUE;
    return wrong(error, "time", text, _("a time in seconds, such as 1.5"));
}

static gboolean read_size(const char *text, int *width, int *height, GError **error)
{
    char rest;
    if (sscanf(text, "%dx%d%c", width, height, &rest) == 2 && *width > 0 && *height > 0 && *width <= GREATEST_SIZE &&
        *height <= GREATEST_SIZE)
        return TRUE;
    return wrong(error, "size", text, _("a size in pixels, such as 1280x800"));
}

static gboolean read_theme(const char *text, TinkerScreenshot *screenshot, GError **error)
{
    static const char *const themes[] = {"light", "dark", "contrast-light", "contrast-dark"};
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        if (strcmp(text, themes[i]) != 0) continue;
        screenshot->dark = i % 2 == 1;
        screenshot->high_contrast = i >= 2;
        return TRUE;
    }
    return wrong(error, "theme", text, _("one of light, dark, contrast-light, contrast-dark"));
}

/* Options that mean nothing without a picture. */
static gboolean check_alone(GVariantDict *options, GError **error)
{
    static const char *const parts[] = {"scene",  "time",     "size",         "theme",     "select", "page",   "panel",
                                        "forces", "velocity", "acceleration", "net-force", "trail",  "measure"};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        if (!g_variant_dict_contains(options, parts[i])) continue;
        g_set_error(error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE, _("--%s goes with --screenshot only"), parts[i]);
        return FALSE;
    }
    return TRUE;
}

static gboolean read_screenshot(TinkerCommandLine *line, GVariantDict *options, GError **error)
{
    TinkerScreenshot *screenshot = line->screenshot;
    g_autofree char *time = NULL, *size = NULL, *theme = NULL;
    g_variant_dict_lookup(options, "scene", "^ay", &screenshot->scene);
    g_variant_dict_lookup(options, "select", "s", &screenshot->select);
    g_variant_dict_lookup(options, "page", "s", &screenshot->page);
    g_variant_dict_lookup(options, "panel", "s", &screenshot->panel);
    screenshot->forces = g_variant_dict_contains(options, "forces");
    screenshot->velocity = g_variant_dict_contains(options, "velocity");
    screenshot->acceleration = g_variant_dict_contains(options, "acceleration");
    screenshot->net_force = g_variant_dict_contains(options, "net-force");
    screenshot->trail = g_variant_dict_contains(options, "trail");
    screenshot->measure = g_variant_dict_contains(options, "measure");
    screenshot->time = NAN;
    screenshot->width = 1280;
    screenshot->height = 800;
    if (g_variant_dict_lookup(options, "time", "s", &time) && !read_time(time, &screenshot->time, error)) return FALSE;
    if (g_variant_dict_lookup(options, "size", "s", &size) &&
        !read_size(size, &screenshot->width, &screenshot->height, error))
        return FALSE;
    return !g_variant_dict_lookup(options, "theme", "s", &theme) || read_theme(theme, screenshot, error);
}

gboolean tinker_command_line_read(TinkerCommandLine *line, GVariantDict *options, GError **error)
{
    *line = (TinkerCommandLine){FALSE};
    g_auto(GStrv) folders = NULL;
    char *file = NULL;
    line->version = g_variant_dict_contains(options, "version");
    line->new_scene = g_variant_dict_contains(options, "new");
    if (g_variant_dict_lookup(options, "plugins", "^aay", &folders))
        line->plugin_folders = tinker_plugin_folders(folders);
    if (!g_variant_dict_lookup(options, "screenshot", "^ay", &file)) return check_alone(options, error);
    line->screenshot = g_new0(TinkerScreenshot, 1);
    line->screenshot->file = file;
    return read_screenshot(line, options, error);
}

void tinker_command_line_clear(TinkerCommandLine *line)
{
    g_clear_pointer(&line->plugin_folders, g_strfreev);
    if (line->screenshot == NULL) return;
    g_free(line->screenshot->file);
    g_free(line->screenshot->scene);
    g_free(line->screenshot->select);
    g_free(line->screenshot->page);
    g_free(line->screenshot->panel);
    g_clear_pointer(&line->screenshot, g_free);
}
