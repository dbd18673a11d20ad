/* What is wrong with a text that is not JSON, by what stands there and what probably was meant. */
#include "scene/json/position-scanner-private.h"

#include <glib/gi18n-lib.h>
#include <string.h>

gboolean scanner_fail(Scanner *s, gsize at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    s->scan->fault = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    s->scan->fault_at = at;
    return FALSE;
}

/* The length of the word that is there, cut where it is long. */
static gsize word_length(const Scanner *s)
{
    const char *from = s->text + s->at;
    gsize room = MIN(s->length - s->at, 20), word = 0;
    while (word < room && (g_ascii_isalnum(from[word]) || from[word] == '_' || from[word] == '-'))
        word++;
    return word;
}

/* "expected X, Y found" with the word or character that is there. */
gboolean scanner_fail_expected(Scanner *s, const char *expected)
{
    if (s->at == 0 && s->length >= 3 && memcmp(s->text, "\xEF\xBB\xBF", 3) == 0)
        return scanner_fail(s, 0, _("the text begins with a byte-order mark (save it as UTF-8 without one)"));
    if (s->at >= s->length)
        return scanner_fail(s, s->at, _("not JSON: %s was expected, but the text ends here"), expected);
    const char *from = s->text + s->at;
    gsize before = s->at;
    while ((*from == ']' || *from == '}') && before > 0 && strchr(" \n\r\t", s->text[before - 1]) != NULL)
        before--;
    if ((*from == ']' || *from == '}') && before > 0 && s->text[before - 1] == ',')
        return scanner_fail(s, before - 1, _("not JSON: a comma stands before '%c' (take it out)"), *from);
    gsize word = word_length(s);
    if (word > 0)
        return scanner_fail(s, s->at, _("not JSON: %s was expected, \"%.*s\" found"), expected, (int)word, from);
    gunichar c = g_utf8_get_char_validated(from, (gssize)(s->length - s->at));
    if (c == (gunichar)-1 || c == (gunichar)-2)
        return scanner_fail(s, s->at, _("not UTF-8: byte 0x%02X cannot stand here"), (guchar)*from);
    if (!g_unichar_isprint(c)) return scanner_fail(s, s->at, _("not JSON: %s was expected, U+%04X found"), expected, c);
    return scanner_fail(s, s->at, _("not JSON: %s was expected, '%.*s' found"), expected,
                        (int)(g_utf8_next_char(from) - from), from);
}

/* How many characters of a number stand before a place. */
static gsize number_before(const Scanner *s, gsize at)
{
    gsize count = 0;
    while (count < at && (g_ascii_isdigit(s->text[at - count - 1]) || strchr("+-.eE", s->text[at - count - 1]) != NULL))
        count++;
    return count;
}

/* A number with a decimal comma, "1,5", where a key is expected behind the comma; 0: it is none. */
static gsize decimal_comma(const Scanner *s)
{
    if (s->at < 2 || !g_ascii_isdigit(s->text[s->at]) || s->text[s->at - 1] != ',') return 0;
    return number_before(s, s->at - 1);
}

gboolean scanner_fail_key(Scanner *s)
{
    const char *expected = _("a key in double quotes");
    const gsize word = word_length(s), whole = word > 0 ? decimal_comma(s) : 0;
    if (whole > 0)
        return scanner_fail(s, s->at - 1,
                            _("not JSON: decimals are written with a point, not a comma (\"%.*s,%.*s\" is no number)"),
                            (int)whole, s->text + s->at - 1 - whole, (int)word, s->text + s->at);
    if (word == 0) return scanner_fail_expected(s, expected);
    return scanner_fail(s, s->at, _("not JSON: %s was expected, found %.*s without quotes"), expected, (int)word,
                        s->text + s->at);
}
