/* What measured values differ by from a curve, worked out by hand: the curve is a parabola, which its samples tell
 * exactly, and each value is off it by a number that is chosen. */
#include <math.h>

#include "measure/residuals.h"
#include "physics-fixture.h"

#define SAMPLES 21

static double times[SAMPLES], values[SAMPLES];

/* y = 3 t^2 - 2 t + 1 from 0 to 2 s. */
static TinkerCurveSamples parabola(void)
{
    for (int i = 0; i < SAMPLES; i++) {
        const double t = times[i] = 0.1 * i;
        values[i] = 3 * t * t - 2 * t + 1;
    }
    return (TinkerCurveSamples){times, values, SAMPLES};
}

/* At 0.25, 1.05, 1.73 s the parabola is at 0.6875, 2.2075, 6.5187; the values are off by 0.3, -0.4, 1.2, of which the
 * squares are 0.09, 0.16, 1.44. One at 2.5 s is beyond its end. */
static const double at[] = {0.25, 1.05, 1.73, 2.5}, measured_values[] = {0.9875, 1.8075, 7.7187, 100};
static const TinkerCurveSamples measured = {at, measured_values, G_N_ELEMENTS(at)};

static void check(double from, double to, double truth, gsize of)
{
    const TinkerCurveSamples curve = parabola();
    TinkerStatistic rms;
    gsize count;
    g_assert_true(tinker_residuals(&curve, &measured, from, to, 0, &rms, &count));
    g_assert_cmpuint(count, ==, of);
    physics_assert_near("rms", rms.value, truth, 1e-12);
    physics_assert_near("error", rms.error, 0, 1e-12);
}

static void test_by_hand(void)
{
    check(0, 2, sqrt((0.09 + 0.16 + 1.44) / 3), 3);
    check(0, 9, sqrt((0.09 + 0.16 + 1.44) / 3), 3);
    check(0, 1.5, sqrt((0.09 + 0.16) / 2), 2);
    check(1.05, 1.73, sqrt((0.16 + 1.44) / 2), 2);
}

/* What the curve may be off by is an error of the number. */
static void test_band(void)
{
    const TinkerCurveSamples curve = parabola();
    TinkerStatistic rms;
    gsize count;
    g_assert_true(tinker_residuals(&curve, &measured, 0, 1.5, 0.02, &rms, &count));
    physics_assert_near("rms", rms.value, sqrt(0.125), 1e-12);
    physics_assert_near("error", rms.error, 0.02, 1e-12);
}

/* At a blow a curve has two samples at one time: values on either side are told from their own side. */
static void test_jump(void)
{
    double jump_times[12], jump_values[12];
    for (int i = 0; i < 12; i++) {
        jump_times[i] = i < 6 ? 0.2 * i : 0.2 * (i - 1);
        jump_values[i] = i < 6 ? 2 : -1;
    }
    const TinkerCurveSamples curve = {jump_times, jump_values, 12};
    const double when[] = {0.9, 1.1}, what[] = {2.5, -1.5};
    const TinkerCurveSamples beside = {when, what, 2};
    TinkerStatistic rms;
    gsize count;
    g_assert_true(tinker_residuals(&curve, &beside, 0, 2, 0, &rms, &count));
    g_assert_cmpuint(count, ==, 2);
    physics_assert_near("rms", rms.value, 0.5, 1e-12);
}

/* What the curve between its samples may be off by is told: of a cosine, which few samples do not tell exactly, values
 * are off by 1 mm in turns, which is their root mean square. */
static void test_coarse(void)
{
    double curve_times[SAMPLES], curve_values[SAMPLES], when[SAMPLES - 1], what[SAMPLES - 1];
    for (int i = 0; i < SAMPLES; i++)
        curve_values[i] = cos(curve_times[i] = 0.3 * i);
    for (int i = 0; i < SAMPLES - 1; i++)
        what[i] = cos(when[i] = 0.3 * i + 0.15) + (i % 2 == 0 ? 1e-3 : -1e-3);
    const TinkerCurveSamples curve = {curve_times, curve_values, SAMPLES}, beside = {when, what, SAMPLES - 1};
    TinkerStatistic rms;
    gsize count;
    g_assert_true(tinker_residuals(&curve, &beside, 0, 9, 0, &rms, &count));
    g_assert_cmpfloat(fabs(rms.value - 1e-3), >, 1e-9);
    g_assert_cmpfloat(fabs(rms.value - 1e-3), <=, rms.error);
    g_assert_cmpfloat(rms.error, <, 0.1);
}

/* A flight between two events that no sample is in: the curve is straight there, off by what it bends by elsewhere. */
static void test_between_events(void)
{
    static const double curve_times[] = {0, 0.2, 0.4, 0.6, 0.8, 1, 1, 1.1, 1.1, 1.3, 1.5, 1.7, 1.9, 2.1};
    const gsize all = G_N_ELEMENTS(curve_times);
    double curve_values[G_N_ELEMENTS(curve_times)];
    for (gsize i = 0; i < all; i++) {
        const double from = i < 6 ? 0 : 1.1, t = curve_times[i] - from;
        curve_values[i] = i == 6 ? 0 : 5 * t * (1 - t);
    }
    const TinkerCurveSamples curve = {curve_times, curve_values, all};
    const double when[] = {1.05}, what[] = {5 * 0.05 * 0.05};
    const TinkerCurveSamples beside = {when, what, 1};
    TinkerStatistic rms;
    gsize count;
    g_assert_true(tinker_residuals(&curve, &beside, 0, 2, 0, &rms, &count));
    physics_assert_near("rms", rms.value, 0.0125, 1e-12);
    physics_assert_near("error", rms.error, 0.0125, 1e-12);
}

static void test_none(void)
{
    TinkerCurveSamples curve = parabola();
    TinkerStatistic rms;
    gsize count;
    g_assert_false(tinker_residuals(&curve, &measured, 0.3, 1, 0, &rms, &count));
    curve.count = 4;
    g_assert_false(tinker_residuals(&curve, &measured, 0, 2, 0, &rms, &count));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_set_nonfatal_assertions();
    g_test_add_func("/measure/residuals/by-hand", test_by_hand);
    g_test_add_func("/measure/residuals/band", test_band);
    g_test_add_func("/measure/residuals/jump", test_jump);
    g_test_add_func("/measure/residuals/coarse", test_coarse);
    g_test_add_func("/measure/residuals/between-events", test_between_events);
    g_test_add_func("/measure/residuals/none", test_none);
    return g_test_run();
}
