/* Formulas of notes: what becomes of names, and of what is none. */
#include <string.h>

#include "law/written-formula.h"

static void test_mathml(void)
{
    static const struct {
        const char *text, *mathml;
    } cases[] = {
        {"x", "<mrow><mi>x</mi></mrow>"},
        {"omega_0 = 5", "<mrow><msub><mi>ω</mi><mrow><mn>0</mn></mrow></msub></mrow><mo>=</mo><mrow><mn>5</mn></mrow>"},
        {"Delta_max", "<mrow><msub><mi>Δ</mi><mrow><mi>max</mi></mrow></msub></mrow>"},
        {"theta1", "<mrow><msub><mi>θ</mi><mrow><mn>1</mn></mrow></msub></mrow>"},
        {"alphabet", "<mrow><mi>alphabet</mi></mrow>"},
        {"a/b", "<mrow><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac></mrow>"},
        {"sqrt(k)", "<mrow><msqrt><mrow><mi>k</mi></mrow></msqrt></mrow>"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *mathml = tinker_written_formula_mathml(cases[i].text, &error);
        g_assert_no_error(error);
        g_assert_cmpstr(mathml, ==, cases[i].mathml);
    }
}

static void test_mistakes(void)
{
    static const char *const bad[] = {"", "F =", "= 3", "a +", "(a", "foo(3)", "a $ b", "x = 3 = "};
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_written_formula_mathml(bad[i], &error));
        g_assert_nonnull(error);
    }
    g_autofree char *chain = tinker_written_formula_mathml("a = b = c >= d", NULL);
    g_assert_nonnull(chain);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/law/written-formula/mathml", test_mathml);
    g_test_add_func("/law/written-formula/mistakes", test_mistakes);
    return g_test_run();
}
