/* Antiderivatives: their differences against those of antiderivatives from tables, written in C, over intervals that
 * cross what switches. */
#include <math.h>
#include <string.h>

#include "law/integral.h"
#include "law/value.h"

static const char *const names[] = {"x", "b", NULL};

#define B 0.7 /* the value of b */

static double value_of(const char *symbol, void *data)
{
    return strcmp(symbol, "x") == 0 ? *(const double *)data : B;
}

static TinkerExpression *integral_of(const char *text)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerExpression) integrand = tinker_expression_parse(text, names, &error);
    g_assert_no_error(error);
    return tinker_expression_integral(integrand, "x");
}

static double constant(double x)
{
    return 4 * x;
}
static double cubic(double x)
{
    return 3 * pow(x - B, 4) / 4 - (x - B) * (x - B);
}
static double product(double x)
{
    return pow(x, 5) / 5 - B * pow(x, 4) / 2 + B * B * pow(x, 3) / 3;
}
static double inverse(double x)
{
    return -1 / (2 * x * x);
}
static double logarithm(double x)
{
    return log(fabs(2 * x + B)) / 2;
}
static double geometric(double x)
{
    return sqrt(x * x + B * B);
}
static double kepler(double x)
{
    return -1 / sqrt(x * x + B);
}
static double gauss(double x)
{
    return -exp(-x * x / 2);
}
static double morse(double x)
{
    const double w = exp(-B * (x - 1));
    return -w / B + w * w / (2 * B);
}
static double lattice(double x)
{
    return -cos(B * x) / B;
}
static double saturated(double x)
{
    return log(cosh(3 * x)) / 3;
}
static double one_sided(double x)
{
    return x > 1 ? 2 * (x - 1) * (x - 1) : 0;
}
static double both_sides(double x)
{
    return x < 1 ? x * x / 2 - 0.5 : (x * x * x - 1) / 3;
}
static double absolute(double x)
{
    return fabs(x - 1) * (x - 1) / 2;
}
static double quotient(double x)
{
    return x - B * log(fabs(x));
}

static void test_tables(void)
{
    static const struct {
        const char *integrand;
        double (*table)(double x);
        double from, to;
    } cases[] = {
        {"4", constant, -2, 3},
        {"3*(x - b)^3 - 2*(x - b)", cubic, -2, 3},
        {"x^2*(x - b)^2", product, -2, 3},
        {"1/x^3", inverse, 0.5, 4},
        {"1/(2*x + b)", logarithm, 0.5, 4},
        {"x/sqrt(x^2 + b^2)", geometric, -2, 3},
        {"x/(x^2 + b)^1.5", kepler, -2, 3},
        {"x/sqrt(x^2 + b)^3", kepler, -2, 3},
        {"x*exp(-x^2/2)", gauss, -2, 3},
        {"(1 - exp(-b*(x - 1)))*exp(-b*(x - 1))", morse, -2, 3},
        {"sin(b*x)", lattice, -2, 3},
        {"tanh(3*x)", saturated, -2, 3},
        {"4*max(x - 1, 0)", one_sided, -2, 3},
        {"4*ramp(x - 1)", one_sided, -2, 3},
        {"-4*min(1 - x, 0)", one_sided, -2, 3},
        {"if(x > 1, 4*(x - 1), 0)", one_sided, -2, 3},
        {"if(1 < x, 4*(x - 1), 0)", one_sided, -2, 3},
        {"if(x < 1, x, x^2)", both_sides, -2, 3},
        {"abs(x - 1)", absolute, -2, 3},
        {"(x - b)/x", quotient, 0.5, 4},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TinkerExpression) found = integral_of(cases[i].integrand);
        if (found == NULL) g_error("%s has no antiderivative", cases[i].integrand);
        for (int k = 1; k <= 10; k++) {
            double from = cases[i].from, to = from + (cases[i].to - from) * k / 10;
            const double given =
                tinker_expression_value(found, value_of, &to) - tinker_expression_value(found, value_of, &from);
            const double expected = cases[i].table(to) - cases[i].table(from);
            if (!(fabs(given - expected) <= 1e-13 * (1 + fabs(expected) + fabs(cases[i].table(from)))))
                g_error("%s from %g to %g: %.17g, not %.17g", cases[i].integrand, from, to, given, expected);
        }
    }
}

/* None is told rather than a wrong one. */
static void test_not_found(void)
{
    static const char *const cases[] = {"exp(-x^2)", "sin(x)/x", "sqrt(1 + x^3)",       "x^x",
                                        "x^(b/2)",   "floor(x)", "if(sin(x) > 0, 1, 2)"};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        g_assert_null(integral_of(cases[i]));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/integral/tables", test_tables);
    g_test_add_func("/integral/not-found", test_not_found);
    return g_test_run();
}
