/* Expressions: the grammar, closed forms of values and derivatives, one-sided limits, and what is refused. */
#include <math.h>
#include <string.h>

#include "evaluator-helper.h"

static double value(const char *text, double t)
{
    double result[3];
    evaluate_inside(text, t, result);
    return result[0];
}

static void test_grammar(void)
{
    g_assert_cmpfloat(value("-2^2", 0), ==, -4);
    g_assert_cmpfloat(value("2^3^2", 0), ==, 512);
    g_assert_cmpfloat(value("2^-1", 0), ==, 0.5);
    g_assert_cmpfloat(value("8/4/2", 0), ==, 1);
    g_assert_cmpfloat(value("1-2-3", 0), ==, -4);
    g_assert_cmpfloat(value("1+2*3^2", 0), ==, 19);
    g_assert_cmpfloat(value(" ( 1 + 2 ) * + 3\t", 0), ==, 9);
    g_assert_cmpfloat(value("1.5e1 + .5", 0), ==, 15.5);
    g_assert_cmpfloat(value("+3*t", 2), ==, 6);
    g_assert_cmpfloat(value(".5*t - +1.", 4), ==, 1);
    g_assert_cmpfloat(value("2*-t", 3), ==, -6);
    g_assert_cmpfloat(value("1 < 2 ", 0), ==, 1);
    g_assert_cmpfloat(value("1+1 < 2*1", 0), ==, 0);
}

static void test_functions(void)
{
    g_assert_cmpfloat(value("atan2(1, -1)", 0), ==, atan2(1, -1));
    g_assert_cmpfloat(value("atan2(-1, t)", -1), ==, atan2(-1, -1));
    g_assert_cmpfloat(value("mod(-1, 3)", 0), ==, 2);
    g_assert_cmpfloat(value("mod(1, -3)", 0), ==, -2);
    g_assert_cmpfloat(value("floor(-0.5)", 0), ==, -1);
    g_assert_cmpfloat(value("step(0)", 0), ==, 1);
    g_assert_cmpfloat(value("step(t)", -1e-9), ==, 0);
    g_assert_cmpfloat(value("pulse(t, 1, 2)", 1), ==, 1);
    g_assert_cmpfloat(value("pulse(t, 1, 2)", 2), ==, 0);
    g_assert_cmpfloat(value("pulse(t, 2, 1)", 1.5), ==, 0);
    g_assert_cmpfloat(value("ramp(t-1)", 3), ==, 2);
    g_assert_cmpfloat(value("ramp(t-1)", 0), ==, 0);
    g_assert_cmpfloat(value("square(t)", 0), ==, 1);
    g_assert_cmpfloat(value("square(t)", 4), ==, -1);
    g_assert_cmpfloat(value("square(t)", -0.1), ==, -1);
    g_assert_cmpfloat(value("sawtooth(t)", 0), ==, -1);
    g_assert_cmpfloat_with_epsilon(value("sawtooth(t)", G_PI), 0, 1e-15);
    g_assert_cmpfloat_with_epsilon(value("sawtooth(t)", 2.5 * G_PI), -0.5, 1e-15);
    g_assert_cmpfloat(value("if(t > 2, 10, 20)", 3), ==, 10);
    g_assert_cmpfloat(value("if(t > 2, 10, 20)", 1), ==, 20);
    g_assert_cmpfloat(value("if(t >= 1, sqrt(t-1), 5)", 0), ==, 5);
    g_assert_cmpfloat(value("min(t, 2) + max(t, 2)", 7), ==, 9);
    g_assert_cmpfloat(value("abs(-3)", 0), ==, 3);
    static const char *const truths[] = {"1<2", "2<=2", "2>1", "2>=2", "2==2", "1!=2", "floor(t)==3"};
    static const char *const falsehoods[] = {"2<2", "3<=2", "2>2", "1>=2", "1==2", "2!=2", "floor(t)!=3"};
    for (gsize i = 0; i < G_N_ELEMENTS(truths); i++) {
        g_assert_cmpfloat(value(truths[i], 3.5), ==, 1);
        g_assert_cmpfloat(value(falsehoods[i], 3.5), ==, 0);
    }
}

/* Value, first and second derivative in closed form at t = 0.3. */
static void test_derivatives(void)
{
    const double t = 0.3, s = sin(t), c = cos(t), e = exp(t), q = 1 - t * t, a = 1 + t * t, h = cosh(t);
    const struct {
        const char *text;
        double expected[3];
    } cases[] = {
        {"sin(t)", {s, c, -s}},
        {"cos(2*t)", {cos(2 * t), -2 * sin(2 * t), -4 * cos(2 * t)}},
        {"tan(t)", {tan(t), 1 / (c * c), 2 * s / (c * c * c)}},
        {"asin(t)", {asin(t), 1 / sqrt(q), t / pow(q, 1.5)}},
        {"acos(t)", {acos(t), -1 / sqrt(q), -t / pow(q, 1.5)}},
        {"atan(t)", {atan(t), 1 / a, -2 * t / (a * a)}},
        {"sinh(t)", {sinh(t), h, sinh(t)}},
        {"cosh(t)", {h, sinh(t), h}},
        {"tanh(t)", {tanh(t), 1 / (h * h), -2 * tanh(t) / (h * h)}},
        {"exp(t)", {e, e, e}},
        {"log(t)", {log(t), 1 / t, -1 / (t * t)}},
        {"sqrt(t)", {sqrt(t), 0.5 / sqrt(t), -0.25 / (t * sqrt(t))}},
        {"t^3", {t * t * t, 3 * t * t, 6 * t}},
        {"t^-2", {1 / (t * t), -2 / (t * t * t), 6 / (t * t * t * t)}},
        {"2^t", {pow(2, t), log(2) * pow(2, t), log(2) * log(2) * pow(2, t)}},
        {"t^t", {pow(t, t), pow(t, t) * (log(t) + 1), pow(t, t) * ((log(t) + 1) * (log(t) + 1) + 1 / t)}},
        {"t*sin(t)", {t * s, s + t * c, 2 * c - t * s}},
        {"1/(1+t^2)", {1 / a, -2 * t / (a * a), (6 * t * t - 2) / (a * a * a)}},
        {"atan2(sin(t), cos(t))", {t, 1, 0}},
        {"exp(sin(t))", {exp(s), c * exp(s), (c * c - s) * exp(s)}},
        {"mod(t, 0.25)^2", {0.05 * 0.05, 0.1, 2}},
        {"abs(t-1)", {0.7, -1, 0}},
        {"pi", {G_PI, 0, 0}},
        {"10*sin(2*t)*exp(-t)",
         {10 * sin(0.6) / e, 10 * (2 * cos(0.6) - sin(0.6)) / e, 10 * (-3 * sin(0.6) - 4 * cos(0.6)) / e}},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double result[3];
        evaluate_inside(cases[i].text, t, result);
        g_test_message("%s", cases[i].text);
        for (int j = 0; j < 3; j++)
            g_assert_cmpfloat_with_epsilon(result[j], cases[i].expected[j], 1e-14 * fmax(1, fabs(result[j])));
    }
    double start[3];
    evaluate_inside("t^2", 0, start);
    g_assert_cmpfloat(start[1], ==, 0);
    g_assert_cmpfloat(start[2], ==, 2);
}

/* At both ends of a piece the value is that of the piece, not of its neighbour. */
static void test_one_sided(void)
{
    static const struct {
        const char *text;
        double break_at, left, right, left_slope, right_slope;
    } cases[] = {
        {"if(t < 2, t, 10 - t)", 2, 2, 8, 1, -1},
        {"pulse(t, 5, 5.01)", 5, 0, 1, 0, 0},
        {"pulse(t, 5, 5.01)", 5.01, 1, 0, 0, 0},
        {"floor(t)", 3, 2, 3, 0, 0},
        {"mod(t, 2)", 4, 2, 0, 1, 1},
        {"abs(t - 1)", 1, 0, 0, -1, 1},
        {"sawtooth(pi*t)", 2, 1, -1, 1, 1},
        {"square(pi*t)", 1, 1, -1, 0, 0},
        {"step(t - 1)*t", 1, 0, 1, 0, 1},
        {"ramp(3 - t)", 3, 0, 0, -1, 0},
        {"min(t, 2)", 2, 2, 2, 1, 0},
        {"max(t, 2)", 2, 2, 2, 0, 1},
        {"atan2(t - 1, -1)", 1, -G_PI, G_PI, -1, -1},
        {"if(t^2 > 2, 5, 1)", G_SQRT2, 1, 5, 0, 0},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_test_message("%s", cases[i].text);
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(cases[i].text);
        double left[3], right[3];
        const double at = cases[i].break_at;
        tinker_waveform_enter_piece(evaluator, at - 0.005);
        tinker_waveform_evaluate(evaluator, at, left);
        tinker_waveform_enter_piece(evaluator, at + 0.005);
        tinker_waveform_evaluate(evaluator, at, right);
        g_assert_cmpfloat_with_epsilon(left[0], cases[i].left, 1e-14);
        g_assert_cmpfloat_with_epsilon(right[0], cases[i].right, 1e-14);
        g_assert_cmpfloat_with_epsilon(left[1], cases[i].left_slope, 1e-14);
        g_assert_cmpfloat_with_epsilon(right[1], cases[i].right_slope, 1e-14);
    }
}

/* A piece is entered at a time at which its argument happens to touch a level, or to be 0. */
static void test_touching(void)
{
    static const struct {
        const char *text;
        double expected;
    } cases[] = {{"-(t - 1)^2 >= 0", 0}, {"(t - 1)^2 > 0", 1},   {"floor(-(t - 1)^2)", -1}, {"t != 1", 1},
                 {"t == 1", 0},          {"if(t - 1, 2, 3)", 2}, {"abs(-(t - 1)^2)", 0.25}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double result[3];
        g_test_message("%s", cases[i].text);
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(cases[i].text);
        tinker_waveform_enter_piece(evaluator, 1);
        tinker_waveform_evaluate(evaluator, 1.5, result);
        g_assert_cmpfloat(result[0], ==, cases[i].expected);
    }
}

static void test_harmonic(void)
{
    const double t = 0.7, w = 3, p = 0.4, a = 2.5;
    g_autoptr(TinkerWaveform) sine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_SINE);
    g_autoptr(TinkerWaveform) cosine = tinker_waveform_new_harmonic(TINKER_WAVEFORM_COSINE);
    g_autoptr(TinkerWaveform) none = tinker_waveform_new_harmonic(TINKER_WAVEFORM_NONE);
    TinkerWaveform *const waveforms[] = {sine, cosine, none};
    const double s = sin(w * t + p), c = cos(w * t + p);
    const double expected[3][3] = {{a * s, a * w * c, -a * w * w * s}, {a * c, -a * w * s, -a * w * w * c}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveforms[i], a, w, p, TRUE);
        double result[3];
        tinker_waveform_evaluate(evaluator, t, result);
        for (int j = 0; j < 3; j++)
            g_assert_cmpfloat_with_epsilon(result[j], expected[i][j], 1e-14);
        g_assert_cmpfloat(tinker_waveform_next_break(evaluator, 0, INFINITY), ==, INFINITY);
    }
}

static void test_refused(void)
{
    static const struct {
        const char *text;
        TinkerWaveformError code;
        const char *message;
    } cases[] = {
        {"sni(t)", TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, "column 1: unknown name \"sni\"; did you mean \"sin\"?"},
        {"2*T", TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, "column 3: unknown name \"T\"; did you mean \"t\"?"},
        {"2t", TINKER_WAVEFORM_ERROR_SYNTAX,
         "column 2: an operator is expected before \"t\"; did you mean a product, *?"},
        {"3,5", TINKER_WAVEFORM_ERROR_SYNTAX,
         "column 2: a comma stands between the arguments of a function only; decimals have a point, as in 3.5"},
        {"t=4", TINKER_WAVEFORM_ERROR_SYNTAX, "column 2: \"=\" is not known; did you mean ==?"},
        {"1 − t", TINKER_WAVEFORM_ERROR_SYNTAX, "column 3: \"−\" is not known; did you mean -?"},
        {"−1", TINKER_WAVEFORM_ERROR_SYNTAX, "column 1: \"−\" is not known; did you mean -?"},
        {"1 + sin t", TINKER_WAVEFORM_ERROR_SYNTAX, "column 5: sin is a function, write sin(x)"},
        {"pulse(t, 1)", TINKER_WAVEFORM_ERROR_SYNTAX, "column 11: pulse takes 3 arguments: pulse(t, a, b)"},
        {"sin(t, 1)", TINKER_WAVEFORM_ERROR_SYNTAX, "column 7: sin takes 1 argument: sin(x)"},
        {"0 < t < 1", TINKER_WAVEFORM_ERROR_SYNTAX,
         "column 7: comparisons do not chain; did you mean a product, (a < b)*(b < c)?"},
        {"(1", TINKER_WAVEFORM_ERROR_SYNTAX, "column 3: an operator or \")\" is expected, not the end"},
        {"1)", TINKER_WAVEFORM_ERROR_SYNTAX, "column 2: \")\" closes no bracket"},
        {"", TINKER_WAVEFORM_ERROR_SYNTAX, "column 1: a number, t, a function or \"(\" is expected, not the end"},
        {"1e999", TINKER_WAVEFORM_ERROR_SYNTAX, "column 1: the number is larger than 1.8e308"},
        {"1.2.3", TINKER_WAVEFORM_ERROR_SYNTAX, "column 4: a number such as 1.5 is expected, not \".\""},
        {"t\xff", TINKER_WAVEFORM_ERROR_SYNTAX, "column 2: the text is not UTF-8 here"},
        {"t*", TINKER_WAVEFORM_ERROR_SYNTAX, "column 3: a number, t, a function or \"(\" is expected, not the end"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_waveform_new_expression(cases[i].text, &error));
        g_assert_error(error, TINKER_WAVEFORM_ERROR, (gint)cases[i].code);
        g_assert_cmpstr(error->message, ==, cases[i].message);
    }
}

/* Whatever repeats too often is an error, not a crash. */
static void test_deep(void)
{
    static const char *const units[] = {"(", "-", "2^", "sin(", "if(t,", "1+(", "t+", "max(t,", "1<("};
    static const int counts[] = {1000, 10000, 100000};
    for (gsize i = 0; i < G_N_ELEMENTS(units); i++) {
        for (gsize j = 0; j < G_N_ELEMENTS(counts); j++) {
            g_autoptr(GString) text = g_string_new(NULL);
            for (int k = 0; k < counts[j]; k++)
                g_string_append(text, units[i]);
            g_autoptr(GError) error = NULL;
            g_assert_null(tinker_waveform_new_expression(text->str, &error));
            g_assert_true(g_str_has_prefix(error->message, "column "));
        }
    }
    g_autoptr(GString) nested = g_string_new(NULL);
    for (int i = 0; i < 100; i++)
        g_string_append_c(nested, '(');
    g_string_append_c(nested, 't');
    for (int i = 0; i < 100; i++)
        g_string_append_c(nested, ')');
    g_assert_cmpfloat(value(nested->str, 4), ==, 4);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/expression/grammar", test_grammar);
    g_test_add_func("/expression/functions", test_functions);
    g_test_add_func("/expression/derivatives", test_derivatives);
    g_test_add_func("/expression/one-sided", test_one_sided);
    g_test_add_func("/expression/touching", test_touching);
    g_test_add_func("/expression/harmonic", test_harmonic);
    g_test_add_func("/expression/refused", test_refused);
    g_test_add_func("/expression/deep", test_deep);
    return g_test_run();
}
