/* The estimate of the global error against the true one, on motions with a closed form. */
#include "physics-fixture.h"

#include "closed-form-motions.h"
#include "estimate-case.h"
#include "numerics/methods/integrators.h"
#include "physics/run/simulation.h"
#include "physics/run/tolerances.h"
#include "physics/system/summary.h"

#include <math.h>
#include <string.h>

/* For how far and how fast the motion reaches. */
#define TIMES_BETWEEN 64

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
    const double claimed = tinker_simulation_error(simulation);
    if (time == 0 || claimed > TINKER_UNPREDICTABLE) return TRUE;
    double actual = fmax(comparison->error, ESTIMATE_FLOOR);
    g_assert_cmpfloat(claimed, >=, ESTIMATE_FLOOR);
    g_array_append_val(comparison->claimed, claimed);
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
                                                                  .interval = problem->duration / ESTIMATE_SAMPLES,
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

static const char *const methods[] = ESTIMATE_METHODS;

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
    g_assert_cmpuint(claimed->len, ==, ESTIMATE_SAMPLES);
    for (guint i = 0; i < claimed->len; i++)
        g_assert_cmpfloat(g_array_index(claimed, double, i), >=, g_array_index(true_errors, double, i));
    g_assert_cmpfloat(g_array_index(claimed, double, ESTIMATE_SAMPLES - 1), <,
                      20 * g_array_index(true_errors, double, ESTIMATE_SAMPLES - 1));
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

/* A slider-crank that is driven: nothing of it is free, so samples are off by rounding whatever the method, and so is
 * what is claimed, also within steps, which leave the constraints by the tolerance. */
static void test_nothing_free(void)
{
    static const char *const all[] = {"dopri5", "dop853", "rk4", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(all); m++) {
        const PhysicsOptions options = {.method = all[m],
                                        .step = 0.05,
                                        .tolerance = 1e-3,
                                        .duration = 3,
                                        .columns = "Bar 0.angle, Mass 0.x, Mass 0.vx",
                                        .estimate = TRUE};
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
            "{'type': 'bar', 'length': 0.6, 'position': [0.3, 0]}, {'type': 'bar', 'position': [1.1, 0]},"
            "{'type': 'mass', 'position': [1.6, 0]}, {'type': 'slot', 'ends': ['Support 0', 'Mass 0']},"
            "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.3, 0]}]},"
            "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.3, 0]}, {'block': 'Bar 1', 'at': [-0.5, 0]}]},"
            "{'type': 'pin', 'ends': [{'block': 'Bar 1', 'at': [0.5, 0]}, 'Mass 0']},"
            "{'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 2}");
        for (gsize i = 0; i < physics_samples(run); i++) {
            const double a = 2 * physics_time(run, i), rise = 0.6 * sin(a), far = sqrt(1 - rise * rise);
            physics_assert_near("angle", physics_value(run, i, 0), a, 1e-12);
            physics_assert_near("place", physics_value(run, i, 1), 0.6 * cos(a) + far, 1e-12);
            physics_assert_near("speed", physics_value(run, i, 2), -2 * rise - 1.2 * cos(a) * rise / far, 1e-12);
        }
        physics_assert_near("estimate", run->summary->error_estimate, 0, 1e-11);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/estimate/closed-forms", test_closed_forms);
    g_test_add_func("/physics/estimate/exact", test_exact);
    g_test_add_func("/physics/estimate/nothing-free", test_nothing_free);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
