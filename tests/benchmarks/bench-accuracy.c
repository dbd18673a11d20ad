/* How accurate steps are: the order of a method, rods over a long time, and a motion that is known to many digits. The
 * suites of tests/ hold the program to such things; here are the figures themselves. */
#include <math.h>

#include "floors.h"
#include "report.h"
#include "scene-text.h"
#include "subject.h"

/* x of m x'' + c x' + k x = 0 with m = 1, c = 0.4, k = 25 from rest at x = 1. */
static double oscillator_exact(double t)
{
    double decay = 0.2, frequency = sqrt(25.0 - decay * decay);
    return exp(-decay * t) * (cos(frequency * t) + decay / frequency * sin(frequency * t));
}

/* The largest error at the end of any step within `duration`. */
static double oscillator_error(double h, double duration)
{
    g_autofree char *text = benchmark_oscillator(FALSE);
    BenchmarkSubject subject = benchmark_subject(text, "rk4", h);
    double worst = 0, place[2];
    while (tinker_simulation_time(subject.simulation) < duration - 0.5 * h) {
        benchmark_subject_step(&subject);
        benchmark_subject_place(&subject, "M0", place);
        worst = fmax(worst, fabs(place[0] - 2.0 - oscillator_exact(tinker_simulation_time(subject.simulation))));
    }
    benchmark_subject_clear(&subject);
    return worst;
}

static void report_oscillator(BenchmarkReport *report)
{
    const char *scene = "S1 oscillator, rk4";
    if (!benchmark_report_wants(report, scene)) return;
    double coarse = oscillator_error(0.01, 100), fine = oscillator_error(0.005, 100);
    benchmark_report_figure(report, scene, "error at 1/100 s, 100 s", coarse, "m", NAN);
    benchmark_report_figure(report, scene, "error at 1/200 s, 100 s", fine, "m", NAN);
    benchmark_report_figure(report, scene, "error at 1/1000 s, 100 s", oscillator_error(0.001, 100), "m", 1e-10);
    benchmark_report_figure(report, scene, "observed order less 4, amount", fabs(log2(coarse / fine) - 4.0), "1", 0.1);
}

static void report_pendulum(BenchmarkReport *report)
{
    const char *scene = "pendulum from level, rk4, 1/100 s";
    if (!benchmark_report_wants(report, scene)) return;
    const double level = G_PI / 2;
    g_autofree char *text = benchmark_chain(1, &level, 1.0);
    BenchmarkSubject subject = benchmark_subject(text, "rk4", 0.01);
    double worst = 0, place[2];
    for (int i = 0; i < 10000; i++) {
        benchmark_subject_step(&subject);
        benchmark_subject_place(&subject, "M0", place);
        worst = fmax(worst, fabs(hypot(place[0], place[1]) - 1.0));
    }
    const TinkerSummary *summary = tinker_simulation_summary(subject.simulation);
    benchmark_report_figure(report, scene, "rod's length over 100 s, off by", worst, "m", 1e-10);
    benchmark_report_figure(report, scene, "energy balance over 100 s, off by", summary->energy_balance_error, "1",
                            1e-3);
    benchmark_subject_clear(&subject);
}

/* x and y of both masses 5 s after both rods were let go level, to 1e-15: the equations in angles in 64-bit mantissas,
 * by the method of order 4 with 50 000 and 100 000 steps, extrapolated. */
static const double double_pendulum_at_5[] = {-0.58686920981627138, -0.80968174647180144, -1.550778469470442,
                                              -1.0759127348126536};

static double floor_double_pendulum_error(double h)
{
    FloorDoublePendulum at = {{G_PI / 2, G_PI / 2}, {0, 0}};
    floor_double_pendulum_steps(&at, h, lround(5 / h));
    double x = sin(at.angle[0]), y = -cos(at.angle[0]);
    double ends[] = {x, y, x + sin(at.angle[1]), y - cos(at.angle[1])}, worst = 0;
    for (int i = 0; i < 4; i++)
        worst = fmax(worst, fabs(ends[i] - double_pendulum_at_5[i]));
    return worst;
}

static double double_pendulum_error(double h)
{
    const double level[2] = {G_PI / 2, G_PI / 2};
    g_autofree char *text = benchmark_chain(2, level, 1.0);
    BenchmarkSubject subject = benchmark_subject(text, "rk4", h);
    double ends[4], worst = 0;
    for (long i = lround(5 / h); i > 0; i--)
        benchmark_subject_step(&subject);
    benchmark_subject_place(&subject, "M0", ends);
    benchmark_subject_place(&subject, "M1", ends + 2);
    for (int i = 0; i < 4; i++)
        worst = fmax(worst, fabs(ends[i] - double_pendulum_at_5[i]));
    benchmark_subject_clear(&subject);
    return worst;
}

static void report_double_pendulum(BenchmarkReport *report)
{
    const char *scene = "S2 double pendulum, rk4, at 5 s";
    if (!benchmark_report_wants(report, scene)) return;
    benchmark_report_figure(report, scene, "error at 1/1000 s", double_pendulum_error(1e-3), "m", 1e-7);
    benchmark_report_figure(report, scene, "error at 1/1000 s of the floor", floor_double_pendulum_error(1e-3), "m",
                            NAN);
    benchmark_report_figure(report, scene, "error at 1/4000 s", double_pendulum_error(2.5e-4), "m", 1e-9);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    report_oscillator(report);
    report_pendulum(report);
    report_double_pendulum(report);
    return benchmark_report_end(report);
}
