/* Ticks are round numbers, in order, within the range, and as many as there is room for. */
#include <math.h>

#include "render/plot/plot.h"

#define MOST 20

/* The step is 1, 2 or 5 times a power of ten and every tick a multiple of it. Where neighbouring doubles are not much
 * closer together than ticks, their difference is too blurred to tell. */
static void check_round(const double *ticks, int count)
{
    double difference = ticks[1] - ticks[0];
    if (difference < 1e-11 * fmax(fabs(ticks[0]), fabs(ticks[count - 1]))) return;
    char text[64];
    g_snprintf(text, sizeof text, "%.0e", difference);
    g_assert_true(text[0] == '1' || text[0] == '2' || text[0] == '5');
    double step = g_ascii_strtod(text, NULL);
    g_assert_cmpfloat_with_epsilon(difference / step, 1, 1e-3);
    for (int i = 0; i < count; i++)
        g_assert_cmpfloat_with_epsilon(ticks[i] / step, round(ticks[i] / step), 1e-3);
}

static void check_range(double low, double high, int most)
{
    double ticks[MOST];
    int decimals = -1, count = tinker_plot_ticks(low, high, most, ticks, &decimals);
    g_assert_cmpint(count, <=, most);
    g_assert_cmpint(decimals, >=, 0);
    for (int i = 0; i < count; i++) {
        g_assert_cmpfloat(ticks[i], >=, low);
        g_assert_cmpfloat(ticks[i], <=, high);
        if (i > 0) g_assert_cmpfloat(ticks[i], >, ticks[i - 1]);
    }
    /* The next finer step, at most 2.5 times finer, has more than `most`. */
    gboolean resolved = high - low > 1e-12 * fmax(fabs(low), fabs(high)) && high - low > 1e-299;
    if (most >= 5 && resolved) g_assert_cmpint(count, >=, (most - 1) / 2.5 - 1);
    if (count >= 2) check_round(ticks, count);
}

static void test_property(void)
{
    for (int i = 0; i < 20000; i++) {
        double size = pow(10, g_test_rand_double_range(-300, 300));
        double low = size * g_test_rand_double_range(-1, 1);
        double high = low + fabs(low) * pow(10, g_test_rand_double_range(-9, 2)) + 1e-300;
        if (!isfinite(high) || high > 1e300) continue;
        check_range(low, high, g_test_rand_int_range(1, MOST + 1));
    }
}

static void test_known(void)
{
    double ticks[MOST];
    int decimals;
    g_assert_cmpint(tinker_plot_ticks(0, 10, 6, ticks, &decimals), ==, 6);
    for (int i = 0; i < 6; i++)
        g_assert_cmpfloat(ticks[i], ==, 2.0 * i);
    g_assert_cmpint(decimals, ==, 0);
    /* Exactly the doubles that the decimal numbers read as, which sums of 0.1 are not. */
    static const double tenths[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
    g_assert_cmpint(tinker_plot_ticks(0, 1, 11, ticks, &decimals), ==, 11);
    for (int i = 0; i < 11; i++)
        g_assert_cmpfloat(ticks[i], ==, tenths[i]);
    g_assert_cmpint(decimals, ==, 1);
    g_assert_cmpint(tinker_plot_ticks(-0.25, 0.25, 5, ticks, &decimals), ==, 5);
    g_assert_cmpfloat(ticks[0], ==, -0.2);
    g_assert_cmpfloat(ticks[2], ==, 0);
}

static void test_odd(void)
{
    double ticks[MOST];
    int decimals;
    g_assert_cmpint(tinker_plot_ticks(1, 1, 5, ticks, &decimals), ==, 0);
    g_assert_cmpint(tinker_plot_ticks(2, 1, 5, ticks, &decimals), ==, 0);
    g_assert_cmpint(tinker_plot_ticks(NAN, 1, 5, ticks, &decimals), ==, 0);
    g_assert_cmpint(tinker_plot_ticks(0, INFINITY, 5, ticks, &decimals), ==, 0);
    g_assert_cmpint(tinker_plot_ticks(0, 1, 0, ticks, &decimals), ==, 0);
    check_range(-1e308, 1e308, 10);
    check_range(1, nextafter(1, 2), 10);
    check_range(1e15, 1e15 + 1, 10);
    check_range(0, 5e-324, 10);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/ticks/property", test_property);
    g_test_add_func("/render/ticks/known", test_known);
    g_test_add_func("/render/ticks/odd", test_odd);
    return g_test_run();
}
