/* Typed laws, compiled: values, slopes and curvatures against functions written in C, numbers with units, and texts
 * that must be refused, or be taken without harm. */
#include <math.h>
#include <string.h>

#include "law/typed-law.h"
#include "units/compiled.h"

static const char *const arguments[] = {"L", "rate", "t"};

/* A class as a plugin would declare it: a law, and two numbers. */
static TinkerPropertyType properties[3] = {
    {.struct_size = sizeof(TinkerPropertyType),
     .kind = TINKER_KIND_TEXT,
     .id = "tension",
     .flags = TINKER_TEXT_LAW,
     .choices = arguments,
     .choice_count = 3},
    {.struct_size = sizeof(TinkerPropertyType), .kind = TINKER_KIND_TEXT, .id = "a", .flags = TINKER_TEXT_QUANTITY},
    {.struct_size = sizeof(TinkerPropertyType), .kind = TINKER_KIND_TEXT, .id = "b", .flags = TINKER_TEXT_QUANTITY},
};

static const char *text_of(int32_t property, void *data)
{
    return ((const char *const *)data)[property];
}

static TinkerTypedLaw *typed(const char *law, const char *a, const char *b, GError **error)
{
    const char *texts[] = {law, a, b};
    TinkerBlockClass block_class = {.property_count = 3, .properties = properties};
    return tinker_typed_new(&block_class, 0, text_of, texts, error);
}

static void assert_near(double value, double expected)
{
    if (!(fabs(value - expected) <= 1e-14 * (1 + fabs(expected)))) g_error("%.17g, not %.17g", value, expected);
}

/* a = 12 in/s^2 and so on would be plain numbers in SI. T = a (L - 1)^3 + b rate sin(t) */
static void test_values(void)
{
    g_autoptr(GError) error = NULL;
    TinkerTypedLaw *law = typed("a*(L - 1)^3 + b*rate*sin(t)", "2 N/m^3", "12 in", &error);
    g_assert_no_error(error);
    const double L = 1.7, rate = -0.4, t = 0.9, a = 2, b = 0.3048, at[] = {L, rate, t};
    assert_near(tinker_compiled_value(law->value, at), a * pow(L - 1, 3) + b * rate * sin(t));
    assert_near(tinker_compiled_value(law->slopes[0], at), 3 * a * (L - 1) * (L - 1));
    assert_near(tinker_compiled_value(law->slopes[1], at), b * sin(t));
    assert_near(tinker_compiled_value(law->curvatures[0], at), 6 * a * (L - 1));
    assert_near(tinker_compiled_value(law->curvatures[5], at), b * cos(t));
    tinker_typed_free(law);
}

/* What switches, and every function there is beside those above. */
static void test_functions(void)
{
    const double at[] = {0.6, -2.5, 7.3};
    const struct {
        const char *text;
        double value, slope;
    } cases[] = {
        {"if(rate < 0, L^2, 1/L)", 0.36, 1.2},
        {"max(L, rate) + min(L, t)", 1.2, 2},
        {"abs(rate)*L", 1.5, 2.5},
        {"atan2(L, t)", atan2(0.6, 7.3), 7.3 / (0.6 * 0.6 + 7.3 * 7.3)},
        {"mod(t, 2)*L + floor(t)", 1.3 * 0.6 + 7, 1.3},
        {"exp(-L)*cosh(L) + log(L)", exp(-0.6) * cosh(0.6) + log(0.6), exp(-0.6) * (sinh(0.6) - cosh(0.6)) + 1 / 0.6},
        {"L^-2 + L^0.5", pow(0.6, -2) + sqrt(0.6), -2 * pow(0.6, -3) + 0.5 / sqrt(0.6)},
        {"step(rate)*L + ramp(L)", 0.6, 1},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        TinkerTypedLaw *law = typed(cases[i].text, "", "", &error);
        g_assert_no_error(error);
        assert_near(tinker_compiled_value(law->value, at), cases[i].value);
        assert_near(tinker_compiled_value(law->slopes[0], at), cases[i].slope);
        tinker_typed_free(law);
    }
}

static void assert_refused(const char *law, const char *a, const char *why)
{
    g_autoptr(GError) error = NULL;
    g_assert_null(typed(law, a, "", &error));
    g_assert_nonnull(error);
    if (strstr(error->message, why) == NULL) g_error("\"%s\" should say \"%s\"", error->message, why);
}

static void test_refused(void)
{
    assert_refused("a*L", "", "names a, which has no value");
    assert_refused("a*L", "3 parrots", "parrots");
    assert_refused("k*L", "", "k");
    assert_refused("(L", "", "");
    g_autoptr(GString) sum = g_string_new("L");
    for (int i = 0; i < 3000; i++)
        g_string_append_printf(sum, "*sin(%d + L)", i);
    assert_refused(sum->str, "", "too long");
}

/* Nests and chains of any text: refused or worked out, and neither takes long nor harms. */
static void test_random_texts(void)
{
    static const char *const pieces[] = {"L",    "rate", "t",      "a",    "3",     "+",    "-",   "*", "/",
                                         "^",    "(",    ")",      "sin(", "sqrt(", ", ",   "if(", "<", "max(",
                                         "log(", "mod(", "atan2(", "exp(", "1e300", "abs(", " == "};
    g_autoptr(GRand) random = g_rand_new_with_seed((guint32)g_test_rand_int());
    for (int round = 0; round < 3000; round++) {
        g_autoptr(GString) text = g_string_new(NULL);
        g_autoptr(GError) error = NULL;
        const int count = g_rand_int_range(random, 1, 14);
        for (int i = 0; i < count; i++)
            g_string_append(text, pieces[g_rand_int_range(random, 0, G_N_ELEMENTS(pieces))]);
        TinkerTypedLaw *law = typed(text->str, "2", "", &error);
        const double at[] = {1.5, 0.5, 0.25};
        g_assert_true((law == NULL) == (error != NULL));
        if (law != NULL) (void)tinker_compiled_value(law->curvatures[0], at);
        tinker_typed_free(law);
    }
    g_autoptr(GString) nest = g_string_new(NULL);
    for (int i = 0; i < 60; i++)
        g_string_append(nest, "sin(L*");
    g_string_append(nest, "L");
    for (int i = 0; i < 60; i++)
        g_string_append(nest, ")");
    g_autoptr(GError) error = NULL;
    tinker_typed_free(typed(nest->str, "2", "", &error));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/law/typed/values", test_values);
    g_test_add_func("/law/typed/functions", test_functions);
    g_test_add_func("/law/typed/refused", test_refused);
    g_test_add_func("/law/typed/random-texts", test_random_texts);
    return g_test_run();
}
