/* The far ends: stiffness, mass, length, step and time over many decades, singular places, hopeless scenes. */
#include "physics-fixture.h"

#include <float.h>
#include <math.h>

/* --- stiffness and mass --- */

/* Twenty periods along the line, and ten turns of a mass that the spring holds on a circle:
 * k (r - L) = m w^2 r, with r = 1.5 L. */
static void check_stiffness(double k)
{
    double w = sqrt(k / 0.5), turn = sqrt(k / 3 / 0.5);
    g_autoptr(PhysicsRun) line =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = 40 * G_PI / w, .columns = "Mass 0.x, Mass 0.vx"},
                    "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 0.5, 'position': [1.25, 0]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': %.17g}",
                    k);
    for (gsize i = 0; i < physics_samples(line); i++) {
        double t = physics_time(line, i);
        physics_assert_near("x", physics_value(line, i, 0), 1 + 0.25 * cos(w * t), 1e-12);
        physics_assert_near("vx", physics_value(line, i, 1) / w, -0.25 * sin(w * t), 1e-12);
    }
    g_autoptr(PhysicsRun) circle = physics_run(
        &(PhysicsOptions){
            .method = "auto", .tolerance = 1e-11, .duration = 20 * G_PI / turn, .columns = "Mass 0.x, Mass 0.y"},
        "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 0.5, 'position': [1.5, 0], 'velocity': [0, "
        "%.17g]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': %.17g}",
        1.5 * turn, k);
    for (gsize i = 0; i < physics_samples(circle); i++) {
        double t = physics_time(circle, i);
        physics_assert_near("x", physics_value(circle, i, 0), 1.5 * cos(turn * t), 2e-9);
        physics_assert_near("y", physics_value(circle, i, 1), 1.5 * sin(turn * t), 2e-9);
    }
    g_assert_cmpfloat(circle->summary->energy_balance_error, <, 1e-9);
}

static void test_stiffness(void)
{
    for (int decade = -6; decade <= 12; decade++)
        check_stiffness(pow(10, decade));
}

/* Two free masses on a spring of 40 N/m and 1 m: they swing against each other with w^2 = k (1/m + 1/M), and turn about
 * each other where the spring pulls them to. */
static void check_mass_ratio(double ratio)
{
    double w = sqrt(40 * (1 + 1 / ratio)), turn = w / sqrt(3), share = 1 / (1 + ratio);
    g_autoptr(PhysicsRun) line = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 20, .interval = 0.37, .columns = "Mass 0.x, Mass 1.x"},
        "{'type': 'mass', 'mass': %.17g}, {'type': 'mass', 'position': [1.25, 0]},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 40}",
        ratio);
    for (gsize i = 0; i < physics_samples(line); i++) {
        double swing = 0.25 * cos(w * physics_time(line, i)) - 0.25;
        double bound = (1 + 20 * w) * 10 * DBL_EPSILON;
        physics_assert_near("heavy", physics_value(line, i, 0), -share * swing, bound);
        physics_assert_near("light", physics_value(line, i, 1), 1.25 + (1 - share) * swing, bound);
    }
    g_autoptr(PhysicsRun) circle =
        physics_run(&(PhysicsOptions){.method = "auto",
                                      .tolerance = 1e-11,
                                      .duration = 20 * G_PI / turn,
                                      .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y"},
                    "{'type': 'mass', 'mass': %.17g, 'position': [%.17g, 0], 'velocity': [0, %.17g]},"
                    "{'type': 'mass', 'position': [%.17g, 0], 'velocity': [0, %.17g]},"
                    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 40}",
                    ratio, -1.5 * share, -1.5 * share * turn, 1.5 * (1 - share), 1.5 * (1 - share) * turn);
    for (gsize i = 0; i < physics_samples(circle); i++) {
        double c = 1.5 * cos(turn * physics_time(circle, i)), s = 1.5 * sin(turn * physics_time(circle, i));
        physics_assert_near("heavy x", physics_value(circle, i, 0), -share * c, 2e-9);
        physics_assert_near("heavy y", physics_value(circle, i, 1), -share * s, 2e-9);
        physics_assert_near("light x", physics_value(circle, i, 2), (1 - share) * c, 2e-9);
        physics_assert_near("light y", physics_value(circle, i, 3), (1 - share) * s, 2e-9);
    }
}

static void test_mass_ratios(void)
{
    for (int decade = -9; decade <= 9; decade += 3)
        check_mass_ratio(pow(10, decade));
}

/* --- length --- */

/* A pendulum with two rods, one that swings on a spring, and an oscillator; `unit` metres stand for one. */
static PhysicsRun *scaled(const char *method, double unit, double x, double y)
{
    static const char *const columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 2.x, Mass 2.y, Mass 3.x, Mass 3.y";
    return physics_run(
        &(PhysicsOptions){
            .method = method, .duration = 4, .step = 0.005, .tolerance = 1e-10, .interval = 0.16, .columns = columns},
        "{'type': 'gravity', 'acceleration': %.17g}, {'type': 'support', 'solid': false, 'position': [%.17g, %.17g]},"
        "{'type': 'mass', 'position': [%.17g, %.17g]}, {'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
        "{'type': 'mass', 'position': [%.17g, %.17g]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 2'], 'rest_length': %.17g, 'stiffness': 40},"
        "{'type': 'mass', 'position': [%.17g, %.17g]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 3'], 'rest_length': %.17g, 'stiffness': 25}",
        9.75 * unit, x, y, x + unit, y, x + 1.75 * unit, y - unit, x + 1.25 * unit, y - 0.5 * unit, unit, x,
        y - 1.5 * unit, unit);
}

static void assert_same_motion(const PhysicsRun *run, double unit, const double *place, const PhysicsRun *reference,
                               const char *what)
{
    double most = 0;
    for (gsize i = 0; i < physics_samples(run); i++)
        for (gsize k = 0; k < 8; k++)
            most = fmax(most, fabs((physics_value(run, i, k) - place[k % 2]) / unit - physics_value(reference, i, k)));
    g_test_message("%s, unit %g m: off by %.3g", what, unit, most);
    g_assert_cmpfloat(most, <, 1e-9);
}

static void test_unit_of_length(gconstpointer method)
{
    static const double units[] = {1e-6, 1e-3, 1e3, 1e6}, origin[2] = {0, 0};
    g_autoptr(PhysicsRun) metres = scaled(method, 1, 0, 0);
    for (gsize u = 0; u < G_N_ELEMENTS(units); u++) {
        g_autoptr(PhysicsRun) run = scaled(method, units[u], 0, 0);
        assert_same_motion(run, units[u], origin, metres, method);
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
        if (g_str_equal(method, "auto")) g_assert_cmpint(run->summary->steps, ==, metres->summary->steps);
    }
}

/* Typed in millimetres, metres and kilometres. */
static void test_typed_units(gconstpointer method)
{
    static const char *const scenes[] = {
        "{'type': 'support', 'solid': false, 'position': ['250 mm', '-500 mm']}, {'type': 'gravity'},"
        "{'type': 'mass', 'position': ['1250 mm', '-500 mm']}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'mass', 'position': ['1250 mm', '-1500 mm']},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': '750 mm', 'stiffness': '0.05 N/mm'}",
        "{'type': 'support', 'solid': false, 'position': [0.25, -0.5]}, {'type': 'gravity'},"
        "{'type': 'mass', 'position': [1.25, -0.5]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'mass', 'position': [1.25, -1.5]},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 0.75, 'stiffness': 50}",
        "{'type': 'support', 'solid': false, 'position': ['0.00025 km', '-0.0005 km']}, {'type': 'gravity'},"
        "{'type': 'mass', 'position': ['0.00125 km', '-0.0005 km']}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'mass', 'position': ['0.00125 km', '-0.0015 km']},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': '0.00075 km', 'stiffness': '50 N/m'}",
    };
    static const double origin[2] = {0, 0};
    static const char columns[] = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 0.vx, Mass 0.vy, Mass 1.vx, Mass 1.vy";
    const PhysicsOptions options = {
        .method = method, .duration = 4, .step = 0.005, .tolerance = 1e-10, .interval = 0.16, .columns = columns};
    g_autoptr(PhysicsRun) metres = physics_run(&options, "%s", scenes[1]);
    for (gsize u = 0; u < G_N_ELEMENTS(scenes); u += 2) {
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", scenes[u]);
        assert_same_motion(run, 1, origin, metres, method);
    }
}

static void test_far_away(gconstpointer method)
{
    static const double place[2] = {1e6, -1e6};
    g_autoptr(PhysicsRun) here = scaled(method, 1, 0, 0), there = scaled(method, 1, place[0], place[1]);
    assert_same_motion(there, 1, place, here, method);
}

/* --- steps and times --- */

/* 1 000 steps of a twentieth of a radian, from nanoseconds to a quarter of an hour each. */
static void test_steps(gconstpointer method)
{
    static const double steps[] = {1e-9, 1e-6, 1e-3, 1, 1e3};
    double end[G_N_ELEMENTS(steps)][2];
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        double w = 0.05 / steps[i];
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = method,
                                          .step = steps[i],
                                          .duration = 1000 * steps[i],
                                          .columns = "Mass 0.x, Mass 0.vx, Mass 1.x"},
                        "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.25, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': %.17g},"
                        "{'type': 'mass', 'position': [1.25, 0], 'velocity': [0, %.17g]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 1'], 'rest_length': 1, 'stiffness': %.17g}",
                        w * w, 0.5 * w, w * w);
        g_assert_cmpint(run->summary->steps, ==, 2000);
        end[i][0] = physics_last(run, 0);
        end[i][1] = physics_last(run, 2);
        physics_assert_near("vx", physics_last(run, 1) / w, -0.25 * sin(50), 0.02);
    }
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++)
        for (int k = 0; k < 2; k++)
            physics_assert_near("end", end[i][k], end[3][k], 1e-10);
}

/* w = 1: the phase of the last sample, 6.3e6 rad, is known to half a unit in its last place, 4.7e-10. */
static void test_million_periods(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .method = "auto", .duration = 2e6 * G_PI, .interval = 1e4 * G_PI, .columns = "Mass 0.x, Mass 0.vx"},
        "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.25, 0], 'velocity': [0.5, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1}");
    double most = 0;
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        most = fmax(most, fabs(physics_value(run, i, 0) - 1 - 0.25 * cos(t) - 0.5 * sin(t)));
        most = fmax(most, fabs(physics_value(run, i, 1) + 0.25 * sin(t) - 0.5 * cos(t)));
    }
    g_test_message("%s: off by %.3g after 1e6 periods", run->summary->method, most);
    g_assert_cmpfloat(most, <, 2e6 * G_PI * DBL_EPSILON);
}

/* What Verlet keeps instead of the energy differs from it by (h w)^2 / 4 of it at most, for ever. */
static void test_verlet_keeps_its_energy(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "verlet", .duration = 2e5 * G_PI, .step = 0.2, .columns = "Mass 0.x"},
                    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.25, 0]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1}");
    g_test_message("energy off by %.3g", run->summary->energy_balance_error);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1.001 * 0.2 * 0.2 / 4);
    g_autoptr(PhysicsRun) pendulum = physics_run(
        &(PhysicsOptions){.method = "verlet", .duration = 4e4, .step = 0.05, .columns = "Rod 0.length error"},
        "{'type': 'support', 'solid': false}, {'type': 'gravity', 'acceleration': 1}, {'type': 'mass', 'position': [1, "
        "0]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_test_message("energy of the pendulum off by %.3g", pendulum->summary->energy_balance_error);
    g_assert_cmpfloat(pendulum->summary->energy_balance_error, <, 0.05 * 0.05);
    g_assert_cmpfloat(pendulum->summary->constraint_position_error, <, 1e-12);
}

/* --- long chains --- */

static char *chain_of(int links, double length, double angle)
{
    GString *text = g_string_new("{'type': 'gravity', 'acceleration': 9.81}, {'type': 'support', 'solid': false}");
    double x = cos(angle) * length / links, y = sin(angle) * length / links;
    for (int i = 1; i <= links; i++)
        g_string_append_printf(text, ",{'type': 'mass', 'mass': 0.1, 'position': [%.17g, %.17g]}", i * x, i * y);
    for (int i = 0; i < links; i++)
        if (i == 0)
            g_string_append(text, ",{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
        else
            g_string_append_printf(text, ",{'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - 1, i);
    return g_string_free(text, FALSE);
}

static void test_thousand_links(void)
{
    g_autofree char *hanging = chain_of(1000, 100, -G_PI / 2), *level = chain_of(1000, 100, 0);
    g_autoptr(PhysicsRun) rest = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 1, .tolerance = 1e-9, .columns = "Mass 999.x, Mass 999.y"},
        "%s", hanging);
    physics_assert_near("x", physics_last(rest, 0), 0, 1e-10);
    physics_assert_near("y", physics_last(rest, 1), -100, 1e-10);
    g_assert_cmpfloat(rest->summary->constraint_position_error, <, 1e-12);
    static const char *const methods[] = {"auto", "rk4", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = methods[m],
                                                                  .duration = 0.05,
                                                                  .tolerance = 1e-9,
                                                                  .step = 1e-3,
                                                                  .columns = "Mass 999.y, Mass 500.x"},
                                                "%s", level);
        g_test_message("%s: %d steps, constraint error %.3g, energy %.3g", methods[m], (int)run->summary->steps,
                       run->summary->constraint_position_error, run->summary->energy_balance_error);
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-4);
        physics_assert_near("free end", physics_last(run, 0), -9.81 * 0.05 * 0.05 / 2, 1e-3);
    }
}

static void test_whip_crack(void)
{
    g_autofree char *blocks = chain_of(100, 10, 0);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .method = "auto", .tolerance = 1e-9, .duration = 5, .interval = 0.05, .columns = "Mass 99.vx, Mass 99.vy"},
        "%s", blocks);
    double fastest = 0;
    for (gsize i = 0; i < physics_samples(run); i++)
        fastest = fmax(fastest, hypot(physics_value(run, i, 0), physics_value(run, i, 1)));
    g_test_message("%d steps, %d evaluations; energy off by %.3g, rods by %.3g; the end reaches %.3g m/s",
                   (int)run->summary->steps, (int)run->summary->evaluations, run->summary->energy_balance_error,
                   run->summary->constraint_position_error, fastest);
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-4);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
    g_assert_cmpfloat(fastest, >, sqrt(2 * 9.81 * 10));
}

/* --- denormals --- */

static void test_denormals(void)
{
    static const char *const methods[] = {"auto", "rk4", "verlet", "semi-implicit-euler", "dopri5", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m],
                              .duration = 1,
                              .columns = "Mass 0.x, Mass 0.vx, Mass 1.x, Mass 2.x, Mass 2.y, Spring 1.tension"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 1e-290, 'position': [1, 0], 'velocity': "
            "[1e-310, 0]},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1e-288},"
            "{'type': 'mass', 'position': [5e-324, 1], 'velocity': [1e-310, 1e-310]},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 1e-310},"
            "{'type': 'mass', 'mass': 1e-300, 'position': [0, -1], 'velocity': [1e-300, 0]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 2']}");
        g_assert_cmpfloat(run->summary->simulated_s, ==, 1);
        physics_assert_near("x", physics_last(run, 0), 1, 1e-15);
        physics_assert_near("x", physics_last(run, 3), 0, 1e-299);
        physics_assert_near("y", physics_last(run, 4), -1, 1e-15);
    }
}

static void add_for_methods(const char *path, const char *const *methods, GTestDataFunc test)
{
    for (; *methods != NULL; methods++) {
        g_autofree char *name = g_strdup_printf("/physics/extremes/%s/%s", path, *methods);
        g_test_add_data_func(name, *methods, test);
    }
}

static void add_tests(void)
{
    static const char *const all[] = {"auto",   "rk4",     "verlet",  "semi-implicit-euler", "dopri5",
                                      "dop853", "verlet6", "newmark", "generalized-alpha",   NULL};
    static const char *const fixed[] = {"rk4", "verlet", "verlet6", "newmark", NULL};
    g_test_add_func("/physics/extremes/stiffness", test_stiffness);
    g_test_add_func("/physics/extremes/mass-ratios", test_mass_ratios);
    add_for_methods("unit-of-length", all, test_unit_of_length);
    add_for_methods("typed-units", all, test_typed_units);
    add_for_methods("far-away", all, test_far_away);
    add_for_methods("steps", fixed, test_steps);
    g_test_add_func("/physics/extremes/million-periods", test_million_periods);
    g_test_add_func("/physics/extremes/verlet-keeps-its-energy", test_verlet_keeps_its_energy);
    g_test_add_func("/physics/extremes/thousand-links", test_thousand_links);
    g_test_add_func("/physics/extremes/whip-crack", test_whip_crack);
    g_test_add_func("/physics/extremes/denormals", test_denormals);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
