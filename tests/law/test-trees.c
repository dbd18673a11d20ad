/* Trees of expressions: their derivatives against derivatives worked out by hand and written in C, their dimensions
 * against those of textbook laws, and their values against the C library. */
#include <math.h>
#include <string.h>

#include "law/build.h"
#include "law/collect.h"
#include "law/derivative.h"
#include "law/dimension.h"
#include "law/reduce.h"
#include "law/typeset.h"
#include "law/value.h"

static const char *const names[] = {"x", "y", "k", "m", "v", "L", NULL};

static TinkerExpression *parse(const char *text)
{
    g_autoptr(GError) error = NULL;
    TinkerExpression *expression = tinker_expression_parse(text, names, &error);
    g_assert_no_error(error);
    return expression;
}

/* x and y; k is 3. */
static double value_of(const char *symbol, void *data)
{
    const double *at = data;
    if (strcmp(symbol, "x") == 0) return at[0];
    if (strcmp(symbol, "y") == 0) return at[1];
    g_assert_cmpstr(symbol, ==, "k");
    return 3;
}

typedef double (*Function)(double x, double y);

static double product(double x, double y)
{
    return 3 * y * cos(x) - 3 * x * y * sin(x);
}
static double quotient(double x, double y)
{
    return (1 * (x * x + y) - x * 2 * x) / ((x * x + y) * (x * x + y));
}
static double root(double x, double y)
{
    return x / sqrt(x * x + y * y);
}
static double power(double x, double y)
{
    return pow(x, y) * y / x;
}
static double exponent(double x, double y)
{
    return pow(y, x) * log(y);
}
static double angle(double x, double y)
{
    return -y / (x * x + y * y);
}
static double chain(double x, double y)
{
    return exp(-x * x) * -2 * x * tanh(y * x) + exp(-x * x) * y / (cosh(y * x) * cosh(y * x));
}
static double inverse(double x, double y)
{
    return 0.1 / sqrt(1 - 0.01 * x * x) - 0.1 / sqrt(1 - 0.01 * x * x) + y / (1 + x * x * y * y);
}
static double pieces(double x, double y)
{
    return (x < 0 ? -1 : 1) + (x > y ? 1 : 0) + (x < y ? 2 * x : 0) + 1;
}

static const struct {
    const char *text;
    Function derivative;
} derivatives[] = {
    {"k*x*y*cos(x)", product},
    {"x/(x^2 + y)", quotient},
    {"sqrt(x^2 + y^2)", root},
    {"x^y", power},
    {"y^x", exponent},
    {"atan2(y, x)", angle},
    {"exp(-x^2)*tanh(y*x)", chain},
    {"asin(x/10) + acos(x/10) + atan(x*y)", inverse},
    {"abs(x) + max(x, y) + if(x < y, x^2, y) + step(x) + floor(x) + mod(x, 7)", pieces},
};

static void test_derivatives(void)
{
    static const double states[][2] = {{0.7, 1.3}, {2.3, 0.4}, {1.9, 1.1}, {0.2, 2.6}};
    for (gsize i = 0; i < G_N_ELEMENTS(derivatives); i++) {
        g_autoptr(TinkerExpression) expression = parse(derivatives[i].text);
        g_autoptr(TinkerExpression) derivative = tinker_expression_derivative_by(expression, "x");
        for (gsize s = 0; s < G_N_ELEMENTS(states); s++) {
            const double expected = derivatives[i].derivative(states[s][0], states[s][1]);
            const double found = tinker_expression_value(derivative, value_of, (void *)states[s]);
            g_assert_cmpfloat(fabs(found - expected), <=, 1e-13 * (1 + fabs(expected)));
        }
    }
}

static void test_tidied(void)
{
    g_autoptr(TinkerExpression) expression = parse("k*(L - x) + m*v");
    g_autoptr(TinkerExpression) by_x = tinker_expression_derivative_by(expression, "x");
    g_autoptr(TinkerExpression) by_y = tinker_expression_derivative_by(expression, "y");
    g_assert_cmpint(by_x->kind, ==, TINKER_EXPRESSION_NEGATIVE);
    g_assert_cmpstr(by_x->parts[0]->name, ==, "k");
    g_assert_true(tinker_expression_is_number(by_y, 0));
    g_assert_true(tinker_expression_uses(expression, "v"));
    g_assert_false(tinker_expression_uses(expression, "t"));
}

static void test_values(void)
{
    const double at[] = {0.6, -2.5};
    static const struct {
        const char *text;
        double value;
    } cases[] = {{"2*x - y/x - 1", 2 * 0.6 + 2.5 / 0.6 - 1},
                 {"-x^2^2 + mod(y, 2)", -0.6 * 0.6 * 0.6 * 0.6 + 1.5},
                 {"sqrt(2) + pi", 1.41421356237309505 + 3.14159265358979324},
                 {"pulse(x, 0, 1) + step(y) + ramp(x) + square(x) + sawtooth(pi)", 1 + 0 + 0.6 + 1 + 0},
                 {"if(x < y, 1/0, max(x, y) - min(x, y)) + abs(y)", 0.6 + 2.5 + 2.5},
                 {"(x <= x) + (x >= y)*2 + (x == x)*4 + (x != x)*8 + (y > x)*16", 7},
                 {"atan2(y, x) + log(exp(x)) + sinh(x) - cosh(x)", -1.3352513460740334 + 0.6 - 0.5488116360940264}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TinkerExpression) expression = parse(cases[i].text);
        const double found = tinker_expression_value(expression, value_of, (void *)at);
        g_assert_cmpfloat(fabs(found - cases[i].value), <=, 4e-15 * (1 + fabs(found)));
    }
}

/* (transfer full) */
static char *nested(const char *step, int count, const char *end)
{
    GString *text = g_string_new(NULL);
    for (int i = 0; i < count; i++)
        g_string_append(text, step);
    g_string_append(text, end);
    return g_string_free(text, FALSE);
}

/* Long sums and products are flat; what is deep is refused, not read until the stack ends. */
static void test_limits(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *sum = nested("x + ", 5000, "y"), *quotient_text = nested("x/", 5000, "y");
    g_autoptr(TinkerExpression) flat = parse(sum);
    g_assert_cmpint(flat->count, ==, 5001);
    g_assert_cmpint(flat->depth, ==, 1);
    g_assert_null(tinker_expression_parse(quotient_text, names, &error));
    g_assert_nonnull(strstr(error->message, "too long"));
    g_clear_error(&error);
    g_assert_null(tinker_expression_parse("x + vv", names, &error));
    g_assert_nonnull(strstr(error->message, "column 5: unknown name \"vv\"; did you mean \"v\"?"));
}

static gboolean dimension_of(const char *symbol, TinkerDimension *dimension, G_GNUC_UNUSED void *data)
{
    static const struct {
        const char *symbol;
        TinkerDimension dimension;
    } known[] = {{"x", {0, 1, 0, 0}}, {"y", {0, 1, 0, 0}},  {"k", {1, 0, -2, 0}}, {"m", {1, 0, 0, 0}},
                 {"t", {0, 0, 1, 0}}, {"v", {0, 1, -1, 0}}, {"L", {0, 1, 0, 0}}};
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++)
        if (strcmp(known[i].symbol, symbol) == 0) *dimension = known[i].dimension;
    return TRUE;
}

static void test_dimensions(void)
{
    static const struct {
        const char *text, *dimension; /* or the message */
    } cases[] = {
        {"k*(x - L)", "N"},
        {"k*(x - L)^2/2 + m*v^2/2", "J"},
        {"sqrt(k/m)*t", "1"},
        {"v/t", "m/s^2"},
        {"sin(x/L)*cos(2*pi)", "1"},
        {"0", "0"},
        {"0 + x", "m"},
        {"if(t < 2*t, x, 0)", "m"},
        {"atan2(y, x)", "1"},
        {"x + t", "a sum of m and s"},
        {"sin(x)", "sin of m and 1"},
        {"x^t", "an exponent of s and 1"},
        {"max(x, k)", "max of m and N/m"},
        {"1 + x", "a sum of 1 and m"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TinkerExpression) expression = parse(cases[i].text);
        g_autofree char *why = NULL, *text = NULL;
        TinkerLawDimension dimension;
        if (tinker_expression_dimension(expression, dimension_of, NULL, &dimension, &why))
            text = tinker_law_dimension_text(&dimension);
        g_assert_cmpstr(text != NULL ? text : why, ==, cases[i].dimension);
    }
}

static void look_of(const char *symbol, TinkerSymbolLook *look, void *data)
{
    *look = (TinkerSymbolLook){symbol, "", 0, NULL};
}

/* As one writes it by hand. */
static void test_lowest_terms(void)
{
    static const char *const pairs[][2] = {{"2*k*(x - y)/2", "k*(x - y)"},
                                           {"6*x/4", "3*x/2"},
                                           {"3*x^2/3", "x^2"},
                                           {"2*x/(6*y)", "x/(3*y)"},
                                           {"-(2*k*x)/2", "-(k*x)"},
                                           {"sin(4*x/2) + y", "sin(2*x) + y"},
                                           {"2/4", "1/2"},
                                           {"x/2", "x/2"},
                                           {"2.5*x/2", "2.5*x/2"},
                                           {"(2*x + y)/2", "(2*x + y)/2"}};
    for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++) {
        g_autoptr(TinkerExpression) long_form = parse(pairs[i][0]), expected = parse(pairs[i][1]);
        g_autoptr(TinkerExpression) reduced = tinker_expression_reduced(long_form);
        g_autofree char *found = tinker_expression_typeset(reduced, TINKER_TYPESET_TEXT, look_of, NULL);
        g_autofree char *wanted = tinker_expression_typeset(expected, TINKER_TYPESET_TEXT, look_of, NULL);
        g_assert_cmpstr(found, ==, wanted);
    }
}

static gboolean is_of_angle(const TinkerExpression *factor, void *data)
{
    return tinker_expression_uses(factor, "x") || tinker_expression_uses(factor, "v");
}

/* x is an angle, v its rate. Textbooks' terms of a double pendulum, of bars, and of a pivot that is shaken by y. */
static void test_collected(void)
{
    static const char *const pairs[][2] = {
        {"m*k*L*sin(x) + y*k*L*sin(x)", "(m + y)*k*L*sin(x)"},
        {"m*L^2*v + y*L^2*v + k*v", "((m + y)*L^2 + k)*v"},
        {"m*y*sin(x) + k*L*y*sin(x) + k*m*y*sin(x)", "(m + k*(L + m))*y*sin(x)"},
        {"m*k*L*sin(x) + m*y*L*sin(x)", "m*(k + y)*L*sin(x)"},
        {"-(m*k*sin(x)) - m*y*sin(x) + t*sin(x)", "-(m*(k + y) - t)*sin(x)"},
        {"m*L*sin(x) + m*L*cos(x)", "m*L*sin(x) + m*L*cos(x)"},
        {"k*y + m*L + k*sin(x)", "k*y + m*L + k*sin(x)"},
        {"m*L + m*y + k*y + t", "m*(L + y) + k*y + t"},
        {"m*k*sin(x) + m*k*sin(x)", "2*m*k*sin(x)"},
        {"m*L*v/k + y*v", "m*L*v/k + y*v"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++) {
        g_autoptr(TinkerExpression) long_form = parse(pairs[i][0]), expected = parse(pairs[i][1]);
        g_autoptr(TinkerExpression) shorter = tinker_expression_collected(long_form, is_of_angle, NULL);
        g_autofree char *found = tinker_expression_typeset(shorter, TINKER_TYPESET_TEXT, look_of, NULL);
        g_autofree char *wanted = tinker_expression_typeset(expected, TINKER_TYPESET_TEXT, look_of, NULL);
        g_assert_cmpstr(found, ==, wanted);
    }
}

/* Even powers have no sign below them. */
static void test_even_powers(void)
{
    TinkerExpression *x = tinker_expression_negated(parse("x"));
    g_autoptr(TinkerExpression) square = tinker_expression_squared(tinker_expression_ref(x)), plain = parse("x^2");
    g_autoptr(TinkerExpression) cube = tinker_expression_to_power(x, tinker_expression_number(3));
    g_assert_true(tinker_expression_equal(square, plain));
    g_assert_cmpint(cube->parts[0]->kind, ==, TINKER_EXPRESSION_NEGATIVE);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/law/lowest-terms", test_lowest_terms);
    g_test_add_func("/law/even-powers", test_even_powers);
    g_test_add_func("/law/collected", test_collected);
    g_test_add_func("/law/derivatives", test_derivatives);
    g_test_add_func("/law/tidied", test_tidied);
    g_test_add_func("/law/values", test_values);
    g_test_add_func("/law/limits", test_limits);
    g_test_add_func("/law/dimensions", test_dimensions);
    return g_test_run();
}
