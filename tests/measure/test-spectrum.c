/* Spectra of sums of sines: lines where they are, with their amplitudes. */
#include <math.h>

#include "measure/spectrum.h"
#include "physics-fixture.h"

#define COUNT 1000

/* 10 s at 100 a second: lines of 0.1 Hz. */
static void test_lines(void)
{
    double values[COUNT], amplitudes[COUNT / 2 + 1];
    for (int i = 0; i < COUNT; i++) {
        const double t = i / 100.0;
        values[i] = 7 + 3 * sin(2 * G_PI * 1.3 * t) + 0.02 * cos(2 * G_PI * 20 * t + 1);
    }
    g_assert_true(tinker_spectrum(values, COUNT, TINKER_WINDOW_RECTANGULAR, amplitudes));
    for (int k = 0; k <= COUNT / 2; k++)
        physics_assert_near("line", amplitudes[k], k == 13 ? 3 : k == 200 ? 0.02 : 0, 3e-6);
    /* Hann's has half of each line on both sides of it */
    g_assert_true(tinker_spectrum(values, COUNT, TINKER_WINDOW_HANN, amplitudes));
    for (int k = 0; k <= COUNT / 2; k++)
        physics_assert_near("line", amplitudes[k],
                            k == 13                ? 3
                            : k == 12 || k == 14   ? 1.5
                            : k == 200             ? 0.02
                            : k == 199 || k == 201 ? 0.01
                                                   : 0,
                            3e-6);
}

/* Half a line beside: without a window it leaks as 1 / k, with Hann's as 1 / k^3. */
static void test_leakage(void)
{
    double values[COUNT], plain[COUNT / 2 + 1], hann[COUNT / 2 + 1];
    for (int i = 0; i < COUNT; i++)
        values[i] = sin(2 * G_PI * 50.5 * i / COUNT);
    g_assert_true(tinker_spectrum(values, COUNT, TINKER_WINDOW_RECTANGULAR, plain));
    g_assert_true(tinker_spectrum(values, COUNT, TINKER_WINDOW_HANN, hann));
    g_assert_cmpfloat(plain[100], >, 3e-3);
    g_assert_cmpfloat(hann[100], <, 2e-5);
}

/* Of 3 s on, and up to where samples are even no more: 997 of them, of which 996 are transformed, 49.8 periods. */
static void test_curve(void)
{
    double times[COUNT + 400], values[COUNT + 400];
    g_autoptr(GArray) frequencies = g_array_new(FALSE, FALSE, sizeof(double)),
                      amplitudes = g_array_new(FALSE, FALSE, sizeof(double));
    for (int i = 0; i < COUNT + 400; i++) {
        times[i] = i < 1297 ? i / 100.0 : 12.96 + (i - 1296) / 300.0;
        values[i] = 2 * sin(2 * G_PI * 5 * times[i]);
    }
    g_assert_true(
        tinker_spectrum_of_curve(times, values, COUNT + 400, 3, 14, TINKER_WINDOW_HANN, frequencies, amplitudes));
    g_assert_cmpuint(frequencies->len, ==, 996 / 2 + 1);
    g_assert_cmpuint(amplitudes->len, ==, frequencies->len);
    guint greatest = 0;
    for (guint k = 0; k < frequencies->len; k++) {
        physics_assert_near("frequency", g_array_index(frequencies, double, k), k / 9.96, 1e-9);
        if (g_array_index(amplitudes, double, k) > g_array_index(amplitudes, double, greatest)) greatest = k;
    }
    g_assert_cmpuint(greatest, ==, 50); /* the nearest to 5 Hz */
    g_assert_cmpfloat(g_array_index(amplitudes, double, 50), >, 1.7);
    g_assert_false(tinker_spectrum_of_curve(times, values, 3, 0, 14, TINKER_WINDOW_HANN, frequencies, amplitudes));
    g_assert_false(tinker_spectrum_of_curve(times, values, 900, 9, 14, TINKER_WINDOW_HANN, frequencies, amplitudes));
    g_assert_cmpuint(frequencies->len + amplitudes->len, ==, 0);
}

/* A number of samples with a large prime factor takes no longer than its neighbours: 2 x 499979 of them would, for
 * minutes. */
static void test_many(void)
{
    const gsize count = 2 * 499979;
    g_autofree double *times = g_new(double, count), *values = g_new(double, count);
    g_autoptr(GArray) frequencies = g_array_new(FALSE, FALSE, sizeof(double)),
                      amplitudes = g_array_new(FALSE, FALSE, sizeof(double));
    for (gsize i = 0; i < count; i++) {
        times[i] = (double)i / 1000;
        values[i] = cos(2 * G_PI * 50 * times[i]);
    }
    g_assert_true(tinker_spectrum_of_curve(times, values, count, 0, 2000, TINKER_WINDOW_HANN, frequencies, amplitudes));
    g_assert_cmpuint(frequencies->len, >, 499900);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_set_nonfatal_assertions();
    g_test_add_func("/measure/spectrum/lines", test_lines);
    g_test_add_func("/measure/spectrum/leakage", test_leakage);
    g_test_add_func("/measure/spectrum/curve", test_curve);
    g_test_add_func("/measure/spectrum/many", test_many);
    return g_test_run();
}
