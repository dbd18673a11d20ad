/* Expressions as presentation MathML Core. */
#include <math.h>
#include <string.h>

#include "law/typeset-private.h"

static void put_text(GString *text, const char *tag, const char *content)
{
    g_autofree char *escaped = g_markup_escape_text(content, -1);
    g_string_append_printf(text, "<%s>%s</%s>", tag, escaped, tag);
}

static void put_letters(GString *text, const TinkerSymbolLook *look, gsize length)
{
    g_autofree char *letters = g_strndup(look->stem, length);
    if (look->dots == 0) {
        put_text(text, "mi", letters);
        return;
    }
    /* no accent="true": browsers draw the dots of one into the letter */
    g_string_append(text, "<mover>");
    put_text(text, "mi", letters);
    g_string_append_printf(text, "<mo>%s</mo></mover>", look->dots == 2 ? "¨" : "˙");
}

static void put_symbol(GString *text, const TinkerSymbolLook *look)
{
    const gsize length = tinker_stem_letters(look->stem);
    const char *const parts[] = {look->stem + length, look->index, look->component != NULL ? look->component : ""};
    g_autoptr(GString) index = g_string_new(NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        if (parts[i][0] == '\0') continue;
        if (index->len > 0) g_string_append(index, "<mo>,</mo>");
        put_text(index, strspn(parts[i], "0123456789") == strlen(parts[i]) ? "mn" : "mi", parts[i]);
    }
    if (index->len > 0) g_string_append(text, "<msub>");
    put_letters(text, look, length);
    if (index->len > 0) g_string_append_printf(text, "<mrow>%s</mrow></msub>", index->str);
}

static void put_number(GString *text, double number)
{
    char digits[32];
    int power;
    if (number == G_PI) {
        put_text(text, "mi", "π");
        return;
    }
    if (number == 2 * G_PI) {
        put_text(text, "mn", "2");
        put_text(text, "mi", "π");
        return;
    }
    tinker_typeset_digits(digits, number);
    const gboolean has_power = tinker_typeset_power(digits, &power);
    put_text(text, "mn", digits);
    if (has_power) g_string_append_printf(text, "<mo>·</mo><msup><mn>10</mn><mn>%d</mn></msup>", power);
}

static void put_function(GString *text, const char *name)
{
    put_text(text, "mi", name);
    g_string_append(text, "<mo>&#x2061;</mo>");
}

static void put_comparison(GString *text, const char *sign)
{
    put_text(text, "mo", tinker_typeset_comparison(sign));
}

static void raise_symbol(GString *text, gsize symbol, const char *exponent)
{
    const gsize tag = strlen("<msub");
    const gboolean has_index = g_str_has_prefix(text->str + symbol, "<msub>");
    if (has_index) {
        g_string_insert(text, (gssize)(symbol + tag), "sup");
        g_string_truncate(text, text->len - strlen("</msub>"));
    } else {
        g_string_insert(text, (gssize)symbol, "<msup>");
    }
    g_string_append_printf(text, "%s%s", exponent, has_index ? "</msubsup>" : "</msup>");
}

const TinkerTypesetStyle tinker_mathml_style = {
    /* what may stretch is drawn from a larger size in most fonts, with space around it */
    .open = "<mo stretchy=\"false\">(</mo>",
    .close = "<mo stretchy=\"false\">)</mo>",
    .high = {"<mo>(</mo>", "<mo>)</mo>"},
    .plus = "<mo>+</mo>",
    .minus = "<mo>−</mo>",
    .sign = "<mo>−</mo>",
    .times = "<mo>&#x2062;</mo>",
    .times_number = "<mo>·</mo>",
    .times_function = "<mo lspace=\"0.17em\" rspace=\"0\">&#x2062;</mo>",
    .comma = "<mo>,</mo>",
    .stacked = TRUE,
    .group = {"<mrow>", "</mrow>"},
    .fraction = {"<mfrac>", "", "</mfrac>"},
    .power = {"<msup>", "", "</msup>"},
    .raise = raise_symbol,
    .root = {"<msqrt>", "</msqrt>"},
    .absolute = {"<mo>|</mo>", "<mo>|</mo>"},
    .cases = {"<mo>{</mo><mtable><mtr><mtd>", "</mtd><mtd><mtext>if </mtext>", "</mtd></mtr><mtr><mtd>",
              "</mtd></mtr></mtable>"},
    .otherwise = "</mtd><mtd><mtext>else</mtext>",
    .number = put_number,
    .symbol = put_symbol,
    .function = put_function,
    .compare = put_comparison,
};
