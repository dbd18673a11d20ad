/* Expressions as LaTeX, for math mode, with amsmath. */
#include <math.h>
#include <string.h>

#include "law/typeset-private.h"

/* Letters of a name, with what LaTeX takes for signs of its own made harmless. */
static void put_name(GString *text, const char *name)
{
    for (const char *p = name; *p != '\0'; p++) {
        if (strchr("_%#&${}", *p) != NULL)
            g_string_append_printf(text, "\\%c", *p);
        else if (*p == '\\')
            g_string_append(text, "\\backslash ");
        else if (*p == '^' || *p == '~')
            g_string_append_printf(text, "\\%c{}", *p);
        else
            g_string_append_c(text, *p);
    }
}

/* A letter, or a word upright. Where the index begins is answered. */
static const char *put_stem(GString *text, const char *stem)
{
    const gsize length = tinker_stem_letters(stem);
    g_autofree char *letters = g_strndup(stem, length);
    const char *greek = tinker_greek_name(letters);
    if (greek != NULL) {
        g_string_append_printf(text, "\\%s", greek);
    } else if (g_utf8_strlen(letters, -1) == 1) {
        put_name(text, letters);
    } else {
        g_string_append(text, "\\mathrm{");
        put_name(text, letters);
        g_string_append_c(text, '}');
    }
    return stem + length;
}

static void put_symbol(GString *text, const TinkerSymbolLook *look)
{
    g_string_append(text, look->dots == 2 ? "\\ddot{" : look->dots == 1 ? "\\dot{" : "{");
    const char *digits = put_stem(text, look->stem);
    g_string_append(text, "}");
    const char *const parts[] = {digits, look->index, look->component != NULL ? look->component : ""};
    gboolean any = FALSE;
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        if (parts[i][0] == '\0') continue;
        g_string_append(text, any ? "," : "_{");
        any = TRUE;
        const char *greek = tinker_greek_name(parts[i]);
        if (greek != NULL) {
            g_string_append_printf(text, "\\%s", greek);
        } else if (strlen(parts[i]) > 1 && strspn(parts[i], "0123456789") != strlen(parts[i])) {
            g_string_append(text, "\\text{");
            put_name(text, parts[i]);
            g_string_append_c(text, '}');
        } else {
            put_name(text, parts[i]);
        }
    }
    if (any) g_string_append_c(text, '}');
}

static void put_number(GString *text, double number)
{
    char digits[32];
    int power;
    if (number == G_PI) {
        g_string_append(text, "\\pi ");
        return;
    }
    if (number == 2 * G_PI) {
        g_string_append(text, "2 \\pi ");
        return;
    }
    tinker_typeset_digits(digits, number);
    const gboolean has_power = tinker_typeset_power(digits, &power);
    g_string_append(text, digits);
    if (has_power) g_string_append_printf(text, "\\cdot 10^{%d}", power);
}

static void put_function(GString *text, const char *name)
{
    static const char *const known[] = {"sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "min", "max", NULL};
    if (g_strv_contains(known, name))
        g_string_append_printf(text, "\\%s", name);
    else if (strcmp(name, "log") == 0)
        g_string_append(text, "\\ln");
    else if (name[0] == 'a' && (strcmp(name, "asin") == 0 || strcmp(name, "acos") == 0 || strcmp(name, "atan") == 0))
        g_string_append_printf(text, "\\arc%s", name + 1);
    else
        g_string_append_printf(text, "\\operatorname{%s}", name);
}

static void put_comparison(GString *text, const char *sign)
{
    const char *shown = strcmp(sign, "<=") == 0   ? "\\le "
                        : strcmp(sign, ">=") == 0 ? "\\ge "
                        : strcmp(sign, "!=") == 0 ? "\\ne "
                        : strcmp(sign, "==") == 0 ? "="
                                                  : sign;
    g_string_append(text, shown);
}

static void raise_symbol(GString *text, G_GNUC_UNUSED gsize symbol, const char *exponent)
{
    g_string_append_printf(text, "^{%s}", exponent);
}

const TinkerTypesetStyle tinker_latex_style = {
    /* what grows has more space around it than a bracket of one line is to have */
    .open = "(",
    .close = ")",
    .high = {"\\left(", "\\right)"},
    .plus = "+",
    .minus = "-",
    .sign = "-",
    .times = "\\,",
    .times_number = "\\cdot ",
    .comma = ",",
    .stacked = TRUE,
    .group = {"", ""},
    .fraction = {"\\frac{", "}{", "}"},
    .power = {"{", "}^{", "}"},
    .raise = raise_symbol,
    .root = {"\\sqrt{", "}"},
    .absolute = {"\\left|", "\\right|"},
    .cases = {"\\begin{cases}", "&\\text{if }", "\\\\", "\\end{cases}"},
    .otherwise = "&\\text{else}",
    .number = put_number,
    .symbol = put_symbol,
    .function = put_function,
    .compare = put_comparison,
};
