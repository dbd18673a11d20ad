/* Numbers with units as people type them, and messages of the core as sentences under an entry. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"
#include "gui/text/translate.h"

gboolean property_refuse(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, message);
    return FALSE;
}

static const char *without_column(const char *message)
{
    const char *at = message;
    if (!g_str_has_prefix(at, "column ")) return message;
    at += strlen("column ");
    while (g_ascii_isdigit(*at))
        at++;
    return g_str_has_prefix(at, ": ") ? at + 2 : message;
}

static const char *without_prefix(const char *message, const char *prefix)
{
    gsize length = prefix != NULL ? strlen(prefix) : 0;
    if (length == 0 || strncmp(message, prefix, length) != 0 || strncmp(message + length, ": ", 2) != 0) return message;
    return message + length + 2;
}

static gboolean is_word_character(char c)
{
    return g_ascii_isalnum(c) || c == '_';
}

/* Puts titles in the place of ids, word by word. */
static char *with_titles(const char *message, const TinkerBlockClass *block_class)
{
    GString *text = g_string_new(NULL);
    for (const char *at = message; *at != '\0';) {
        gsize length = 0;
        while (is_word_character(at[length]))
            length++;
        g_autofree char *word = g_strndup(at, MAX(length, 1));
        int32_t property = length > 0 ? tinker_block_class_property(block_class, word) : -1;
        if (property >= 0)
            g_string_append_printf(text, _("“%s”"), tinker_translate(block_class->properties[property].title));
        else
            g_string_append(text, word);
        at += strlen(word);
    }
    return g_string_free(text, FALSE);
}

void property_fail(GError **error, GError *cause, const char *prefix, const TinkerBlockClass *block_class)
{
    const char *bare = without_column(without_prefix(cause->message, prefix));
    g_autofree char *titled = block_class != NULL ? with_titles(bare, block_class) : g_strdup(bare);
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
