/* Passing over texts, numbers and words. */
#include "scene/json/position-scanner-private.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* The four digits behind \u, or -1. */
static int hex4(const Scanner *s, gsize at)
{
    int value = 0;
    for (int i = 0; i < 4; i++) {
        int digit = at + i < s->length ? g_ascii_xdigit_value(s->text[at + i]) : -1;
        if (digit < 0) return -1;
        value = value * 16 + digit;
    }
    return value;
}

/* Stands on a backslash; passes over the escape. */
static gboolean scan_escape(Scanner *s)
{
    gsize start = s->at++;
    int c = scanner_peek(s);
    s->at++;
    if (c != -1 && c != 0 && strchr("\"\\/bfnrt", c) != NULL) return TRUE;
    if (c != 'u')
        return scanner_fail(
            s, start,
            _("not JSON: a backslash is followed by one of \" \\ / b f n r t u (write \\\\ for a backslash)"));
    int unit = hex4(s, s->at);
    if (unit < 0) return scanner_fail(s, start, _("not JSON: \\u is followed by four hexadecimal digits"));
    if (unit == 0) return scanner_fail(s, start, _("the character U+0000 cannot stand in a text of a scene"));
    s->at += 4;
    if (unit < 0xD800 || unit > 0xDFFF) return TRUE;
    gboolean pair = unit < 0xDC00 && s->at + 1 < s->length && s->text[s->at] == '\\' && s->text[s->at + 1] == 'u';
    int second = pair ? hex4(s, s->at + 2) : -1;
    if (second < 0xDC00 || second > 0xDFFF)
        return scanner_fail(s, start, _("\\u%04X is half of a surrogate pair"), (guint)unit);
    s->at += 6;
    return TRUE;
}

/* Stands on the opening quote; passes over the text. */
gboolean scanner_string(Scanner *s, gboolean *escaped)
{
    gsize start = s->at++;
    *escaped = FALSE;
    for (;;) {
        int c = scanner_peek(s);
        if (c == -1) return scanner_fail(s, start, _("not JSON: a text that begins here has no closing quote"));
        if (c == '"') break;
        if (c == '\\') {
            *escaped = TRUE;
            if (!scan_escape(s)) return FALSE;
        } else if (c < 0x20) {
            return scanner_fail(s, s->at,
                                _("not JSON: a control character (U+%04X) in a text must be written as \\u%04X"), c, c);
        } else if (c < 0x80) {
            s->at++;
        } else {
            const char *from = s->text + s->at;
            gunichar wide = g_utf8_get_char_validated(from, (gssize)(s->length - s->at));
            if (wide == (gunichar)-1 || wide == (gunichar)-2)
                return scanner_fail(s, s->at, _("not UTF-8: byte 0x%02X cannot stand here"), (guint)c);
            s->at += (gsize)(g_utf8_next_char(from) - from);
        }
    }
    s->at++;
    return TRUE;
}

static gboolean scan_digits(Scanner *s)
{
    gsize start = s->at;
    while (s->at < s->length && g_ascii_isdigit(s->text[s->at]))
        s->at++;
    return s->at > start || scanner_fail_expected(s, _("a digit"));
}

gboolean scanner_number(Scanner *s)
{
    gsize start = s->at;
    if (scanner_peek(s) == '-') s->at++;
    if (scanner_peek(s) == '0')
        s->at++;
    else if (!scan_digits(s))
        return FALSE;
    if (g_ascii_isdigit(scanner_peek(s) == -1 ? ' ' : scanner_peek(s)))
        return scanner_fail(s, start, _("not JSON: a number must not begin with a zero that means nothing"));
    if (scanner_peek(s) == '.') {
        s->at++;
        if (!scan_digits(s)) return FALSE;
    }
    if (scanner_peek(s) == 'e' || scanner_peek(s) == 'E') {
        s->at++;
        if (scanner_peek(s) == '+' || scanner_peek(s) == '-') s->at++;
        if (!scan_digits(s)) return FALSE;
    }
    if (s->at - start > JSON_LONGEST_NUMBER)
        return scanner_fail(s, start, _("a number of more than %d characters (17 digits say all that is kept)"),
                            JSON_LONGEST_NUMBER);
    return TRUE;
}

gboolean scanner_word(Scanner *s, const char *word)
{
    gsize length = strlen(word);
    if (s->length - s->at >= length && memcmp(s->text + s->at, word, length) == 0) {
        gboolean longer = s->at + length < s->length && g_ascii_isalnum(s->text[s->at + length]);
        if (!longer) {
            s->at += length;
            return TRUE;
        }
    }
    return scanner_fail_expected(s, _("a value"));
}
