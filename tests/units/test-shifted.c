/* Shifted waveforms: f(t + by), against the waveform itself at t + by and against shifts by pencil and paper. */
#include <math.h>
#include <string.h>

#include "evaluator-helper.h"

static const double shifts[] = {0.5, 1, 2.25, -0.75, 1.0 / 3, 97.1};

/* Value and derivatives of both at the same instant, seen from inside the same piece. */
static void assert_same(TinkerWaveformEvaluator *shifted, TinkerWaveformEvaluator *plain, double by, double inside,
                        double t)
{
    double value[3], truth[3];
    tinker_waveform_enter_piece(shifted, inside);
    tinker_waveform_enter_piece(plain, inside + by);
    tinker_waveform_evaluate(shifted, t, value);
    tinker_waveform_evaluate(plain, t + by, truth);
    for (int i = 0; i < 3; i++)
        g_assert_cmpfloat_with_epsilon(value[i], truth[i], 1e-13 * (1 + fabs(truth[i])) * (1 + fabs(by)));
}

/* In the form that a piece has, about a time that is not its origin. */
static void assert_form(TinkerWaveformEvaluator *shifted, TinkerWaveformEvaluator *plain, double by, double inside,
                        double t)
{
    TinkerSignal signals[16];
    int count = tinker_waveform_signals(shifted);
    g_assert_cmpint(count, ==, tinker_waveform_signals(plain));
    if (count == 0) return;
    double sum = 0, truth[3];
    tinker_waveform_enter_piece(shifted, inside);
    tinker_waveform_form(shifted, inside, signals);
    for (int i = 0; i < count; i++) {
        const double *c = signals[i].coefficient, since = t - signals[i].origin;
        sum += signals[i].kind == TINKER_SIGNAL_POLYNOMIAL ? c[0] + since * (c[1] + since * (c[2] + since * c[3]))
                                                           : c[0] * sin(c[1] * since + c[2]);
    }
    tinker_waveform_enter_piece(plain, inside + by);
    tinker_waveform_evaluate(plain, t + by, truth);
    g_assert_cmpfloat_with_epsilon(sum, truth[0], 1e-11 * (1 + fabs(truth[0])) * (1 + by * by));
}

/* All breaks of the waveform behind `by` are found, each once and `by` earlier; between them both are the same. */
static void assert_shifted(TinkerWaveform *waveform, double by, gboolean smooth)
{
    const double amplitude = 1.5, frequency = 3, phase = 0.4;
    g_autoptr(TinkerWaveform) later = tinker_waveform_shifted(waveform, by);
    g_autoptr(TinkerWaveformEvaluator) shifted =
        tinker_waveform_evaluator_new(later, amplitude, frequency, phase, smooth);
    g_autoptr(TinkerWaveformEvaluator) plain =
        tinker_waveform_evaluator_new(waveform, amplitude, frequency, phase, smooth);
    double t = 0, end = 6;
    for (int pieces = 0; t < end; pieces++) {
        g_assert_cmpint(pieces, <, 1000);
        double next = fmin(tinker_waveform_next_break(shifted, t, end), end);
        double expected = fmin(tinker_waveform_next_break(plain, t + by + 1e-12, end + by) - by, end);
        g_assert_cmpfloat_with_epsilon(next, expected, 1e-13 * (1 + fabs(by)));
        g_assert_cmpfloat(next, >, t);
        const double inside = t + 0.4 * (next - t);
        assert_same(shifted, plain, by, inside, t);
        assert_same(shifted, plain, by, inside, next);
        assert_form(shifted, plain, by, inside, t + 0.7 * (next - t));
        t = next;
    }
}

static void assert_all_shifts(TinkerWaveform *waveform, gboolean smooth)
{
    for (gsize i = 0; i < G_N_ELEMENTS(shifts); i++)
        assert_shifted(waveform, shifts[i], smooth);
}

static void test_harmonics(void)
{
    for (int kind = TINKER_WAVEFORM_NONE; kind <= TINKER_WAVEFORM_COSINE; kind++) {
        g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_harmonic((TinkerWaveformKind)kind);
        assert_all_shifts(waveform, FALSE);
    }
    /* a quarter of a period makes a sine a cosine */
    g_autoptr(TinkerWaveform) sine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_SINE);
    g_autoptr(TinkerWaveform) later = tinker_waveform_shifted(sine, G_PI / 8);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(later, 2, 4, 0, FALSE);
    double value[3];
    tinker_waveform_evaluate(evaluator, 0.3, value);
    g_assert_cmpfloat_with_epsilon(value[0], 2 * cos(1.2), 1e-15);
    g_assert_cmpfloat_with_epsilon(value[1], -8 * sin(1.2), 4e-15);
}

static void test_expressions(void)
{
    static const char *const texts[] = {
        "3",
        "t",
        "10*sin(2*t) - t^2/4",
        "pulse(t, 5, 5.01)",
        "square(3*t) + sawtooth(pi*t)",
        "if(t < 3, t, 2*cos(t))",
        "min(t, 2) + abs(3 - t) + ramp(t - 4)",
        "sin(t) > 0.5",
        "exp(-t/9)*tanh(t)*1e-1",
        "step(t^2 - 2)",
        "(1 + sin(t))*(2 - cos(t))",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_test_message("%s", texts[i]);
        g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(texts[i], NULL);
        assert_all_shifts(waveform, FALSE);
        /* what a file would hold is the same to the bit */
        g_autoptr(TinkerWaveform) shifted = tinker_waveform_shifted(waveform, 1.0 / 3);
        g_autoptr(TinkerWaveformEvaluator) one = tinker_waveform_evaluator_new(shifted, 1, 1, 0, FALSE);
        g_autoptr(TinkerWaveformEvaluator) other = evaluator_of(tinker_waveform_expression(shifted));
        for (double t = 0.1; t < 9; t += 0.37) {
            double left[3], right[3];
            tinker_waveform_enter_piece(one, t);
            tinker_waveform_enter_piece(other, t);
            tinker_waveform_evaluate(one, t, left);
            tinker_waveform_evaluate(other, t, right);
            g_assert_cmpmem(left, sizeof left, right, sizeof right);
        }
    }
}

static void test_texts(void)
{
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression("2e1*tan(t)+ t*pulse(t, 1, t)", NULL);
    g_autoptr(TinkerWaveform) shifted = tinker_waveform_shifted(waveform, 0.25);
    g_assert_cmpstr(tinker_waveform_expression(shifted), ==,
                    "2e1*tan((t + 0.25))+ (t + 0.25)*pulse((t + 0.25), 1, (t + 0.25))");
    g_autoptr(TinkerWaveform) twice = tinker_waveform_shifted(shifted, -0.75);
    g_assert_cmpstr(tinker_waveform_expression(twice), ==,
                    "2e1*tan((t - 0.5))+ (t - 0.5)*pulse((t - 0.5), 1, (t - 0.5))");
    g_autoptr(TinkerWaveform) back = tinker_waveform_shifted(twice, 0.5);
    g_assert_true(back == waveform);
}

/* The longest text that can be read can be shifted, too. */
static void test_long_text(void)
{
    g_autoptr(GString) text = g_string_new("t");
    while (text->len + 2 < 32760)
        g_string_append(text, "+t");
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(text->str, NULL);
    g_assert_nonnull(waveform);
    g_autoptr(TinkerWaveform) shifted = tinker_waveform_shifted(waveform, 2);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(shifted, 1, 1, 0, FALSE);
    double value[3];
    tinker_waveform_evaluate(evaluator, 1, value);
    g_assert_cmpfloat(value[0], ==, 3.0 * (double)((text->len + 1) / 2));
}

static void test_tables(void)
{
    const double times[] = {0.1, 0.7, 1.3, 2, 3.14, 4, 5.5}, values[] = {1, 4, -2, 0, 3, 3, -1};
    g_autoptr(TinkerWaveform) plain =
        tinker_waveform_new_table(times, values, G_N_ELEMENTS(times), TINKER_TABLE_VALUE, NULL);
    assert_all_shifts(plain, FALSE);
    assert_all_shifts(plain, TRUE);
    g_autoptr(TinkerWaveform) acceleration =
        tinker_waveform_new_table(times, values, G_N_ELEMENTS(times), TINKER_TABLE_ACCELERATION, NULL);
    assert_all_shifts(acceleration, FALSE);
}

/* A constant acceleration from rest: velocity and displacement go on from what they have grown to. */
static void test_growth(void)
{
    g_autoptr(TinkerWaveform) waveform =
        tinker_waveform_new_table((const double[]){0, 100}, (const double[]){3, 3}, 2, TINKER_TABLE_ACCELERATION, NULL);
    g_autoptr(TinkerWaveform) later = tinker_waveform_shifted(waveform, 2);
    tinker_waveform_unref(g_steal_pointer(&waveform)); /* the shifted one keeps what it needs */
    g_autoptr(TinkerWaveform) latest = tinker_waveform_shifted(later, 3);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(latest, 1, 1, 0, FALSE);
    double value[3];
    tinker_waveform_enter_piece(evaluator, 0.5);
    tinker_waveform_evaluate(evaluator, 1, value);
    g_assert_cmpfloat_with_epsilon(value[0], 3 * 36 / 2.0, 1e-12);
    g_assert_cmpfloat_with_epsilon(value[1], 18, 1e-13);
    g_assert_cmpfloat(value[2], ==, 3);
    g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 0, INFINITY), ==, 95);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/units/shifted/harmonics", test_harmonics);
    g_test_add_func("/units/shifted/expressions", test_expressions);
    g_test_add_func("/units/shifted/texts", test_texts);
    g_test_add_func("/units/shifted/long-text", test_long_text);
    g_test_add_func("/units/shifted/tables", test_tables);
    g_test_add_func("/units/shifted/growth", test_growth);
    return g_test_run();
}
