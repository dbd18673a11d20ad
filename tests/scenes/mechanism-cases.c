/* Mechanisms whose crank a drive turns evenly have closed forms: the loop of their links is solved by circles and
 * tangents. What moves by itself is held against its energy and its accelerations. */
#include "mechanism-cases.h"

#include <math.h>

#include "measures.h"
#include "program.h"

/* The bar swings as a point at two thirds of its length does. At the bottom its pin carries the weight and the pull
 * towards the centre, m w^2 L / 2 with w^2 = 3 g (1 - cos a) / L. */
void check_compound_pendulum(const char *path)
{
    const double length = 1.2, angle = RADIANS(60.0), mass = 2.0;
    const double quarter = sqrt(length / GRAVITY) * measure_quarter_period(angle);
    const double times[] = {quarter, 2.0 * quarter, 3.3, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Bob.x"), 1.0, 1e-8);
    CLOSE(test_table_value(record, 0, "Centre of percussion.x"), -1.0, 1e-8);
    CLOSE(test_table_value(record, 0, "Pin.force y"), -mass * GRAVITY * (1.0 + 1.5 * (1.0 - cos(angle))), 1e-7);
    CLOSE(test_table_value(record, 1, "Centre of percussion.x"), -1.0 - length * sin(angle), 1e-8);
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++)
        CLOSE(test_table_value(record, row, "Centre of percussion.y"), test_table_value(record, row, "Bob.y"), 1e-8);
}

/* Of the two bars at a row: kinetic energy and weight. */
static double bars_energy(const TestTable *record, gsize row)
{
    return test_table_value(record, row, "Upper bar.kinetic energy") +
           test_table_value(record, row, "Lower bar.kinetic energy") +
           1.2 * GRAVITY * test_table_value(record, row, "Upper bar.y") +
           1.0 * GRAVITY * test_table_value(record, row, "Lower bar.y");
}

/* Chaotic, but its energy is known. */
void check_double_bar_pendulum(const char *path)
{
    g_autoptr(TestTable) record = measure_columns_at(
        path, "0,2,5,10", "Upper bar.kinetic energy,Lower bar.kinetic energy,Upper bar.y,Lower bar.y");
    double fastest = 0.0;
    for (gsize row = 0; row < record->rows; row++) {
        fastest = fmax(fastest, test_table_value(record, row, "Lower bar.kinetic energy"));
        CLOSE(bars_energy(record, row), bars_energy(record, 0), 1e-8);
    }
    g_assert_cmpuint(record->rows, ==, 4);
    g_assert_cmpfloat(fastest, >, 1.0);
}

/* The end of the coupler: twice as far from the crank pin as the rocker pin, where circles about crank pin and rocker
 * pivot meet. */
static void coupler_point(double angle, double *x, double *y)
{
    const double pin[2] = {cos(angle), sin(angle)}, rocker = 2.5;
    const double across[2] = {2.0 - pin[0], -pin[1]}, distance = hypot(across[0], across[1]);
    const double height = sqrt(rocker * rocker - 0.25 * distance * distance);
    const double meet[2] = {pin[0] + 0.5 * across[0] - across[1] / distance * height,
                            pin[1] + 0.5 * across[1] + across[0] / distance * height};
    *x = 2.0 * meet[0] - pin[0];
    *y = 2.0 * meet[1] - pin[1];
}

void check_four_bar_coupler_curve(const char *path)
{
    const double times[] = {0.0, 0.4, 1.7, 2.5, 8.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        double x, y;
        coupler_point(G_PI + 0.5 * G_PI * times[row], &x, &y);
        CLOSE(test_table_value(record, row, "Coupler point.x"), x, 1e-8);
        CLOSE(test_table_value(record, row, "Coupler point.y"), y, 1e-8);
    }
}

/* s = r cos f + q with q = sqrt(l^2 - r^2 sin^2 f); its acceleration is w^2 s''(f). */
void check_slider_crank(const char *path)
{
    const double r = 0.5, l = 1.5, w = 10.0;
    g_autoptr(TestTable) record = measure_columns_at(path, "0,0.1,0.31415926535897932,0.7,2", "Piston.x,Piston.ax");
    for (gsize row = 0; row < record->rows; row++) {
        const double f = w * test_table_value(record, row, "time"), q = sqrt(l * l - r * r * sin(f) * sin(f));
        const double bend = -r * cos(f) - r * r * cos(2.0 * f) / q - pow(r * r * sin(f) * cos(f), 2.0) / (q * q * q);
        CLOSE(test_table_value(record, row, "Piston.x"), r * cos(f) + q, 1e-9);
        CLOSE(test_table_value(record, row, "Piston.ax"), w * w * bend, 1e-6);
    }
}

/* x = r cos wt; the pin carries the accelerated 2.5 kg, at the arm r sin wt. */
void check_scotch_yoke(const char *path)
{
    const double r = 0.6, w = 3.0, mass = 2.5;
    const double times[] = {0.2, 1.0, 2.9, 6.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double f = w * times[row];
        CLOSE(test_table_value(record, row, "Yoke.x"), r * cos(f), 1e-9);
        CLOSE(test_table_value(record, row, "Plunger.vx"), -r * w * sin(f), 1e-8);
        CLOSE(test_table_value(record, row, "Drive.torque"), mass * w * w * r * r * sin(f) * cos(f), 1e-7);
    }
}

/* The arm points from its foot to the crank pin. It turns back where the crank stands across it. */
void check_quick_return(const char *path)
{
    const double r = 0.4, height = 1.9, w = G_PI, b = asin(r);
    const double times[] = {0.3, 1.2, 1.7, 4.9, (0.5 * G_PI + b) / w, (1.5 * G_PI - b) / w};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const gsize sorted = test_table_row(record, times[row]);
        const double f = 0.5 * G_PI + w * times[row];
        CLOSE(test_table_value(record, sorted, "Tool.x"), height * r * cos(f) / (1.0 + r * sin(f)), 1e-8);
        CLOSE(test_table_value(record, sorted, "Arm.angle"), atan2(1.0 + r * sin(f), r * cos(f)), 1e-8);
        if (row >= 4) CLOSE(test_table_value(record, sorted, "Tool.vx"), 0.0, 1e-8);
    }
}

/* The planet rolls inside the ring: where they touch it has no speed. It carries the sun's rim along on its far side.
 */
void check_planetary_gear(const char *path)
{
    const double times[] = {0.7, 5.0, 12.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        CLOSE(test_table_value(record, row, "Arm.angle"), times[row], 1e-9);
        CLOSE(test_table_value(record, row, "Planet.angle"), -1.0 / 0.4 * times[row], 1e-8);
        CLOSE(test_table_value(record, row, "Sun.angle"), (1.0 + 1.4 / 0.6) * times[row], 1e-8);
    }
}

void check_gear_train(const char *path)
{
    const double inertia = 0.045 + (2.43 + 0.03125) / 9.0 + 1.40625 / 81.0, torque = 2.0;
    const double times[] = {0.5, 3.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double rate = torque / inertia * times[row];
        CLOSE(test_table_value(record, row, "Wheel 1.angular velocity"), rate, 1e-9);
        CLOSE(test_table_value(record, row, "Wheel 3.angular velocity"), -rate / 3.0, 1e-9);
        CLOSE(test_table_value(record, row, "Wheel 4.angular velocity"), rate / 9.0, 1e-9);
    }
}

/* Four strands: T - m g = -4 m a for the counterweight, 4 T - M g = M a for the load. */
void check_block_and_tackle(const char *path)
{
    const double m = 13.0, load = 50.0, a = GRAVITY * (4.0 * m - load) / (load + 16.0 * m);
    const double times[] = {1.0, 3.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double risen = 0.5 * a * times[row] * times[row];
        CLOSE(test_table_value(record, row, "Load.y"), risen, 1e-9);
        CLOSE(test_table_value(record, row, "Load.angle"), 0.0, 1e-9);
        CLOSE(test_table_value(record, row, "Counterweight.y"), 2.0 - 4.0 * risen, 1e-9);
        CLOSE(test_table_value(record, row, "Rope.tension"), m * (GRAVITY - 4.0 * a), 1e-7);
    }
}

/* It stays where it is, and its springs carry the moments of the weights beyond them. */
void check_balanced_arm(const char *path)
{
    const double shoulder = RADIANS(60.0), elbow = RADIANS(-20.0);
    const double beyond = 1.5 * GRAVITY * 0.5 * cos(elbow);
    const double all = 2.0 * GRAVITY * 0.6 * cos(shoulder) + 1.5 * GRAVITY * 1.2 * cos(shoulder) + beyond;
    g_autoptr(TestTable) record =
        measure_columns_at(path, "6", "Hand.x,Hand.y,Shoulder spring.torque,Elbow spring.torque");
    CLOSE(test_table_value(record, 0, "Hand.x"), 1.2 * cos(shoulder) + cos(elbow), 1e-9);
    CLOSE(test_table_value(record, 0, "Hand.y"), 1.2 * sin(shoulder) + sin(elbow), 1e-9);
    CLOSE(fabs(test_table_value(record, 0, "Shoulder spring.torque")), all, 1e-8);
    CLOSE(fabs(test_table_value(record, 0, "Elbow spring.torque")), beyond, 1e-8);
}

/* Wound on an axle of radius r: m g - T = m a and T r = I a / r. */
void check_yo_yo(const char *path)
{
    const double mass = 0.5, r = 0.1, inertia = 0.5 * mass * 0.4 * 0.4, a = GRAVITY / (1.0 + inertia / (mass * r * r));
    const double times[] = {0.4, 1.5};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double fallen = 0.5 * a * times[row] * times[row];
        CLOSE(test_table_value(record, row, "Yo-yo.y"), 1.0 - fallen, 1e-9);
        CLOSE(test_table_value(record, row, "Yo-yo.angle"), -fallen / r, 1e-8);
        CLOSE(test_table_value(record, row, "Cord.tension"), mass * (GRAVITY - a), 1e-8);
    }
}

/* The difference of the tensions turns the pulley: (T1 - T2) R = I a / R. */
void check_heavy_pulley(const char *path)
{
    const double heavy = 3.0, light = 2.0, pulley = 4.0, a = (heavy - light) * GRAVITY / (heavy + light + 0.5 * pulley);
    const double times[] = {0.4, 1.2};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double fallen = 0.5 * a * times[row] * times[row];
        CLOSE(test_table_value(record, row, "Heavy.y"), 1.0 - fallen, 1e-9);
        CLOSE(test_table_value(record, row, "Light.y"), -0.6 + fallen, 1e-9);
        CLOSE(test_table_value(record, row, "Heavy cord.tension"), heavy * (GRAVITY - a), 1e-8);
        CLOSE(test_table_value(record, row, "Light cord.tension"), light * (GRAVITY + a), 1e-8);
    }
}
