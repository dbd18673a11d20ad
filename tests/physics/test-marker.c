/* A marker tells how its point moves, and changes nothing. */
#include "physics-fixture.h"

#include <math.h>

static const double g = 9.81;

/* Thrown: x = 1 + 3 t, y = 2 + 4 t - g t^2 / 2. On a support that moves, off its centre and turned by a right angle:
 * x = 5 + 0.5 sin 2t - 1, y = 7 with its derivatives. One on a support that stands far away. */
static const char *const blocks =
    "{'type': 'gravity'}, {'type': 'mass', 'position': [1, 2], 'velocity': [3, 4]},"
    "{'type': 'support', 'name': 'S', 'position': [5, 7], 'orientation': '90 deg', 'solid': false},"
    "{'type': 'support', 'name': 'Far', 'position': [1e6, 0], 'solid': false},"
    "{'type': 'support-motion', 'ends': ['S'], 'waveform': 'sine', 'amplitude': 0.5, 'frequency': 2}%s";

static const char *const markers = ", {'type': 'marker', 'name': 'A', 'ends': ['Mass 0']},"
                                   "{'type': 'marker', 'name': 'B', 'ends': [{'block': 'S', 'at': [0, 1]}]},"
                                   "{'type': 'marker', 'name': 'C', 'ends': ['Far']}";

static void test_quantities(void)
{
    static const PhysicsOptions options = {
        .duration = 1.5,
        .columns = "A.x, A.y, A.vx, A.vy, A.speed, A.ax, A.ay, B.x, B.y, B.vx, B.vy, B.speed, B.ax, B.ay, C.x"};
    g_autoptr(PhysicsRun) run = physics_run(&options, blocks, markers);
    for (gsize k = 0; k < physics_samples(run); k++) {
        const double t = physics_time(run, k), vy = 4 - g * t, u = cos(2 * t);
        const double truth[] = {1 + 3 * t,
                                2 + 4 * t - 0.5 * g * t * t,
                                3,
                                vy,
                                hypot(3, vy),
                                0,
                                -g,
                                4 + 0.5 * sin(2 * t),
                                7,
                                u,
                                0,
                                fabs(u),
                                -2 * sin(2 * t),
                                0,
                                1e6};
        for (gsize c = 0; c < G_N_ELEMENTS(truth); c++)
            physics_assert_near(g_array_index(run->columns, TinkerColumn, c).name, physics_value(run, k, c), truth[c],
                                1e-9);
    }
}

static void test_changes_nothing(void)
{
    static const char *const methods[] = {"dop853", "verlet", "rk4", "exact"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        const PhysicsOptions options = {.method = methods[i]};
        g_autoptr(PhysicsRun) with = physics_run(&options, blocks, markers);
        g_autoptr(PhysicsRun) without = physics_run(&options, blocks, "");
        physics_assert_same_bits(with, without);
        g_assert_cmpint(with->summary->evaluations, ==, without->summary->evaluations);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/marker/quantities", test_quantities);
    g_test_add_func("/physics/marker/changes-nothing", test_changes_nothing);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
