/* The bands around columns that a run with an estimate claims. */
#include "physics-fixture.h"

#include "closed-form-motions.h"
#include "estimate-case.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#include <math.h>
#include <string.h>

typedef struct {
    const ClosedForm *problem;
    double off[4]; /* so far */
    int inside, count;
} BandCheck;

static gboolean check_bands(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    BandCheck *check = data;
    Motion truth = {0};
    check->problem->truth(time, &truth);
    const double *bands = tinker_simulation_bands(simulation);
    const double state[4] = {truth.q[0], truth.q[1], truth.v[0], truth.v[1]};
    g_assert_nonnull(bands);
    for (int k = 0; k < 4 && bands != NULL; k++) {
        check->off[k] = fmax(check->off[k], fabs(values[k] - state[k]));
        if (check->off[k] <= bands[k] + 1e-14) check->inside++;
        check->count++;
    }
    return TRUE;
}

static void test_bands(void)
{
    int inside = 0, count = 0;
    for (const ClosedForm *form = closed_forms; form->name != NULL; form++) {
        if (form->bodies > 1) continue;
        BandCheck check = {.problem = form};
        g_autoptr(PhysicsRun) run =
            physics_prepare(&(PhysicsOptions){.method = "rk4",
                                              .step = 0.05 / form->rate,
                                              .duration = form->duration,
                                              .interval = form->duration / ESTIMATE_SAMPLES,
                                              .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy",
                                              .estimate = TRUE,
                                              .bands = TRUE},
                            "%s", form->blocks);
        g_assert_true(tinker_simulation_run(run->simulation, run->columns, check_bands, &check, NULL));
        inside += check.inside;
        count += check.count;
    }
    g_test_message("%d of %d bands hold", inside, count);
    g_assert_cmpint(inside, >=, (int)(0.95 * count));
}

static gboolean note_bands(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    GArray *noted = data;
    const double *bands = tinker_simulation_bands(simulation);
    g_assert_nonnull(bands);
    if (bands != NULL) g_array_append_val(noted, bands[0]);
    return TRUE;
}

/* The companion, at half the step, stops at t = 1/16 s, where the force is 0/0; the run passes it. */
static void test_bands_end(void)
{
    g_autoptr(GArray) noted = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(PhysicsRun) run = physics_prepare(
        &(PhysicsOptions){.method = "verlet", .step = 0.125, .columns = "Mass 0.x", .estimate = TRUE, .bands = TRUE},
        "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'],"
        "'waveform': {'expression': 'sin(t-0.0625)/(t-0.0625)'}}");
    g_assert_true(tinker_simulation_run(run->simulation, run->columns, note_bands, noted, NULL));
    g_assert_cmpuint(noted->len, ==, 11);
    g_assert_cmpfloat(g_array_index(noted, double, 0), ==, 0);
    for (guint i = 1; i < noted->len; i++)
        g_assert_true(isnan(g_array_index(noted, double, i)));
    g_assert_true(isnan(tinker_simulation_summary(run->simulation)->error_estimate));
}

static gboolean keep_bands(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    memcpy(data, tinker_simulation_bands(simulation), 2 * sizeof(double));
    return TRUE;
}

/* A ball that comes down within roundings of the sample at 0.5 s, before it or behind it: on which side of the impact
 * the run stands, and its companion, is no error of 9 m/s. */
static void test_bands_at_impact(void)
{
    const double late[] = {-1e-14, -2e-15, -1e-15, 0, 1e-15, 2e-15, 1e-14};
    for (gsize i = 0; i < G_N_ELEMENTS(late); i++) {
        double bands[2] = {NAN, NAN};
        const double fall = 0.5 * 9.81 * (0.5 + late[i]) * (0.5 + late[i]);
        g_autoptr(PhysicsRun) run = physics_prepare(
            &(PhysicsOptions){
                .duration = 1, .interval = 0.1, .columns = "Mass 0.y, Mass 0.vy", .estimate = TRUE, .bands = TRUE},
            "{'type': 'gravity'}, {'type': 'support', 'restitution': 0.8}, {'type': 'mass', 'position': [0, %.17g]}",
            0.6 + fall);
        g_assert_true(tinker_simulation_run(run->simulation, run->columns, keep_bands, bands, NULL));
        g_assert_cmpfloat(bands[0], <, 1e-11);
        g_assert_cmpfloat(bands[1], <, 1e-11);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/estimate/bands-at-impact", test_bands_at_impact);
    g_test_add_func("/physics/estimate/bands", test_bands);
    g_test_add_func("/physics/estimate/bands-end", test_bands_end);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
