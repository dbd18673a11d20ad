/* Numbers with units as people type them, and messages of the core as sentences under an entry. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"

gboolean property_refuse(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, message);
    return FALSE;
}

static const char *without_prefix(const char *message, const char *prefix)
{
    gsize length = prefix != NULL ? strlen(prefix) : 0;
    if (length == 0 || strncmp(message, prefix, length) != 0 || strncmp(message + length, ": ", 2) != 0) return message;
    return message + length + 2;
}

void property_fail(GError **error, GError *cause, const char *prefix, const TinkerBlockClass *block_class)
{
    const char *bare = tinker_without_column(without_prefix(cause->message, prefix), NULL);
    g_autofree char *titled = block_class != NULL ? tinker_with_titles(bare, block_class) : g_strdup(bare);
    g_autofree char *message = tinker_sentence(titled);
    g_set_error_literal(error, cause->domain, cause->code, message);
    g_error_free(cause);
}

gboolean property_parse_number(const char *text, TinkerDimension dimension, const char *unit, double *si,
                               GError **error)
{
    GError *cause = NULL;
    if (tinker_number_read(text, dimension, unit, si, &cause)) return TRUE;
    property_fail(error, cause, NULL, NULL); /* in an entry of a few characters nobody counts columns */
    return FALSE;
}
