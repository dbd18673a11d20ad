/* Waveforms as sums of polynomials and harmonics: the sum is the waveform itself, everywhere in the piece. */
#include "evaluator-helper.h"

#include <math.h>

static double sum_at(const TinkerSignal *signals, int count, double t)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        const double *c = signals[i].coefficient, since = t - signals[i].origin;
        if (signals[i].kind == TINKER_SIGNAL_POLYNOMIAL)
            sum += c[0] + since * (c[1] + since * (c[2] + since * c[3]));
        else
            sum += c[0] * sin(c[1] * since + c[2]);
    }
    return sum;
}

/* In the piece around `inside`, about both ends of the range that is looked at. */
static void assert_form(TinkerWaveformEvaluator *evaluator, double inside, double low, double high)
{
    TinkerSignal signals[16];
    int count = tinker_waveform_signals(evaluator);
    g_assert_cmpint(count, >=, 1);
    g_assert_cmpint(count, <=, (int)G_N_ELEMENTS(signals));
    tinker_waveform_enter_piece(evaluator, inside);
    for (int end = 0; end < 2; end++) {
        tinker_waveform_form(evaluator, end == 0 ? low : high, signals);
        for (int i = 0; i <= 20; i++) {
            double t = low + (high - low) * i / 20, value[3];
            tinker_waveform_evaluate(evaluator, t, value);
            g_assert_cmpfloat_with_epsilon(sum_at(signals, count, t), value[0], 1e-12 * (1 + fabs(value[0])));
        }
    }
}

static void test_expressions(void)
{
    static const struct {
        const char *text;
        double inside, low, high;
    } cases[] = {
        {"3", 0.5, 0, 1},
        {"2 - 3*t + t^2/4 - 0.1*t^3", 0.5, 0, 5},
        {"1000*(1-cos(2*pi*t))", 0.5, 0, 3},
        {"5*sin(3*t+1) + 2*cos(t/2) - t", 0.5, 0, 10},
        {"sin(2*t)*cos(3*t)", 0.5, 0, 10},
        {"sin(t)^2", 0.5, 0, 10},
        {"cos(t)^3 - sin(5*t)", 0.5, 0, 10},
        {"(1 + sin(t))*(2 - cos(t))", 0.5, 0, 10},
        {"5*square(3*t) + t", 0.5, 0, 1},
        {"sawtooth(t)*4", 0.25, 0.01, 0.49},
        {"if(t < 1, sin(t), 3*t^2)", 0.5, 0, 1},
        {"if(t < 1, sin(t), 3*t^2)", 1.5, 1, 9},
        {"50*sin(pi*t/0.1)*(1-step(t-0.1))", 0.05, 0, 0.1},
        {"50*sin(pi*t/0.1)*(1-step(t-0.1))", 0.5, 0.1, 1},
        {"sqrt(2)*exp(1)*t", 0.5, 0, 1},
        {"-abs(t-2)", 0.5, 0, 2},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(cases[i].text);
        g_test_message("%s", cases[i].text);
        assert_form(evaluator, cases[i].inside, cases[i].low, cases[i].high);
    }
}

static void test_without_form(void)
{
    static const char *const texts[] = {
        "exp(-t)", "sin(t^2)",  "t*sin(t)", "t^4",
        "1/(1+t)", "sqrt(t+1)", "tanh(t)",  "sin(t)*sin(2*t)*sin(3*t)*sin(4*t)*sin(5*t)"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(texts[i]);
        g_test_message("%s", texts[i]);
        g_assert_cmpint(tinker_waveform_signals(evaluator), ==, 0);
    }
}

static void test_harmonic(void)
{
    g_autoptr(TinkerWaveform) cosine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_COSINE);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(cosine, 3, 2, 0.7, FALSE);
    assert_form(evaluator, 1, 0, 20);
}

/* Every piece of tables of values, linear and as a spline, and of an acceleration. */
static void test_tables(void)
{
    static const double times[] = {1, 1.5, 1.52, 4}, values[] = {0, 2, -1, 3}, pieces[] = {0, 1, 1.5, 1.52, 4, 6};
    for (int kind = 0; kind < 3; kind++) {
        TinkerTableKind of = kind == 2 ? TINKER_TABLE_ACCELERATION : TINKER_TABLE_VALUE;
        g_autoptr(TinkerWaveform) table = tinker_waveform_new_table(times, values, 4, of, NULL);
        g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(table, 1, 0, 0, kind == 1);
        for (gsize i = 0; i + 1 < G_N_ELEMENTS(pieces); i++)
            assert_form(evaluator, 0.5 * (pieces[i] + pieces[i + 1]), pieces[i], pieces[i + 1]);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/forms/expressions", test_expressions);
    g_test_add_func("/forms/without-form", test_without_form);
    g_test_add_func("/forms/harmonic", test_harmonic);
    g_test_add_func("/forms/tables", test_tables);
    return g_test_run();
}
