/* Laws: read over names of their own, derived twice, written in every format, and worked out as a tree and compiled. */
#include <math.h>
#include <string.h>

#include "fuzz-target.h"
#include "law/derivative.h"
#include "law/typeset.h"
#include "law/value.h"
#include "units/compiled/compiled.h"

#define NAMES  3
#define PLACES 9

static const char *const names[NAMES + 1] = {"x", "v", "k_1", NULL};
static const double places[PLACES][NAMES] = {
    {0, 0, 0},     {1, 1, 1},      {0.3, -2, 5},      {-1.5, 0.25, 3}, {1e9, 1e-9, 1},
    {-0.0, 1, -1}, {7, -7, 1e300}, {1e-300, 2, 1e-3}, {2.5, 2.5, 2.5},
};

static void look_of(const char *symbol, TinkerSymbolLook *look, void *data)
{
    (void)data;
    *look = (TinkerSymbolLook){.stem = symbol, .index = ""};
}

static void check_written(const TinkerExpression *law)
{
    static const GMarkupParser parser = {0};
    for (int format = TINKER_TYPESET_TEXT; format <= TINKER_TYPESET_SPEECH; format++) {
        g_autofree char *text = tinker_expression_typeset(law, (TinkerTypesetFormat)format, look_of, NULL);
        if (*text == '\0' || !g_utf8_validate(text, -1, NULL)) g_error("format %d is no text", format);
        if (format != TINKER_TYPESET_MATHML) continue;
        g_autoptr(GError) error = NULL;
        g_autofree char *whole = g_strconcat("<math>", text, "</math>", NULL);
        g_autoptr(GMarkupParseContext) context = g_markup_parse_context_new(&parser, 0, NULL, NULL);
        if (!g_markup_parse_context_parse(context, whole, -1, &error) ||
            !g_markup_parse_context_end_parse(context, &error))
            g_error("%s in %s", error->message, whole);
    }
}

static double value_of(const char *symbol, void *place)
{
    for (int i = 0; i < NAMES; i++)
        if (strcmp(symbol, names[i]) == 0) return ((const double *)place)[i];
    return 0.5; /* t */
}

static gboolean is_same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

/* One place after the other and all at once it gives the same bits. */
static void check_compiled(const TinkerExpression *law)
{
    const char *const all[] = {"x", "v", "k_1", "t"};
    double columns[NAMES + 1][PLACES], results[PLACES];
    const double *by_argument[NAMES + 1];
    TinkerCompiled *compiled = tinker_compiled_new(law, all, NAMES + 1);
    if (compiled == NULL) return;
    for (int i = 0; i <= NAMES; i++) {
        by_argument[i] = columns[i];
        for (int k = 0; k < PLACES; k++)
            columns[i][k] = i < NAMES ? places[k][i] : 0.5;
    }
    const TinkerColumns places_of = {.count = PLACES, .arguments = by_argument};
    const gboolean together = tinker_compiled_values(compiled, &places_of, results);
    for (int k = 0; k < PLACES; k++) {
        const double arguments[] = {places[k][0], places[k][1], places[k][2], 0.5};
        const double alone = tinker_compiled_value(compiled, arguments);
        if (together && !is_same(alone, results[k])) g_error("%.17g alone, %.17g beside others", alone, results[k]);
    }
    tinker_compiled_free(compiled);
}

static void check_law(const TinkerExpression *law)
{
    check_written(law);
    check_compiled(law);
    for (int k = 0; k < PLACES; k++)
        (void)tinker_expression_value(law, value_of, (void *)places[k]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    g_autofree char *text = g_strndup((const char *)data, size);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerExpression) law = tinker_expression_parse(text, names, &error);
    if (law == NULL) {
        if (error == NULL || !g_utf8_validate(error->message, -1, NULL)) g_error("no message");
        return 0;
    }
    check_law(law);
    g_autoptr(TinkerExpression) slope = tinker_expression_derivative_by(law, "x");
    check_law(slope);
    g_autoptr(TinkerExpression) curvature = tinker_expression_derivative_by(slope, "x");
    check_law(curvature);
    return 0;
}
