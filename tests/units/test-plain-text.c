/* What is escaped, and how: by Unicode's categories, spelled out here code by code. */
#include <glib.h>
#include <string.h>

#include "units/quantity/plain-text.h"

static void test_escapes(void)
{
    static const struct {
        const char *text, *line, *lines;
    } rows[] = {
        {"", "", ""},
        {"Größe 3 \"µm\" \\n — 😀", "Größe 3 \"µm\" \\n — 😀", "Größe 3 \"µm\" \\n — 😀"},
        {"a\x1b[31mb", "a\\u001b[31mb", "a\\u001b[31mb"},
        {"a\nb\tc\rd", "a\\nb\\tc\\rd", "a\nb\tc\\rd"},
        {"\a\x7f", "\\u0007\\u007f", "\\u0007\\u007f"},
        {"\xc2\x9b"
         "2J",
         "\\u009b2J", "\\u009b2J"}, /* CSI of ISO 8859-1, as UTF-8 */
        {"\x9b"
         "2J\xff",
         "\\x9b2J\\xff", "\\x9b2J\\xff"}, /* and as a byte */
        {"a\xe2\x80\xa8"
         "b\xe2\x80\xae"
         "c",
         "a\\u2028b\\u202ec", "a\\u2028b\\u202ec"},
        {"cut \xe2\x80", "cut \\xe2\\x80", "cut \\xe2\\x80"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *line = tinker_text_escaped(rows[i].text, FALSE),
                        *lines = tinker_text_escaped(rows[i].text, TRUE);
        g_assert_cmpstr(line, ==, rows[i].line);
        g_assert_cmpstr(lines, ==, rows[i].lines);
        g_assert_cmpint(tinker_text_is_plain(rows[i].text), ==, g_str_equal(rows[i].text, rows[i].line));
    }
}

/* Every code up to U+00FF: those from 0 to 1F and from 7F to 9F are control characters (ISO 6429), the others are not.
 */
static void test_codes(void)
{
    for (gunichar c = 1; c <= 0xff; c++) {
        char text[8] = {0};
        g_unichar_to_utf8(c, text);
        g_assert_cmpint(tinker_text_is_plain(text), ==, !(c < 0x20 || (c >= 0x7f && c <= 0x9f)));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plain-text/escapes", test_escapes);
    g_test_add_func("/plain-text/codes", test_codes);
    return g_test_run();
}
