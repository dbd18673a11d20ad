/* Looking never changes a run: the same bits whatever is recorded, and every time. */
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/run/simulation.h"

#include <math.h>

static const char columns[] = "Mass 0.x, Mass 1.ay, Rod 0.tension, Spring 0.energy, Support 1.vx, Motor 0.power";

static void test_looking_changes_nothing(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    static const double few[] = {3}, list[] = {2.9999, 0.1, 3, 0, 1.0 / 3, 0.1, 2, 1.0471975511965976};
    const PhysicsOptions looks[] = {
        {.interval = 0.1, .columns = columns},
        {.interval = 0.001, .columns = columns},
        {.interval = 0.37, .columns = columns},
        {.at = list, .at_count = G_N_ELEMENTS(list), .columns = columns},
        {.at = few, .at_count = 1},
        {.interval = 3},
        {.interval = 0.1, .columns = columns},
    };
    g_autoptr(PhysicsRun) first = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++) {
        PhysicsOptions options = looks[i];
        options.method = method->id;
        options.duration = 3;
        options.tolerance = 1e-7;
        PhysicsRun *run = physics_run(&options, "%s", physics_rods_and_springs);
        if (first == NULL) {
            first = run;
            continue;
        }
        physics_assert_same_bits(first, run);
        g_assert_cmpint(first->summary->steps, ==, run->summary->steps);
        g_assert_cmpint(first->summary->rejected_steps, ==, run->summary->rejected_steps);
        g_assert_cmpint(first->summary->evaluations, ==, run->summary->evaluations);
        g_assert_cmpmem(first->summary->books, sizeof(first->summary->books), run->summary->books,
                        sizeof(run->summary->books));
        if (i + 1 == G_N_ELEMENTS(looks))
            g_assert_cmpmem(first->samples->data, first->samples->len * sizeof(double), run->samples->data,
                            run->samples->len * sizeof(double));
        physics_run_free(run);
    }
}

/* What steps from sample to sample agrees to rounding, however many samples there are. */
static void test_exact(void)
{
    static const char scene[] =
        "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [2, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 30}, {'type': 'damper', "
        "'ends': ['Support 0', 'Mass 0'], 'damping': 0.2}, {'type': 'motor', 'ends': ['Mass 0'], 'frequency': 5},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 3},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '5*square(3*t) + t^2 - 2*sin(t)^2'}}";
    g_autoptr(PhysicsRun) once =
        physics_run(&(PhysicsOptions){.method = "exact", .duration = 20, .interval = 20, .columns = "Mass 0.x"}, scene);
    g_autoptr(PhysicsRun) often = physics_run(
        &(PhysicsOptions){.method = "exact", .duration = 20, .interval = 0.001, .columns = "Mass 0.x"}, scene);
    g_autoptr(PhysicsRun) other = physics_run(
        &(PhysicsOptions){
            .method = "dop853", .tolerance = 1e-13, .duration = 20, .interval = 20, .columns = "Mass 0.x"},
        scene);
    double x = physics_value(once, 1, 0);
    physics_assert_near("x of many samples", physics_value(often, 20000, 0), x, 1e-11);
    physics_assert_near("x by another method", physics_value(other, 1, 0), x, 1e-9);
    g_assert_cmpfloat(once->summary->energy_balance_error, <, 1e-11);
    g_assert_cmpfloat(often->summary->energy_balance_error, <, 1e-11);
}

/* Single steps without samples are the steps of a run. */
static void test_single_steps(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "rk4", .duration = 2}, "%s", physics_rods_and_springs);
    g_autoptr(PhysicsRun) stepped =
        physics_prepare(&(PhysicsOptions){.method = "rk4", .duration = 2}, "%s", physics_rods_and_springs);
    while (tinker_simulation_time(stepped->simulation) < 2 && stepped->error == NULL)
        tinker_simulation_step(stepped->simulation, &stepped->error);
    g_assert_no_error(stepped->error);
    physics_assert_same_bits(run, stepped);
}

/* Samples at asked times: in order, with 0 the start, whatever the order asked in; the run lasts to the greatest. */
static void test_times_in_any_order(void)
{
    static const double at[] = {1.5, 0.25, 0, 0.25, 1};
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.at = at, .at_count = 5, .duration = 99, .columns = "Mass 0.x, Mass 0.vx"},
                    "{'type': 'mass', 'velocity': [2, 0], 'position': [1, 0]}, {'type': 'motor', 'ends': ['Mass 0'], "
                    "'frequency': 0}");
    static const double sorted[] = {0, 0.25, 0.25, 1, 1.5};
    g_assert_cmpuint(physics_samples(run), ==, 5);
    for (gsize i = 0; i < 5; i++) {
        double t = sorted[i];
        g_assert_cmpfloat(physics_time(run, i), ==, t);
        physics_assert_near("x", physics_value(run, i, 0), 1 + 2 * t + t * t / 2, 1e-14);
        physics_assert_near("vx", physics_value(run, i, 1), 2 + t, 1e-14);
    }
    g_assert_cmpfloat(run->summary->simulated_s, ==, 1.5);
}

/* A tenth of a second has no double, but 0.3 is sampled at the double 0.3; the last sample is at the duration. */
static void test_grid_of_times(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 0.75, .interval = 0.1}, "{'type': 'mass'}");
    static const double times[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75};
    g_assert_cmpuint(physics_samples(run), ==, G_N_ELEMENTS(times));
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++)
        g_assert_cmpfloat(physics_time(run, i), ==, times[i]);
    g_autoptr(PhysicsRun) whole = physics_run(&(PhysicsOptions){.duration = 0.9, .interval = 0.3}, "{'type': 'mass'}");
    g_assert_cmpuint(physics_samples(whole), ==, 4);
    g_assert_cmpfloat(physics_time(whole, 3), ==, 0.9);
}

/* Free fall from rest at a step of 0.01 s: y as the thesis prints it, with five decimals. */
static void test_published_rows(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "rk4", .duration = 0.1, .interval = 0.01, .columns = "Mass 0.y"},
                    "{'type': 'gravity'}, {'type': 'mass'}");
    static const char *const rows[] = {"0.00000",  "-0.00049", "-0.00196", "-0.00441", "-0.00785", "-0.01226",
                                       "-0.01766", "-0.02403", "-0.03139", "-0.03973", "-0.04905"};
    g_assert_cmpuint(physics_samples(run), ==, G_N_ELEMENTS(rows));
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *text = g_strdup_printf("%.5f", physics_value(run, i, 0));
        g_assert_cmpstr(text, ==, rows[i]);
    }
}

static void add_tests(void)
{
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_LINEAR) continue; /* steps from sample to sample: see below */
        g_autofree char *name = g_strdup_printf("/physics/recording/looking-changes-nothing/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_looking_changes_nothing);
    }
    g_test_add_func("/physics/recording/exact", test_exact);
    g_test_add_func("/physics/recording/single-steps", test_single_steps);
    g_test_add_func("/physics/recording/times-in-any-order", test_times_in_any_order);
    g_test_add_func("/physics/recording/grid-of-times", test_grid_of_times);
    g_test_add_func("/physics/recording/published-rows", test_published_rows);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
