/* Cords, by closed forms: yo-yos, loads on wheels, involutes, and what comes taut. */
#include "contact-checks.h"
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "physics/system/summary.h"

#include <math.h>

#define GRAVITY "{'type': 'gravity'}, "
#define GROUND  "{'type': 'support', 'solid': false}, "
/* 2 kg, 0.5 m, 0.25 kg m^2. */
#define DISC "{'type': 'disc', 'position': [0, 0], 'mass': 2, 'radius': 0.5, 'solid': false"
#define AXLE "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, "
#define G    9.81

/* a = g / (1 + I / (m R^2)), T = m (g - a), and it turns with a / R. */
static void test_yo_yo(void)
{
    const double inertias[] = {0.25, 0.02, 3};
    for (gsize k = 0; k < G_N_ELEMENTS(inertias); k++) {
        const double a = G / (1 + inertias[k] / 0.5);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.columns = "Disc 0.y, Disc 0.angle, Cord 0.tension, Disc 0.x"},
            GRAVITY "{'type': 'support', 'solid': false, 'position': [0.5, 1]}, " DISC
                    ", 'inertia': %.17g}, {'type': 'cord', 'ends': ['Disc 0', 'Support 0'], 'side': 'right'}",
            inertias[k]);
        for (gsize i = 0; i < physics_samples(run); i++) {
            const double fallen = 0.5 * a * physics_time(run, i) * physics_time(run, i);
            physics_assert_near("y", physics_value(run, i, 0), -fallen, 1e-9);
            physics_assert_near("angle", physics_value(run, i, 1), fallen / 0.5, 1e-9);
            physics_assert_near("tension", physics_value(run, i, 2), 2 * (G - a), 1e-9);
            physics_assert_near("x", physics_value(run, i, 3), 0, 1e-9);
        }
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-9);
    }
}

/* a = (m_1 - m_2) g / (m_1 + m_2 + I / R^2), each strand with a tension of its own: T_1 - T_2 = I a / R^2. */
static void test_heavy_pulley(void)
{
    const double a = (3 - 1) * G / (3 + 1 + 1);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.5, .columns = "A.y, B.y, Disc 0.angle, Cord 0.tension, Cord 1.tension"},
        GRAVITY GROUND DISC
        "}, " AXLE "{'type': 'mass', 'name': 'A', 'mass': 3, 'position': [0.5, -1]},"
        "{'type': 'mass', 'name': 'B', 'mass': 1, 'position': [-0.5, -2]},"
        "{'type': 'cord', 'ends': ['Disc 0', 'A']}, {'type': 'cord', 'ends': ['Disc 0', 'B'], 'side': 'right'}");
    const double way = 0.5 * a * 0.25;
    physics_assert_near("A", physics_last(run, 0), -1 - way, 1e-9);
    physics_assert_near("B", physics_last(run, 1), -2 + way, 1e-9);
    physics_assert_near("angle", physics_last(run, 2), -way / 0.5, 1e-9);
    physics_assert_near("T_1", physics_last(run, 3), 3 * (G - a), 1e-8);
    physics_assert_near("T_2", physics_last(run, 4), 1 * (G + a), 1e-8);
}

/* About a post that stands still a mass on a cord that unwinds goes along the involute, through whole turns: its speed
 * stays, s ds/dt = R v, and T = m v^2 / s. */
static void test_involute(void)
{
    static const char *const sides[] = {"left", "right"};
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1 : -1, R = 0.2, v = 2;
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 6, .columns = "Cord 0.free length, Mass 0.speed, Cord 0.tension"},
                        GROUND "{'type': 'mass', 'mass': 1.5, 'position': [%.17g, -0.3], 'velocity': [%.17g, 0]},"
                               "{'type': 'cord', 'ends': ['Support 0', 'Mass 0'], 'radius': %.17g, 'side': '%s'}",
                        sign * R, sign * v, R, sides[k]);
        for (gsize i = 0; i < physics_samples(run); i++) {
            const double s = sqrt(0.09 + 2 * R * v * physics_time(run, i));
            physics_assert_near("s", physics_value(run, i, 0), s, 1e-7);
            physics_assert_near("v", physics_value(run, i, 1), v, 1e-8);
            physics_assert_near("T", physics_value(run, i, 2), 1.5 * v * v / s, 1e-5);
        }
    }
}

/* The other way the cord winds up, through more than two turns: s ds/dt = -R v, and T = m v^2 / s. */
static void test_wound_up(void)
{
    static const char *const sides[] = {"left", "right"};
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1 : -1, R = 0.1, v = 2;
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 9, .columns = "Cord 0.free length, Mass 0.speed, Cord 0.tension"},
                        GROUND "{'type': 'mass', 'mass': 1.5, 'position': [%.17g, -2], 'velocity': [%.17g, 0]},"
                               "{'type': 'cord', 'ends': ['Support 0', 'Mass 0'], 'radius': %.17g, 'side': '%s'}",
                        sign * R, -sign * v, R, sides[k]);
        for (gsize i = 0; i < physics_samples(run); i++) {
            const double s = sqrt(4 - 2 * R * v * physics_time(run, i));
            physics_assert_near("s", physics_value(run, i, 0), s, 1e-7);
            physics_assert_near("v", physics_value(run, i, 1), v, 1e-8);
            physics_assert_near("T", physics_value(run, i, 2), 1.5 * v * v / s, 1e-5);
        }
    }
}

/* A disc that turns freely and a mass on its cord keep energy and angular momentum about the axle. */
static void test_angular_momentum(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3,
                          .columns =
                              "Disc 0.angular velocity, Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy, Cord 0.tension"},
        GROUND DISC "}, " AXLE "{'type': 'mass', 'mass': 1.5, 'position': [0.5, -1], 'velocity': [2, -1]},"
                    "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0']}");
    double momentum = 0, energy = 0;
    for (gsize i = 0; i < physics_samples(run); i++) {
        double at[6];
        for (gsize c = 0; c < 6; c++)
            at[c] = physics_value(run, i, c);
        const double L = 0.25 * at[0] + 1.5 * (at[1] * at[4] - at[2] * at[3]);
        const double E = 0.125 * at[0] * at[0] + 0.75 * (at[3] * at[3] + at[4] * at[4]);
        if (i == 0) momentum = L;
        if (i == 0) energy = E;
        physics_assert_near("angular momentum", L, momentum, 1e-8);
        physics_assert_near("energy", E, energy, 1e-8);
        g_assert_cmpfloat(at[5], >=, 0);
    }
}

/* Slack by 0.2 m a load falls freely, and then pulls the disc along with v m / (m + I / R^2), without rebound. */
static void test_comes_taut(void)
{
    const double taut = sqrt(2 * 0.2 / G), after = 3 * G * taut / (3 + 1), a = 3 * G / (3 + 1);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Mass 0.vy, Disc 0.angular velocity, Cord 0.tension"},
                    GRAVITY GROUND DISC "}, " AXLE "{'type': 'mass', 'mass': 3, 'position': [0.5, -1]},"
                                        "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0'], 'length': 1.2}");
    physics_assert_near("before", physics_value(run, 2, 0), -G * 0.2, 1e-10);
    physics_assert_near("slack", physics_value(run, 2, 2), 0, 0);
    contact_assert_event(run, "taut", "Cord 0", taut, 1e-9);
    const double v = after + a * (1 - taut);
    physics_assert_near("v", physics_last(run, 0), -v, 1e-8);
    physics_assert_near("w", physics_last(run, 1), -v / 0.5, 1e-8);
    physics_assert_near("taken", run->summary->books[TINKER_BOOK_CONTACTS],
                        0.5 * 4 * after * after - 0.5 * 3 * G * G * taut * taut, 1e-8);
}

/* A wheel of 0.5 kg m^2 and radius 0.5 that spins with 3 rad/s on a bearing that starts upwards with 1 m/s, and 3 kg
 * and 1 kg at rest on either side. The first cord jerks the wheel to a stop, which jerks the second, that the wheel's
 * spin had let loose, all in one instant: (0.5 + 4 R^2) w = 0.5 w0 + R V (1 - 3), so w = 1/3. */
static void test_jerks_the_other(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.1, .estimate = TRUE, .columns = "Wheel.angular velocity, A.vy, B.vy"},
        "{'type': 'support', 'position': [0, 2], 'solid': false}, {'type': 'disc', 'name': 'Wheel', 'position': [0, 2],"
        " 'radius': 0.5, 'inertia': 0.5, 'angular_velocity': 3, 'velocity': [0, 1]}, {'type': 'pin', 'ends': "
        "['Support 0', 'Wheel']}, {'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', 'amplitude': 1,"
        " 'frequency': 1}, {'type': 'mass', 'name': 'A', 'mass': 3, 'position': [0.5, 0]}, {'type': 'mass', 'name': "
        "'B',"
        " 'mass': 1, 'position': [-0.5, 0]}, {'type': 'cord', 'ends': ['Wheel', 'A'], 'side': 'left'},"
        "{'type': 'cord', 'ends': ['Wheel', 'B'], 'side': 'right'}");
    physics_assert_near("spin", physics_value(run, 0, 0), 1.0 / 3, 1e-12);
    physics_assert_near("A", physics_value(run, 0, 1), 1 + 1.0 / 6, 1e-12);
    physics_assert_near("B", physics_value(run, 0, 2), 1 - 1.0 / 6, 1e-12);
    g_assert_cmpfloat(run->summary->error_estimate, <, 1e-9);
}

/* What is wrong is told with the block and what would be right. */
static void test_refusals(void)
{
    g_autoptr(PhysicsRun) no_radius =
        physics_try(&(PhysicsOptions){0}, GROUND "{'type': 'mass', 'position': [1, 0]},"
                                                 "{'type': 'cord', 'ends': ['Support 0', 'Mass 0']}");
    physics_assert_refused(no_radius, TINKER_MODEL_ERROR_SCENE, "Cord 0", "has no radius", "give the radius", NULL);
    g_autoptr(PhysicsRun) inside =
        physics_try(&(PhysicsOptions){0}, GROUND DISC "}, {'type': 'mass', 'position': [0.2, 0]},"
                                                      "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0']}");
    physics_assert_refused(inside, TINKER_MODEL_ERROR_SCENE, "Cord 0", "place it outside", NULL);
    g_autoptr(PhysicsRun) short_cord =
        physics_try(&(PhysicsOptions){0}, GROUND DISC "}, {'type': 'mass', 'position': [2, 0]},"
                                                      "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0'], 'length': 1}");
    physics_assert_refused(short_cord, TINKER_MODEL_ERROR_SCENE, "Cord 0", NULL);
    g_autoptr(PhysicsRun) thrown = physics_try(&(PhysicsOptions){0}, GROUND DISC
                                               "}, " AXLE "{'type': 'mass', 'position': [1, 0], 'velocity': [-3, 0]},"
                                               "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0']}");
    physics_assert_refused(thrown, TINKER_MODEL_ERROR_RUN, "Cord 0", "disc", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/cords/yo-yo", test_yo_yo);
    g_test_add_func("/cords/heavy-pulley", test_heavy_pulley);
    g_test_add_func("/cords/involute", test_involute);
    g_test_add_func("/cords/wound-up", test_wound_up);
    g_test_add_func("/cords/angular-momentum", test_angular_momentum);
    g_test_add_func("/cords/comes-taut", test_comes_taut);
    g_test_add_func("/cords/jerks-the-other", test_jerks_the_other);
    g_test_add_func("/cords/refusals", test_refusals);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
