/* Expressions as text, LaTeX and MathML: what a textbook would print. */
#include <string.h>

#include "law/typeset.h"

static const char *const names[] = {"k_1", "L_1", "L0_1", "θ", "m", "x", "v", NULL};

/* "L0_1" is L0 with the index 1; v is x with a dot. */
static void look_of(const char *symbol, TinkerSymbolLook *look, G_GNUC_UNUSED void *data)
{
    static char stem[16];
    const char *index = strchr(symbol, '_');
    g_strlcpy(stem, symbol, index != NULL ? (gsize)(index - symbol) + 1 : sizeof stem);
    *look = (TinkerSymbolLook){.stem = stem, .index = index != NULL ? index + 1 : ""};
    if (strcmp(symbol, "v") == 0) *look = (TinkerSymbolLook){.stem = "x", .index = "", .dots = 1};
}

static const struct {
    const char *source, *text, *latex;
} cases[] = {
    {"k_1*(L_1 - L0_1)", "k₁ (L₁ − L0₁)", "{k}_{1}\\,({L}_{1}-{L}_{0,1})"},
    {"-m*9.81", "−m·9.81", "-{m}\\cdot 9.81"},
    {"m*x^2/2", "m x² / 2", "\\frac{{m}\\,{x}^{2}}{2}"},
    {"x/(m*v)", "x / (m ẋ)", "\\frac{{x}}{{m}\\,\\dot{x}}"},
    {"(x/m)*v", "(x / m) ẋ", "\\frac{{x}}{{m}}\\,\\dot{x}"},
    {"x - (m - v)", "x − (m − ẋ)", "{x}-({m}-\\dot{x})"},
    {"(x + 1)^-0.5", "(x + 1)^(−0.5)", "{({x}+1)}^{-0.5}"},
    {"sqrt(x^2 + 1)", "√(x² + 1)", "\\sqrt{{x}^{2}+1}"},
    {"sin(θ)*abs(x)", "sin(θ) |x|", "\\sin({\\theta})\\,\\left|{x}\\right|"},
    {"if(x < 1, 2, 3e-7)", "(2 if x < 1, else 3e-07)",
     "\\begin{cases}2&\\text{if }{x}<1\\\\3\\cdot 10^{-7}&\\text{else}\\end{cases}"},
    {"(x/2 + 1)*v^2", "(x / 2 + 1) ẋ²", "\\left(\\frac{{x}}{2}+1\\right)\\,\\dot{x}^{2}"},
    {"L0_1^2", "L0₁²", "{L}_{0,1}^{2}"},
    {"2*pi*x", "2 π x", NULL},
};

/* Of each case in the same order, read out. */
static const char *const spoken[] = {
    "k one times, L one minus L nought one",
    "minus m times 9.81",
    "m times x squared over 2",
    "x over, m times x dot",
    "x over m, times x dot",
    "x minus, m minus x dot",
    "x plus 1, to the power, minus 0.5",
    "root of, x squared plus 1",
    "sine of, theta, times the size of x",
    "2 if x is less than 1 else 3 times ten to the -7",
    "x over 2 plus 1, times x dot squared",
    "L nought one squared",
    "2 times pi times x",
};

static char *typeset(const char *source, TinkerTypesetFormat format)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerExpression) expression = tinker_expression_parse(source, names, &error);
    g_assert_no_error(error);
    return tinker_expression_typeset(expression, format, look_of, NULL);
}

static void test_lines(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = typeset(cases[i].source, TINKER_TYPESET_TEXT);
        g_autofree char *latex = typeset(cases[i].source, TINKER_TYPESET_LATEX);
        g_autofree char *composed = g_utf8_normalize(text, -1, G_NORMALIZE_DEFAULT_COMPOSE);
        g_assert_cmpstr(composed, ==, cases[i].text);
        if (cases[i].latex != NULL) g_assert_cmpstr(latex, ==, cases[i].latex);
        g_autofree char *speech = typeset(cases[i].source, TINKER_TYPESET_SPEECH);
        g_assert_cmpstr(speech, ==, spoken[i]);
    }
}

static void ignore(G_GNUC_UNUSED GMarkupParseContext *context, G_GNUC_UNUSED const char *name, G_GNUC_UNUSED void *data,
                   G_GNUC_UNUSED GError **error)
{
}

/* Each is well-formed, and the elements that are to have two children or one have them. */
static void test_mathml(void)
{
    const GMarkupParser parser = {.end_element = ignore};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *inner = typeset(cases[i].source, TINKER_TYPESET_MATHML);
        g_autofree char *whole = g_strdup_printf("<math>%s</math>", inner);
        GMarkupParseContext *context = g_markup_parse_context_new(&parser, 0, NULL, NULL);
        g_assert_true(g_markup_parse_context_parse(context, whole, -1, &error));
        g_assert_true(g_markup_parse_context_end_parse(context, &error));
        g_assert_no_error(error);
        g_markup_parse_context_free(context);
    }
    g_autofree char *square = typeset("x^2", TINKER_TYPESET_MATHML);
    g_assert_cmpstr(square, ==, "<mrow><msup><mi>x</mi><mrow><mn>2</mn></mrow></msup></mrow>");
    /* over its index */
    g_autofree char *both = typeset("k_1^2", TINKER_TYPESET_MATHML);
    g_assert_cmpstr(both, ==,
                    "<mrow><msubsup><mi>k</mi><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></msubsup></mrow>");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/typeset/lines", test_lines);
    g_test_add_func("/typeset/mathml", test_mathml);
    return g_test_run();
}
