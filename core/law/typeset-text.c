/* Expressions as a line of text for a terminal: k₁ (L₁ − L0₁). */
#include <math.h>
#include <string.h>

#include "law/typeset-private.h"

/* Digits and signs have letters of their own below the line; anything else stands behind an underscore. */
static void put_index(GString *text, const char *index)
{
    static const char *const low[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    if (index[0] == '\0') return;
    if (strspn(index, "0123456789") != strlen(index)) {
        g_string_append_printf(text, "_%s", index);
        return;
    }
    for (const char *p = index; *p != '\0'; p++)
        g_string_append(text, low[*p - '0']);
}

static void put_symbol(GString *text, const TinkerSymbolLook *look)
{
    g_string_append(text, look->stem);
    /* combining dots: over the letter before them */
    if (look->dots == 1) g_string_append(text, "\xcc\x87");
    if (look->dots == 2) g_string_append(text, "\xcc\x88");
    put_index(text, look->index);
    if (look->component != NULL) g_string_append(text, look->component);
}

static void put_number(GString *text, double number)
{
    char digits[32];
    if (number == G_PI) {
        g_string_append(text, "π");
        return;
    }
    if (number == 2 * G_PI) {
        g_string_append(text, "2π");
        return;
    }
    tinker_typeset_digits(digits, number);
    g_string_append(text, digits);
}

static void put_function(GString *text, const char *name)
{
    g_string_append(text, name);
}

static void put_comparison(GString *text, const char *sign)
{
    g_string_append_printf(text, " %s ", tinker_typeset_comparison(sign));
}

const TinkerTypesetStyle tinker_text_style = {
    .open = "(",
    .close = ")",
    .plus = " + ",
    .minus = " − ",
    .sign = "−",
    .times = " ",
    .times_number = "·",
    .comma = ", ",
    .group = {"", ""},
    .fraction = {"", " / ", ""},
    .power = {"", "^", ""},
    .raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"},
    .root = {"√", ""},
    .absolute = {"|", "|"},
    .cases = {"(", " if ", ", else ", ")"},
    .otherwise = "",
    .number = put_number,
    .symbol = put_symbol,
    .function = put_function,
    .compare = put_comparison,
};
