/* Simplified expressions: as textbooks have them, and at random places worth what they are made from. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "law/build.h"
#include "law/derivative.h"
#include "law/simplify.h"
#include "law/typeset.h"
#include "law/value.h"

static const char *const names[] = {"x", "y", "a", "b", "c", "m", "L", NULL};

static TinkerExpression *parse(const char *text)
{
    g_autoptr(GError) error = NULL;
    TinkerExpression *expression = tinker_expression_parse(text, names, &error);
    g_assert_no_error(error);
    return expression;
}

static void look_of(const char *symbol, TinkerSymbolLook *look, void *data)
{
    *look = (TinkerSymbolLook){.stem = symbol, .index = ""};
}

/* Values in the order of the names. */
static double value_of(const char *symbol, void *data)
{
    for (int i = 0; names[i] != NULL; i++)
        if (strcmp(symbol, names[i]) == 0) return ((const double *)data)[i];
    g_error("no value of %s", symbol);
    return NAN;
}

/* Minus the slope of a potential, and what books have. */
static void test_as_in_books(void)
{
    static const struct {
        const char *potential, *by, *force;
    } laws[] = {
        {"-a*m/sqrt(x^2 + y^2)", "x", "−a m x / (x² + y²)^(3 / 2)"}, /* Kepler */
        {"-a*x^2/2 + b*x^4/4", "x", "a x − b x³"},                   /* Duffing */
        {"-a*cos(b*x)*cos(b*y)", "y", "−a b cos(b x) sin(b y)"},     /* an egg box */
        {"a*(1 - cos(b*x))", "x", "−a b sin(b x)"},                  /* a pendulum, a lattice */
        {"-a/L^2", "L", "−2 a / L³"},
        {"a*((b/L)^12 - 2*(b/L)^6)", "L", "−12 a (b⁶ / L⁷ − b^12 / L^13)"},                 /* Lennard-Jones */
        {"(x^2 + y^2)/2 + x^2*y - y^3/3", "y", "−y − x² + y²"},                             /* Hénon–Heiles */
        {"a*(1 - exp(-b*(L - c)))^2", "L", "−2 a b (1 − exp(−b (L − c))) exp(−b (L − c))"}, /* Morse */
        {"-a*exp(-x^2/(2*b^2))", "x", "−a x exp(−x² / (2 b²)) / b²"},                       /* a Gaussian trap */
        {"a*x^2/4 + a*x^2/4", "x", "−a x"},
        {"if(x < 0, a*x^2/2, b*x^2/2)", "x", "−(a x if x < 0, else b x)"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autoptr(TinkerExpression) potential = parse(laws[i].potential);
        g_autoptr(TinkerExpression) force =
            tinker_expression_negated(tinker_expression_derivative_by(potential, laws[i].by));
        g_autoptr(TinkerExpression) simple = tinker_expression_simplified(force);
        g_autofree char *text = tinker_expression_typeset(simple, TINKER_TYPESET_TEXT, look_of, NULL);
        g_assert_cmpstr(text, ==, laws[i].force);
    }
}

/* What is no rule of real numbers is not used. */
static void test_left_alone(void)
{
    static const char *const cases[][2] = {
        {"sqrt(x^2)", "√(x²)"},
        {"(x^2)^0.5", "√(x²)"},
        {"x/0", "x / 0"},
        {"sqrt(x)*sqrt(y)", "√(x) √(y)"},
        {"sin(x)^2 + cos(x)^2", "sin(x)² + cos(x)²"},
        {"abs(x)*abs(x)", "|x|²"},
        {"x^y*x", "x x^y"},
        {"if(x - x < y, 1, 2)", "(1 if x − x < y, else 2)"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TinkerExpression) given = parse(cases[i][0]), simple = tinker_expression_simplified(given);
        g_autofree char *text = tinker_expression_typeset(simple, TINKER_TYPESET_TEXT, look_of, NULL);
        g_assert_cmpstr(text, ==, cases[i][1]);
    }
}

static TinkerExpression *random_tree(int depth)
{
    const int kind = depth == 0 ? g_test_rand_int_range(0, 2) : g_test_rand_int_range(0, 10);
    TinkerExpression *parts[3];
    if (kind == 0) return tinker_expression_number(g_test_rand_int_range(-4, 5));
    if (kind <= 1) return tinker_expression_symbol(names[g_test_rand_int_range(0, 7)]);
    const int count = kind <= 5 ? 2 : 1;
    for (int i = 0; i < count; i++)
        parts[i] = random_tree(depth - 1);
    switch (kind) {
    case 2:
    case 3:
        return tinker_expression_node(TINKER_EXPRESSION_SUM, NULL, parts, 2);
    case 4:
        return tinker_expression_node(TINKER_EXPRESSION_PRODUCT, NULL, parts, 2);
    case 5:
        return tinker_expression_node(TINKER_EXPRESSION_QUOTIENT, NULL, parts, 2);
    case 6:
        return tinker_expression_node(TINKER_EXPRESSION_NEGATIVE, NULL, parts, 1);
    case 7:
        parts[1] = tinker_expression_number(g_test_rand_int_range(-6, 7) / 2.0);
        return tinker_expression_node(TINKER_EXPRESSION_POWER, NULL, parts, 2);
    case 8:
        return tinker_expression_node(TINKER_EXPRESSION_FUNCTION, "sqrt", parts, 1);
    default:
        return tinker_expression_node(TINKER_EXPRESSION_FUNCTION, "cos", parts, 1);
    }
}

/* How far the value moves where the values of symbols do in their last digits. */
static double spread_of(const TinkerExpression *expression, const double *at, double value)
{
    double spread = DBL_EPSILON * fabs(value);
    for (int shake = 0; shake < 8; shake++) {
        double shaken[7];
        for (int i = 0; i < 7; i++)
            shaken[i] = at[i] * (1 + g_test_rand_double_range(-1, 1) * 8 * DBL_EPSILON);
        spread = fmax(spread, fabs(tinker_expression_value(expression, value_of, shaken) - value));
    }
    return spread;
}

/* Whether it is worth the same at a place; where one of them is no number there, nothing is said. */
static gboolean is_same_at(const TinkerExpression *given, const TinkerExpression *simple, const double *at)
{
    const double before = tinker_expression_value(given, value_of, (void *)at),
                 after = tinker_expression_value(simple, value_of, (void *)at);
    const double lost = spread_of(given, at, before) + spread_of(simple, at, after);
    /* what hangs on the last digits has no value to compare */
    if (!isfinite(before) || !isfinite(lost) || fabs(before) < 1e-60 || lost > 1e-6 * fabs(before)) return FALSE;
    if (fabs(after - before) <= 256 * lost) return TRUE;
    g_autofree char *text = tinker_expression_typeset(given, TINKER_TYPESET_TEXT, look_of, NULL);
    g_autofree char *found = tinker_expression_typeset(simple, TINKER_TYPESET_TEXT, look_of, NULL);
    g_error("%s is %.17g, and %s is %.17g", text, before, found, after);
    return FALSE;
}

static void test_worth_the_same(void)
{
    int compared = 0;
    for (int round = 0; round < 20000; round++) {
        g_autoptr(TinkerExpression) tree = random_tree(g_test_rand_int_range(1, 6));
        g_autoptr(TinkerExpression) slope = tinker_expression_derivative_by(tree, "x");
        g_autoptr(TinkerExpression) simple = tinker_expression_simplified(tree),
                                    simple_slope = tinker_expression_simplified(slope),
                                    again = tinker_expression_simplified(simple);
        for (int place = 0; place < 2; place++) {
            double at[7];
            for (int i = 0; i < 7; i++)
                at[i] = g_test_rand_double_range(place == 0 ? 0.2 : -3, 3);
            compared += is_same_at(tree, simple, at);
            compared += is_same_at(slope, simple_slope, at);
            compared += is_same_at(simple, again, at);
        }
    }
    g_assert_cmpint(compared, >, 20000);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/simplify/as-in-books", test_as_in_books);
    g_test_add_func("/simplify/left-alone", test_left_alone);
    g_test_add_func("/simplify/worth-the-same", test_worth_the_same);
    return g_test_run();
}
