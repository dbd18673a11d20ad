/* Runs that are held to an accuracy: what they end with against closed forms, and what they tell of their tries. */
#include "physics-fixture.h"

#include "closed-form-motions.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define SAMPLES 20
/* Between two samples, for how far and how fast a motion reaches. */
#define TIMES_BETWEEN 64

static const char *const wide_pendulum =
    "{'type': 'support', 'solid': false}, {'type': 'gravity', 'acceleration': 9.81},"
    "{'type': 'mass', 'position': [0.017452406437283512, 0.99984769515639127]}, {'type': 'rod', 'ends': ['Support 0', "
    "'Mass 0'], 'length': 1}";

/* How far and how fast the motion reaches: the scales of an accuracy. */
static void find_scales(const ClosedForm *form, double *extent, double *speed)
{
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    *speed = 0;
    for (int k = 0; k <= SAMPLES * TIMES_BETWEEN; k++) {
        Motion truth = {0};
        form->truth(form->duration * k / (SAMPLES * TIMES_BETWEEN), &truth);
        for (int i = 0; i < form->bodies + form->anchors; i++) {
            const double *at = i < form->bodies ? truth.q + 2 * i : form->anchor[i - form->bodies];
            box[0] = fmin(box[0], at[0]);
            box[1] = fmin(box[1], at[1]);
            box[2] = fmax(box[2], at[0]);
            box[3] = fmax(box[3], at[1]);
            if (i < form->bodies) *speed = fmax(*speed, hypot(truth.v[2 * i], truth.v[2 * i + 1]));
        }
    }
    *extent = hypot(box[2] - box[0], box[3] - box[1]);
}

static char *columns_of(const ClosedForm *form)
{
    GString *columns = g_string_new(NULL);
    for (int i = 0; i < form->bodies; i++)
        g_string_append_printf(columns, "%sMass %d.x,Mass %d.y,Mass %d.vx,Mass %d.vy", i > 0 ? "," : "", i, i, i, i);
    return g_string_free(columns, FALSE);
}

static void assert_true(const PhysicsRun *run, const ClosedForm *form, double accuracy, const char *what)
{
    double extent, speed;
    find_scales(form, &extent, &speed);
    for (gsize sample = 0; sample < physics_samples(run); sample++) {
        Motion truth = {0};
        form->truth(physics_time(run, sample), &truth);
        for (int i = 0; i < form->bodies; i++) {
            double value[4];
            for (gsize k = 0; k < 4; k++)
                value[k] = physics_value(run, sample, 4 * (gsize)i + k);
            double apart = hypot(value[0] - truth.q[2 * i], value[1] - truth.q[2 * i + 1]);
            double faster = hypot(value[2] - truth.v[2 * i], value[3] - truth.v[2 * i + 1]);
            physics_assert_near(what, apart / extent, 0, accuracy);
            physics_assert_near(what, faster / speed, 0, accuracy);
        }
    }
}

static const TinkerTry *try_of(const PhysicsRun *run, guint number)
{
    return &g_array_index(run->summary->tries, TinkerTry, number);
}

/* The record is that of one run, whole, and the last try is that run. */
static void assert_whole(const PhysicsRun *run)
{
    g_assert_cmpuint(physics_samples(run), ==, SAMPLES + 1);
    for (gsize sample = 1; sample <= SAMPLES; sample++)
        g_assert_cmpfloat(physics_time(run, sample), >, physics_time(run, sample - 1));
    guint tries = run->summary->tries->len;
    g_assert_cmpuint(tries, >=, 1);
    g_assert_cmpuint(tries, <=, TINKER_MOST_TRIES);
    const TinkerTry *last = try_of(run, tries - 1);
    g_assert_cmpfloat(last->error_estimate, ==, run->summary->error_estimate);
    g_assert_cmpint(last->evaluations, ==, run->summary->evaluations);
    for (guint i = 0; i + 1 < tries; i++)
        g_assert_cmpfloat(try_of(run, i)->error_estimate, >, run->summary->accuracy);
}

static void hold(const ClosedForm *form, const char *method, double accuracy)
{
    g_autofree char *columns = columns_of(form), *blocks = closed_form_blocks(form);
    g_autofree char *what = g_strdup_printf("%s by %s at %g", form->name, method, accuracy);
    /* a step and a tolerance that are of no use here: they do not count */
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = method,
                                                              .duration = form->duration,
                                                              .interval = form->duration / SAMPLES,
                                                              .tolerance = 0.5,
                                                              .accuracy = accuracy,
                                                              .estimate = TRUE,
                                                              .columns = columns},
                                            "%s", blocks);
    assert_whole(run);
    g_assert_cmpfloat(run->summary->error_estimate, <=, accuracy);
    assert_true(run, form, accuracy, what);
}

static void test_holds(void)
{
    for (const ClosedForm *form = closed_forms; form->name != NULL; form++) {
        hold(form, "auto", 1e-4);
        hold(form, "auto", 1e-9);
        hold(form, "dopri5", 1e-6);
        hold(form, "rk4", 1e-5);
        hold(form, "verlet6", 1e-6);
        hold(form, "verlet", 1e-3);
    }
}

static PhysicsRun *run_pendulum(const char *method, double accuracy)
{
    return physics_try(&(PhysicsOptions){.method = method,
                                         .duration = 10,
                                         .interval = 0.5,
                                         .accuracy = accuracy,
                                         .estimate = TRUE,
                                         .columns = "Mass 0.x"},
                       "%s", wide_pendulum);
}

/* A fixed step is shortened by the order of its method: a further try aims at 0.4 of the accuracy. */
static void test_shortens_by_order(void)
{
    g_autoptr(PhysicsRun) run = run_pendulum("rk4", 1e-4);
    g_assert_no_error(run->error);
    g_assert_cmpuint(run->summary->tries->len, >=, 2); /* near its top it leaves faster than any plan sees */
    const TinkerTry *first = try_of(run, 0), *second = try_of(run, 1);
    double wanted = pow(0.4 * 1e-4 / first->error_estimate, 0.25);
    g_assert_cmpfloat(wanted, >, 1.0 / 30);
    physics_assert_near("step", second->step / first->step, wanted, 1e-9);
    g_assert_cmpint(second->evaluations, >, first->evaluations);
}

static void test_not_met(void)
{
    g_autoptr(PhysicsRun) run = run_pendulum("auto", 1e-15); /* doubles have no such digits */
    physics_assert_refused(run, TINKER_MODEL_ERROR_ACCURACY, "1e-15", "not met", NULL);
    assert_whole(run);
    g_assert_cmpfloat(run->summary->valid_until, >=, 10);
}

/* A companion that breaks down on its way leaves no estimate: the tries that are left are made, tighter. */
static void test_goes_on_without_estimate(void)
{
    const PhysicsOptions options = {.method = "rk4", .duration = 12, .accuracy = 0.01, .estimate = TRUE};
    g_autoptr(PhysicsRun) run =
        physics_try(&options, "%s",
                    "{'type': 'mass', 'position': [1, 0], 'velocity': [0, 0.4]},"
                    "{'type': 'law-force', 'ends': ['Mass 0'], 'potential': '-1/sqrt(x^2+y^2)'}");
    const GArray *tries = run->summary->tries;
    g_assert_cmpuint(tries->len, ==, 3);
    g_assert_true(isnan(g_array_index(tries, TinkerTry, 1).error_estimate));
    g_assert_cmpfloat(g_array_index(tries, TinkerTry, 2).step, <, 0.2 * g_array_index(tries, TinkerTry, 1).step);
    g_assert_true(isfinite(run->summary->error_estimate));
}

static void test_exact_needs_nothing(void)
{
    g_autofree char *blocks = closed_form_blocks(&closed_forms[0]);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 1e4, .accuracy = 1e-9, .estimate = TRUE}, "%s", blocks);
    g_assert_cmpuint(run->summary->tries->len, ==, 1);
    g_assert_cmpstr(try_of(run, 0)->method, ==, "exact");
}

/* Without an estimate there is nothing to hold: the run goes once, as the plan expects it to do. */
static void test_without_estimate(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "rk4", .duration = 10, .accuracy = 1e-9, .columns = "Mass 0.x"}, "%s",
                    wide_pendulum);
    g_assert_cmpuint(run->summary->tries->len, ==, 0);
}

static void test_refused(void)
{
    const double wrong[] = {-1, 1, NAN, INFINITY};
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(PhysicsRun) run = run_pendulum("rk4", wrong[i]);
        physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "accuracy", "between 0 and 1", NULL);
    }
}

static void add_tests(void)
{
    g_test_add_func("/accurate-run/holds", test_holds);
    g_test_add_func("/accurate-run/shortens-by-order", test_shortens_by_order);
    g_test_add_func("/accurate-run/not-met", test_not_met);
    g_test_add_func("/accurate-run/goes-on-without-estimate", test_goes_on_without_estimate);
    g_test_add_func("/accurate-run/exact-needs-nothing", test_exact_needs_nothing);
    g_test_add_func("/accurate-run/without-estimate", test_without_estimate);
    g_test_add_func("/accurate-run/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
