/* Poles, and the edges of where functions are defined: against their places by hand. */
#include <glib.h>
#include <math.h>

#include "units/waveform/waveform-pole.h"

typedef struct {
    const char *text;
    double from, end;
    double pole;  /* INFINITY: none */
    double bound; /* s: 0 means a few ulp */
} Case;

static const Case cases[] = {
    {"1/(t-1)", 0, 3, 1, 0},
    {"1/(t-1)^2", 0, 3, 1, 0},
    {"(t-1)^(-2)", 0, 3, 1, 0},
    {"1/(t^2-2*t+1)", 0, 3, 1, 2e-8}, /* it is rounding within the root of rounding */
    {"1e-9/(t-1)", 0, 3, 1, 0},
    {"1e-6 + 1/(t-0.1)^3", 0, 3, 0.1, 0},
    {"5*t^2 - 1/sin(t)", 0.1, 9, G_PI, 0},
    {"tan(t)", 0, 9, G_PI_2, 0},
    {"tan(t)", 2, 9, 3 * G_PI_2, 0},
    {"1/cos(1e6*t)", 0, 1, G_PI_2 * 1e-6, 0},
    {"log(2-t)", 0, 9, 2, 0},
    {"log((t-2)^2) + 1000*t", 0, 9, 2, 0},
    {"sqrt(2-t)", 0, 9, 2, 0},
    {"(2-t)^0.5", 0, 9, 2, 0},
    {"asin(t/2)", 0, 9, 2, 0},
    {"acos(-t/2)", 0, 9, 2, 0},
    {"exp(1/(2-t))", 0, 9, 2, 0},
    {"(2-t)^(-t)", 0, 9, 2, 0},
    {"1/(exp(t)-2)", 0, 9, G_LN2, 0},
    {"if(t < 5, 1/(t-1), 0)", 0, 5, 1, 0},
    {"sqrt(max(0, t-2)) + 1/(t-1)", 0, 2, 1, 0}, /* the root is of 0 all the way */
    {"sqrt(9.999-t)", 0, 10, 9.999, 0},          /* hardly anything is behind it */
    /* nothing to be found */
    {"1/(1+t^2)", 0, 9, INFINITY, 0},
    {"1/t", 0.5, 1e9, INFINITY, 0},
    {"1/(t-1)", 1, 9, INFINITY, 0}, /* behind it */
    {"sin(t-1)/(t-1)", 0, 9, INFINITY, 0},
    {"(t^2-1)/(t-1)", 0, 9, INFINITY, 0},
    {"(t-1)*log((t-1)^2)", 0, 9, INFINITY, 0},
    {"(1-cos(t-0.5))/(t-0.5)^2", 0, 9, INFINITY, 0},
    {"(1-cos(t-5))/(t-5)^2", 4.9, 9, INFINITY, 0},
    {"(1-cos(t-0.1))/(t-0.1)^2", 0, 9, INFINITY, 0},
    {"exp(-1/(t-1)^2)", 0, 9, INFINITY, 0},
    {"atan(1/(t-1)^2)", 0, 9, INFINITY, 0},
    {"sqrt((t-1)^2)", 0, 9, INFINITY, 0},
    {"if(t < 5, 3, 1/(t-1))", 0, 5, INFINITY, 0},
    {"exp(sin(t))/2 + 3^t", 0, 9, INFINITY, 0},
};

static void test_case(gconstpointer data)
{
    const Case *of = data;
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(of->text, &error);
    g_assert_no_error(error);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveform, 1, 1, 0, FALSE);
    double found = tinker_waveform_next_pole(evaluator, of->from, of->end);
    double bound = of->bound > 0 ? of->bound : 16 * G_MINDOUBLE + 2e-15 * fabs(of->pole);
    g_test_message("%s: %.17g", of->text, found);
    if (isinf(of->pole) ? !isinf(found) : !(fabs(found - of->pole) <= bound))
        g_test_fail_printf("%s: a pole at %.17g, not at %.17g", of->text, found, of->pole);
}

/* (t - a) (t - b) under a fraction, from seeds: the first root behind the start, whichever it is, and no other. */
static void test_random(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(11);
    for (int i = 0; i < 300; i++) {
        double a = g_rand_double_range(random, 0.01, 10), b = g_rand_double_range(random, 0.01, 10);
        g_autofree char *text = i % 2 == 0 ? g_strdup_printf("1/((t-%.17g)*(t-%.17g))", a, b)
                                           : g_strdup_printf("((t-%.17g)^2)^(-0.25) + tan(%.17g*t)", a, G_PI_2 / b);
        g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(text, NULL);
        g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveform, 1, 1, 0, FALSE);
        double found = tinker_waveform_next_pole(evaluator, 0, 11), truth = fmin(a, b);
        if (!(fabs(found - truth) <= 1e-13)) g_test_fail_printf("%s: a pole at %.17g", text, found);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *path = g_strdup_printf("/units/poles/case/%d", (int)i);
        g_test_add_data_func(path, &cases[i], test_case);
    }
    g_test_add_func("/units/poles/random", test_random);
    return g_test_run();
}
