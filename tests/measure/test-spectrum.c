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

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_set_nonfatal_assertions();
    g_test_add_func("/measure/spectrum/lines", test_lines);
    g_test_add_func("/measure/spectrum/leakage", test_leakage);
    return g_test_run();
}
