/* Breaks: found where they are by pencil and paper, each once, and always in bounded time. */
#include <math.h>

#include "evaluator-helper.h"

/* All breaks in (from, horizon] are the expected ones, to `ulps`. */
static void assert_breaks(const char *text, double from, double horizon, const double *expected, int count, int ulps)
{
    g_test_message("%s", text);
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(text);
    double t = from;
    for (int i = 0; i < count; i++) {
        t = tinker_waveform_next_break(evaluator, t, horizon);
        const double ulp = nextafter(fabs(expected[i]), INFINITY) - fabs(expected[i]);
        g_assert_cmpfloat(fabs(t - expected[i]), <=, ulps * ulp);
    }
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, t, horizon), ==, INFINITY);
}

static void test_affine(void)
{
    assert_breaks("pulse(t, 5, 5.01)", 0, INFINITY, (double[]){5, 5.01}, 2, 0);
    assert_breaks("step(t - 0.3)", 0, 10, (double[]){0.3}, 1, 0);
    assert_breaks("step(t - 0.3)", 0.3, 10, NULL, 0, 0);
    assert_breaks("step(t - 3)", 0, 3, (double[]){3}, 1, 0);
    assert_breaks("step(t - 3)", 0, 2.99, NULL, 0, 0);
    assert_breaks("square(10*t)", 0, 1, (double[]){G_PI / 10, G_PI / 5, 3 * G_PI / 10}, 3, 1);
    assert_breaks("sawtooth(pi*t)", 0, 6.5, (double[]){2, 4, 6}, 3, 1);
    assert_breaks("floor(2*t)", 0.5, 2, (double[]){1, 1.5, 2}, 3, 0);
    assert_breaks("floor(-2*t)", 0.5, 2, (double[]){1, 1.5, 2}, 3, 0);
    assert_breaks("mod(t, 0.01)", 4.985, 5.015, (double[]){4.99, 5, 5.01}, 3, 1);
    assert_breaks("mod(t, -0.5)", 0, 1.2, (double[]){0.5, 1}, 2, 0);
    assert_breaks("floor(t)", -1.5, 0.5, (double[]){-1, 0}, 2, 0);
    assert_breaks("min(t, 2) + abs(3 - t) + ramp(t - 4)", 0, 9, (double[]){2, 3, 4}, 3, 0);
    assert_breaks("step(floor(t) - 1.5)*(mod(t, 4) > 3)", 0, 3.5, (double[]){1, 2, 3}, 3, 0);
    assert_breaks("abs(mod(t, 2) - 0.5)", 0, 4, (double[]){0.5, 2, 2.5, 4}, 4, 0);
    /* an angle that stands still below the cut: atan2(-1, -1) is -3/4 pi */
    assert_breaks("step(t - 3 - atan2(-step(t + 1), -1))", 0, 2, (double[]){3 - 0.75 * G_PI}, 1, 1);
}

static void test_curved(void)
{
    assert_breaks("t^2 - 2 > 0", 0, 100, (double[]){G_SQRT2}, 1, 4);
    assert_breaks("t*t < 2", 0, INFINITY, (double[]){G_SQRT2}, 1, 4);
    assert_breaks("sin(t) > 0", 0, 10, (double[]){G_PI, 2 * G_PI, 3 * G_PI}, 3, 4);
    assert_breaks("abs(cos(3*t))", 0, 2, (double[]){G_PI / 6, G_PI / 2}, 2, 4);
    assert_breaks("floor(exp(t))", 0, 1.5, (double[]){log(2), log(3), log(4)}, 3, 4);
    assert_breaks("floor(t^2)", 0, 2, (double[]){1, G_SQRT2, sqrt(3), 2}, 4, 4);
    assert_breaks("if(sin(t) > 0.5, 1, 2)", 0, 6, (double[]){G_PI / 6, 5 * G_PI / 6}, 2, 4);
    assert_breaks("sqrt(t - 5) > 1", 0, 50, (double[]){5, 6}, 2, 4);
    assert_breaks("atan2(sin(t), cos(t))", 1, 7, (double[]){G_PI, 2 * G_PI}, 2, 4);
    /* a pole changes sides too */
    assert_breaks("tan(t) > 1", 0, 4, (double[]){G_PI / 4, G_PI / 2, 5 * G_PI / 4}, 3, 4);
    assert_breaks("1/(t^2 - 2) > 0", 0, 4, (double[]){G_SQRT2}, 1, 4);
    /* a pulse of a microsecond in a hundred seconds: the level is only just exceeded */
    const double half = acos(1 - 1e-12);
    g_autoptr(TinkerWaveformEvaluator) narrow = evaluator_of("cos(t) > 1 - 1e-12");
    const double first = tinker_waveform_next_break(narrow, 1, 7);
    g_assert_cmpfloat_with_epsilon(first, 2 * G_PI - half, 1e-9);
    g_assert_cmpfloat_with_epsilon(tinker_waveform_next_break(narrow, first, 7), 2 * G_PI + half, 1e-9);
}

static void test_nested(void)
{
    /* between 1 and 3 the inner comparison counts, elsewhere not */
    assert_breaks("if((t > 1)*(t < 3), t^2 > 4, 0)", 0, 10, (double[]){1, 2, 3}, 3, 4);
    assert_breaks("if(t < 5, if(t < 2, 1, t), floor(t))", 0, 7, (double[]){2, 5, 6, 7}, 4, 0);
    /* what would switch a million times a second in the branch that is not taken, does not */
    assert_breaks("if(t < 5, sin(t), floor(1e6*t))", 0, 4.9, NULL, 0, 0);
    assert_breaks("if(0, floor(1e6*t), t)", 0, 4.9, NULL, 0, 0);
}

/* Functions that touch a level, or are it but for rounding, do not cross it. */
static void test_no_break(void)
{
    assert_breaks("(t - 1)^2 > 0", 0, 10, NULL, 0, 0);
    assert_breaks("t^2 - 2*t + 1 < 0", 0, 10, NULL, 0, 0);
    assert_breaks("sin(t)^2 + cos(t)^2 - 1 > 0", 0, 10, NULL, 0, 0);
    assert_breaks("sin(t) > 2", 0, 1e6, NULL, 0, 0);
    assert_breaks("t == 5", 0, 10, NULL, 0, 0);
    assert_breaks("log(-1 - t) > 0", 0, 10, NULL, 0, 0);
    assert_breaks("exp(t)*sin(t)", 0, 10, NULL, 0, 0);
    /* in powers, all but lost in rounding about 1: one break, not a swarm */
    g_autoptr(TinkerWaveformEvaluator) flat = evaluator_of("t^3 - 3*t^2 + 3*t - 1 > 0");
    const double found = tinker_waveform_next_break(flat, 0, 10);
    g_assert_cmpfloat_with_epsilon(found, 1, 2e-5);
    g_assert_cmpfloat(tinker_waveform_next_break(flat, found, 10), ==, INFINITY);
}

/* Hostile arguments: whatever is answered, it comes, and lies where it may. */
static void test_bounded(void)
{
    static const char *const texts[] = {"floor(1e300*t)",
                                        "sin(1/t) > 0",
                                        "sin(1e9*t^2) > 0.5",
                                        "tan(1e5*t) > 0",
                                        "floor(exp(exp(t)))",
                                        "(1/0)*t > 0",
                                        "0/0 > t",
                                        "log(t - 5) + (-1)^t > 0",
                                        "floor(t^t^t)",
                                        "square(exp(50*t))",
                                        "sqrt(-t^2) > 0",
                                        "(sin(t)^2 + cos(t)^2 - 1)*1e10 + 1e-7*floor(t*1e8) > 0",
                                        "mod(t, 0)",
                                        "atan2(0*t, -1)",
                                        "floor(1e18*sin(t))",
                                        "exp(1000*t) - exp(1000*t) > 0",
                                        "mod(t, sin(t)*1e-9)"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_test_message("%s", texts[i]);
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(texts[i]);
        double t = 0;
        for (int j = 0; j < 3 && t < 10; j++) {
            double result[3];
            const double next = tinker_waveform_next_break(evaluator, t, 10);
            g_assert_true(next > t);
            g_assert_true(next <= 10 || next == INFINITY);
            tinker_waveform_enter_piece(evaluator, t);
            tinker_waveform_evaluate(evaluator, t, result);
            t = next;
        }
        g_assert_true(tinker_waveform_next_break(evaluator, 0, INFINITY) > 0);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/breaks/affine", test_affine);
    g_test_add_func("/breaks/curved", test_curved);
    g_test_add_func("/breaks/nested", test_nested);
    g_test_add_func("/breaks/no-break", test_no_break);
    g_test_add_func("/breaks/bounded", test_bounded);
    return g_test_run();
}
