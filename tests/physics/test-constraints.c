/* Rods: lengths that are kept, tensions, velocities at the start, and what is refused. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "physics/system/summary.h"
#include "test-systems.h"

#include <math.h>
#include <string.h>

#define PENDULUM                                                                                                       \
    "{'type': 'support'}, {'type': 'gravity'},"                                                                        \
    "{'type': 'mass', 'mass': 2.5, 'position': [1.1820866548733862, 0.5409908875112851]},"                             \
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1.3}"

/* Released at 2 rad from the lowest place. */
static Pendulum pendulum(void)
{
    Pendulum p;
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    return p;
}

static void test_length_is_kept(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dopri5", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = methods[m],
                                                                  .duration = 100,
                                                                  .interval = 0.173,
                                                                  .tolerance = 1e-9,
                                                                  .columns = "Rod 0.length error"},
                                                PENDULUM);
        for (gsize i = 0; i < physics_samples(run); i++)
            physics_assert_near("length error", physics_value(run, i, 0), 0, 1e-10);
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
        g_assert_cmpfloat(run->summary->constraint_velocity_error, <, 1e-10);
    }
}

/* T = m (g cos theta + v^2 / L), with theta from the downward vertical. */
static void test_tension(void)
{
    Pendulum p = pendulum();
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 6, .interval = 0.1, .columns = "Rod 0.tension, Mass 0.x, Mass 0.vy"}, PENDULUM);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double q[2], v[2];
        pendulum_exact(&p, physics_time(run, i), q, v);
        double tension = 2.5 * (9.81 * -q[1] / 1.3 + (v[0] * v[0] + v[1] * v[1]) / 1.3);
        physics_assert_near("tension", physics_value(run, i, 0), tension, 2e-8);
        physics_assert_near("x", physics_value(run, i, 1), q[0], 1e-9);
        physics_assert_near("vy", physics_value(run, i, 2), v[1], 5e-9);
    }
}

/* --- velocities at the start --- */

static void test_start_velocity_of_pendulum(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Mass 0.vx, Mass 0.vy"},
                    "{'type': 'support'}, {'type': 'mass', 'mass': 2, 'position': [0.6, -0.8], 'velocity': [1, 2]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    double along = 0.6 * 1 - 0.8 * 2;
    physics_assert_near("vx", physics_value(run, 0, 0), 1 - along * 0.6, 1e-15);
    physics_assert_near("vy", physics_value(run, 0, 1), 2 + along * 0.8, 1e-15);
    physics_assert_near("impulse", run->summary->start_impulse, 2 * fabs(along), 1e-14);
    g_assert_cmpuint(run->summary->warnings->len, ==, 1);
    g_assert_nonnull(strstr(tinker_warnings_text(run->summary->warnings, 0), "velocities"));
    g_assert_cmpuint(run->summary->events->len, ==, 1);
    const TinkerEvent *event = g_ptr_array_index(run->summary->events, 0);
    g_assert_cmpstr(event->kind, ==, "start");
    g_assert_cmpfloat(event->time, ==, 0);
}

/* An impulse of 1.5 N s along the rod makes 1 kg at (2, 1) m/s and 3 kg at rest fit; they then turn about their centre
 * of mass with -1 m/s over 2 m. */
static void test_start_velocity_of_pair(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4, .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Rod 0.tension"},
        "{'type': 'mass', 'mass': 1, 'velocity': [2, 1]}, {'type': 'mass', 'mass': 3, 'position': [2, 0]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), angle = -0.5 * t, c = cos(angle), s = sin(angle);
        double x = 1.5 + 0.5 * t, y = 0.25 * t;
        physics_assert_near("x of the light one", physics_value(run, i, 0), x - 1.5 * c, 1e-11);
        physics_assert_near("y of the light one", physics_value(run, i, 1), y - 1.5 * s, 1e-11);
        physics_assert_near("x of the heavy one", physics_value(run, i, 2), x + 0.5 * c, 1e-11);
        physics_assert_near("y of the heavy one", physics_value(run, i, 3), y + 0.5 * s, 1e-11);
        physics_assert_near("tension", physics_value(run, i, 4), 1 * 1.5 * 0.25, 1e-11);
    }
}

static void test_fitting_start_is_silent(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){0}, "{'type': 'support'}, {'type': 'mass', 'position': [0.6, -0.8], 'velocity': [1.6, 1.2]},"
                              "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    physics_assert_near("impulse", run->summary->start_impulse, 0, 2e-15);
    g_assert_cmpuint(run->summary->warnings->len, ==, 0);
}

/* --- masses of very different size --- */

static void test_mass_ratio(gconstpointer data)
{
    const double ratio = *(const double *)data, length = 2, spin = 3;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 5, .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Rod 0.tension"},
        "{'type': 'mass', 'mass': %.17g, 'velocity': [0, %.17g]},"
        "{'type': 'mass', 'mass': 1, 'position': [2, 0], 'velocity': [0, %.17g]},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
        ratio, -spin * length / (1 + ratio), spin * length * ratio / (1 + ratio));
    double r0 = length / (1 + ratio), r1 = length * ratio / (1 + ratio);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        physics_assert_near("x0", physics_value(run, i, 0), r0 - r0 * cos(spin * t), 1e-10);
        physics_assert_near("y0", physics_value(run, i, 1), -r0 * sin(spin * t), 1e-10);
        physics_assert_near("x1", physics_value(run, i, 2), r0 + r1 * cos(spin * t), 1e-10);
        physics_assert_near("y1", physics_value(run, i, 3), r1 * sin(spin * t), 1e-10);
        physics_assert_near("tension", physics_value(run, i, 4), r1 * spin * spin, 1e-9 * r1 * spin * spin);
    }
}

/* A hanging chain of very different masses is at rest, and its tensions are the weights below. */
static void test_hanging_masses(gconstpointer data)
{
    const double ratio = *(const double *)data;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .method = "rk4", .duration = 5, .columns = "Rod 0.tension, Rod 1.tension, Mass 0.x, Mass 1.x"},
        "{'type': 'gravity'}, {'type': 'support', 'position': [0, 3]}, {'type': 'mass', 'mass': 1, 'position': [0, 2]},"
        "{'type': 'mass', 'mass': %.17g}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
        ratio);
    for (gsize i = 0; i < physics_samples(run); i++) {
        physics_assert_near("upper tension", physics_value(run, i, 0), 9.81 * (1 + ratio), 1e-9 * (1 + ratio));
        physics_assert_near("lower tension", physics_value(run, i, 1), 9.81 * ratio, 1e-9 * ratio);
        physics_assert_near("x", physics_value(run, i, 2), 0, 0);
        physics_assert_near("x", physics_value(run, i, 3), 0, 0);
    }
}

/* --- what is refused --- */

#define TWO_POINTS "{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"

static void test_refusals(void)
{
    g_autoptr(PhysicsRun) lengths =
        physics_try(&(PhysicsOptions){0}, TWO_POINTS "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 5},"
                                                     "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 5.5}");
    physics_assert_refused(lengths, TINKER_MODEL_ERROR_SCENE, "Rod 1", "5.5 m", "5 m apart", NULL);
    g_autoptr(PhysicsRun) off = physics_try(&(PhysicsOptions){0}, TWO_POINTS
                                            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 5.00001}");
    physics_assert_refused(off, TINKER_MODEL_ERROR_SCENE, "Rod 0", "5.00001 m", "5 m apart", NULL);
    g_autoptr(PhysicsRun) none = physics_try(&(PhysicsOptions){0}, "{'type': 'support'}, {'type': 'mass'},"
                                                                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    physics_assert_refused(none, TINKER_MODEL_ERROR_SCENE, "Rod 0", "0 m apart", NULL);
    g_autoptr(PhysicsRun) loose =
        physics_try(&(PhysicsOptions){0}, "{'type': 'support'}, {'type': 'rod', 'ends': ['Support 0', [1, 1]]}");
    physics_assert_refused(loose, TINKER_MODEL_ERROR_SCENE, "Rod 0", "not connected", NULL);
}

/* A millionth of the length is put right, by moving what can move. */
static void test_small_miss_is_corrected(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.columns = "Mass 0.x, Mass 0.y"}, TWO_POINTS
                                            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 5.000004}");
    physics_assert_near("x", physics_value(run, 0, 0), 3 * (1 + 8e-7), 1e-14);
    physics_assert_near("y", physics_value(run, 0, 1), 4 * (1 + 8e-7), 1e-14);
}

static const double ratios[] = {1e6, 1e-6};

static void add_tests(void)
{
    g_test_add_func("/physics/constraints/length-is-kept", test_length_is_kept);
    g_test_add_func("/physics/constraints/tension", test_tension);
    g_test_add_func("/physics/constraints/start-velocity-of-pendulum", test_start_velocity_of_pendulum);
    g_test_add_func("/physics/constraints/start-velocity-of-pair", test_start_velocity_of_pair);
    g_test_add_func("/physics/constraints/fitting-start-is-silent", test_fitting_start_is_silent);
    g_test_add_data_func("/physics/constraints/mass-ratio/large", &ratios[0], test_mass_ratio);
    g_test_add_data_func("/physics/constraints/mass-ratio/small", &ratios[1], test_mass_ratio);
    g_test_add_data_func("/physics/constraints/hanging-masses/large", &ratios[0], test_hanging_masses);
    g_test_add_data_func("/physics/constraints/hanging-masses/small", &ratios[1], test_hanging_masses);
    g_test_add_func("/physics/constraints/refusals", test_refusals);
    g_test_add_func("/physics/constraints/small-miss-is-corrected", test_small_miss_is_corrected);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
