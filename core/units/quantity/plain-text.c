/* The characters by their Unicode categories. */
#include "units/quantity/plain-text.h"

#include <string.h>

static gboolean is_plain(gunichar c)
{
    const GUnicodeType type = g_unichar_type(c);
    const gboolean turns = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
    return type != G_UNICODE_CONTROL && type != G_UNICODE_LINE_SEPARATOR && type != G_UNICODE_PARAGRAPH_SEPARATOR &&
           !turns;
}

/* The character at `text`, and how many bytes it has; (gunichar)-1 and 1 where there is none. */
static gunichar next(const char *text, gsize *bytes)
{
    const gunichar c = g_utf8_get_char_validated(text, -1);
    const gboolean good = c != (gunichar)-1 && c != (gunichar)-2;
    *bytes = good ? (gsize)(g_utf8_next_char(text) - text) : 1;
    return good ? c : (gunichar)-1;
}

gboolean tinker_text_is_plain(const char *text)
{
    gsize bytes;
    for (; *text != '\0'; text += bytes) {
        const gunichar c = next(text, &bytes);
        if (c == (gunichar)-1 || !is_plain(c)) return FALSE;
    }
    return TRUE;
}

char *tinker_text_escaped(const char *text, gboolean lines)
{
    GString *escaped = g_string_sized_new(strlen(text) + 1);
    gsize bytes;
    for (; *text != '\0'; text += bytes) {
        const gunichar c = next(text, &bytes);
        if (c == (gunichar)-1)
            g_string_append_printf(escaped, "\\x%02x", (guint)(guchar)*text);
        else if (is_plain(c) || (lines && (c == '\n' || c == '\t')))
            g_string_append_len(escaped, text, (gssize)bytes);
        else if (c == '\n' || c == '\t' || c == '\r')
            g_string_append(escaped, c == '\n' ? "\\n" : c == '\t' ? "\\t" : "\\r");
        else
            g_string_append_printf(escaped, "\\u%04x", (guint)c);
    }
    return g_string_free(escaped, FALSE);
}
