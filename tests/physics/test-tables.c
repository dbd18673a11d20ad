/* Tables beside the scene: forces linear between the rows, recorded accelerations and splines that drive a support. */
#include "physics-fixture.h"

#include <glib/gstdio.h>
#include <math.h>

static char *folder, *scene_path;

static void write_table(const char *text)
{
    g_autofree char *path = g_build_filename(folder, "table.csv", NULL);
    g_autoptr(GError) error = NULL;
    g_file_set_contents(path, text, -1, &error);
    g_assert_no_error(error);
}

/* Velocity and place of a unit mass under a force that is linear between rows, from rest, by the exact cubic of each
 * piece; the last value holds. */
static void under_linear_pieces(const double (*rows)[2], gsize count, double t, double *x, double *v)
{
    double from = 0, force = rows[0][1];
    *x = *v = 0;
    for (gsize i = 1; i <= count && from < t; i++) {
        double end = i < count ? fmin(rows[i][0], t) : t, h = end - from;
        double slope = i < count ? (rows[i][1] - rows[i - 1][1]) / (rows[i][0] - rows[i - 1][0]) : 0;
        *x += *v * h + force * h * h / 2 + slope * h * h * h / 6;
        *v += force * h + slope * h * h / 2;
        force += slope * h;
        from = end;
    }
}

static const double force_rows[][2] = {{0, 1.5}, {0.37, -2}, {0.9, 4}, {0.93, 4}, {1.6, 0.25}};

static void test_force(void)
{
    write_table("time,force\n0,3\n0.37,-4\n0.9,8\n0.93,8\n1.6,0.5\n");
    static const char *const methods[] = {"dop853", "dopri5", "rk4"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        /* Order 4 and more is exact on a force that is linear in time; steps of 0.05 s do not divide the rows. */
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = methods[m],
                                                                  .duration = 2.5,
                                                                  .interval = 0.11,
                                                                  .step = 0.05,
                                                                  .columns = "Mass 0.x, Mass 0.vx, Motor 0.force",
                                                                  .path = scene_path},
                                                "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'],"
                                                " 'waveform': {'table': 'table.csv', 'column': 1, 'scale': 0.5}}");
        for (gsize i = 0; i < physics_samples(run); i++) {
            double x, v;
            under_linear_pieces(force_rows, G_N_ELEMENTS(force_rows), physics_time(run, i), &x, &v);
            physics_assert_near("x", physics_value(run, i, 0), x, 1e-12);
            physics_assert_near("vx", physics_value(run, i, 1), v, 1e-12);
        }
        physics_assert_near("force behind the table", physics_last(run, 2), 0.25, 0);
    }
}

/* A recorded ground acceleration, integrated exactly from rest; after the last row the acceleration is 0. */
static const double shake_rows[][2] = {{0, 0}, {0.4, 1.962}, {0.7, -0.981}, {1.0, 0}, {1.0000000001, 0}};

static void test_acceleration(void)
{
    write_table("0,0\n0.4,0.2\n0.7,-0.1\n1.0,0\n");
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 1.7, .interval = 0.07, .columns = "Support 0.x, Support 0.vx", .path = scene_path},
        "{'type': 'support', 'position': [3, 0]}, {'type': 'mass', 'position': [5, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'table': 'table.csv', 'column': 1,"
        " 'scale': 9.81, 'kind': 'acceleration'}}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double x, v;
        under_linear_pieces(shake_rows, G_N_ELEMENTS(shake_rows), physics_time(run, i), &x, &v);
        physics_assert_near("x", physics_value(run, i, 0), 3 + x, 1e-14);
        physics_assert_near("vx", physics_value(run, i, 1), v, 1e-14);
    }
}

/* u'' = -u''_ground - w^2 u of the mass relative to the ground, piece by piece: with the ground's acceleration p + r s,
 * a particular solution is -(p + r s) / w^2. */
static void test_shaken_oscillator(void)
{
    const double w = 5;
    write_table("0,0\n0.4,0.2\n0.7,-0.1\n1.0,0\n");
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1,
                                      .interval = 0.1,
                                      .columns = "Mass 0.x, Support 0.x, Mass 0.vx, Support 0.vx",
                                      .path = scene_path},
                    "{'type': 'support'}, {'type': 'mass', 'position': [2, 0]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0']},"
                    "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'table': 'table.csv', 'column': 1,"
                    " 'scale': 9.81, 'kind': 'acceleration'}}");
    double u = 0, rate = 0;
    gsize sample = 0;
    for (gsize piece = 0; piece < 3; piece++) {
        double from = shake_rows[piece][0], end = shake_rows[piece + 1][0], p = shake_rows[piece][1];
        double r = (shake_rows[piece + 1][1] - p) / (end - from), a = u + p / (w * w), b = (rate + r / (w * w)) / w;
        for (;; sample++) {
            gboolean inside = sample < physics_samples(run) && physics_time(run, sample) <= end + 1e-12;
            double s = (inside ? physics_time(run, sample) : end) - from;
            u = a * cos(w * s) + b * sin(w * s) - (p + r * s) / (w * w);
            rate = w * (b * cos(w * s) - a * sin(w * s)) - r / (w * w);
            if (!inside) break;
            double relative = physics_value(run, sample, 0) - physics_value(run, sample, 1) - 2;
            physics_assert_near("relative place", relative, u, 1e-11);
            physics_assert_near("relative velocity", physics_value(run, sample, 2) - physics_value(run, sample, 3),
                                rate, 1e-10);
        }
    }
    g_assert_cmpuint(sample, ==, physics_samples(run));
}

/* --- a place from a table: the natural cubic spline --- */

#define KNOTS 6
static const double knot_time[KNOTS] = {0, 0.5, 0.8, 1.3, 2, 2.4}, knot_value[KNOTS] = {0, 0.2, -0.1, 0.3, 0.3, 0};

/* Second derivatives at the knots by the dense linear system of continuity, solved by Gauss-Seidel to rounding: the
 * system is diagonally dominant. */
static void second_derivatives(double *m)
{
    for (int i = 0; i < KNOTS; i++)
        m[i] = 0;
    for (int sweep = 0; sweep < 200; sweep++)
        for (int i = 1; i < KNOTS - 1; i++) {
            double left = knot_time[i] - knot_time[i - 1], right = knot_time[i + 1] - knot_time[i];
            double bend = (knot_value[i + 1] - knot_value[i]) / right - (knot_value[i] - knot_value[i - 1]) / left;
            m[i] = (6 * bend - left * m[i - 1] - right * m[i + 1]) / (2 * (left + right));
        }
}

static int piece_of(double t)
{
    int i = 0;
    while (i < KNOTS - 2 && t > knot_time[i + 1])
        i++;
    return i;
}

static double spline(const double *m, double t)
{
    int i = piece_of(t);
    double h = knot_time[i + 1] - knot_time[i], a = (knot_time[i + 1] - t) / h, b = (t - knot_time[i]) / h;
    return a * knot_value[i] + b * knot_value[i + 1] +
           ((a * a * a - a) * m[i] + (b * b * b - b) * m[i + 1]) * h * h / 6;
}

static void spline_driven(double t, const double *y, double *rate, const void *data)
{
    rate[0] = y[1];
    rate[1] = -25 * (y[0] - spline(data, t));
}

static void write_knots(void)
{
    GString *text = g_string_new("# time, place\n");
    for (int i = 0; i < KNOTS; i++)
        g_string_append_printf(text, "%g,%g\n", knot_time[i], knot_value[i]);
    write_table(text->str);
    g_string_free(text, TRUE);
}

static void test_spline(void)
{
    write_knots();
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 2.4, .interval = 0.1, .columns = "Mass 0.x, Mass 0.vx, Support 0.x", .path = scene_path},
        "{'type': 'support', 'position': [-2, 0]}, {'type': 'mass'},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'table': 'table.csv', 'column': 1}}");
    double m[KNOTS], y[2] = {0, 0};
    second_derivatives(m);
    for (gsize i = 1; i < physics_samples(run); i++) {
        /* Rows lie on the tenths, so no step crosses a knot. */
        physics_rk4(2, y, physics_time(run, i - 1), physics_time(run, i), 200, spline_driven, m);
        physics_assert_near("x", physics_value(run, i, 0), y[0], 1e-10);
        physics_assert_near("vx", physics_value(run, i, 1), y[1], 1e-10);
        physics_assert_near("support", physics_value(run, i, 2), -2 + spline(m, physics_time(run, i)), 1e-14);
    }
}

/* The spline's first and second derivative. */
static void spline_rates(const double *m, double t, double rates[2])
{
    const int i = piece_of(t);
    const double h = knot_time[i + 1] - knot_time[i], a = (knot_time[i + 1] - t) / h, b = (t - knot_time[i]) / h;
    rates[0] = (knot_value[i + 1] - knot_value[i]) / h + ((3 * b * b - 1) * m[i + 1] - (3 * a * a - 1) * m[i]) * h / 6;
    rates[1] = a * m[i] + b * m[i + 1];
}

#define DRIVEN_BAR                                                                                                     \
    "{'type': 'support', 'solid': false}, {'type': 'bar', 'position': [0.5, 0], 'velocity': [0, 0.25]},"               \
    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"                                     \
    "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 0,"                                                    \
    " 'waveform': {'table': 'table.csv', 'column': 1}}"

/* A bar that a drive turns by the same table, from within its first piece: a corner at a row no bar could follow. The
 * torque is I times the second derivative. The table ends with the run, where its rate jumps to 0: the bar need not
 * follow that any more, and the last sample has the rate before it. A run that goes on would have to. */
static void test_drive(void)
{
    write_knots();
    double m[KNOTS], rates[2] = {0};
    second_derivatives(m);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2.4,
                                      .interval = 0.1,
                                      .columns = "Bar 0.angle, Bar 0.x, Bar 0.angular velocity, "
                                                 "Drive 0.torque",
                                      .path = scene_path},
                    DRIVEN_BAR);
    for (gsize i = 1; i < physics_samples(run); i++) {
        const double t = physics_time(run, i), angle = spline(m, t);
        spline_rates(m, t, rates);
        physics_assert_near("angle", physics_value(run, i, 0), angle, 1e-12);
        physics_assert_near("x", physics_value(run, i, 1), 0.5 * cos(angle), 1e-12);
        physics_assert_near("rate", physics_value(run, i, 2), rates[0], 1e-11);
        physics_assert_near("torque", physics_value(run, i, 3), rates[1] / 3, 1e-10);
    }
    g_assert_cmpfloat(fabs(rates[0]), >, 0.5);
    g_autoptr(PhysicsRun) longer = physics_try(&(PhysicsOptions){.duration = 2.5, .path = scene_path}, DRIVEN_BAR);
    physics_assert_refused(longer, TINKER_MODEL_ERROR_SCENE, "Drive 0", "2.4 s", NULL);
}

/* The end of a spring on that bar jumps at the instant at which the table ends: what follows neither is not booked, so
 * the books close, and are those of a run in which nothing jumps. */
static void test_drive_and_jump(void)
{
    static const char *const places[] = {"0*t", "if(t < 2.4, 0, 1)"};
    double given[2];
    write_knots();
    for (int jumps = 0; jumps < 2; jumps++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 2.4, .interval = 0.1, .columns = "Bar 0.angle", .path = scene_path},
            DRIVEN_BAR ", {'type': 'support', 'position': [0.5, 3], 'solid': false},"
                       "{'type': 'spring', 'ends': ['Support 1', 'Bar 0'], 'stiffness': 7},"
                       "{'type': 'support-motion', 'ends': ['Support 1'], 'waveform': {'expression': '%s'}}",
            places[jumps]);
        physics_assert_near("balance error", run->summary->energy_balance_error, 0, 1e-8);
        given[jumps] = run->summary->books[TINKER_BOOK_SUPPORT_MOTION];
    }
    physics_assert_near("given by the support", given[1], given[0], 1e-12);
}

static void add_tests(void)
{
    g_test_add_func("/physics/tables/force", test_force);
    g_test_add_func("/physics/tables/acceleration", test_acceleration);
    g_test_add_func("/physics/tables/shaken-oscillator", test_shaken_oscillator);
    g_test_add_func("/physics/tables/spline", test_spline);
    g_test_add_func("/physics/tables/drive", test_drive);
    g_test_add_func("/physics/tables/drive-and-jump", test_drive_and_jump);
}

int main(int argc, char **argv)
{
    folder = g_dir_make_tmp("tinker-tables-XXXXXX", NULL);
    g_assert_nonnull(folder);
    scene_path = g_build_filename(folder, "scene.tinker.json", NULL);
    int status = physics_main(argc, argv, add_tests);
    g_autofree char *table = g_build_filename(folder, "table.csv", NULL);
    g_unlink(table);
    g_rmdir(folder);
    g_free(scene_path);
    g_free(folder);
    return status;
}
