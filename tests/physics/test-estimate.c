/* The estimate of the global error against the true one, on motions with a closed form; and what else it promises. */
#include "physics-fixture.h"

#include "closed-form-motions.h"
#include "numerics/methods/integrators.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define SAMPLES 50
/* For how far and how fast the motion reaches. */
#define TIMES_BETWEEN 64
/* Errors below this share of the scales are rounding. */
#define FLOOR (100 * DBL_EPSILON)

/* --- estimate and truth --- */

/* One run: what it claims beside what is true, sample by sample. */
typedef struct {
    const ClosedForm *problem;
    double time, box[4], speed; /* reached so far */
    double apart, faster;       /* m, m/s: the largest errors so far */
    double error;               /* the same in units of what was reached */
    GArray *claimed, *true_error;
} Comparison;

static void widen(Comparison *comparison, double x, double y)
{
    double *box = comparison->box;
    box[0] = fmin(box[0], x);
    box[1] = fmin(box[1], y);
    box[2] = fmax(box[2], x);
    box[3] = fmax(box[3], y);
}

/* The motion reaches farthest and goes fastest between samples, too. */
static void reach(Comparison *comparison, double from, double to)
{
    for (int k = 1; k <= TIMES_BETWEEN; k++) {
        Motion truth = {0};
        comparison->problem->truth(from + (to - from) * k / TIMES_BETWEEN, &truth);
        for (int i = 0; i < comparison->problem->bodies; i++) {
            widen(comparison, truth.q[2 * i], truth.q[2 * i + 1]);
            comparison->speed = fmax(comparison->speed, hypot(truth.v[2 * i], truth.v[2 * i + 1]));
        }
    }
}

/* Of the state, the largest so far, in units of how far and how fast the motion has reached. */
static double true_error(Comparison *comparison, double time, const double *values)
{
    Motion truth = {0};
    comparison->problem->truth(time, &truth);
    for (int i = 0; i < comparison->problem->bodies; i++) {
        const double *body = values + 4 * i;
        comparison->apart = fmax(comparison->apart, hypot(body[0] - truth.q[2 * i], body[1] - truth.q[2 * i + 1]));
        comparison->faster = fmax(comparison->faster, hypot(body[2] - truth.v[2 * i], body[3] - truth.v[2 * i + 1]));
    }
    double apart = comparison->apart, faster = comparison->faster;
    const double *box = comparison->box;
    double extent = hypot(box[2] - box[0], box[3] - box[1]);
    double places = extent > 0 ? apart / extent : 0, speeds = comparison->speed > 0 ? faster / comparison->speed : 0;
    return fmax(places, speeds);
}

static gboolean compare(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Comparison *comparison = data;
    reach(comparison, comparison->time, time);
    comparison->time = time;
    comparison->error = true_error(comparison, time, values);
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    if (time == 0 || isfinite(summary->predictable_until)) return TRUE;
    double actual = fmax(comparison->error, FLOOR);
    g_assert_cmpfloat(summary->error_estimate, >=, FLOOR);
    g_array_append_val(comparison->claimed, summary->error_estimate);
    g_array_append_val(comparison->true_error, actual);
    return TRUE;
}

static void compare_run(const ClosedForm *problem, const char *method, double step, double tolerance, GArray *claimed,
                        GArray *true_errors)
{
    Comparison comparison = {.problem = problem,
                             .box = {INFINITY, INFINITY, -INFINITY, -INFINITY},
                             .claimed = claimed,
                             .true_error = true_errors};
    for (int i = 0; i < problem->anchors; i++)
        widen(&comparison, problem->anchor[i][0], problem->anchor[i][1]);
    GString *columns = g_string_new(NULL);
    for (int i = 0; i < problem->bodies; i++)
        g_string_append_printf(columns, "%sMass %d.x, Mass %d.y, Mass %d.vx, Mass %d.vy", i > 0 ? ", " : "", i, i, i,
                               i);
    g_autofree char *blocks = closed_form_blocks(problem);
    g_autoptr(PhysicsRun) run = physics_prepare(&(PhysicsOptions){.method = method,
                                                                  .step = step,
                                                                  .tolerance = tolerance,
                                                                  .duration = problem->duration,
                                                                  .interval = problem->duration / SAMPLES,
                                                                  .columns = columns->str,
                                                                  .estimate = TRUE},
                                                "%s", blocks);
    g_string_free(columns, TRUE);
    guint before = claimed->len;
    g_autoptr(GError) error = NULL;
    gboolean done = tinker_simulation_run(run->simulation, run->columns, compare, &comparison, &error);
    g_assert_no_error(error);
    g_assert_true(done);
    if (claimed->len == before) return;
    g_test_message("%-21s step %-8.3g tolerance %-6.1g: error %.2e, estimate %.2e", problem->name, step, tolerance,
                   g_array_index(true_errors, double, true_errors->len - 1),
                   g_array_index(claimed, double, claimed->len - 1));
}

static int by_value(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* Inside in 95 % of the samples, and no more than 5 and 20 times too large in half and 95 % of them. */
static void judge(const char *what, const GArray *claimed, const GArray *true_errors)
{
    guint count = claimed->len, inside = 0;
    g_assert_cmpuint(count, >, 1000);
    g_autofree double *ratios = g_new(double, count);
    for (guint i = 0; i < count; i++) {
        ratios[i] = g_array_index(claimed, double, i) / g_array_index(true_errors, double, i);
        if (ratios[i] >= 1) inside++;
    }
    qsort(ratios, count, sizeof(double), by_value);
    double median = ratios[count / 2], high = ratios[(gsize)(0.95 * count)];
    g_test_message("%s: %.2f %% of %u samples inside; estimate over truth: least %.3g, median %.3g, 95 %% below %.3g",
                   what, 100.0 * inside / count, count, ratios[0], median, high);
    g_assert_cmpfloat(inside, >=, 0.95 * count);
    g_assert_cmpfloat(median, <, 5);
    g_assert_cmpfloat(high, <, 20);
}

static const char *const methods[] = {"rk4",     "verlet",  "semi-implicit-euler", "dopri5", "dop853",
                                      "verlet6", "newmark", "generalized-alpha"};

static void test_closed_forms(void)
{
    /* Of the fastest motion, a step; order 1 takes a tenth of it. */
    static const double angles[] = {0.2, 0.1, 0.05, 0.02};
    static const double tolerances[] = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
    g_autoptr(GArray) claimed = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) true_errors = g_array_new(FALSE, FALSE, sizeof(double));
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(GArray) ours = g_array_new(FALSE, FALSE, sizeof(double));
        g_autoptr(GArray) theirs = g_array_new(FALSE, FALSE, sizeof(double));
        const TinkerIntegrator *method = tinker_integrator_builtin(methods[m]);
        gboolean adaptive = (method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
        double share = method->order == 1 ? 0.1 : 1.0;
        g_test_message("%s", methods[m]);
        for (const ClosedForm *form = closed_forms; form->name != NULL; form++)
            for (gsize i = 0; i < (adaptive ? G_N_ELEMENTS(tolerances) : G_N_ELEMENTS(angles)); i++)
                compare_run(form, methods[m], adaptive ? 0 : share * angles[i] / form->rate,
                            adaptive ? tolerances[i] : 0, ours, theirs);
        judge(methods[m], ours, theirs);
        g_array_append_vals(claimed, ours->data, ours->len);
        g_array_append_vals(true_errors, theirs->data, theirs->len);
    }
    judge("all methods", claimed, true_errors);
}

/* Unit mass and 3 N/m, whose frequency no double is; in extended precision, as the angle grows to 1e7. */
static void slow_oscillator(double t, Motion *motion)
{
    const long double omega = sqrtl(3), angle = omega * t;
    motion->q[0] = (double)(0.25L * cosl(angle) + 0.5L / omega * sinl(angle));
    motion->v[0] = (double)(0.5L * cosl(angle) - 0.25L * omega * sinl(angle));
}

static void check_exact(const ClosedForm *problem)
{
    g_autoptr(GArray) claimed = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) true_errors = g_array_new(FALSE, FALSE, sizeof(double));
    compare_run(problem, "exact", 0, 0, claimed, true_errors);
    g_assert_cmpuint(claimed->len, ==, SAMPLES);
    for (guint i = 0; i < claimed->len; i++)
        g_assert_cmpfloat(g_array_index(claimed, double, i), >=, g_array_index(true_errors, double, i));
    g_assert_cmpfloat(g_array_index(claimed, double, SAMPLES - 1), <,
                      20 * g_array_index(true_errors, double, SAMPLES - 1));
}

/* What is claimed of an exact solution holds over a million periods, too. */
static void test_exact(void)
{
    for (int decade = 0; decade <= 6; decade += 2) {
        ClosedForm problem = {"slow", 1, 1, 2 * G_PI * pow(10, decade), slow_oscillator, NULL, 1, {{-1, 0}}};
        problem.blocks = "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
                         "{'type': 'mass', 'position': [0.25, 0], 'velocity': [0.5, 0]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 3}";
        check_exact(&problem);
    }
    for (const ClosedForm *form = closed_forms; form->name != NULL; form++)
        if (strstr("undamped, under-damped, over-damped, forced, resonance, fall, ellipse, two masses, chain",
                   form->name))
            check_exact(form);
}

/* --- bands around columns --- */

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
                                              .interval = form->duration / SAMPLES,
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

/* --- beyond predictability --- */

#define DOUBLE_PENDULUM                                                                                                \
    "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [1, 0]},"                  \
    "{'type': 'mass', 'position': [2, 0.1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"                        \
    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}"

static int count_warnings(const PhysicsRun *run, const char *words)
{
    int count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        if (strstr(g_ptr_array_index(run->summary->warnings, i), words) != NULL) count++;
    return count;
}

static PhysicsRun *run_chaos(const char *method, double tolerance, gboolean estimate)
{
    return physics_run(&(PhysicsOptions){.method = method,
                                         .tolerance = tolerance,
                                         .step = tolerance,
                                         .duration = 60,
                                         .interval = 0.1,
                                         .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y",
                                         .estimate = estimate},
                       DOUBLE_PENDULUM);
}

/* The first time at which the two runs are a tenth of 4 m apart. */
static double parted_at(const PhysicsRun *left, const PhysicsRun *right)
{
    for (gsize i = 0; i < physics_samples(left); i++)
        for (gsize k = 0; k < 4; k++)
            if (fabs(physics_value(left, i, k) - physics_value(right, i, k)) > 0.1 * 4) return physics_time(left, i);
    return INFINITY;
}

/* It says so before the truth is lost, and not much earlier: errors grow tenfold in one or two seconds here. */
static void test_chaos(void)
{
    static const struct {
        const char *method;
        double tolerance;
    } cases[] = {{"dop853", 1e-6}, {"dop853", 1e-9}, {"dopri5", 1e-7}, {"rk4", 1e-3}};
    g_autoptr(PhysicsRun) finest = run_chaos("dop853", 1e-13, FALSE);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = run_chaos(cases[i].method, cases[i].tolerance, TRUE);
        double parted = parted_at(run, finest), said = run->summary->predictable_until;
        g_test_message("%s at %g: predictable until %g s, parted at %g s", cases[i].method, cases[i].tolerance, said,
                       parted);
        g_assert_cmpfloat(said, <=, parted + 1e-9);
        g_assert_cmpfloat(said, >, parted - 5);
        g_assert_cmpfloat(run->summary->error_estimate, >, 0.1);
        g_assert_cmpint(count_warnings(run, "not predictable beyond t = "), ==, 1);
    }
}

/* --- what an estimate must not do --- */

/* A double pendulum, an oscillator that swings on a moving support, one along a line. */
#define BUSY_SCENE                                                                                                     \
    DOUBLE_PENDULUM                                                                                                    \
    ", {'type': 'support', 'solid': false, 'position': [5, 0]}, {'type': 'mass', 'position': [5, -1.2]},"              \
    "{'type': 'spring', 'ends': ['Support 1', 'Mass 2'], 'rest_length': 1},"                                           \
    "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.1, 'frequency': 3},"                             \
    "{'type': 'motor', 'ends': ['Mass 2'], 'waveform': {'expression': 'step(t-0.7)'}},"                                \
    "{'type': 'support', 'solid': false, 'position': [9, 0]}, {'type': 'mass', 'position': [9, -1.5]},"                \
    "{'type': 'spring', 'ends': ['Support 2', 'Mass 3'], 'rest_length': 1, 'stiffness': 1000},"                        \
    "{'type': 'motor', 'ends': ['Mass 3'], 'angle': '90 deg', 'waveform': {'expression': 'step(t-0.7)'}}"

static void assert_same_record(const PhysicsRun *left, const PhysicsRun *right)
{
    g_assert_cmpmem(left->samples->data, left->samples->len * sizeof(double), right->samples->data,
                    right->samples->len * sizeof(double));
    physics_assert_same_bits(left, right);
    const TinkerSummary *l = left->summary, *r = right->summary;
    g_assert_cmpint(l->steps, ==, r->steps);
    g_assert_cmpint(l->evaluations, ==, r->evaluations);
    g_assert_cmpfloat(l->energy_balance_error, ==, r->energy_balance_error);
    g_assert_cmpfloat(l->kinetic_end, ==, r->kinetic_end);
    g_assert_cmpfloat(l->constraint_position_error, ==, r->constraint_position_error);
    g_assert_cmpmem(l->books, sizeof(l->books), r->books, sizeof(r->books));
    g_assert_cmpuint(l->events->len, ==, r->events->len);
}

static void test_no_bit_changes(void)
{
    for (gsize m = 0; m <= G_N_ELEMENTS(methods); m++) {
        PhysicsOptions options = {
            .method = m < G_N_ELEMENTS(methods) ? methods[m] : "auto",
            .duration = 2,
            .interval = 0.03,
            .step = 2e-3,
            .tolerance = 1e-8,
            .columns =
                "Mass 0.x, Mass 1.y, Mass 2.y, Mass 2.vy, Mass 3.y, Rod 0.tension, Spring 0.tension, Support 1.y"};
        g_autoptr(PhysicsRun) without = physics_run(&options, BUSY_SCENE);
        options.estimate = options.bands = TRUE;
        g_autoptr(PhysicsRun) with = physics_run(&options, BUSY_SCENE);
        assert_same_record(with, without);
        g_assert_true(isnan(without->summary->error_estimate));
        g_assert_true(isinf(without->summary->predictable_until));
        g_assert_cmpfloat(with->summary->error_estimate, >, FLOOR);
        g_assert_cmpfloat(with->summary->error_estimate, <, 0.1);
        g_assert_cmpuint(with->summary->warnings->len, ==, without->summary->warnings->len);
    }
}

/* A wall that a coarse step happens to stop short of and a finer one runs into: the run does as without a companion. */
static void test_failing_companion(void)
{
    int lost = 0;
    for (int i = 0; i < 40; i++) {
        PhysicsOptions options = {
            .method = "semi-implicit-euler", .step = 0.2, .duration = 1, .columns = "Mass 0.x, Mass 0.vx"};
        g_autofree char *scene = g_strdup_printf(
            "{'type': 'mass', 'velocity': [%g, 0]}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': 4}", 4.5 + 0.02 * i);
        g_autoptr(PhysicsRun) without = physics_try(&options, "%s", scene);
        options.estimate = TRUE;
        g_autoptr(PhysicsRun) with = physics_try(&options, "%s", scene);
        g_assert_true((with->error == NULL) == (without->error == NULL));
        if (with->error != NULL) g_assert_cmpstr(with->error->message, ==, without->error->message);
        g_assert_cmpmem(with->samples->data, with->samples->len * sizeof(double), without->samples->data,
                        without->samples->len * sizeof(double));
        int warnings = count_warnings(with, "there is no error estimate beyond t = ");
        g_assert_cmpint(warnings, <=, 1);
        lost += with->error == NULL && warnings == 1;
    }
    g_test_message("%d of 40 companions failed in a run that did not", lost);
    g_assert_cmpint(lost, >, 0);
}

/* What hangs at rest stays there: its speeds are rounding, and so is what two runs of them differ by. */
static void test_rest(void)
{
    const char *const all[] = {"rk4", "verlet6", "newmark", "dop853"};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        PhysicsOptions options = {.method = all[i], .step = 1e-3, .duration = 3, .tolerance = 1e-13, .estimate = TRUE};
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "{'type': 'mass', 'position': [-1.6828098921791184, -0.2876739612022381]},"
                                  "{'type': 'mass', 'position': [-0.9875696021116536, 1.2445711576479659]},"
                                  "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1000},"
                                  "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 2}");
        g_assert_cmpfloat(run->summary->error_estimate, <, 1e-9);
        g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    }
}

/* One step takes a loose run to its end, and its companion too: that they agree says nothing. Against x = (t - sin t).
 */
static void test_equal_steps(void)
{
    PhysicsOptions options = {
        .method = "dop853", .duration = 1.5, .tolerance = 1e-3, .columns = "Mass 0.x", .estimate = TRUE};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'], 'waveform': 'sine', 'frequency': 1}");
    double error = fabs(physics_last(run, 0) - (1.5 - sin(1.5))) / (1.5 - sin(1.5));
    g_assert_cmpint(run->summary->steps, ==, 1);
    g_assert_cmpfloat(run->summary->error_estimate, >=, error);
}

/* Masses on a line whose ends pass each other again and again: what rounding starts grows there by far more than the
 * time. Runs that meet other samples round otherwise, and part by no more than both claim. */
static void test_passing(void)
{
    const char *scene = "{'type': 'support', 'solid': false},"
                        "{'type': 'mass', 'position': [1, 0], 'mass': 0.12, 'velocity': [-0.7, 0]},"
                        "{'type': 'mass', 'position': [2, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 20000, 'rest_length': 0},"
                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 5000, 'rest_length': 1}";
    PhysicsOptions options = {.method = "exact", .duration = 3, .interval = 0.1, .columns = "Mass 0.x, Mass 1.x"};
    options.estimate = TRUE;
    g_autoptr(PhysicsRun) coarse = physics_run(&options, "%s", scene);
    options.interval = 0.01;
    g_autoptr(PhysicsRun) fine = physics_run(&options, "%s", scene);
    double claimed = coarse->summary->error_estimate + fine->summary->error_estimate;
    for (gsize i = 0; i < 2; i++) /* the extent is about 2.5 m */
        physics_assert_near("x", physics_last(coarse, i), physics_last(fine, i), 2.5 * claimed);
    g_assert_cmpfloat(claimed, >, 1e-8);
}

/* A mass on a stiff spring of some length, which is pushed slowly: its ends come nowhere near each other, so the exact
 * solution is off by rounding alone, of which speeds have more than places. Of m x'' = F (1 - cos W t) - k x from rest,
 * with w^2 = k / m, x = F / k (1 - cos w t) - F / (m (w^2 - W^2)) (cos W t - cos w t). Velocities are compared: places
 * are so near to the rest length that what is recorded of them is that. */
static void test_stiff_apart(void)
{
    enum { TIMES = 10 };
    const double force = 1000, k = 1e12, slow = 2 * G_PI, fast = 1e6, between = 0.05;
    PhysicsOptions options = {
        .method = "exact", .duration = TIMES * between, .interval = between, .columns = "Mass 0.vx", .estimate = TRUE};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0]},"
                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1e12, 'rest_length': 1},"
                  "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '1000*(1-cos(2*pi*t))'}}");
    const double speed = force * slow / k, claimed = run->summary->error_estimate;
    g_assert_true(isinf(run->summary->predictable_until));
    g_assert_cmpfloat(claimed, <, 1e-6);
    for (int i = 1; i <= TIMES; i++) {
        const double t = i * between, rings = force * (fast / k - fast / (fast * fast - slow * slow));
        const double v = rings * sin(fast * t) + force * slow / (fast * fast - slow * slow) * sin(slow * t);
        physics_assert_near("vx", physics_value(run, i, 0), v, claimed * speed);
    }
}

/* --- where an exact solution ends, and between samples --- */

/* What a run claims, sample by sample. */
static gboolean keep_claim(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    GArray *claims = data;
    double claim = tinker_simulation_summary(simulation)->error_estimate;
    if (time > 0) g_array_append_val(claims, claim);
    return TRUE;
}

static GArray *claims_of(const PhysicsOptions *options, const char *blocks)
{
    GArray *claims = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GError) error = NULL;
    g_autoptr(PhysicsRun) run = physics_prepare(options, "%s", blocks);
    tinker_simulation_run(run->simulation, NULL, keep_claim, claims, &error);
    g_assert_no_error(error);
    return claims;
}

/* Pushed along by 6 sin 5t while it falls onto a smooth floor and after: x = 6 (5t - sin 5t) / 25. The fall and its end
 * are exact, what follows is not. */
static void test_exact_then_contact(void)
{
    static const double tolerances[] = {1e-3, 1e-6, 1e-9};
    const char *scene = "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 100,"
                        "'static_friction': 0, 'dynamic_friction': 0},"
                        "{'type': 'mass', 'position': [0, 0.7]},"
                        "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': 'sine', 'amplitude': 6, 'frequency': 5}";
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        PhysicsOptions options = {.method = "auto",
                                  .tolerance = tolerances[i],
                                  .duration = 6,
                                  .interval = 0.25,
                                  .columns = "Mass 0.x, Mass 0.vx",
                                  .estimate = TRUE};
        g_autoptr(GArray) claims = claims_of(&options, scene);
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", scene);
        double apart = 0, faster = 0;
        for (guint k = 0; k < claims->len; k++) {
            double t = physics_time(run, k + 1), extent = 6 * (5 * t - sin(5 * t)) / 25, speed = 12.0 / 5;
            apart = fmax(apart, fabs(physics_value(run, k + 1, 0) - extent));
            faster = fmax(faster, fabs(physics_value(run, k + 1, 1) - 6 * (1 - cos(5 * t)) / 5));
            double error = fmax(apart / extent, faster / speed);
            g_assert_cmpfloat(fmax(error, FLOOR), <=, g_array_index(claims, double, k));
        }
        g_assert_cmpfloat(apart, >, 0);
    }
}

/* x'' + 1000 x' + 20000 x = 0 from x = 1 at 300 m/s: what is fast is over within some milliseconds. */
static void strongly_damped(double t, Motion *motion)
{
    double root = sqrt(500.0 * 500.0 - 20000.0), slow = -20000.0 / (500 + root), fast = -500 - root;
    double c = (300 - fast) / (slow - fast), d = 1 - c;
    motion->q[0] = c * exp(slow * t) + d * exp(fast * t);
    motion->v[0] = slow * c * exp(slow * t) + fast * d * exp(fast * t);
}

/* A few samples late in the motion claim what it was off by early, too. */
static void test_between_samples(void)
{
    static const double tolerances[] = {1e-4, 1e-6, 1e-9};
    const char *scene = "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
                        "{'type': 'mass', 'position': [1, 0], 'velocity': [300, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 20000, 'rest_length': 1},"
                        "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 1000}";
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++) {
        PhysicsOptions options = {.tolerance = tolerances[i], .duration = 0.6, .interval = 0.3, .estimate = TRUE};
        g_autoptr(GArray) claims = claims_of(&options, scene);
        options.interval = 1e-4;
        options.columns = "Mass 0.x, Mass 0.vx";
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", scene);
        double reach = 0, apart = 0, faster = 0;
        for (gsize k = 0; k < physics_samples(run); k++) {
            Motion truth = {0};
            strongly_damped(physics_time(run, k), &truth);
            reach = fmax(reach, truth.q[0]);
            apart = fmax(apart, fabs(physics_value(run, k, 0) - truth.q[0]));
            faster = fmax(faster, fabs(physics_value(run, k, 1) - truth.v[0]));
        }
        double error = fmax(apart / (reach + 1), faster / 300), claimed = g_array_index(claims, double, 1);
        g_test_message("tolerance %g: error %.2g, claimed %.2g", tolerances[i], error, claimed);
        g_assert_cmpfloat(error, <=, 2 * claimed); /* where stability makes the steps, errors are spikes */
        g_assert_cmpfloat(claimed, <, 10 * error);
    }
}

/* Thrown from side to side of a smooth elastic wedge, a ball loses the last bit first and everything in the end. Two
 * methods, both right to rounding between blows, are within what each claims for as long as it claims to know. */
static void test_wedge(void)
{
    const char *scene =
        "{'type': 'gravity'}, {'type': 'support', 'position': [-2, 2], 'orientation': -0.7854, 'width': 8,"
        "'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0}, {'type': 'support', 'position': [2, 2],"
        "'orientation': 0.9, 'width': 8, 'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'mass', 'position': [0.3, 4], 'width': 0, 'height': 0}";
    PhysicsOptions options = {.method = "auto",
                              .tolerance = 1e-9,
                              .duration = 200,
                              .interval = 0.5,
                              .columns = "Mass 0.x, Mass 0.y",
                              .estimate = TRUE};
    g_autoptr(GArray) claims = claims_of(&options, scene);
    g_autoptr(PhysicsRun) exact = physics_run(&options, "%s", scene);
    options.method = "dopri5";
    g_autoptr(PhysicsRun) other = physics_run(&options, "%s", scene);
    double known = fmin(exact->summary->predictable_until, other->summary->predictable_until);
    gboolean parted = FALSE;
    for (guint k = 0; k < claims->len; k++) {
        double apart = hypot(physics_value(exact, k + 1, 0) - physics_value(other, k + 1, 0),
                             physics_value(exact, k + 1, 1) - physics_value(other, k + 1, 1));
        parted |= apart > 0.1;
        /* the extent is about 3 m */
        if (physics_time(exact, k + 1) < known) g_assert_cmpfloat(apart, <=, 2 * 3 * g_array_index(claims, double, k));
    }
    g_test_message("predictable until %g s", known);
    g_assert_true(parted);
    g_assert_cmpfloat(known, <, 200);
    g_assert_cmpfloat(known, >, 5);
}

static void add_tests(void)
{
    g_test_add_func("/physics/estimate/closed-forms", test_closed_forms);
    g_test_add_func("/physics/estimate/exact", test_exact);
    g_test_add_func("/physics/estimate/bands", test_bands);
    g_test_add_func("/physics/estimate/bands-end", test_bands_end);
    g_test_add_func("/physics/estimate/chaos", test_chaos);
    g_test_add_func("/physics/estimate/no-bit-changes", test_no_bit_changes);
    g_test_add_func("/physics/estimate/failing-companion", test_failing_companion);
    g_test_add_func("/physics/estimate/rest", test_rest);
    g_test_add_func("/physics/estimate/equal-steps", test_equal_steps);
    g_test_add_func("/physics/estimate/passing", test_passing);
    g_test_add_func("/physics/estimate/stiff-apart", test_stiff_apart);
    g_test_add_func("/physics/estimate/exact-then-contact", test_exact_then_contact);
    g_test_add_func("/physics/estimate/between-samples", test_between_samples);
    g_test_add_func("/physics/estimate/wedge", test_wedge);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
