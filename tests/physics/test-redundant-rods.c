/* Rods that depend on one another, stand on supports alone, or lie in a singular place. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "test-systems.h"

#include <math.h>
#include <string.h>

/* Three links of 1 m, hung along a line at 0, 2 and 3 m, carry a straight coupler of three masses: two rods along it
 * and one over both, which is redundant. Every link swings as a pendulum of its own length from `start`. */
static void check_parallelogram(const char *method, double across, double start, double bound)
{
    static const double hung_at[3] = {0, 2, 3}, masses[3] = {1, 4, 0.5};
    const double along[2] = {sqrt(1 - across * across), across};
    Pendulum p;
    pendulum_init(&p, 1.0, 9.81, start, 0.0);
    GString *text = g_string_new("{'type': 'gravity'}");
    for (int k = 0; k < 3; k++) {
        double x = hung_at[k] * along[0], y = hung_at[k] * along[1];
        g_string_append_printf(text,
                               ",{'type': 'support', 'solid': false, 'position': [%.17g, %.17g]},"
                               "{'type': 'mass', 'mass': %g, 'position': [%.17g, %.17g]},"
                               "{'type': 'rod', 'ends': ['Support %d', 'Mass %d']},"
                               "{'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}",
                               x, y, masses[k], x + sin(start), y - cos(start), k, k, k, (k + 1) % 3);
    }
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = method,
                                      .duration = 3,
                                      .step = 1e-3,
                                      .tolerance = 1e-11,
                                      .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 2.x, Mass 2.y"},
                    "%s", text->str);
    g_string_free(text, TRUE);
    TinkerModelSizes sizes = tinker_model_sizes(run->model);
    g_assert_cmpint(sizes.constraint_rows, ==, 6);
    g_assert_cmpint(sizes.redundant_rows, ==, 1);
    g_assert_cmpint(sizes.degrees_of_freedom, ==, 1);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double q[2], v[2];
        pendulum_exact(&p, physics_time(run, i), q, v);
        for (gsize k = 0; k < 3; k++) {
            physics_assert_near("x", physics_value(run, i, 2 * k), hung_at[k] * along[0] + q[0], bound);
            physics_assert_near("y", physics_value(run, i, 2 * k + 1), hung_at[k] * along[1] + q[1], bound);
        }
    }
    g_test_message("%s: constraint error %.3g", method, run->summary->constraint_position_error);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
}

/* The global errors of order 4 and 2 are of the size 3 s * 10 (h w)^4 and 10 (h w)^2, with w^2 = g / L. */
static void test_parallelogram(void)
{
    check_parallelogram("dop853", 0, 1.0, 1e-9);
    check_parallelogram("rk4", 0, 1.0, 1e-9);
    check_parallelogram("verlet", 0, 1.0, 1e-4);
}

/* Hung along the vertical, it is flat at the lowest place, where it could turn into an antiparallelogram: it keeps the
 * branch of its velocity. */
static void test_flat_parallelogram(void)
{
    check_parallelogram("dop853", 1, G_PI / 2, 1e-6);
    check_parallelogram("rk4", 1, G_PI / 2, 1e-6);
    check_parallelogram("verlet", 1, G_PI / 2, 1e-4);
}

/* The same rod several times: the least-norm tensions are equal shares of the single one's. */
static void test_equal_shares(void)
{
    Pendulum p;
    pendulum_init(&p, 2.0, 9.81, 1.0, 0.0);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .duration = 4, .interval = 0.1, .columns = "Rod 0.tension, Rod 1.tension, Rod 2.tension, Mass 0.x"},
        "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 3, 'position': [%.17g, "
        "%.17g]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Support 0']},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}",
        2 * sin(1), -2 * cos(1));
    g_assert_cmpint(tinker_model_sizes(run->model).redundant_rows, ==, 2);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double q[2], v[2];
        pendulum_exact(&p, physics_time(run, i), q, v);
        double tension = 3 * (9.81 * -q[1] / 2 + (v[0] * v[0] + v[1] * v[1]) / 2);
        for (gsize k = 0; k < 3; k++)
            physics_assert_near("share", physics_value(run, i, k), tension / 3, 1e-8);
        physics_assert_near("x", physics_value(run, i, 3), q[0], 1e-9);
    }
}

/* A free square of 1 m with both diagonals turns at 2 rad/s and drifts. The force towards the centre, F = m w^2 / sqrt
 * 2, is that of a diagonal and of two sides at 45 degrees; of all pairs, the least norm of the six has T_side = F / (2
 * sqrt 2), T_diagonal = F / 2. */
static void test_braced_square(void)
{
    const double spin = 2, r = sqrt(0.5), force = 1.5 * spin * spin * r;
    GString *text = g_string_new(NULL);
    for (int i = 0; i < 4; i++) {
        double angle = G_PI / 4 + i * G_PI / 2;
        g_string_append_printf(
            text, "{'type': 'mass', 'mass': 1.5, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},",
            r * cos(angle), r * sin(angle), 0.3 - spin * r * sin(angle), -0.1 + spin * r * cos(angle));
    }
    g_string_append(text,
                    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
                    "{'type': 'rod', 'ends': ['Mass 2', 'Mass 3']}, {'type': 'rod', 'ends': ['Mass 3', 'Mass 0']},"
                    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 3']}");
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 6,
                          .interval = 0.25,
                          .columns =
                              "Mass 0.x, Mass 0.y, Mass 3.x, Mass 3.y, Rod 0.tension, Rod 3.tension, Rod 4.tension"},
        "%s", text->str);
    g_string_free(text, TRUE);
    g_assert_cmpint(tinker_model_sizes(run->model).redundant_rows, ==, 1);
    g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 3);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        for (gsize k = 0; k < 2; k++) {
            double angle = G_PI / 4 + 3 * (double)k * G_PI / 2 + spin * t;
            physics_assert_near("x", physics_value(run, i, 2 * k), 0.3 * t + r * cos(angle), 1e-10);
            physics_assert_near("y", physics_value(run, i, 2 * k + 1), -0.1 * t + r * sin(angle), 1e-10);
        }
        physics_assert_near("side", physics_value(run, i, 4), force / sqrt(8), 1e-9);
        physics_assert_near("side", physics_value(run, i, 5), force / sqrt(8), 1e-9);
        physics_assert_near("diagonal", physics_value(run, i, 6), force / 2, 1e-9);
    }
}

/* A rod between two fixed supports has nothing to do, and its neighbour on the same supports swings as ever. */
static void test_rod_between_supports(void)
{
    Pendulum p;
    pendulum_init(&p, 1.0, 9.81, G_PI / 2, 0.0);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .columns = "Mass 0.x, Mass 0.y, Rod 0.tension, Rod 0.length error"},
        "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': "
        "[0.1, 0.2]},"
        "{'type': 'mass', 'position': [1, 0]}, {'type': 'rod', 'ends': ['Support 0', 'Support 1']},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double q[2], v[2];
        pendulum_exact(&p, physics_time(run, i), q, v);
        physics_assert_near("x", physics_value(run, i, 0), q[0], 1e-9);
        physics_assert_near("y", physics_value(run, i, 1), q[1], 1e-9);
        physics_assert_near("tension", physics_value(run, i, 2), 0, 0);
        physics_assert_near("length error", physics_value(run, i, 3), 0, 0);
    }
}

/* Supports that part pull a rod between them apart: no motion of anything satisfies that. */
static void test_rod_between_parting_supports(void)
{
    g_autoptr(PhysicsRun) run = physics_try(
        &(PhysicsOptions){0}, "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': "
                              "[1, 0]}, {'type': 'mass'},"
                              "{'type': 'rod', 'ends': ['Support 0', 'Support 1']},"
                              "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.1, 'frequency': 1}");
    g_assert_nonnull(run->error);
    g_assert_nonnull(strstr(run->error->message, "Rod 0"));
}

/* A mass in the middle of a straight line of two rods cannot move at all, though no rod resists it there to first
 * order. It stays, or the run says why not; it never moves or speeds up unsaid. */
static void test_straight_singular_mass(void)
{
    static const char *const methods[] = {"rk4", "verlet", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_try(
            &(PhysicsOptions){
                .method = methods[m], .tolerance = 1e-9, .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy"},
            "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [-1, 0]}, {'type': 'support', "
            "'solid': false, 'position': [1, 0]},"
            "{'type': 'mass'}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
            "{'type': 'rod', 'ends': ['Mass 0', 'Support 1']}");
        if (run->error != NULL) {
            g_test_message("%s: %s", methods[m], run->error->message);
            g_assert_nonnull(strstr(run->error->message, "Rod"));
            continue;
        }
        g_test_message("%s: x %g, y %g, vx %g, vy %g", methods[m], physics_last(run, 0), physics_last(run, 1),
                       physics_last(run, 2), physics_last(run, 3));
        for (gsize i = 0; i < physics_samples(run); i++) {
            physics_assert_near("x", physics_value(run, i, 0), 0, 1e-6);
            physics_assert_near("y", physics_value(run, i, 1), 0, 1e-6);
            physics_assert_near("vx", physics_value(run, i, 2), 0, 1e-3);
            physics_assert_near("vy", physics_value(run, i, 3), 0, 1e-3);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/redundant-rods/parallelogram", test_parallelogram);
    g_test_add_func("/physics/redundant-rods/flat-parallelogram", test_flat_parallelogram);
    g_test_add_func("/physics/redundant-rods/equal-shares", test_equal_shares);
    g_test_add_func("/physics/redundant-rods/braced-square", test_braced_square);
    g_test_add_func("/physics/redundant-rods/rod-between-supports", test_rod_between_supports);
    g_test_add_func("/physics/redundant-rods/rod-between-parting-supports", test_rod_between_parting_supports);
    g_test_add_func("/physics/redundant-rods/straight-singular-mass", test_straight_singular_mass);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
