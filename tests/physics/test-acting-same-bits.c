/* Looking at the forces that act changes no bit of a run; what acts at the start is the first sample. */
#include "acting-watch.h"

#include "numerics/methods/integrators.h"
#include "physics/record/columns.h"
#include "physics/system/summary.h"

static const char contacts[] =
    "{'type': 'gravity'}, {'type': 'support', 'width': 20, 'orientation': 0.1, 'static_friction': 0.3, "
    "'dynamic_friction': 0.2, 'restitution': 0.6}, {'type': 'mass', 'position': [0, 2]}, {'type': 'mass', 'position': "
    "[-3, 1.5]}, {'type': 'mass', 'position': [-1.6, 1.5]}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 2'], 'rest_length': 1.5}";

/* All samples of a run, with its end state behind. */
static GArray *run_watched(const char *blocks, const PhysicsOptions *how, gboolean looks, gboolean with_columns)
{
    g_autoptr(PhysicsRun) run = physics_prepare(how, "%s", blocks);
    ActingWatch watch;
    acting_watch_open(&watch, run->scene, run->model);
    watch.look = looks;
    watch.samples = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) none = tinker_columns_new();
    GArray *all = watch.columns;
    if (!with_columns) watch.columns = none;
    tinker_simulation_run(run->simulation, watch.columns, acting_watch_look, &watch, &run->error);
    g_assert_no_error(run->error);
    g_assert_cmpint(watch.allotted, ==, 0);
    g_assert_cmpint(watch.looked, ==, looks ? 151 : 0);
    watch.columns = all;
    const TinkerSummary *summary = tinker_simulation_summary(run->simulation);
    double counts[2] = {(double)summary->steps, (double)summary->evaluations};
    g_array_append_vals(watch.samples, counts, 2);
    g_array_append_vals(watch.samples, summary->books, TINKER_BOOK_COUNT);
    for (guint i = 0; i < watch.bodies->len; i++) {
        double state[4];
        tinker_simulation_state(run->simulation, g_array_index(watch.bodies, TinkerBlockId, i), state, state + 2);
        g_array_append_vals(watch.samples, state, 4);
    }
    acting_watch_close(&watch);
    return watch.samples;
}

static void check_same_bits(const char *blocks, PhysicsOptions how)
{
    how.duration = 3;
    how.interval = 0.02;
    if (how.tolerance == 0) how.tolerance = 1e-7;
    for (int with_columns = 0; with_columns < 2; with_columns++) {
        g_autoptr(GArray) plain = run_watched(blocks, &how, FALSE, with_columns);
        g_autoptr(GArray) looked = run_watched(blocks, &how, TRUE, with_columns);
        g_assert_cmpmem(plain->data, plain->len * sizeof(double), looked->data, looked->len * sizeof(double));
    }
}

static void test_same_bits(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    if (method->flags & TINKER_INTEGRATOR_LINEAR) return;
    check_same_bits(physics_rods_and_springs, (PhysicsOptions){.method = method->id});
}

static void test_same_bits_of_contacts(void)
{
    check_same_bits(contacts, (PhysicsOptions){.method = "auto"});
    check_same_bits(contacts, (PhysicsOptions){.method = "verlet", .step = 0.001});
    check_same_bits(contacts, (PhysicsOptions){.method = "auto", .step = 0.002, .impulses = TRUE});
}

/* Islands of their own: the whole model is not stepped itself. And what is stepped along a line. */
static void test_same_bits_of_islands(void)
{
    check_same_bits("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [2, 0]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1}, {'type': 'motor', 'ends': "
                    "['Mass 0'], 'frequency': 5}, {'type': 'mass', 'position': [0, 3]}, {'type': 'spring', 'ends': "
                    "['Support 0', 'Mass 1'], 'rest_length': 1}, {'type': 'damper', 'ends': ['Support 0', 'Mass 1']}",
                    (PhysicsOptions){.method = "auto"});
}

/* The set-up state is the first sample. */
static void test_start_is_first_sample(void)
{
    static const double start[] = {0};
    g_autoptr(PhysicsRun) once = physics_prepare(&(PhysicsOptions){.at = start, .at_count = 1}, "%s", contacts);
    ActingWatch first;
    acting_watch_open(&first, once->scene, once->model);
    tinker_simulation_run(once->simulation, first.columns, acting_watch_look, &first, &once->error);
    g_autoptr(GArray) out = acting_watch_at_start(once->scene);
    g_assert_cmpint(first.looked, ==, 1);
    g_assert_cmpuint(out->len, ==, first.out->len);
    for (guint i = 0; i < out->len; i++) { /* member by member: what lies between them is anything */
        const TinkerActingForce *l = &g_array_index(out, TinkerActingForce, i);
        const TinkerActingForce *r = &g_array_index(first.out, TinkerActingForce, i);
        g_assert_true(l->by == r->by && l->on == r->on && l->kind == r->kind);
        const double left[] = {l->x, l->y, l->fx, l->fy}, right[] = {r->x, r->y, r->fx, r->fy};
        g_assert_cmpmem(left, sizeof left, right, sizeof right);
    }
    acting_watch_close(&first);
}

static void add_tests(void)
{
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        g_autofree char *name = g_strdup_printf("/physics/acting-forces/same-bits/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_same_bits);
    }
    g_test_add_func("/physics/acting-forces/same-bits/contacts", test_same_bits_of_contacts);
    g_test_add_func("/physics/acting-forces/same-bits/islands", test_same_bits_of_islands);
    g_test_add_func("/physics/acting-forces/start-is-first-sample", test_start_is_first_sample);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
