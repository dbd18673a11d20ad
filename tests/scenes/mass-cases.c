/* Masses in free flight, on rods and on springs: closed forms, integrals of the motion, equilibrium. */
#include "mass-cases.h"

#include <glib.h>
#include <math.h>

#include "measures.h"
#include "program.h"

void check_network(const char *path)
{
    measure_check_energy(path, GRAVITY, "10");
}

/* Period 4 sqrt(L/g) K(sin(a/2)) for the amplitude a; at the bottom the rod pulls with m g (3 - 2 cos a). */
void check_pendulum(const char *path)
{
    const double angle = G_PI / 3.0, length = 2.5;
    const double quarter = sqrt(length / GRAVITY) * measure_quarter_period(angle);
    const double times[] = {quarter, 2.0 * quarter, 4.0 * quarter};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Bob.x"), 0.0, 1e-8);
    CLOSE(test_table_value(record, 0, "Rod.tension"), GRAVITY * (3.0 - 2.0 * cos(angle)), 1e-7);
    CLOSE(test_table_value(record, 1, "Bob.x"), -length * sin(angle), 1e-8);
    CLOSE(test_table_value(record, 2, "Bob.x"), length * sin(angle), 1e-8);
}

/* The same fall as the table that a graph exports: two columns, trailing zeros dropped. */
static void check_free_fall_table(const char *path)
{
    static const char *const published =
        "Time,Y Position\n0,0\n0.01,-0.00049\n0.02,-0.00196\n0.03,-0.00441\n0.04,-0.00785\n0.05,-0.01226\n"
        "0.06,-0.01766\n0.07,-0.02403\n0.08,-0.03139\n0.09,-0.03973\n0.1,-0.04905\n";
    const char *arguments[] = {"graph", path, "Mass 0.y", "--decimals", "5", "-o", "-", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    g_assert_cmpint(program->status, ==, 0);
    g_assert_true(g_str_has_prefix(program->output, published));
}

/* The first ten rows as they were published for this fall, five decimals each. */
void check_free_fall(const char *path)
{
    static const char *const published[] = {"-0.00049", "-0.00196", "-0.00441", "-0.00785", "-0.01226",
                                            "-0.01766", "-0.02403", "-0.03139", "-0.03973", "-0.04905"};
    const char *options[] = {NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_assert_cmpuint(run->record->rows, ==, 101);
    for (gsize row = 0; row < G_N_ELEMENTS(published); row++) {
        const double y = test_table_value(run->record, row + 1, "Mass 0.y"), t = 0.01 * (double)(row + 1);
        g_autofree char *text = g_strdup_printf("%.5f", y);
        g_assert_cmpstr(text, ==, published[row]);
        CLOSE(y, -0.5 * GRAVITY * t * t, 1e-14);
    }
    check_free_fall_table(path);
}

void check_double_pendulum(const char *path)
{
    measure_check_energy(path, GRAVITY, "10");
}

/* After half a minute those with an even count are back where they were and the others on the far side; after a minute
 * all are back. */
void check_pendulum_wave(const char *path)
{
    const double times[] = {0.0, 30.0, 60.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int count = 20; count <= 34; count++) {
        g_autofree char *column = g_strdup_printf("Bob %d.x", count);
        const double start = test_table_value(record, 0, column);
        g_assert_cmpfloat(start, >, 0.3);
        CLOSE(test_table_value(record, 1, column), count % 2 == 0 ? start : -start, 1e-6);
        CLOSE(test_table_value(record, 2, column), start, 1e-6);
    }
}

/* No force from outside: momentum stays 0 and the angular momentum what it was, 4 m w r^2. */
void check_rotating_square(const char *path)
{
    const double times[] = {0.0, 1.3, 5.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    double radius[G_N_ELEMENTS(times)] = {0.0};
    for (gsize row = 0; row < record->rows; row++) {
        double momentum = 0.0, angular = 0.0;
        for (int i = 0; i < 4; i++) {
            double state[4];
            const char *const quantities[] = {"x", "y", "vx", "vy"};
            for (int q = 0; q < 4; q++) {
                g_autofree char *column = g_strdup_printf("Mass %d.%s", i, quantities[q]);
                state[q] = test_table_value(record, row, column);
            }
            momentum += state[2];
            angular += state[0] * state[3] - state[1] * state[2];
            radius[row] = hypot(state[0], state[1]);
        }
        CLOSE(momentum, 0.0, 1e-10);
        CLOSE(angular, 16.0, 1e-9);
    }
    g_assert_cmpfloat(fabs(radius[1] - radius[0]), >, 0.01);
}

/* At rest every link pulls with the same horizontal force, and the ends carry the weight of 19 beads. */
void check_hanging_cable(const char *path)
{
    const double times[] = {100.0};
    g_autoptr(TestTable) record = measure_at(path, times, 1);
    double from[2] = {-3.0, 2.0}, first = 0.0, up_left = 0.0, up_right = 0.0;
    for (int i = 1; i <= 20; i++) {
        g_autofree char *x = g_strdup_printf("Bead %d.x", i), *y = g_strdup_printf("Bead %d.y", i);
        g_autofree char *tension = g_strdup_printf("Link %d.tension", i);
        const double to[2] = {i < 20 ? test_table_value(record, 0, x) : 3.0,
                              i < 20 ? test_table_value(record, 0, y) : 2.0};
        const double pull = test_table_value(record, 0, tension), length = hypot(to[0] - from[0], to[1] - from[1]);
        const double across = pull * (to[0] - from[0]) / length;
        CLOSE(length, 0.4, 1e-12);
        if (i == 1) {
            first = across;
            up_left = pull * (from[1] - to[1]) / length;
        }
        up_right = pull * (to[1] - from[1]) / length;
        CLOSE(across, first, 1e-6);
        from[0] = to[0];
        from[1] = to[1];
    }
    CLOSE(up_left + up_right, 19 * 0.1 * GRAVITY, 1e-6);
    CLOSE(up_left, up_right, 1e-6);
}

/* y = -(v^2 / g) log(cosh(g t / v)) with v = sqrt(m g / drag). */
void check_terminal_velocity(const char *path)
{
    const struct {
        const char *y, *vy;
        double mass;
    } bodies[] = {{"Light.y", "Light.vy", 1.0}, {"Heavy.y", "Heavy.vy", 4.0}};
    const double times[] = {0.5, 2.0, 5.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize body = 0; body < G_N_ELEMENTS(bodies); body++) {
        const double v = sqrt(bodies[body].mass * GRAVITY / 0.1);
        for (gsize row = 0; row < record->rows; row++) {
            CLOSE(test_table_value(record, row, bodies[body].y), -v * v / GRAVITY * log(cosh(GRAVITY * times[row] / v)),
                  1e-8);
            CLOSE(test_table_value(record, row, bodies[body].vy), -v * tanh(GRAVITY * times[row] / v), 1e-8);
        }
    }
}

void check_four_bar(const char *path)
{
    measure_check_energy(path, 0.0, "10");
}

/* The mean motion is that of a particle in the potential -g L cos + (A w sin)^2 / 4 (Kapitza): upright is stable, so
 * the bob never comes further down than three times the start angle. */
void check_kapitza(const char *path)
{
    const char *options[] = {NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double leftmost = 0.0;
    for (gsize row = 0; row < run->record->rows; row++) {
        g_assert_cmpfloat(test_table_value(run->record, row, "Bob.y"), >, cos(G_PI / 6.0) - 0.08);
        leftmost = fmin(leftmost, test_table_value(run->record, row, "Bob.x"));
    }
    g_assert_cmpfloat(leftmost, <, -0.1);
}

void check_falling_chain(const char *path)
{
    measure_check_energy(path, GRAVITY, "2");
}

void check_projectiles(const char *path)
{
    const double times[] = {0.7, 14.0 / GRAVITY, 2.4};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int degrees = 30; degrees <= 60; degrees += 15) {
        g_autofree char *x = g_strdup_printf("Thrown at %d.x", degrees),
                        *y = g_strdup_printf("Thrown at %d.y", degrees);
        const double angle = degrees * G_PI / 180.0;
        for (gsize row = 0; row < record->rows; row++) {
            const double t = times[row];
            CLOSE(test_table_value(record, row, x), 14.0 * cos(angle) * t, 1e-12 * 30.0);
            CLOSE(test_table_value(record, row, y), 14.0 * sin(angle) * t - 0.5 * GRAVITY * t * t, 1e-12 * 30.0);
        }
    }
}

void check_spring_pendulum(const char *path)
{
    measure_check_energy(path, GRAVITY, "40");
}
