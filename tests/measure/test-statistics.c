/* Statistics of curves whose mean, extrema, period and damping are known. Errors cover what is off. */
#include <math.h>

#include "measure/statistics.h"
#include "physics-fixture.h"

#define MOST 20001

static double times[MOST], values[MOST];

static void fill(gsize count, double to, double (*function)(double))
{
    for (gsize i = 0; i < count; i++) {
        times[i] = to * (double)i / (double)(count - 1);
        values[i] = function(times[i]);
    }
}

static void check(const char *what, TinkerStatistic found, double truth, double bound)
{
    physics_assert_near(what, found.value, truth, bound);
    physics_assert_near("error", found.error, 0, 100 * bound);
    if (!(fabs(found.value - truth) <= found.error + 1e-12 * fabs(truth)))
        g_test_fail_printf("%s is off by %.3g, and says %.3g", what, fabs(found.value - truth), found.error);
}

static double wave(double t)
{
    return 2 + 3 * sin(2 * G_PI * t + 0.3);
}

/* Over four whole periods; the samples know neither a maximum nor the ends of the interval. */
static void test_wave(void)
{
    TinkerStatistics s;
    fill(1000, 5, wave);
    g_assert_true(tinker_statistics(times, values, 1000, 0.5, 4.5, 0, &s));
    check("mean", s.mean, 2, 1e-9);
    check("rms", s.rms, sqrt(4 + 4.5), 1e-8);
    check("least", s.least, -1, 1e-7);
    check("greatest", s.greatest, 5, 1e-7);
    check("amplitude", s.amplitude, 3, 1e-7);
    check("period", s.period, 1, 1e-6);
    physics_assert_near("damping", s.damping.value, 0, 1e-7);
}

/* Coarser samples are worse, by what is said. */
static void test_coarse(void)
{
    TinkerStatistics s;
    fill(101, 5, wave);
    g_assert_true(tinker_statistics(times, values, 101, 0.5, 4.5, 0, &s));
    check("greatest", s.greatest, 5, 1e-3);
    check("rms", s.rms, sqrt(8.5), 1e-3);
}

/* z = 0.05, about 1.7: extrema are half a damped period from each other, and their distances fall by exp(-d/2). */
static double damped(double t)
{
    return 1.7 + exp(-0.05 * 4 * t) * cos(4 * sqrt(1 - 0.0025) * t + 1);
}

static void test_damped(void)
{
    TinkerStatistics s;
    fill(20001, 20, damped);
    g_assert_true(tinker_statistics(times, values, 20001, 0, 20, 0, &s));
    check("period", s.period, 2 * G_PI / (4 * sqrt(1 - 0.0025)), 1e-7);
    check("decrement", s.decrement, 2 * G_PI * 0.05 / sqrt(1 - 0.0025), 1e-7);
    check("damping", s.damping, 0.05, 1e-8);
}

/* As of a run whose error grows with time: too large, and late. */
#define BAND 1e-3
static double damped_badly(double t)
{
    return damped(t) + BAND * t / 20 * sin(4 * t + 1.3);
}

/* As of a method that damps too much and is too slow: exp(-a t) t is 1 / (a e) at most. */
static double damped_by_method(double t)
{
    const double more = 0.5 * BAND * 0.05 * 4 * G_E;
    return 1.7 + exp(-(0.05 * 4 + more) * t) * cos((4 * sqrt(1 - 0.0025) - more) * t + 1);
}

/* What is not within the errors of the samples is within those that a band adds. */
static void test_band(void)
{
    TinkerStatistics without, with;
    const double period = 2 * G_PI / (4 * sqrt(1 - 0.0025)), decrement = 2 * G_PI * 0.05 / sqrt(1 - 0.0025);
    fill(20001, 20, damped_by_method);
    g_assert_true(tinker_statistics(times, values, 20001, 0, 20, 0, &without));
    g_assert_cmpfloat(fabs(without.period.value - period), >, without.period.error);
    g_assert_cmpfloat(fabs(without.decrement.value - decrement), >, without.decrement.error);
    g_assert_true(tinker_statistics(times, values, 20001, 0, 20, BAND, &with));
    check("period", with.period, period, 1e-3);
    check("decrement", with.decrement, decrement, 1e-2);
    check("damping", with.damping, 0.05, 1e-2);
    fill(20001, 20, damped_badly);
    g_assert_true(tinker_statistics(times, values, 20001, 0, 20, 0, &without));
    g_assert_true(tinker_statistics(times, values, 20001, 0, 20, BAND, &with));
    check("period", with.period, period, 1e-3);
    check("decrement", with.decrement, decrement, 1e-2);
    check("damping", with.damping, 0.05, 1e-2);
    physics_assert_near("mean's error", with.mean.error, without.mean.error + BAND, 1e-15);
    physics_assert_near("rms's error", with.rms.error, without.rms.error + BAND, 1e-15);
    physics_assert_near("amplitude's error", with.amplitude.error, without.amplitude.error + BAND, 1e-15);
}

/* What has died away is less than the band by far, and does not spoil what is known of what is larger. */
static double damped_for_long(double t)
{
    return damped(t) + BAND * fmin(t / 20, 1) * sin(4 * t + 1.3);
}

static void test_died_away(void)
{
    TinkerStatistics s;
    fill(20001, 80, damped_for_long);
    g_assert_true(tinker_statistics(times, values, 20001, 0, 80, BAND, &s));
    check("period", s.period, 2 * G_PI / (4 * sqrt(1 - 0.0025)), 0.02);
    check("decrement", s.decrement, 2 * G_PI * 0.05 / sqrt(1 - 0.0025), 0.02);
    check("damping", s.damping, 0.05, 0.003);
    g_assert_cmpfloat(s.period.error, <, 0.05);
    g_assert_cmpfloat(s.decrement.error, <, 0.05);
    g_assert_cmpfloat(s.damping.error, <, 0.008);
}

static double straight(double t)
{
    return 3 - 2 * t;
}

static void test_no_oscillation(void)
{
    TinkerStatistics s;
    fill(100, 2, straight);
    g_assert_true(tinker_statistics(times, values, 100, 0, 2, 0, &s));
    check("mean", s.mean, 1, 1e-12);
    check("rms", s.rms, sqrt(7.0 / 3), 1e-12);
    check("least", s.least, -1, 1e-12);
    g_assert_true(isnan(s.period.value));
    g_assert_true(isnan(s.damping.value));
    g_assert_cmpint(s.no_period, ==, TINKER_SWINGS_TOO_FEW);
    g_assert_false(tinker_statistics(times, values, 6, 0, 0.1, 0, &s));
}

/* Falls 2.05 m onto a floor at 0 that gives back e of the speed, again and again. */
static double bounce(double t, double e)
{
    const double g = 9.81, speed = sqrt(2 * g * 2.05), fall = speed / g;
    if (t < fall) return 2.05 - 0.5 * g * t * t;
    double start = fall, up = e * speed;
    while (t > start + 2 * up / g) {
        start += 2 * up / g;
        up *= e;
    }
    return up * (t - start) - 0.5 * g * (t - start) * (t - start);
}

static double bounce_for_ever(double t)
{
    return bounce(t, 1);
}

static double bounce_less(double t)
{
    return bounce(t, 0.8);
}

/* A kink is where both sides meet: the curve goes down to the floor, which no sample is on, and not below. */
static void test_bounces(void)
{
    TinkerStatistics s;
    fill(801, 8, bounce_for_ever);
    g_assert_true(tinker_statistics(times, values, 801, 0, 8, 0, &s));
    check("least", s.least, 0, 1e-12);
    check("greatest", s.greatest, 2.05, 1e-12);
    check("period", s.period, 2 * sqrt(2 * 2.05 / 9.81), 1e-12);
    physics_assert_near("damping", s.damping.value, 0, 1e-12);
}

/* Each bounce is shorter than the one before: there is no period, and no damping of a swing. */
static void test_uneven(void)
{
    TinkerStatistics s;
    fill(501, 5, bounce_less);
    g_assert_true(tinker_statistics(times, values, 501, 0, 5, 0, &s));
    check("least", s.least, 0, 1e-12);
    g_assert_true(isnan(s.period.value) && isnan(s.decrement.value) && isnan(s.damping.value));
    g_assert_cmpint(s.no_period, ==, TINKER_SWINGS_UNEVEN);
    g_assert_cmpint(s.no_damping, ==, TINKER_SWINGS_UNEVEN);
}

/* A ball that falls from 1 m and rises with half the speed each time, sampled in steps, with both sides of each blow;
 * answers how many samples there are. */
static gsize fill_to_rest(double step, double to)
{
    const double g = 9.81;
    double start = 0, up = 0, height = 1, end = sqrt(2 / g);
    gsize count = 0, next = 0;
    while (start < end && end < to) {
        for (; step * (double)next < end; next++, count++) {
            const double t = times[count] = step * (double)next;
            values[count] = height + up * (t - start) - 0.5 * g * (t - start) * (t - start);
        }
        for (int side = 0; side < 2; side++, count++) {
            times[count] = end;
            values[count] = 0;
        }
        up = 0.5 * (start == 0 ? g * end : up);
        start = end;
        height = 0;
        end = start + 2 * up / g;
        if (end - start < 1e-12) break;
    }
    for (; step * (double)next <= to; next++, count++) {
        times[count] = step * (double)next;
        values[count] = 0;
    }
    return count;
}

static void check_covers(const char *what, TinkerStatistic found, double truth, double most)
{
    const double off = fabs(found.value - truth);
    if (!(off <= found.error * (1 + 1e-9)))
        g_test_fail_printf("%s is off by %.3g, and says %.3g", what, off, found.error);
    g_assert_cmpfloat(found.error, <=, most * (1 + 1e-9));
}

/* Between its last blows no sample lies. A flight of the time s has the area g s^3 / 12 under it and g^2 s^5 / 120
 * under its square; each is half as long as the one before, the first as long as the fall. */
static void test_comes_to_rest(void)
{
    const double g = 9.81, fall = sqrt(2 / g), to = 2;
    static const double steps[] = {0.01, 0.02, 0.025, 0.04, 0.05, 0.1};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        TinkerStatistics s;
        const double most = g * steps[i] * steps[i] / 2; /* of straight pieces between every second sample */
        const gsize count = fill_to_rest(steps[i], to);
        g_assert_true(tinker_statistics(times, values, count, 0, to, 0, &s));
        check_covers("mean", s.mean, (2 * fall / 3 + g * pow(fall, 3) / 12 / (1 - 0.125)) / to, most);
        check_covers("rms", s.rms, sqrt((8 * fall / 15 + g * g * pow(fall, 5) / 120 / (1 - 1 / 32.0)) / to), most);
        check("least", s.least, 0, 1e-12);
    }
    /* the seventh flight alone, no sample within it */
    TinkerStatistics s;
    const double begins = fall * (3 - 2 * pow(0.5, 6)), lasts = fall * pow(0.5, 6);
    const gsize count = fill_to_rest(0.05, to);
    g_assert_true(tinker_statistics(times, values, count, begins, begins + lasts, 0, &s));
    check_covers("greatest", s.greatest, g * lasts * lasts / 8, g * lasts * lasts / 8);
    check_covers("mean", s.mean, g * lasts * lasts / 12, g * lasts * lasts / 12);
}

/* Dry friction takes the same away from each swing, four times what a mass is pulled off by at rest: half a swing of 1
 * s about that, the next about minus that. */
static double pulled_off;

static double rubbed(double t)
{
    const double half = floor(t), amplitude = 1.1 - 2 * pulled_off * half, side = fmod(half, 2) == 0 ? 1 : -1;
    return side * (pulled_off + (amplitude - pulled_off) * cos(G_PI * (t - half)));
}

static void test_dry_friction(void)
{
    static const double much_and_little[] = {0.1, 0.03, 0.004};
    for (gsize i = 0; i < G_N_ELEMENTS(much_and_little); i++) {
        TinkerStatistics s;
        pulled_off = much_and_little[i];
        fill(5001, 5, rubbed);
        g_assert_true(tinker_statistics(times, values, 5001, 0, 5, 0, &s));
        check_covers("period", s.period, 2, 2e-5);
        g_assert_true(isnan(s.decrement.value) && isnan(s.damping.value));
        g_assert_cmpint(s.no_period, ==, TINKER_SWINGS_GOOD);
        g_assert_cmpint(s.no_damping, ==, TINKER_SWINGS_OFF_SHARE);
        /* three extrema fall by the same share as well as by the same amount */
        g_assert_true(tinker_statistics(times, values, 5001, 0.5, 3.5, 0, &s));
        check_covers("period", s.period, 2, 2e-5);
        g_assert_true(isnan(s.decrement.value) && isnan(s.damping.value));
        g_assert_cmpint(s.no_damping, ==, TINKER_SWINGS_TOO_FEW);
    }
}

/* Of what is no number somewhere nothing is known, neither its extrema nor a period. */
static void test_undefined(void)
{
    TinkerStatistics s;
    fill(1000, 5, wave);
    values[500] = NAN;
    g_assert_true(tinker_statistics(times, values, 1000, 0.5, 4.5, 0, &s));
    g_assert_true(isnan(s.mean.value) && isnan(s.greatest.value) && isnan(s.amplitude.error) && isnan(s.period.value));
    g_assert_cmpint(s.no_period, ==, TINKER_SWINGS_UNDEFINED);
    g_assert_true(tinker_statistics(times, values, 1000, 0.5, 2.2, 0, &s));
    check("amplitude", s.amplitude, 3, 1e-7);
}

/* As the error of a formula that divides by what nearly vanishes half way between two samples. */
static double peak(double t)
{
    return 1 / (0.01 + (t - 0.525) * (t - 0.525));
}

static void test_greatest_about(void)
{
    fill(21, 1, peak);
    double about = tinker_greatest_about(times, values, 21, 0, 1);
    g_assert_cmpfloat(values[10], <, 95);
    g_assert_cmpfloat(about, >=, 100);
    g_assert_cmpfloat(about, <, 150);
    g_assert_cmpfloat(tinker_greatest_about(times, values, 21, 0, 0.2), <, 12);
    fill(2001, 1, peak);
    about = tinker_greatest_about(times, values, 2001, 0, 1);
    g_assert_cmpfloat(about, >=, 100);
    g_assert_cmpfloat(about, <, 100.01);
    values[700] = NAN;
    g_assert_true(isnan(tinker_greatest_about(times, values, 2001, 0, 1)));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_set_nonfatal_assertions();
    g_test_add_func("/measure/statistics/wave", test_wave);
    g_test_add_func("/measure/statistics/coarse", test_coarse);
    g_test_add_func("/measure/statistics/damped", test_damped);
    g_test_add_func("/measure/statistics/band", test_band);
    g_test_add_func("/measure/statistics/died-away", test_died_away);
    g_test_add_func("/measure/statistics/no-oscillation", test_no_oscillation);
    g_test_add_func("/measure/statistics/bounces", test_bounces);
    g_test_add_func("/measure/statistics/uneven", test_uneven);
    g_test_add_func("/measure/statistics/comes-to-rest", test_comes_to_rest);
    g_test_add_func("/measure/statistics/dry-friction", test_dry_friction);
    g_test_add_func("/measure/statistics/undefined", test_undefined);
    g_test_add_func("/measure/statistics/greatest-about", test_greatest_about);
    return g_test_run();
}
