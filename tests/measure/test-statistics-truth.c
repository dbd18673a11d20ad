/* Signals with closed forms, at from two samples a swing to a thousand, over parts that begin and end anywhere:
 * whatever is shown, its error covers the truth. Sums of swings, each of which grows or falls by its own share, are
 * integrated in the complex plane:
 *
 *     y = Re sum A e^(z t),    int Re(A e^(z t)) dt = Re(A / z e^(z t)),    Re(a) Re(b) = Re(a b + a b*) / 2. */
#include <complex.h>
#include <math.h>

#include "measure/statistics.h"
#include "physics-fixture.h"

#define MOST  200000
#define TERMS 3
#define FINE  40000 /* times at which a signal is asked for its extrema */

typedef struct {
    const char *name;
    double (*form)(double t); /* NULL: the sum of terms */
    double complex size[TERMS], rate[TERMS];
    double lasts, swing;      /* s: all of it, and the shortest swing in it */
    double period, decrement; /* NAN: none may be shown */
    gboolean open;            /* well sampled as well it may be left open */
} Signal;

static double triangle(double t)
{
    const double s = fmod(t, 2);
    return s < 1 ? s : 2 - s;
}

static double steep(double t)
{
    const double s = fmod(t, 2);
    return s < 0.4 ? s / 0.4 : (2 - s) / 1.6;
}

static double rectified(double t)
{
    return fabs(sin(t));
}

static double peaked(double t)
{
    return exp(5 * cos(t));
}

static double narrow(double t)
{
    return 1 / (1.05 - cos(t));
}

static double clipped(double t)
{
    return tanh(3 * sin(t));
}

static double flat_topped(double t)
{
    return fmin(sin(t), 0.5);
}

static double half_wave(double t)
{
    return fmax(sin(t), 0);
}

static double level_then_parabola(double t)
{
    return pow(fmax(sin(t), 0), 2);
}

static double flat_both_ways(double t)
{
    return fmax(-0.3, fmin(0.6, sin(t) + 0.2 * sin(2 * t)));
}

#define TURN (2 * G_PI)
static const Signal signals[] = {
    {"swing", NULL, {1, 2 * I}, {0, 3 * I}, 17.3, TURN / 3, TURN / 3, 0},
    {"damped", NULL, {0.5, 1 + I}, {0, -0.1 + 4 * I}, 20.2, TURN / 4, TURN / 4, 0.1 * TURN / 4},
    {"soon over", NULL, {1}, {-0.8 + 4 * I}, 6.1, TURN / 4, TURN / 4, 0.8 * TURN / 4},
    {"hardly damped", NULL, {1 + I}, {-0.002 + 4 * I}, 31, TURN / 4, TURN / 4, 0.002 * TURN / 4},
    {"growing", NULL, {1 + I}, {0.1 + 4 * I}, 12, TURN / 4, TURN / 4, -0.1 * TURN / 4},
    {"third harmonic", NULL, {-I, -0.9 * I}, {I, 3 * I}, 40, TURN / 3, TURN, NAN},
    {"octave", NULL, {-I, 0.3 - 0.8 * I}, {I, 2 * I}, 40, TURN / 2, TURN, NAN},
    {"on a slow one", NULL, {-I, 2 + I}, {I, 4 * I}, 40, TURN / 4, TURN, NAN},
    {"beat", NULL, {-I, -I}, {10 * I, 11 * I}, 20, TURN / 11, TURN, NAN},
    {"no common period", NULL, {-I, -I}, {I, M_SQRT2 *I}, 60, TURN / M_SQRT2, NAN, NAN},
    {"modulated", NULL, {1, -0.25 * I, 0.25 * I}, {5 * I, 5.7 * I, 4.3 * I}, 30, TURN / 5.7, NAN, NAN},
    {"sinking", NULL, {4, 1 + I}, {-0.05, -0.1 + 4 * I}, 12, TURN / 4, TURN / 4, 0.1 * TURN / 4},
    {"built up", NULL, {1, -0.7}, {4 * I, -0.1 + 4 * I}, 20, TURN / 4, TURN / 4, 0},
    {"hardly there", NULL, {1e6, -1e-3 * I}, {0, 2 * I}, 20, TURN / 2, TURN / 2, 0},
    {"triangle", triangle, {0}, {0}, 14, 2, 2, 0},
    {"steep one way", steep, {0}, {0}, 14, 2, 2, 0},
    {"rectified", rectified, {0}, {0}, 20, G_PI, G_PI, 0},
    {"peaked", peaked, {0}, {0}, 40, TURN / 2, TURN, 0},
    {"narrow peaks", narrow, {0}, {0}, 40, TURN / 8, TURN, 0},
    {"clipped", clipped, {0}, {0}, 40, TURN / 4, TURN, 0},
    {"flat-topped", flat_topped, {0}, {0}, 40, TURN / 4, TURN, 0},
    {"half wave", half_wave, {0}, {0}, 40, TURN / 4, TURN, 0},
    {"level, then a parabola", level_then_parabola, {0}, {0}, 40, TURN / 4, TURN, 0, TRUE},
    {"flat both ways", flat_both_ways, {0}, {0}, 40, TURN / 4, TURN, 0},
};

static double value_of(const Signal *signal, double t)
{
    double sum = 0;
    if (signal->form != NULL) return signal->form(t);
    for (int k = 0; k < TERMS; k++)
        sum += creal(signal->size[k] * cexp(signal->rate[k] * t));
    return sum;
}

static double area(double complex size, double complex rate, double from, double to)
{
    if (rate == 0) return creal(size) * (to - from);
    return creal(size / rate * (cexp(rate * to) - cexp(rate * from)));
}

/* Mean and root mean square, of forms that are no sums by the midpoint rule; and the extrema. */
typedef struct {
    double mean, rms, least, greatest;
} Truth;

static Truth truth_of(const Signal *signal, double from, double to)
{
    double mean = 0, square = 0;
    Truth truth = {0, 0, INFINITY, -INFINITY};
    for (int i = 0; i <= 2 * FINE; i++) {
        const double y = value_of(signal, from + (to - from) * i / (2 * FINE));
        truth.least = fmin(truth.least, y);
        truth.greatest = fmax(truth.greatest, y);
        mean += i % 2 ? y / FINE : 0;
        square += i % 2 ? y * y / FINE : 0;
    }
    for (int k = 0; signal->form == NULL && k < TERMS; k++) {
        mean = (k == 0 ? 0 : mean) + area(signal->size[k], signal->rate[k], from, to) / (to - from);
        for (int j = 0; j < TERMS; j++) {
            const double complex a = signal->size[k], b = signal->size[j], p = signal->rate[k], q = signal->rate[j];
            const double both = area(a * b, p + q, from, to) + area(a * conj(b), p + conj(q), from, to);
            square = (k + j == 0 ? 0 : square) + 0.5 * both / (to - from);
        }
    }
    truth.mean = mean;
    truth.rms = sqrt(square);
    return truth;
}

/* `slack`: of the truth itself. */
static void check(const Signal *signal, double samples, const char *what, TinkerStatistic found, double truth,
                  double slack)
{
    if (isnan(found.value)) return;
    if (!(fabs(found.value - truth) <= found.error + slack))
        g_test_fail_printf("%s, %g samples a swing: %s %.9g ± %.2g, where %.9g is true", signal->name, samples, what,
                           found.value, found.error, truth);
}

static void check_part(const Signal *signal, double samples, gsize count, const double *times, const double *values,
                       double from, double to)
{
    TinkerStatistics s;
    g_assert_true(tinker_statistics(times, values, count, from, to, 0, &s));
    const Truth truth = truth_of(signal, from, to);
    const double size = fmax(fabs(truth.least), fabs(truth.greatest)), range = truth.greatest - truth.least;
    const double missed = signal->form != NULL ? 3e-4 : 1e-5; /* of the range: extrema between the times asked for */
    const double slack = 1e-13 * size + missed * range;
    check(signal, samples, "mean", s.mean, truth.mean, slack);
    check(signal, samples, "rms", s.rms, truth.rms, slack);
    check(signal, samples, "least", s.least, truth.least, slack);
    check(signal, samples, "greatest", s.greatest, truth.greatest, slack);
    check(signal, samples, "amplitude", s.amplitude, 0.5 * range, slack);
    check(signal, samples, "period", s.period, signal->period, 1e-12 * signal->period);
    check(signal, samples, "decrement", s.decrement, signal->decrement, 1e-12);
    if (samples < 100 || signal->open) return;
    /* no excuse: what is well sampled is known well */
    g_assert_cmpfloat(s.mean.error, <, 1e-3 * range);
    g_assert_cmpfloat(s.amplitude.error, <, 5e-3 * range);
    g_assert_true(isnan(signal->period) == isnan(s.period.value));
    if (!isnan(signal->period)) g_assert_cmpfloat(s.period.error, <, 5e-3 * signal->period);
}

static void test_signal(gconstpointer data)
{
    static const double densities[] = {2.3, 3.1, 4.2, 5.3, 6.7, 8.1, 11.3, 14.9, 20.7, 33.3, 60.1, 200.3, 1000.7};
    const Signal *signal = data;
    g_autofree double *times = g_new(double, MOST), *values = g_new(double, MOST);
    for (gsize k = 0; k < G_N_ELEMENTS(densities); k++) {
        const double step = signal->swing / densities[k];
        const gsize count = (gsize)(signal->lasts / step) + 1;
        g_assert_cmpuint(count, <, MOST);
        for (gsize i = 0; i < count; i++) {
            times[i] = (double)i * step;
            values[i] = value_of(signal, times[i]);
        }
        if (count < 10) continue;
        const double end = times[count - 1];
        check_part(signal, densities[k], count, times, values, 0, end);
        check_part(signal, densities[k], count, times, values, 0, 0.83 * end);
        check_part(signal, densities[k], count, times, values, 0.09 * end, end);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_set_nonfatal_assertions();
    for (gsize i = 0; i < G_N_ELEMENTS(signals); i++) {
        g_autofree char *path = g_strconcat("/measure/statistics/truth/", signals[i].name, NULL);
        g_test_add_data_func(path, &signals[i], test_signal);
    }
    return g_test_run();
}
