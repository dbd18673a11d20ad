/* Exit statuses by error domain, and the program's lines on standard error. */
#include "common/program/exit-status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "common/program/print.h"
#include "physics/model/model.h"
#include "plugin/catalogue/catalogue.h"
#include "scene/store/scene.h"
#include "units/quantity/units.h"
#include "units/waveform/waveform.h"

#define ANY_CODE (-1)

static const char *program = "tinker";

void tinker_report_as(const char *name)
{
    program = name;
}

GQuark tinker_cli_error_quark(void)
{
    return g_quark_from_static_string("tinker-cli-error-quark");
}

static GQuark option_error(void)
{
    return G_OPTION_ERROR;
}

static GQuark file_error(void)
{
    return G_FILE_ERROR;
}

/* The first row that fits counts. */
static const struct {
    GQuark (*domain)(void);
    int code;
    int status;
} statuses[] = {
    {tinker_cli_error_quark, TINKER_CLI_ERROR_USAGE, TINKER_EXIT_USAGE},
    {tinker_cli_error_quark, ANY_CODE, TINKER_EXIT_FILE},
    {option_error, ANY_CODE, TINKER_EXIT_USAGE},
    {file_error, ANY_CODE, TINKER_EXIT_FILE},
    {tinker_scene_error_quark, TINKER_SCENE_ERROR_FILE, TINKER_EXIT_FILE},
    {tinker_scene_error_quark, TINKER_SCENE_ERROR_TYPE, TINKER_EXIT_PLUGIN},
    {tinker_scene_error_quark, ANY_CODE, TINKER_EXIT_SCENE},
    {tinker_units_error_quark, ANY_CODE, TINKER_EXIT_SCENE},
    {tinker_waveform_error_quark, ANY_CODE, TINKER_EXIT_SCENE},
    {tinker_plugin_error_quark, TINKER_PLUGIN_ERROR_FILE, TINKER_EXIT_FILE},
    {tinker_plugin_error_quark, ANY_CODE, TINKER_EXIT_PLUGIN},
    {tinker_model_error_quark, TINKER_MODEL_ERROR_PLUGIN, TINKER_EXIT_PLUGIN},
    {tinker_model_error_quark, TINKER_MODEL_ERROR_RUN, TINKER_EXIT_RUN_FAILED},
    {tinker_model_error_quark, TINKER_MODEL_ERROR_ACCURACY, TINKER_EXIT_RUN_FAILED},
    {tinker_model_error_quark, TINKER_MODEL_ERROR_STOPPED, TINKER_EXIT_RUN_FAILED},
    {tinker_model_error_quark, TINKER_MODEL_ERROR_MEMORY, TINKER_EXIT_FILE},
    {tinker_model_error_quark, ANY_CODE, TINKER_EXIT_SCENE},
};

int tinker_exit_status(const GError *error)
{
    for (gsize i = 0; i < G_N_ELEMENTS(statuses); i++)
        if (error->domain == statuses[i].domain() && (statuses[i].code == ANY_CODE || statuses[i].code == error->code))
            return statuses[i].status;
    return TINKER_EXIT_RUN_FAILED;
}

void tinker_blame_option(const char *option, GError **error)
{
    if (error == NULL || *error == NULL) return;
    if (g_error_matches(*error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_TYPE)) return;
    GError *usage = option == NULL
                        ? g_error_new_literal(TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, (*error)->message)
                        : g_error_new(TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s: %s", option, (*error)->message);
    g_clear_error(error);
    *error = usage;
}

int tinker_report_error(const char *scene, const GError *error)
{
    gboolean of_scene = scene != NULL && error->domain != TINKER_CLI_ERROR;
    gboolean told = of_scene && g_str_has_prefix(error->message, scene) && error->message[strlen(scene)] == ':';
    if (of_scene && !told)
        tinker_print_line(stderr, "%s: %s: %s", program, scene, error->message);
    else
        tinker_print_line(stderr, "%s: %s", program, error->message);
    return tinker_exit_status(error);
}

static void report(const char *what, const char *format, va_list arguments) G_GNUC_PRINTF(2, 0);
static void report(const char *what, const char *format, va_list arguments)
{
    g_autofree char *text = g_strdup_vprintf(format, arguments);
    tinker_print_line(stderr, "%s: %s%s", program, what, text);
}

void tinker_report_warning(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report("warning: ", format, arguments);
    va_end(arguments);
}

void tinker_report_note(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report("", format, arguments);
    va_end(arguments);
}
