/* Singular places and hopeless scenes: ends that coincide, dead points, forces without bound, contradictions. Each has
 * a clear answer within bounded work. */
#include "physics-fixture.h"
#include "physics/model/model.h"

#include <math.h>
#include <string.h>

/* --- singular places --- */

static void assert_clear(const PhysicsRun *run, const char *block)
{
    if (run->error == NULL) return;
    g_test_message("%s", run->error->message);
    g_assert_nonnull(strstr(run->error->message, block));
}

/* A spring without length at its anchor is an oscillator; one with a length has no direction there: nothing pulls until
 * something else moves the mass, or the scene is refused with a reason. */
static void test_coincident_ends(void)
{
    static const char *const methods[] = {"auto", "rk4", "verlet", "dop853", "newmark"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) none =
            physics_run(&(PhysicsOptions){.method = methods[m],
                                          .duration = 2,
                                          .step = 1e-3,
                                          .columns = "Mass 0.x, Mass 0.y, Spring 0.tension, Spring 0.length"},
                        "{'type': 'support', 'solid': false}, {'type': 'mass', 'velocity': [3, 4]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 0, 'stiffness': 4}");
        for (guint i = 0; i < none->summary->warnings->len; i++)
            g_assert_null(strstr(tinker_warnings_text(none->summary->warnings, i), "at one place"));
        for (gsize i = 0; i < physics_samples(none); i++) {
            physics_assert_near("x", physics_value(none, i, 0), 1.5 * sin(2 * physics_time(none, i)), 1e-5);
            physics_assert_near("y", physics_value(none, i, 1), 2 * sin(2 * physics_time(none, i)), 1e-5);
        }
        g_autoptr(PhysicsRun) rest = physics_try(
            &(PhysicsOptions){
                .method = methods[m], .duration = 2, .step = 1e-3, .columns = "Mass 0.x, Mass 0.y, Spring 0.tension"},
            "{'type': 'support', 'solid': false}, {'type': 'mass'},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 4}");
        assert_clear(rest, "Spring 0");
        g_assert_cmpuint(rest->summary->warnings->len, >=, 1);
        g_assert_nonnull(
            strstr(tinker_warnings_text(rest->summary->warnings, 0), "Spring 0: its ends are at one place"));
        g_autoptr(PhysicsRun) through = physics_try(
            &(PhysicsOptions){.method = methods[m],
                              .duration = 2,
                              .step = 1e-3,
                              .tolerance = 1e-9,
                              .columns = "Mass 0.x, Mass 0.y, Spring 0.tension"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1.2], 'velocity': [0, -5]},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 4}");
        assert_clear(through, "Spring 0");
        g_test_message("%s: %g s; %g evaluations, through the anchor %g", methods[m], through->summary->simulated_s,
                       (double)rest->summary->evaluations, (double)through->summary->evaluations);
        g_assert_cmpint(through->summary->evaluations, <, 100000);
        for (gsize i = 0; i < physics_samples(through); i++)
            physics_assert_near("x", physics_value(through, i, 0), 0, 1e-9);
    }
}

/* So does a law that is asked: it has no direction where it pulls with its ends at one place, and is an oscillator
 * where it does not, small beside its softening: x'' = -c x / s^5. */
static void test_coincident_ends_of_a_law(void)
{
    static const char *const methods[] = {"auto", "rk4", "verlet", "dop853", "newmark", "generalized-alpha"};
    static const char *const types[] = {"magnet", "plain-magnet"};
    for (gsize m = 0; m < 2 * G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) none = physics_run(
            &(PhysicsOptions){.method = methods[m / 2], .duration = 2, .step = 1e-3, .columns = "Mass 0.x, Mass 0.y"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'velocity': [3e-3, 4e-3]},"
            "{'type': '%s', 'ends': ['Support 0', 'Mass 0'], 'softening': 3, 'strength': 972}",
            types[m % 2]);
        g_assert_cmpuint(none->summary->warnings->len, ==, 0);
        for (gsize i = 0; i < physics_samples(none); i++) {
            physics_assert_near("x", physics_value(none, i, 0), 1.5e-3 * sin(2 * physics_time(none, i)), 1e-8);
            physics_assert_near("y", physics_value(none, i, 1), 2e-3 * sin(2 * physics_time(none, i)), 1e-8);
        }
        g_autoptr(PhysicsRun) rest =
            physics_run(&(PhysicsOptions){.method = methods[m / 2], .duration = 2, .step = 1e-3, .columns = "Mass 0.x"},
                        "{'type': 'support', 'solid': false}, {'type': 'mass'},"
                        "{'type': '%s', 'ends': ['Support 0', 'Mass 0'], 'softening': 1, 'strength': 1, 'pull': 0.5}",
                        types[m % 2]);
        g_assert_cmpuint(rest->summary->warnings->len, >=, 1);
        g_assert_nonnull(strstr(tinker_warnings_text(rest->summary->warnings, 0), "0: its ends are at one place"));
        g_assert_nonnull(strstr(tinker_warnings_text(rest->summary->warnings, 0), "0.5 N"));
        g_assert_cmpfloat(physics_last(rest, 0), ==, 0);
    }
}

/* A rod of no length is no rod. */
static void test_rod_without_length(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){.columns = "Mass 0.x"}, "{'type': 'support', 'solid': false}, {'type': 'mass'},"
                                                              "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    g_assert_nonnull(run->error);
    g_test_message("%s", run->error != NULL ? run->error->message : "");
}

/* Cranks of 1 m 2 m apart on a coupler of 2 m, and a third one in between: every crank turns as one, through its dead
 * points again and again, at the speed that the energy leaves it: m_total v^2 / 2 is constant without gravity. */
static void test_dead_points(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto",
                          .duration = 10,
                          .tolerance = 1e-10,
                          .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 2.x, Mass 2.y"},
        "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [2, 0]}, {'type': "
        "'support', 'solid': false, 'position': [1, 0]},"
        "{'type': 'mass', 'position': [0, 1], 'velocity': [2, 0]},"
        "{'type': 'mass', 'position': [2, 1], 'velocity': [2, 0]},"
        "{'type': 'mass', 'position': [1, 1], 'velocity': [2, 0]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 1']},"
        "{'type': 'rod', 'ends': ['Support 2', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 2']},"
        "{'type': 'rod', 'ends': ['Mass 2', 'Mass 1']}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double turn = 2 * physics_time(run, i);
        for (gsize k = 0; k < 3; k++) {
            double hinge = k == 0 ? 0 : k == 1 ? 2 : 1;
            physics_assert_near("x", physics_value(run, i, 2 * k), hinge + sin(turn), 1e-6);
            physics_assert_near("y", physics_value(run, i, 2 * k + 1), cos(turn), 1e-6);
        }
    }
    g_test_message("constraint error %.3g, energy %.3g", run->summary->constraint_position_error,
                   run->summary->energy_balance_error);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-6);
}

/* A parallelogram with a third crank in which one mass is far heavier or lighter than the others: without gravity it
 * turns as evenly as ever. */
static void test_heavy_parallelogram(void)
{
    for (int decade = -9; decade <= 9; decade += 3) {
        for (int heavy = 0; heavy < 3; heavy++) {
            double masses[3] = {1, 4, 0.5};
            masses[heavy] *= pow(10, decade);
            g_autoptr(PhysicsRun) run = physics_run(
                &(PhysicsOptions){
                    .duration = 2, .tolerance = 1e-11, .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 2.x"},
                "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [2, 0]}, "
                "{'type': 'support', 'solid': false, 'position': [3, 0]},"
                "{'type': 'mass', 'mass': %.17g, 'position': [0.6, 0.8], 'velocity': [1.6, -1.2]},"
                "{'type': 'mass', 'mass': %.17g, 'position': [2.6, 0.8], 'velocity': [1.6, -1.2]},"
                "{'type': 'mass', 'mass': %.17g, 'position': [3.6, 0.8], 'velocity': [1.6, -1.2]},"
                "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 1']},"
                "{'type': 'rod', 'ends': ['Support 2', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                "{'type': 'rod', 'ends': ['Mass 1', 'Mass 2']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 2']}",
                masses[0], masses[1], masses[2]);
            for (gsize i = 0; i < physics_samples(run); i++) {
                double angle = atan2(0.6, 0.8) + 2 * physics_time(run, i), x = sin(angle), y = cos(angle);
                physics_assert_near("first x", physics_value(run, i, 0), x, 1e-8);
                physics_assert_near("first y", physics_value(run, i, 1), y, 1e-8);
                physics_assert_near("second x", physics_value(run, i, 2), 2 + x, 1e-8);
                physics_assert_near("second y", physics_value(run, i, 3), y, 1e-8);
                physics_assert_near("third x", physics_value(run, i, 4), 3 + x, 1e-8);
            }
            g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
        }
    }
}

/* A crank of 1 m, a coupler of 3 m and a rocker of 2 m on hinges 3 m apart, 1 kg and 2 kg at the pins: where crank and
 * coupler lie along one line, the rocker stands still. */
typedef struct {
    double pin[2], rocker_rate; /* m; of the rocker's turning, in units of the crank's */
} FourBar;

static FourBar four_bar(double crank)
{
    double a[2] = {cos(crank), sin(crank)}, d[2] = {3 - a[0], -a[1]}, gap = hypot(d[0], d[1]);
    double along = (gap * gap + 9 - 4) / (2 * gap), across = sqrt(9 - along * along);
    double u[2] = {d[0] / gap, d[1] / gap};
    FourBar bar = {{a[0] + along * u[0] - across * u[1], a[1] + along * u[1] + across * u[0]}, 0};
    double coupler[2] = {bar.pin[0] - a[0], bar.pin[1] - a[1]}, rocker[2] = {bar.pin[0] - 3, bar.pin[1]};
    double crank_along = -a[1] * coupler[0] + a[0] * coupler[1];
    bar.rocker_rate = crank_along / (-rocker[1] * coupler[0] + rocker[0] * coupler[1]);
    return bar;
}

/* Without gravity the energy (1 + 2 * 4 rate^2) crank'^2 / 2 stays; the crank starts at 3 rad/s from pi / 2. */
static void crank_rate(double t, const double *y, double *rate, const void *data)
{
    const double *energy = data;
    double ratio = four_bar(y[0]).rocker_rate;
    rate[0] = sqrt(*energy / (1 + 8 * ratio * ratio));
}

static void test_four_bar(void)
{
    FourBar start = four_bar(G_PI / 2);
    double phi[2] = {-start.pin[1], start.pin[0] - 3}, energy = 9 * (1 + 8 * start.rocker_rate * start.rocker_rate);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto",
                          .duration = 8,
                          .interval = 0.25,
                          .tolerance = 1e-11,
                          .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y"},
        "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [3, 0]},"
        "{'type': 'mass', 'position': [0, 1], 'velocity': [-3, 0]},"
        "{'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 1']},"
        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
        start.pin[0], start.pin[1], 3 * start.rocker_rate * phi[0], 3 * start.rocker_rate * phi[1]);
    double crank = G_PI / 2;
    for (gsize i = 0; i < physics_samples(run); i++) {
        if (i > 0) physics_rk4(1, &crank, physics_time(run, i - 1), physics_time(run, i), 2000, crank_rate, &energy);
        FourBar now = four_bar(crank);
        physics_assert_near("crank's x", physics_value(run, i, 0), cos(crank), 1e-8);
        physics_assert_near("crank's y", physics_value(run, i, 1), sin(crank), 1e-8);
        physics_assert_near("rocker's x", physics_value(run, i, 2), now.pin[0], 1e-8);
        physics_assert_near("rocker's y", physics_value(run, i, 3), now.pin[1], 1e-8);
    }
    g_assert_cmpfloat(crank, >, 4 * G_PI);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
}

/* --- hopeless scenes --- */

/* Two bodies that fall onto each other: the force has no bound, the steps go to nothing. They meet after
 * pi / (2 sqrt 2) r^(3/2) / sqrt(G (m + M)). A method of fixed steps may jump over that, but then says that what
 * follows is not to be believed. */
static void test_collapse(void)
{
    static const char *const methods[] = {"auto", "dopri5", "dop853", "rk4", "verlet", "newmark", "generalized-alpha"};
    double meet = G_PI / sqrt(8) / sqrt(20);
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_try(
            &(PhysicsOptions){.method = methods[m], .duration = 10, .columns = "Mass 0.x, Mass 1.x", .estimate = TRUE},
            "{'type': 'mass', 'position': [-0.5, 0]}, {'type': 'mass', 'position': [0.5, 0]},"
            "{'type': 'attraction', 'strength': 10}");
        if (run->error != NULL) g_test_message("%s: %s", methods[m], run->error->message);
        if (m < 3) g_assert_error(run->error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN);
        g_assert_cmpfloat(fmin(run->summary->valid_until, run->summary->predictable_until), <=, 1);
        g_assert_cmpint(run->summary->evaluations, <, 100000);
        if (m < 3) g_assert_cmpfloat(run->summary->simulated_s, <, meet + 1e-3);
    }
}

/* Never satisfied, or no number: given up on within a few hundred evaluations. */
static void test_hopeless_plugins(void)
{
    static const char *const methods[] = {"auto",   "dopri5",  "dop853",  "rk4",
                                          "verlet", "verlet6", "newmark", "generalized-alpha"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        gint64 before = 0;
        for (int mode = 6; mode >= 0; mode--) { /* 6: none, to count what a run up to 1 s takes */
            if (mode == 4) continue;
            g_autoptr(PhysicsRun) run = physics_try(
                &(PhysicsOptions){
                    .method = methods[m], .duration = mode == 6 ? 1 : 3, .step = 0.01, .columns = "Mass 0.x"},
                "{'type': 'support', 'solid': false, 'position': [0, 1]}, {'type': 'mass', 'velocity': [1, 0]},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0']},"
                "{'type': 'faulty', 'ends': ['Mass 0'], 'mode': %d}",
                mode);
            if (mode == 6) {
                before = run->summary->evaluations;
                continue;
            }
            g_assert_error(run->error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN);
            g_assert_cmpint(run->summary->evaluations, <, before + 1000);
        }
    }
}

/* A mass that turns about another at 1e150 m/s would take as many steps: the run is given up, not the user. */
static void test_out_of_proportion(void)
{
    static const char *const methods[] = {"auto", "dopri5", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_try(
            &(PhysicsOptions){.method = methods[m], .tolerance = 1e-6, .columns = "Mass 0.x"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0], 'velocity': [0, 1e150]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'gravity'}");
        physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "out of all proportion", NULL);
        g_assert_cmpint(run->summary->evaluations, <, 200000);
    }
}

static void test_contradictory_rods(void)
{
    g_autoptr(PhysicsRun) run = physics_try(
        &(PhysicsOptions){.columns = "Mass 0.x"},
        "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [3, 0]}, {'type': "
        "'mass', 'position': [1, 0]},"
        "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.5, 'frequency': 2},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Support 1', 'Mass 0']}");
    g_assert_nonnull(run->error);
    g_test_message("%s", run->error->message);
    g_assert_nonnull(strstr(run->error->message, "Rod"));
}

static void add_tests(void)
{
    g_test_add_func("/physics/singular/coincident-ends", test_coincident_ends);
    g_test_add_func("/physics/singular/coincident-ends-of-a-law", test_coincident_ends_of_a_law);
    g_test_add_func("/physics/singular/rod-without-length", test_rod_without_length);
    g_test_add_func("/physics/singular/dead-points", test_dead_points);
    g_test_add_func("/physics/singular/heavy-parallelogram", test_heavy_parallelogram);
    g_test_add_func("/physics/singular/four-bar", test_four_bar);
    g_test_add_func("/physics/singular/collapse", test_collapse);
    g_test_add_func("/physics/singular/hopeless-plugins", test_hopeless_plugins);
    g_test_add_func("/physics/singular/out-of-proportion", test_out_of_proportion);
    g_test_add_func("/physics/singular/contradictory-rods", test_contradictory_rods);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
