/* The errors of this folder. */
#include "plugin/trust/refuse.h"

GQuark tinker_plugin_error_quark(void)
{
    return g_quark_from_static_string("tinker-plugin-error-quark");
}

static void set_error(GError **error, TinkerPluginError code, const char *format, va_list arguments)
    G_GNUC_PRINTF(3, 0);

static void set_error(GError **error, TinkerPluginError code, const char *format, va_list arguments)
{
    g_propagate_error(error, g_error_new_valist(TINKER_PLUGIN_ERROR, (int)code, format, arguments));
}

gboolean tinker_refuse(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    set_error(error, TINKER_PLUGIN_ERROR_REFUSED, format, arguments);
    va_end(arguments);
    return FALSE;
}

gboolean tinker_fail_file(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    set_error(error, TINKER_PLUGIN_ERROR_FILE, format, arguments);
    va_end(arguments);
    return FALSE;
}
