/* Linear oscillations: closed forms, and amplitudes from the equations in complex numbers. */
#include "oscillation-cases.h"

#include <complex.h>
#include <glib.h>
#include <math.h>

#include "measures.h"
#include "program.h"

/* y = y0 - m g / k (1 - cos(sqrt(k / m) t)). */
void check_spring_mass(const char *path)
{
    const double times[] = {0.3, 2.0 * G_PI / 5.0, 5.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double t = times[row];
        CLOSE(test_table_value(record, row, "Mass 0.y"), 2.0 - GRAVITY / 25.0 * (1.0 - cos(5.0 * t)), 1e-8);
        CLOSE(test_table_value(record, row, "Mass 0.x"), 0.0, 1e-12);
    }
}

/* About its rest (4 - 2 - m g / k), with z = 0.1: -a exp(-z w t) (cos(v t) + z w / v sin(v t)), v = w sqrt(1 - z^2). */
void check_damped_oscillator(const char *path)
{
    const double w = 5.0, z = 0.1, v = w * sqrt(1.0 - z * z), rest = 2.0 - GRAVITY / 25.0, a = rest - 1.1076;
    const double times[] = {0.3, 2.0 * G_PI / v, 4.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double t = times[row], swing = cos(v * t) + z * w / v * sin(v * t);
        CLOSE(test_table_value(record, row, "Mass 0.y"), rest - a * exp(-z * w * t) * swing, 1e-9);
    }
    /* a whole swing later */
    CLOSE((rest - test_table_value(record, 1, "Mass 0.y")) / a, 0.532, 5e-4);
}

void check_motor_on_mass(const char *path)
{
    g_autoptr(TestTable) record = measure_last_period(path, 3.0, 60.0);
    CLOSE(measure_amplitude(record, "Mass 0.x", 3.0), 4.0 / cabs(25.0 - 9.0 + 3.0 * I), 1e-8);
}

/* A mass on a spring k to a support that moves by A sin(wt), with a damper c to the ground: k A / |k - m w^2 + i c w|.
 */
void check_support_motion(const char *path)
{
    g_autoptr(TestTable) record = measure_last_period(path, 4.0, 100.0);
    CLOSE(measure_amplitude(record, "Mass 0.y", 4.0), 25.0 * 0.1 / cabs(25.0 - 16.0 + 0.5 * 4.0 * I), 1e-8);
}

/* Peaks of the drift for this record, from the exact recurrence for piecewise linear input in 30 digits; the one at the
 * samples agrees with Chopra, Dynamics of Structures, sec. 6.4 (2.67 in). */
void check_base_excitation(const char *path)
{
    const char *options[] = {"--tolerance", "1e-11", "--method", "auto", "--columns", "Columns.extension", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double least = 0.0;
    g_assert_cmpuint(run->record->rows, ==, 1560);
    for (gsize row = 0; row < run->record->rows; row++)
        least = fmin(least, test_table_value(run->record, row, "Columns.extension"));
    CLOSE(least, -0.0679400697200715, 1e-7 * 0.0679);

    const double peak_time = 2.35260413318;
    const char *at[] = {"--at", "2.35260413318", "--tolerance", "1e-11", "--columns", "Columns.extension", NULL};
    g_autoptr(TestSceneRun) peak = test_scene_run(path, at);
    const gsize row = test_table_row(peak->record, peak_time);
    CLOSE(test_table_value(peak->record, row, "Columns.extension"), -0.0682745772274636, 1e-7 * 0.0683);
}

/* Displacements of three masses after 10 s, from an exponential of the chain's matrix in quadruple precision: a series
 * of 23 terms and 33 doublings. */
void check_stiff_chain(const char *path)
{
    const double times[] = {10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Mass 1.x"), 0.2 - 0.039405348006644858, 1e-10);
    CLOSE(test_table_value(record, 0, "Mass 25.x"), 5.0 - 0.22589290755500446, 1e-10);
    CLOSE(test_table_value(record, 0, "Mass 50.x"), 10.0 - 0.23318212317135215, 1e-10);
}

/* Two modes: both masses together with k = 25, and against each other with k = 25 + 2 * 2. */
void check_beats(const char *path)
{
    const double times[] = {1.0, 4.0, G_PI / (sqrt(29.0) - 5.0), 40.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double together = 0.3 * cos(5.0 * times[row]), apart = 0.3 * cos(sqrt(29.0) * times[row]);
        CLOSE(test_table_value(record, row, "Mass 0.x"), -1.5 + together + apart, 1e-8);
        CLOSE(test_table_value(record, row, "Mass 1.x"), 1.5 + together - apart, 1e-8);
    }
}

/* Alone, at resonance from rest: x = F / (2 m w^2) (sin wt - wt cos wt). With the absorber the steady amplitude of the
 * two-mass system. */
void check_tuned_mass_damper(const char *path)
{
    const double times[] = {3.3, 10.0};
    g_autoptr(TestTable) alone = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < alone->rows; row++) {
        const double phase = 10.0 * times[row];
        CLOSE(test_table_value(alone, row, "Main mass alone.x"),
              -0.5 + 5.0 / (2.0 * 1000.0) * (sin(phase) - phase * cos(phase)), 1e-8);
    }
    const double w = 10.0, m2 = 0.5, k2 = 45.35, c2 = 1.21;
    const double complex link = k2 + I * c2 * w, main_mass = 1000.0 - 10.0 * w * w;
    const double complex absorber = link - m2 * w * w;
    const double complex steady = 5.0 / (main_mass + link - link * link / absorber);
    g_autoptr(TestTable) record = measure_last_period(path, w, 100.0);
    CLOSE(measure_amplitude(record, "Main mass with absorber.x", w), cabs(steady), 1e-8);
    CLOSE(measure_amplitude(record, "Absorber.x", w), cabs(steady * link / absorber), 1e-8);
}

/* Springs k to a beam that moves by A sin(wt), air drag c on the masses: k A / |k - m w^2 + i c w| each. */
void check_resonance(const char *path)
{
    const double w = 6.0;
    g_autoptr(TestTable) record = measure_last_period(path, w, 200.0);
    for (int i = 0; i < 7; i++) {
        const double own = 4.5 + 0.5 * i;
        g_autofree char *column = g_strdup_printf("Reed %g.y", own);
        CLOSE(measure_amplitude(record, column, w), own * own * 0.06 / cabs(own * own - w * w + I * 0.25 * w), 1e-8);
    }
}
