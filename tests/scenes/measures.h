/* What is measured of a run to hold it against what is known. */
#ifndef TEST_MEASURES_H
#define TEST_MEASURES_H

#include "table.h"

#define GRAVITY                        9.81
#define CLOSE(actual, expected, limit) g_assert_cmpfloat_with_epsilon(actual, expected, limit)
#define RADIANS(degrees)               ((degrees)*G_PI / 180.0)

/* Runs a scene with samples at these times, with errors far below the limits used here. (transfer full) */
TestTable *measure_at(const char *path, const double *times, gsize count);

/* Values at a time, written as text, of columns that need not be recorded by themselves: "NAME.QUANTITY,...".
 * (transfer full) */
TestTable *measure_columns_at(const char *path, const char *time, const char *columns);

/* Runs a scene with samples over the last period of the angular frequency w (rad/s) before `until`. (transfer full) */
TestTable *measure_last_period(const char *path, double w, double until);

/* The amplitude with which a column swings over such a period: the first Fourier coefficient, to which a constant does
 * not contribute. */
double measure_amplitude(const TestTable *record, const char *column, double w);

/* Fails the test unless the energy of all masses and springs of the scene stays what it was, to 1e-8 of the largest
 * kinetic energy. `gravity` in m/s^2, downwards. */
void measure_check_energy(const char *path, double gravity, const char *duration);

/* K(sin(angle / 2)), the complete elliptic integral, by the arithmetic-geometric mean: a quarter period of the pendulum
 * with this amplitude, over sqrt(L / g). */
double measure_quarter_period(double angle);

#endif
