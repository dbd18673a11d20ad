/* Typed laws, compiled: values, slopes and curvatures against functions written in C, numbers with units, and texts
 * that must be refused, or be taken without harm. */
#include <math.h>
#include <string.h>

#include "law/typed-law.h"
#include "units/compiled/typed-energy.h"

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

/* Powers of wholes and halves are products and roots. */
static void test_powers(void)
{
    for (int halves = -33; halves <= 33; halves++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *text = g_strdup_printf("L^(%d/2)", halves);
        TinkerTypedLaw *law = typed(text, "", "", &error);
        g_assert_no_error(error);
        const double bases[] = {0.3, 1, 1.7, 4};
        for (gsize i = 0; i < G_N_ELEMENTS(bases); i++) {
            const double at[] = {bases[i], 0, 0}, n = halves / 2.0;
            const double value = pow(bases[i], n), slope = n * pow(bases[i], n - 1);
            g_assert_cmpfloat(fabs(tinker_compiled_value(law->value, at) - value), <=, 20 * DBL_EPSILON * value);
            g_assert_cmpfloat(fabs(tinker_compiled_value(law->slopes[0], at) - slope), <=,
                              20 * DBL_EPSILON * fabs(slope));
        }
        tinker_typed_free(law);
    }
}

static void assert_same_bits(double value, double expected)
{
    if (memcmp(&value, &expected, sizeof value) != 0 && !(isnan(value) && isnan(expected)))
        g_error("%.17g, not %.17g to the last bit", value, expected);
}

/* Sums of products are one step, and are rounded after each operation all the same. */
static void test_sums(void)
{
    const double L = 0.6, rate = -2.5, t = 7.3, a = 1.7, b = 0.3, at[] = {L, rate, t};
    const struct {
        const char *text;
        double value;
    } cases[] = {
        {"a*L + b*rate", a * L + b * rate},
        {"a*L + b*rate^2", a * L + b * (rate * rate)},
        {"a*rate^3 + b*L", a * (rate * rate * rate) + b * L},
        {"rate^3*a + b*L^2", rate * rate * rate * a + b * (L * L)},
        {"a*(L - t)^2 + b*(L - t)^4", a * ((L - t) * (L - t)) + b * (((L - t) * (L - t)) * ((L - t) * (L - t)))},
        {"a*rate^2 + t", a * (rate * rate) + t},
        {"t + rate^3*b", t + rate * rate * rate * b},
        {"a*L - b*rate^2", a * L - b * (rate * rate)},
        {"a*L + a*L", a * L + a * L},
        {"a*L^2 + b*L^2", a * (L * L) + b * (L * L)},
        {"L*rate + rate*t", L * rate + rate * t},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        TinkerTypedLaw *law = typed(cases[i].text, "1.7", "0.3", &error);
        g_assert_no_error(error);
        assert_same_bits(tinker_compiled_value(law->value, at), cases[i].value);
        tinker_typed_free(law);
    }
}

#define MANY 203

/* Asked together and one by one: the same bits, with laws that are alike, that differ in a number, that differ, and
 * that are not there, in any order and number; and whole rows of few, which go a way of their own. */
static void test_many(void)
{
    static const char *const texts[] = {
        "a*(L - 1)^3 + b*L",
        "a*(L - 1)^3 + b*L",
        "a*L^2 + b*rate*t + a",
        "a*L^2.5 - exp(-b*rate)/t",
        "if(L < 1, a, b)*sqrt(L) + floor(3*L)",
        "a - b*L",
        "a",
        "L",
        "abs(rate)*L - mod(t, 2) + atan2(L, rate) + max(L, b)",
    };
    for (int round = 0; round < 120; round++) {
        TinkerTypedLaw *laws[2 * MANY] = {NULL};
        double columns[3][MANY];
        const gboolean row = round >= 60;
        const int count = g_test_rand_int_range(1, row ? 80 : MANY + 1),
                  kinds = g_test_rand_int_range(1, G_N_ELEMENTS(texts) + 1);
        for (int i = 0; i < count; i++) {
            g_autofree char *a = g_strdup_printf("%.17g", g_test_rand_double_range(0.5, 3));
            const char *text =
                texts[row || g_test_rand_int_range(0, 100) < 93 ? round % kinds : g_test_rand_int_range(0, kinds)];
            g_autoptr(GError) error = NULL;
            if (row || g_test_rand_int_range(0, 40) > 0)
                laws[2 * i] = typed(text, round % 3 == 0 ? "2" : a, "0.3", &error);
            g_assert_no_error(error);
            for (int k = 0; k < 3; k++)
                columns[k][i] = g_test_rand_double_range(0.1, 2);
        }
        tinker_typed_join(laws, 2, count);
        const gboolean uniform = round % 2 == 0;
        const double *const whole[] = {columns[0], columns[1], uniform ? NULL : columns[2]}, alike[] = {0, 0, 0.7};
        const int first = row ? 0 : g_test_rand_int_range(0, count); /* part of a row */
        const double *const shifted[] = {whole[0] + first, whole[1] + first, uniform ? NULL : whole[2] + first};
        const TinkerTypedQuestion question = {(const TinkerTypedLaw *const *)laws + 2 * first, 2, count - first,
                                              shifted, alike};
        double values[MANY], slopes[MANY], curvatures[MANY];
        for (int i = 0; i < MANY; i++)
            values[i] = slopes[i] = curvatures[i] = -7;
        tinker_typed_ask(&question, -1, -1, values);
        tinker_typed_ask(&question, 0, -1, slopes);
        tinker_typed_ask(&question, 0, 1, curvatures);
        for (int i = 0; i < MANY; i++) {
            const TinkerTypedLaw *law = first + i < count ? laws[2 * (first + i)] : NULL;
            const double at[] = {columns[0][(first + i) % MANY], columns[1][(first + i) % MANY],
                                 uniform ? alike[2] : columns[2][(first + i) % MANY]};
            assert_same_bits(values[i], law != NULL ? tinker_compiled_value(law->value, at) : -7);
            assert_same_bits(slopes[i], law != NULL ? tinker_compiled_value(law->slopes[0], at) : -7);
            assert_same_bits(curvatures[i], law != NULL ? tinker_compiled_value(law->curvatures[1], at) : -7);
        }
        for (int i = 0; i < count; i++)
            tinker_typed_free(laws[2 * i]);
    }
}

/* One law at many places. */
static void test_many_places(void)
{
    g_autoptr(GError) error = NULL;
    const TinkerTypedLaw *law = typed("a*(L - 1)^3 + b*rate*sin(t)", "2", "0.3", &error);
    g_assert_no_error(error);
    double lengths[MANY], rates[MANY], values[MANY];
    for (int i = 0; i < MANY; i++) {
        lengths[i] = 0.1 + 0.01 * i;
        rates[i] = cos(i);
    }
    const double *const asked[] = {lengths, rates, NULL}, uniform[] = {0, 0, 0.9};
    for (int count = 1; count <= MANY; count++) {
        const TinkerTypedQuestion question = {&law, 0, count, asked, uniform};
        tinker_typed_ask(&question, -1, -1, values);
        for (int i = 0; i < count; i++) {
            const double at[] = {lengths[i], rates[i], 0.9};
            assert_same_bits(values[i], tinker_compiled_value(law->value, at));
        }
    }
    tinker_typed_free((TinkerTypedLaw *)law);
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

static double stored(const char *law, double length)
{
    g_autoptr(GError) error = NULL;
    TinkerTypedLaw *laws[] = {typed(law, "3 N", "2", &error)};
    const TinkerBlockClass block_class = {.property_count = 3, .properties = properties};
    g_assert_no_error(error);
    tinker_typed_set_energies(&block_class, laws);
    const double at[] = {length, -0.4, 0.9}, energy = tinker_typed_stored(laws[0], at);
    g_assert_true(tinker_typed_stores(laws[0]) == !isnan(energy));
    tinker_typed_free(laws[0]);
    return energy;
}

/* The energy between two lengths is the integral of the tension at rest, whether the grammar has it or not: that of
 * exp(-L^2) is an error function, that of sin(L)/L by its series. */
static void test_stored(void)
{
    const double a = 0.3, b = 2.5;
    assert_near(stored("a*L^2 + rate", b) - stored("a*L^2 + rate", a), pow(b, 3) - pow(a, 3));
    assert_near(stored("a*exp(-L^2) + rate", b) - stored("a*exp(-L^2) + rate", a),
                1.5 * sqrt(G_PI) * (erf(b) - erf(a)));
    double sum = 0, up = b, down = a;
    for (int n = 1; n < 40; n += 2, up *= -b * b / (n * (n - 1)), down *= -a * a / (n * (n - 1)))
        sum += (up - down) / n;
    assert_near(stored("sin(L)/L", b) - stored("sin(L)/L", a), sum);
    g_assert_true(isnan(stored("exp(-L^2)*sin(t)", b)));
    g_assert_true(isnan(stored("exp(-L^2)*sqrt(b - L)", a))); /* of longer ones it is no number */
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/law/typed/values", test_values);
    g_test_add_func("/law/typed/functions", test_functions);
    g_test_add_func("/law/typed/powers", test_powers);
    g_test_add_func("/law/typed/sums", test_sums);
    g_test_add_func("/law/typed/many", test_many);
    g_test_add_func("/law/typed/many-places", test_many_places);
    g_test_add_func("/law/typed/refused", test_refused);
    g_test_add_func("/law/typed/stored", test_stored);
    g_test_add_func("/law/typed/random-texts", test_random_texts);
    return g_test_run();
}
