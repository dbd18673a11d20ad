/* Expressions as they are read out: "minus k one times, L one minus L nought". A bracket is a pause, which is written
 * as a comma. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "law/typeset-private.h"

static const char *digit_word(char digit)
{
    static const char *const words[] = {N_("nought"), N_("one"), N_("two"),   N_("three"), N_("four"),
                                        N_("five"),   N_("six"), N_("seven"), N_("eight"), N_("nine")};
    return _(words[digit - '0']);
}

/* "0" is nought, "12" is one two. */
static void put_index(GString *text, const char *index)
{
    if (index[0] == '\0') return;
    if (strspn(index, "0123456789") != strlen(index)) {
        g_string_append_printf(text, " %s", index);
        return;
    }
    for (; *index != '\0'; index++)
        g_string_append_printf(text, " %s", digit_word(*index));
}

static void put_symbol(GString *text, const TinkerSymbolLook *look)
{
    const gsize length = tinker_stem_letters(look->stem);
    g_autofree char *letters = g_strndup(look->stem, length);
    const char *greek = tinker_greek_name(letters);
    if (greek != NULL && g_str_has_prefix(greek, "var")) greek += strlen("var");
    g_string_append(text, greek != NULL ? greek : letters);
    put_index(text, look->stem + length);
    put_index(text, look->index);
    if (look->component != NULL) g_string_append_printf(text, " %s", look->component);
    if (look->dots == 1) g_string_append_printf(text, " %s", _("dot"));
    if (look->dots == 2) g_string_append_printf(text, " %s", _("double dot"));
}

static void put_number(GString *text, double number)
{
    char digits[32];
    int power;
    if (number == G_PI) {
        g_string_append(text, "pi");
        return;
    }
    if (number == 2 * G_PI) {
        g_string_append(text, "2 pi");
        return;
    }
    tinker_typeset_digits(digits, number);
    /* Translators: "1.5 times ten to the minus 7", as it is read out. */
    if (tinker_typeset_power(digits, &power))
        g_string_append_printf(text, _("%s times ten to the %d"), digits, power);
    else
        g_string_append(text, digits);
}

static void put_function(GString *text, const char *name)
{
    static const struct {
        const char *name, *word;
    } known[] = {{"sin", N_("sine of")},          {"cos", N_("cosine of")},      {"tan", N_("tangent of")},
                 {"asin", N_("arc sine of")},     {"acos", N_("arc cosine of")}, {"atan", N_("arc tangent of")},
                 {"atan2", N_("arc tangent of")}, {"sqrt", N_("root of")},       {"exp", N_("exponential of")},
                 {"log", N_("logarithm of")}};
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++)
        if (strcmp(known[i].name, name) == 0) {
            g_string_append(text, _(known[i].word));
            return;
        }
    g_string_append_printf(text, _("%s of"), name);
}

static void put_comparison(GString *text, const char *sign)
{
    static const struct {
        const char *sign, *word;
    } known[] = {{"<", N_("is less than")}, {">", N_("is greater than")}, {"<=", N_("is at most")},
                 {">=", N_("is at least")}, {"!=", N_("is not")},         {"==", N_("is")}};
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++)
        if (strcmp(known[i].sign, sign) == 0) g_string_append_printf(text, " %s ", _(known[i].word));
}

static const char *spaced(const char *word)
{
    g_autofree char *text = g_strdup_printf(" %s ", word);
    return g_intern_string(text);
}

/* Its words are those of the language at the first call. */
const TinkerTypesetStyle *tinker_speech_style(void)
{
    static TinkerTypesetStyle style;
    static gsize ready;
    if (g_once_init_enter(&ready)) {
        style = (TinkerTypesetStyle){
            .open = ", ",
            .close = ", ",
            .plus = spaced(_("plus")),
            .minus = spaced(_("minus")),
            .sign = spaced(_("minus")),
            .times = spaced(_("times")),
            .times_number = spaced(_("times")),
            .comma = spaced(_("and")),
            .group = {"", ""},
            .fraction = {"", spaced(_("over")), ""},
            .power = {"", spaced(_("to the power")), ""},
            .raised = {NULL, NULL, spaced(_("squared")), spaced(_("cubed"))},
            .root = {spaced(_("root of")), ""},
            .absolute = {spaced(_("the size of")), ", "},
            .cases = {"", spaced(_("if")), spaced(_("else")), ""},
            .otherwise = "",
            .number = put_number,
            .symbol = put_symbol,
            .function = put_function,
            .compare = put_comparison,
        };
        g_once_init_leave(&ready, 1);
    }
    return &style;
}

void tinker_speech_tidy(GString *text)
{
    g_autofree char *raw = g_strdup(text->str);
    g_string_truncate(text, 0);
    gboolean pause = FALSE, gap = FALSE;
    for (const char *p = raw; *p != '\0'; p++) {
        if (*p == ',' || *p == ' ') {
            pause = pause || *p == ',';
            gap = TRUE;
            continue;
        }
        if (gap && text->len > 0) g_string_append(text, pause ? ", " : " ");
        g_string_append_c(text, *p);
        pause = gap = FALSE;
    }
}
