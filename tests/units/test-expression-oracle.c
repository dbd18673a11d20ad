/* Random expressions against muParser, and their derivatives against Richardson-extrapolated differences of muParser's
 * values. Only what both read alike is written: muParser has its own min, max, abs and comparisons, no step, pulse,
 * mod; powers of signed numbers stand in brackets. */
#include <math.h>
#include <string.h>

#include <muParserDLL.h>

#include "evaluator-helper.h"

static void write_expression(GString *text, GRand *rand, int depth)
{
    static const char *const functions[] = {"sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "exp", "abs"};
    /* atan2 of -0 is on either side of the cut by its sign bit, which says nothing about the side in time */
    static const char *const pairs[] = {"min(", "max(", "atan2(0.011+"};
    static const char *const signs[] = {"+", "-", "*", "/", "+", "*"};
    static const char *const comparisons[] = {"<", "<=", ">", ">=", "!="};
    const int choice = depth == 0 ? g_rand_int_range(rand, 0, 3) : g_rand_int_range(rand, 3, 11);
    if (choice <= 1) {
        g_string_append(text, "t");
    } else if (choice == 2) {
        g_string_append_printf(text, "%.3f", g_rand_double_range(rand, 0.1, 3));
    } else if (choice <= 5) {
        g_string_append_c(text, '(');
        write_expression(text, rand, depth - 1);
        g_string_append(text, signs[g_rand_int_range(rand, 0, G_N_ELEMENTS(signs))]);
        write_expression(text, rand, depth - 1);
        g_string_append_c(text, ')');
    } else if (choice <= 7) {
        g_string_append_printf(text, "%s(", functions[g_rand_int_range(rand, 0, G_N_ELEMENTS(functions))]);
        write_expression(text, rand, depth - 1);
        g_string_append_c(text, ')');
    } else if (choice == 8) {
        g_string_append(text, pairs[g_rand_int_range(rand, 0, G_N_ELEMENTS(pairs))]);
        write_expression(text, rand, depth - 1);
        g_string_append_c(text, ',');
        write_expression(text, rand, depth - 1);
        g_string_append_c(text, ')');
    } else if (choice == 9) {
        g_string_append(text, "((");
        write_expression(text, rand, depth - 1);
        g_string_append_printf(text, ")^%d)", g_rand_int_range(rand, -2, 5));
    } else {
        g_string_append_c(text, '(');
        write_expression(text, rand, depth - 1);
        g_string_append(text, comparisons[g_rand_int_range(rand, 0, G_N_ELEMENTS(comparisons))]);
        write_expression(text, rand, depth - 1);
        g_string_append_c(text, ')');
    }
}

/* First and second derivative by central differences, extrapolated twice; error[] is how much the last step changed. */
static void differences(muParserHandle_t parser, double *variable, double t, double result[2], double error[2])
{
    double tables[2][3];
    *variable = t;
    const double middle = mupEval(parser);
    for (int i = 0; i < 3; i++) {
        const double h = ldexp(1, -8 - i);
        *variable = t + h;
        const double above = mupEval(parser);
        *variable = t - h;
        const double below = mupEval(parser);
        tables[0][i] = (above - below) / (2 * h);
        tables[1][i] = (above - 2 * middle + below) / (h * h);
    }
    for (int j = 0; j < 2; j++) {
        const double *d = tables[j];
        const double first = (4 * d[1] - d[0]) / 3, second = (4 * d[2] - d[1]) / 3;
        result[j] = (16 * second - first) / 15;
        error[j] = fabs(second - first) + 1e-12 * ldexp(fabs(middle), 10 * (j + 1));
    }
}

static void test_random(void)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(11);
    double variable = 0;
    int compared = 0, differentiated = 0;
    muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
    mupDefineVar(parser, "t", &variable);
    for (int i = 0; i < 3000; i++) {
        g_autoptr(GString) text = g_string_new(NULL);
        write_expression(text, rand, g_rand_int_range(rand, 1, 5));
        const double t = g_rand_double_range(rand, -2, 2);
        mupSetExpr(parser, text->str);
        variable = t;
        const double expected = mupEval(parser);
        g_assert_false(mupError(parser));
        if (!isfinite(expected) || fabs(expected) > 1e6) continue;

        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(text->str);
        double result[3];
        tinker_waveform_enter_piece(evaluator, t);
        tinker_waveform_evaluate(evaluator, t, result);
        g_test_message("%s at %.17g", text->str, t);
        g_assert_cmpfloat_with_epsilon(result[0], expected, 1e-12 * fmax(1, fabs(expected)));
        compared++;

        /* differences mean nothing across a break */
        if (tinker_waveform_next_break(evaluator, t - 0.005, t + 0.005) <= t + 0.005) continue;
        double slopes[2], errors[2];
        differences(parser, &variable, t, slopes, errors);
        for (int j = 0; j < 2; j++) {
            if (!(errors[j] < 1e-4 * fmax(1, fabs(slopes[j])))) continue;
            /* a value may be finite by way of an infinite one, 1/(1/0); its derivatives are not */
            if (!isfinite(result[j + 1])) continue;
            g_assert_cmpfloat_with_epsilon(result[j + 1], slopes[j], fmax(errors[j], 1e-9));
            differentiated++;
        }
    }
    mupRelease(parser);
    g_assert_cmpint(compared, >, 2000);
    g_assert_cmpint(differentiated, >, 2000);
}

/* Within a piece, the function that was frozen inside it is the function itself: no break was missed. Times nearer to
 * the ends than `margin` are left out, where rounding decides. */
static int compare_piece(TinkerWaveformEvaluator *evaluator, muParserHandle_t parser, double *variable, double left,
                         double right)
{
    const int samples = 40;
    const double margin = 1e-6;
    int compared = 0;
    tinker_waveform_enter_piece(evaluator, left + 0.4871 * (right - left)); /* not 0, where t/t is no number */
    for (int i = 1; i < samples; i++) {
        double result[3];
        const double t = left + (right - left) * (i - 0.4142) / samples; /* not where == may hold for an instant */
        if (t - left < margin || right - t < margin) continue;
        *variable = t;
        const double expected = mupEval(parser);
        if (!isfinite(expected) || fabs(expected) > 1e6) continue;
        tinker_waveform_evaluate(evaluator, t, result);
        g_assert_cmpfloat_with_epsilon(result[0], expected, 1e-9 * fmax(1, fabs(expected)));
        compared++;
    }
    return compared;
}

static void test_pieces(void)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(12);
    double variable = 0;
    int compared = 0;
    muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
    mupDefineVar(parser, "t", &variable);
    for (int i = 0; i < 150; i++) {
        g_autoptr(GString) text = g_string_new(NULL);
        write_expression(text, rand, g_rand_int_range(rand, 2, 5));
        g_test_message("%s", text->str);
        mupSetExpr(parser, text->str);
        g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(text->str);
        double left = -2;
        for (int pieces = 0; pieces < 20 && left < 2; pieces++) {
            const double right = fmin(tinker_waveform_next_break(evaluator, left, 2), 2);
            compared += compare_piece(evaluator, parser, &variable, left, right);
            left = right;
        }
    }
    mupRelease(parser);
    g_assert_cmpint(compared, >, 5000);
}

/* What both agree on in the grammar; where muParser is known to differ (3,5 and t=4) only ours is right. */
static void test_grammar(void)
{
    static const char *const texts[] = {"1-2-3", "8/4/2",    "2^3^2", "-2^2", "1+2*3^2",
                                        "2*-3",  "1.5e1+.5", "1<2",   "2<1+0"};
    double variable = 0;
    muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
    mupDefineVar(parser, "t", &variable);
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        double result[3];
        mupSetExpr(parser, texts[i]);
        evaluate_inside(texts[i], 0, result);
        g_test_message("%s", texts[i]);
        g_assert_cmpfloat(result[0], ==, mupEval(parser));
    }
    mupRelease(parser);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/expression-oracle/random", test_random);
    g_test_add_func("/expression-oracle/pieces", test_pieces);
    g_test_add_func("/expression-oracle/grammar", test_grammar);
    return g_test_run();
}
