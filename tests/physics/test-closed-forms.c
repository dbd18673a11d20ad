/* Motions with a closed form, from the text of a scene to the samples: wind, motors, moving supports, units. */
#include "physics-fixture.h"

#include <complex.h>
#include <math.h>

/* --- wind --- */

/* v = w + (v0 - w) exp(-c t / m). */
static void test_linear_wind(void)
{
    const double m = 2.0, c = 0.6, w[2] = {3.0, -1.0}, v0[2] = {-2.0, 5.0};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 7, .interval = 0.7, .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy, Mass 0.ay"},
        "{'type': 'mass', 'mass': 2, 'position': [1, 2], 'velocity': [-2, 5]},"
        "{'type': 'wind', 'velocity': [3, -1], 'drag': 0.6}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), decay = exp(-c * t / m);
        for (gsize k = 0; k < 2; k++) {
            double x = (double)(k + 1) + w[k] * t + (v0[k] - w[k]) * m / c * (1 - decay);
            physics_assert_near("place", physics_value(run, i, k), x, 1e-10);
            physics_assert_near("velocity", physics_value(run, i, 2 + k), w[k] + (v0[k] - w[k]) * decay, 1e-10);
        }
        physics_assert_near("acceleration", physics_value(run, i, 4), -c / m * (v0[1] - w[1]) * decay, 1e-10);
    }
}

/* Quadratic drag under gravity from rest: v = -v_end tanh(g t / v_end), v_end = sqrt(m g / c). */
static void test_quadratic_wind(void)
{
    const double m = 3.0, c = 0.25, g = 9.81, end = sqrt(m * g / c);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 5, .columns = "Mass 0.y, Mass 0.vy"},
                    "{'type': 'mass', 'mass': 3}, {'type': 'gravity'}, {'type': 'wind', 'drag_quadratic': 0.25}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        physics_assert_near("y", physics_value(run, i, 0), -end * end / g * log(cosh(g * t / end)), 1e-9);
        physics_assert_near("vy", physics_value(run, i, 1), -end * tanh(g * t / end), 1e-9);
    }
}

/* Pulled from rest at 1 m by k (p - x) - c v: it swings about p. What the hand gave is the kinetic energy, and nothing
 * is stored. A hand that does not pull does nothing. */
static void test_hand(void)
{
    const double m = 2, k = 18, c = 3, p = 4, decay = 0.5 * c / m, omega = sqrt(k / m - decay * decay);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .interval = 0.3, .columns = "Mass 0.x, Mass 0.vx, H.force, H.power, Mass 0.y"},
        "{'type': 'mass', 'mass': 2, 'position': [1, 7]}, {'type': 'hand', 'name': 'H', 'ends': ['Mass 0'],"
        "'place': [4, 7], 'pulls': true, 'stiffness': 18, 'damping': 3},"
        "{'type': 'hand', 'ends': ['Mass 0'], 'place': [9, 9]}");
    double v = 0;
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i),
                     x = p + (1 - p) * exp(-decay * t) * (cos(omega * t) + decay / omega * sin(omega * t));
        v = (p - 1) * exp(-decay * t) * (omega + decay * decay / omega) * sin(omega * t);
        physics_assert_near("x", physics_value(run, i, 0), x, 1e-9);
        physics_assert_near("vx", physics_value(run, i, 1), v, 1e-9);
        physics_assert_near("force", physics_value(run, i, 2), fabs(k * (p - x) - c * v), 1e-8);
        physics_assert_near("power", physics_value(run, i, 3), (k * (p - x) - c * v) * v, 1e-8);
        physics_assert_near("y", physics_value(run, i, 4), 7, 1e-12);
    }
    physics_assert_near("given", run->summary->books[TINKER_BOOK_MOTORS], 0.5 * m * v * v, 1e-8);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-8);
}

/* --- driven oscillators --- */

/* m x'' + c x' + k x = Re((force) exp(i W t)), from x0, v0, under-damped. */
typedef struct {
    double m, c, k, rate, x0, v0;
    double complex force;
} Driven;

static double complex driven_at(double t, const Driven *d, gboolean velocity)
{
    double complex s = I * d->rate, steady = d->force / (d->k + d->c * s + d->m * s * s);
    double decay = 0.5 * d->c / d->m, omega = sqrt(d->k / d->m - decay * decay);
    double complex root = -decay + I * omega;
    double x0 = d->x0 - creal(steady), v0 = d->v0 - creal(s * steady);
    double complex free = x0 - I * (v0 + decay * x0) / omega;
    double complex sum = velocity ? s * steady * cexp(s * t) + root * free * cexp(root * t)
                                  : steady * cexp(s * t) + free * cexp(root * t);
    return creal(sum);
}

static double driven_place(double t, const void *data)
{
    return creal(driven_at(t, data, FALSE));
}

static double driven_velocity(double t, const void *data)
{
    return creal(driven_at(t, data, TRUE));
}

static void check_motor(const char *waveform, double complex unit)
{
    Driven d = {.m = 1.5, .c = 0.4, .k = 25, .rate = 3.1, .x0 = 0.3, .v0 = -0.2};
    d.force = 4.0 * unit * cexp(I * 0.7);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 12, .interval = 0.31, .columns = "Mass 0.x, Mass 0.vx, Motor 0.force"},
        "{'type': 'support', 'position': [-2, 0]},"
        "{'type': 'mass', 'mass': 1.5, 'position': [0.3, 0], 'velocity': [-0.2, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2},"
        "{'type': 'damper', 'ends': ['Mass 0', 'Support 0'], 'damping': 0.4},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': '%s', 'amplitude': 4, 'frequency': 3.1, 'phase': 0.7}",
        waveform);
    physics_assert_follows(run, 0, driven_place, &d, 1e-9);
    physics_assert_follows(run, 1, driven_velocity, &d, 1e-8);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        physics_assert_near("force", physics_value(run, i, 2), creal(d.force * cexp(I * d.rate * t)), 1e-13);
    }
}

static void test_motors(void)
{
    check_motor("cosine", 1.0);
    check_motor("sine", -I);
}

/* The support's displacement u passes through spring and damper: the force on the mass is k u + c u'. */
static void check_support(const char *waveform, double complex unit)
{
    Driven d = {.m = 1.5, .c = 0.4, .k = 25, .rate = 3.1};
    double complex u = 0.15 * unit * cexp(I * 0.4);
    d.force = (d.k + d.c * I * d.rate) * u;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 12, .interval = 0.31, .columns = "Mass 0.x, Mass 0.vx, Support 0.x, Support 0.vx"},
        "{'type': 'support', 'position': [-2, 0]}, {'type': 'mass', 'mass': 1.5},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2},"
        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.4},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': '%s', 'amplitude': 0.15, 'frequency': 3.1,"
        " 'phase': 0.4}",
        waveform);
    physics_assert_follows(run, 0, driven_place, &d, 1e-9);
    physics_assert_follows(run, 1, driven_velocity, &d, 1e-8);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double complex now = u * cexp(I * d.rate * physics_time(run, i));
        physics_assert_near("support's x", physics_value(run, i, 2), -2 + creal(now), 1e-14);
        physics_assert_near("support's vx", physics_value(run, i, 3), creal(I * d.rate * now), 1e-14);
    }
}

static void test_supports(void)
{
    check_support("cosine", 1.0);
    check_support("sine", -I);
}

/* Several gravities, winds and motors add up; motors at angles: constant acceleration. */
static void test_everything_adds_up(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy"},
        "{'type': 'mass', 'mass': 2}, {'type': 'gravity'}, {'type': 'gravity', 'acceleration': 4, 'angle': 0},"
        "{'type': 'wind', 'velocity': [5, 0], 'drag': 0.3}, {'type': 'wind', 'velocity': [0, 2], 'drag': 0.5},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 6, 'frequency': 0, 'angle': '90 deg'},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '3*t'}, 'angle': '180 deg'}");
    /* 2 v' = F0 + F1 t - 0.8 v, so v = a + b t - a exp(-0.4 t). */
    double force[2][2] = {{8 + 1.5, -3}, {-2 * 9.81 + 1.0 + 6, 0}};
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), decay = exp(-0.4 * t);
        for (gsize k = 0; k < 2; k++) {
            double b = force[k][1] / 0.8, a = (force[k][0] - 2 * b) / 0.8;
            physics_assert_near("velocity", physics_value(run, i, 2 + k), a + b * t - a * decay, 1e-10);
            physics_assert_near("place", physics_value(run, i, k), a * t + b * t * t / 2 - a / 0.4 * (1 - decay),
                                1e-10);
        }
    }
}

/* A spring at a point of a turned support, whose place in the world is (1, 2) + R(30 deg) (0.5, -0.2). */
static void test_point_of_turned_support(void)
{
    double c = sqrt(3) / 2, s = 0.5, x = 1 + c * 0.5 + s * 0.2, y = 2 + s * 0.5 - c * 0.2;
    Driven d = {.m = 1, .k = 25, .x0 = 0.1};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4, .columns = "Mass 0.x, Mass 0.y, Spring 0.length"},
        "{'type': 'support', 'position': [1, 2], 'orientation': '30 deg'},"
        "{'type': 'mass', 'position': [%.17g, %.17g]},"
        "{'type': 'spring', 'ends': ['Mass 0', {'block': 'Support 0', 'at': [0.5, -0.2]}], 'rest_length': 1.5}",
        x + 1.6, y);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double stretch = driven_place(physics_time(run, i), &d);
        physics_assert_near("x", physics_value(run, i, 0), x + 1.5 + stretch, 1e-10);
        physics_assert_near("y", physics_value(run, i, 1), y, 1e-10);
        physics_assert_near("length", physics_value(run, i, 2), 1.5 + stretch, 1e-10);
    }
}

/* The point moves with its support, and turns with its orientation once. */
static void test_moving_point(void)
{
    Driven d = {.m = 1, .c = 0.2, .k = 25, .rate = 2};
    d.force = (d.k + d.c * I * d.rate) * -I * 0.3;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 6, .columns = "Mass 0.y, Mass 0.vy"},
        "{'type': 'support', 'orientation': '90 deg'}, {'type': 'mass', 'position': [0, 3]},"
        "{'type': 'spring', 'ends': [{'block': 'Support 0', 'at': [1, 0]}, 'Mass 0'], 'rest_length': 2},"
        "{'type': 'damper', 'ends': [{'block': 'Support 0', 'at': [1, 0]}, 'Mass 0'], 'damping': 0.2},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.3, 'frequency': 2, 'angle': '90 deg'}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        physics_assert_near("y", physics_value(run, i, 0), 3 + driven_place(t, &d), 1e-9);
        physics_assert_near("vy", physics_value(run, i, 1), driven_velocity(t, &d), 1e-8);
    }
}

/* Half a slug on 100 lbf/ft, a foot away, driven at 120 rpm: 1 slug = 1 lbf s^2/ft, 1 lb = 0.45359237 kg. */
static void test_units(void)
{
    const double foot = 0.3048, pound_force = 0.45359237 * 9.80665, slug = pound_force / foot;
    Driven d = {.m = 0.5 * slug, .k = 100 * pound_force / foot, .rate = 4 * G_PI, .x0 = 0.1 * foot, .v0 = -2 * foot};
    d.force = 3 * pound_force * cexp(I * G_PI / 6);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 2, .columns = "Mass 0.y, Mass 0.vy"},
        "{'type': 'support'}, {'type': 'mass', 'mass': '0.5 slug', 'position': [0, '1.1 ft'], 'velocity': [0, '-2 "
        "ft/s']},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': '12 in', 'stiffness': '100 lbf/ft'},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': '3 lbf', 'frequency': '120 rpm', 'phase': '30 deg',"
        " 'angle': '90 deg'}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        physics_assert_near("y", physics_value(run, i, 0), foot + driven_place(t, &d), 1e-10);
        physics_assert_near("vy", physics_value(run, i, 1), driven_velocity(t, &d), 1e-9);
    }
}

/* m x'' + k x = exp(-t) from rest: x = (exp(-t) - cos wt + sin wt / w) / (m (1 + w^2)). */
static void test_expression(void)
{
    const double m = 2, w = 3;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 5, .columns = "Mass 0.x"},
                    "{'type': 'support', 'position': [-1, 0]}, {'type': 'mass', 'mass': 2},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 18},"
                    "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': 'exp(-t)'}, 'amplitude': 7}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), x = (exp(-t) - cos(w * t) + sin(w * t) / w) / (m * (1 + w * w));
        physics_assert_near("x", physics_value(run, i, 0), x, 1e-11);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/closed-forms/linear-wind", test_linear_wind);
    g_test_add_func("/physics/closed-forms/quadratic-wind", test_quadratic_wind);
    g_test_add_func("/physics/closed-forms/hand", test_hand);
    g_test_add_func("/physics/closed-forms/motors", test_motors);
    g_test_add_func("/physics/closed-forms/supports", test_supports);
    g_test_add_func("/physics/closed-forms/everything-adds-up", test_everything_adds_up);
    g_test_add_func("/physics/closed-forms/point-of-turned-support", test_point_of_turned_support);
    g_test_add_func("/physics/closed-forms/moving-point", test_moving_point);
    g_test_add_func("/physics/closed-forms/units", test_units);
    g_test_add_func("/physics/closed-forms/expression", test_expression);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
