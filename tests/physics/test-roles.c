/* Roles that no bundled block fills, through blocks made for it, against closed forms and independent integrations. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "test-systems.h"

#include <math.h>

static void assert_balanced(const PhysicsRun *run)
{
    physics_assert_near("balance error", run->summary->energy_balance_error, 0, 1e-9);
}

/* x'' = -k x^3: x = A cn(A sqrt(k) t, 1/sqrt 2). The host takes differences where a method wants derivatives. */
static void test_cubic_line(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 6, .interval = 0.3, .tolerance = 1e-11, .columns = "Mass 0.x, Mass 0.vx"},
        "{'type': 'support', 'solid': false, 'position': [-2, 0]}, {'type': 'mass', 'position': [0.8, 0]},"
        "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 7, 'length': 2}");
    g_assert_cmpint(tinker_model_sizes(run->model).nonlinear_lines, ==, 1);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double rate = 0.8 * sqrt(7), sn, cn, dn;
        jacobi(rate * physics_time(run, i), G_SQRT2 / 2, &sn, &cn, &dn);
        physics_assert_near("x", physics_value(run, i, 0), 0.8 * cn, 1e-9);
        physics_assert_near("vx", physics_value(run, i, 1), -0.8 * rate * sn * dn, 1e-9);
    }
    physics_assert_near("dampers", run->summary->books[TINKER_BOOK_DAMPERS], 0, 1e-14);
    physics_assert_near("stored at the start", run->summary->potential_start, 0.25 * 7 * pow(0.8, 4), 1e-14);
    assert_balanced(run);
}

/* A mass on a rod of 2 m, turned back by a torsional spring against the arm to another support: m L^2 phi'' = -k phi.
 */
static void test_torsion(void)
{
    const double start = 1.1, rate = sqrt(5 / (0.7 * 4));
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 7, .tolerance = 1e-11, .columns = "Mass 0.x, Mass 0.y"},
        "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [3, 0]},"
        "{'type': 'mass', 'mass': 0.7, 'position': [%.17g, %.17g]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'torsion', 'ends': ['Support 1', 'Support 0', 'Mass 0'], 'stiffness': 5}",
        2 * cos(start), 2 * sin(start));
    for (gsize i = 0; i < physics_samples(run); i++) {
        double angle = start * cos(rate * physics_time(run, i));
        physics_assert_near("x", physics_value(run, i, 0), 2 * cos(angle), 1e-9);
        physics_assert_near("y", physics_value(run, i, 1), 2 * sin(angle), 1e-9);
    }
    physics_assert_near("stored at the start", run->summary->potential_start, 2.5 * start * start, 1e-13);
    physics_assert_near("motors", run->summary->books[TINKER_BOOK_MOTORS], 0, 1e-9);
    assert_balanced(run);
}

/* Many elements of different numbers of ends: every end swings about the middle of its own, which stays. */
static void test_bundles(void)
{
    const int count = 600;
    GString *text = g_string_new(NULL);
    for (int i = 0, mass = 0; i < count; i++) {
        int ends = 2 + i % 3 % 2;
        GString *names = g_string_new(NULL);
        for (int e = 0; e < ends; e++, mass++) {
            double place[2] = {10.0 * i + (e == 0 ? 0.1 : -0.1 / (ends - 1)), e == 0 ? 0.2 : -0.2 / (ends - 1)};
            g_string_append_printf(text, "{'type': 'mass', 'mass': 0.5, 'position': [%.17g, %.17g]},", place[0],
                                   place[1]);
            g_string_append_printf(names, "%s'Mass %d'", e > 0 ? ", " : "", mass);
        }
        g_string_append_printf(text, "{'type': 'bundle', 'ends': [%s], 'stiffness': 4.5}%s", names->str,
                               i + 1 < count ? "," : "");
        g_string_free(names, TRUE);
    }
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 0.7, .tolerance = 1e-10}, "%s", text->str);
    g_string_free(text, TRUE);
    for (int i = 0, mass = 0; i < count; i++) {
        int ends = 2 + i % 3 % 2;
        for (int e = 0; e < ends; e++, mass++) {
            double share = (e == 0 ? 1 : -1.0 / (ends - 1)) * cos(3 * 0.7), state[4];
            g_autofree char *name = g_strdup_printf("Mass %d", mass);
            physics_state(run, name, state);
            physics_assert_near(name, state[0], 10.0 * i + 0.1 * share, 1e-8);
            physics_assert_near(name, state[1], 0.2 * share, 1e-8);
        }
    }
}

/* Two bodies on an ellipse of eccentricity 0.6 about their common centre; E - e sin E = n t by Newton's iteration. */
static void test_kepler(void)
{
    const double e = 0.6, m[2] = {1, 3}, mu = 2 * (m[0] + m[1]), n = sqrt(mu), b = sqrt(1 - e * e);
    const double speed = sqrt(mu * (1 + e) / (1 - e)), part[2] = {-m[1] / (m[0] + m[1]), m[0] / (m[0] + m[1])};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 7, .interval = 0.1, .tolerance = 1e-12, .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y"},
        "{'type': 'attraction', 'strength': 2}, {'type': 'mass', 'mass': 1, 'position': [%.17g, 0], 'velocity': [0, "
        "%.17g]},"
        "{'type': 'mass', 'mass': 3, 'position': [%.17g, 0], 'velocity': [0, %.17g]}",
        part[0] * (1 - e), part[0] * speed, part[1] * (1 - e), part[1] * speed);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double mean = n * physics_time(run, i), anomaly = mean;
        for (int k = 0; k < 50; k++)
            anomaly -= (anomaly - e * sin(anomaly) - mean) / (1 - e * cos(anomaly));
        for (gsize k = 0; k < 2; k++) {
            physics_assert_near("x", physics_value(run, i, 2 * k), part[k] * (cos(anomaly) - e), 1e-8);
            physics_assert_near("y", physics_value(run, i, 2 * k + 1), part[k] * b * sin(anomaly), 1e-8);
        }
    }
    physics_assert_near("potential", run->summary->potential_start, -2 * 3 / (1 - e), 1e-13);
    physics_assert_near("fields", run->summary->books[TINKER_BOOK_FIELDS], 0, 1e-8);
    assert_balanced(run);
}

/* A pendulum whose length is driven, r = 1 + 0.3 sin 2t: theta'' = -(g sin theta + 2 r' theta') / r. */
static void driven_length(double t, const double *y, double *rate, const void *data)
{
    double r = 1 + 0.3 * sin(2 * t), v = 0.6 * cos(2 * t);
    rate[0] = y[1];
    rate[1] = -(9.81 * sin(y[0]) + 2 * v * y[1]) / r;
}

static double energy_of(double t, const double *y)
{
    double r = 1 + 0.3 * sin(2 * t), v = 0.6 * cos(2 * t);
    return 2 * (0.5 * (v * v + r * r * y[1] * y[1]) - 9.81 * r * cos(y[0]));
}

static void test_actuator(void)
{
    double y[2] = {0.5, 0}, start = energy_of(0, y);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 5, .interval = 0.25, .columns = "Mass 0.x, Mass 0.y, Mass 0.vx"},
        "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
        "{'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},"
        "{'type': 'actuator', 'ends': ['Support 0', 'Mass 0'], 'waveform': {'expression': '1 + 0.3*sin(2*t)'}}",
        sin(0.5), -cos(0.5), 0.6 * sin(0.5), -0.6 * cos(0.5));
    g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    for (gsize i = 1; i < physics_samples(run); i++) {
        double t = physics_time(run, i), r = 1 + 0.3 * sin(2 * t), v = 0.6 * cos(2 * t);
        physics_rk4(2, y, physics_time(run, i - 1), t, 1000, driven_length, NULL);
        physics_assert_near("x", physics_value(run, i, 0), r * sin(y[0]), 1e-9);
        physics_assert_near("y", physics_value(run, i, 1), -r * cos(y[0]), 1e-9);
        physics_assert_near("vx", physics_value(run, i, 2), v * sin(y[0]) + r * y[1] * cos(y[0]), 1e-9);
    }
    physics_assert_near("motors", run->summary->books[TINKER_BOOK_MOTORS], energy_of(5, y) - start, 1e-8);
    assert_balanced(run);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
}

/* A spring of rest length 0 on a support that goes round a circle: both axes are driven oscillators of their own. */
static void test_orbit(void)
{
    const double r = 0.4, w = 2, gain = 25 / (25 - w * w);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 5,
                          .interval = 0.25,
                          .tolerance = 1e-11,
                          .columns = "Mass 0.x, Mass 0.y, Support 0.x, Support 0.y, Support 0.vx, Support 0.vy"},
        "{'type': 'support', 'solid': false, 'position': [1, 2]}, {'type': 'mass', 'position': [1, 2]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 0},"
        "{'type': 'orbit', 'ends': ['Support 0'], 'radius': 0.4, 'rate': 2}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), c = cos(w * t), s = sin(w * t);
        double x = r * (gain * c - 1 + (1 - gain) * cos(5 * t)), y = r * gain * (s - w / 5 * sin(5 * t));
        physics_assert_near("x", physics_value(run, i, 0), 1 + x, 1e-9);
        physics_assert_near("y", physics_value(run, i, 1), 2 + y, 1e-9);
        physics_assert_near("support's x", physics_value(run, i, 2), 1 + r * c - r, 1e-15);
        physics_assert_near("support's y", physics_value(run, i, 3), 2 + r * s, 1e-15);
        physics_assert_near("support's vx", physics_value(run, i, 4), -w * r * s, 1e-15);
        physics_assert_near("support's vy", physics_value(run, i, 5), w * r * c, 1e-15);
    }
    assert_balanced(run);
}

static void add_tests(void)
{
    g_test_add_func("/physics/roles/cubic-line", test_cubic_line);
    g_test_add_func("/physics/roles/torsion", test_torsion);
    g_test_add_func("/physics/roles/bundles", test_bundles);
    g_test_add_func("/physics/roles/kepler", test_kepler);
    g_test_add_func("/physics/roles/actuator", test_actuator);
    g_test_add_func("/physics/roles/orbit", test_orbit);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
