/* Sines and cosines of many angles, against those of more digits that the C library has for long doubles. */
#include "numerics/sines/sines.h"

#include <float.h>
#include <glib.h>
#include <math.h>
#include <string.h>

#define COUNT 1000

/* Units in the last place of a double between a value and the right one. */
static double ulps(double value, long double right)
{
    int exponent;
    frexp((double)right, &exponent);
    return (double)(fabsl((long double)value - right) / ldexpl(1, MAX(exponent, DBL_MIN_EXP) - DBL_MANT_DIG));
}

static double worst_of(const double *angles)
{
    double sines[COUNT], cosines[COUNT], worst = 0;
    tinker_sines(COUNT, angles, sines, cosines);
    for (int i = 0; i < COUNT; i++) {
        worst = fmax(worst, ulps(sines[i], sinl((long double)angles[i])));
        worst = fmax(worst, ulps(cosines[i], cosl((long double)angles[i])));
    }
    return worst;
}

/* At random within a range, for each range from tiny angles to the largest that are reduced here. */
static void test_ranges(void)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(1);
    for (int exponent = -30; exponent <= 19; exponent++)
        for (int round = 0; round < 20; round++) {
            double angles[COUNT];
            for (int i = 0; i < COUNT; i++)
                angles[i] = ldexp(g_rand_double_range(rand, -1, 1), exponent);
            g_assert_cmpfloat(worst_of(angles), <, 0.8);
        }
}

/* Where a sine or a cosine is nearly 0, and what is left of the angle has lost most of its digits. */
static void test_quarters(void)
{
    for (int first = -600000; first < 600000; first += 1000) {
        double angles[COUNT];
        for (int i = 0; i < COUNT; i++)
            angles[i] = (double)((long double)(first + i) * 1.57079632679489661923132169163975144L);
        g_assert_cmpfloat(worst_of(angles), <, 1.1);
    }
}

/* Where an angle stands among others changes no bit of what it gives. */
static void test_alone(void)
{
    double angles[67], sines[67], cosines[67];
    for (int i = 0; i < 67; i++)
        angles[i] = 0.37 * i - 11;
    tinker_sines(67, angles, sines, cosines);
    for (int i = 0; i < 67; i++) {
        double sine, cosine;
        tinker_sines(1, &angles[i], &sine, &cosine);
        g_assert_cmpmem(&sine, sizeof sine, &sines[i], sizeof sine);
        g_assert_cmpmem(&cosine, sizeof cosine, &cosines[i], sizeof cosine);
    }
}

static void test_large(void)
{
    const double angles[] = {1e6, -1e22, 0.5, INFINITY, NAN};
    double sines[5], cosines[5];
    tinker_sines(5, angles, sines, cosines);
    g_assert_cmpfloat(ulps(sines[0], sinl(1e6L)), <, 1);
    g_assert_cmpfloat(ulps(cosines[1], cosl(-1e22L)), <, 1);
    g_assert_cmpfloat(ulps(sines[2], sinl(0.5L)), <, 0.8);
    for (int i = 3; i < 5; i++)
        g_assert_true(isnan(sines[i]) && isnan(cosines[i]));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/sines/ranges", test_ranges);
    g_test_add_func("/numerics/sines/quarters", test_quarters);
    g_test_add_func("/numerics/sines/alone", test_alone);
    g_test_add_func("/numerics/sines/large", test_large);
    return g_test_run();
}
