/* Rules of integrators, tried on motions in closed form. */
#include <math.h>
#include <string.h>

#include "conformance/probe/kit.h"
#include "conformance/probe/method-systems.h"
#include "conformance/probe/quiet.h"

#define SIZE       KIT_SYSTEM_SIZE
#define OMEGA      KIT_SYSTEM_OMEGA
#define DURATION   2.0
#define MOST_STEPS 2000000
#define ROUNDING   1e-11 /* errors below this do not tell an order */

/* One run. */
typedef struct {
    const KitMotion *motion;
    const TinkerIntegrator *method;
    void *stepper;
    TinkerState state;
    double q[SIZE], v[SIZE], books[1];
    TinkerStepReport report;
} Run;

static gboolean begin(KitCheck *check, Run *run, const KitMotion *motion, double tolerance)
{
    const TinkerIntegratorOptions options = {
        .struct_size = sizeof options, .tolerance = tolerance, .spectral_radius = 0.8};
    *run = (Run){.motion = motion, .method = check->integrator, .report = {.struct_size = sizeof(TinkerStepReport)}};
    motion->exact(0, run->q, run->v);
    run->state = (TinkerState){0, run->q, run->v, run->books};
    kit_phase(check, "create");
    run->stepper = run->method->create(motion->system, &options);
    if (run->stepper == NULL) kit_fail(check, "create answers NULL on %s", motion->name);
    if (run->stepper != NULL) run->method->restart(run->stepper);
    return run->stepper != NULL;
}

static gboolean advance(KitCheck *check, Run *run, double limit)
{
    kit_phase(check, "a step at t = %g s", run->state.t);
    const TinkerStatus status = run->method->step(run->stepper, &run->state, limit, &run->report);
    if (status != TINKER_OK)
        kit_fail(check, "a step from %g s to %g s answers %d: %s", run->state.t, limit, status,
                 run->report.failure != NULL ? run->report.failure : "it gives no reason");
    return status == TINKER_OK;
}

static void end(Run *run)
{
    if (run->stepper != NULL) run->method->destroy(run->stepper);
}

static gboolean is_adaptive(const KitCheck *check)
{
    return (check->integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
}

/* The error at the end: of `steps` equal steps, or with a tolerance. NAN where the check is decided. */
static double error_with(KitCheck *check, const KitMotion *motion, int steps, double tolerance)
{
    Run run;
    double error = NAN;
    gboolean going = begin(check, &run, motion, tolerance);
    if (is_adaptive(check)) {
        for (int i = 0; going && run.state.t < DURATION && i < MOST_STEPS; i++)
            going = advance(check, &run, DURATION);
    } else {
        for (int i = 1; going && i <= steps; i++)
            going = advance(check, &run, i == steps ? DURATION : DURATION * i / steps);
    }
    if (going) error = kit_motion_error(motion, run.state.t, run.q, run.v);
    end(&run);
    return error;
}

static int least_steps(const TinkerIntegrator *method)
{
    const double limit = method->imaginary_limit > 0 ? fmin(method->imaginary_limit, 1.0) : 1.0;
    return (int)ceil(DURATION * OMEGA / (0.5 * limit));
}

static void try_tolerances(KitCheck *check, const KitMotion *motion)
{
    const double coarse = error_with(check, motion, 1, 1e-5), fine = error_with(check, motion, 1, 1e-9);
    if (kit_decided(check)) return;
    if (!(fine <= 1e-5) || !(fine <= 0.1 * coarse || fine <= 1e-10))
        kit_fail(check,
                 "on %s its error is %.3g with a tolerance of 1e-5 and %.3g with 1e-9; it was to follow the tolerance",
                 motion->name, coarse, fine);
    else if (motion == &kit_driven)
        kit_tell(check, "error %.2g with a tolerance of 1e-5, %.2g with 1e-9", coarse, fine);
}

/* The slope over the finest halving whose errors are above rounding; INFINITY where one halving takes the error down to
 * it. */
static double order_on(KitCheck *check, const KitMotion *motion, double *before)
{
    int steps = least_steps(check->integrator);
    double slope = INFINITY;
    *before = error_with(check, motion, steps, 1e-9);
    for (int halving = 0; halving < 8 && !kit_decided(check); halving++) {
        steps *= 2;
        const double error = error_with(check, motion, steps, 1e-9);
        if (!(error > ROUNDING)) break;
        slope = log2(*before / error);
        *before = error;
    }
    return slope;
}

static void try_steps(KitCheck *check, const KitMotion *motion)
{
    double error;
    const double slope = order_on(check, motion, &error);
    if (kit_decided(check)) return;
    if (!(slope >= check->integrator->order - 0.35))
        kit_fail(check, "on %s halving its step shows the order %.2f, %d is declared", motion->name, slope,
                 check->integrator->order);
    else if (motion == &kit_driven && isinf(slope))
        kit_tell(check, "half of its largest step takes the error from %.2g to rounding", error);
    else if (motion == &kit_driven)
        kit_tell(check, "measured %.2f, declared %d", slope, check->integrator->order);
}

void kit_try_method_order(KitCheck *check)
{
    void (*const try_on)(KitCheck *, const KitMotion *) = is_adaptive(check) ? try_tolerances : try_steps;
    try_on(check, &kit_oscillator);
    if (check->integrator->flags & TINKER_INTEGRATOR_LINEAR)
        kit_tell(check, "tried on an oscillator alone, since it needs a linear system");
    else if (!kit_decided(check))
        try_on(check, &kit_driven);
}

/* Steps land and dense output fits --------------------------------------------------------------------------------- */

static void look_inside(KitCheck *check, const Run *run, double from, const double *q_from, const double *v_from)
{
    double q[SIZE], v[SIZE];
    const double places[] = {from, run->state.t, (from + run->state.t) / 2};
    const double h = OMEGA * (run->state.t - from),
                 at_end = kit_motion_error(run->motion, run->state.t, run->q, run->v);
    for (int k = 0; k < 3 && !kit_decided(check); k++) {
        kit_phase(check, "interpolate");
        if (run->method->interpolate(run->stepper, places[k], q, v, NULL) != TINKER_OK) {
            kit_fail(check, "interpolate at %g s fails, inside the last step from %g s to %g s", places[k], from,
                     run->state.t);
            return;
        }
        double miss = 0;
        for (int i = 0; i < SIZE; i++)
            miss = fmax(miss, fmax(fabs(q[i] - (k == 0 ? q_from[i] : run->q[i])),
                                   fabs(v[i] - (k == 0 ? v_from[i] : run->v[i])) / OMEGA));
        if (k < 2 && !(miss <= 1e-7 + 0.1 * fabs(at_end)))
            kit_fail(check, "interpolated at the %s of a step it is off by %.3g", k == 0 ? "beginning" : "end", miss);
        const double inside = kit_motion_error(run->motion, places[2], q, v);
        const double allowed = 20 * at_end + pow(h, check->integrator->dense_order + 1) + 1e-7;
        if (k == 2 && !(inside <= allowed))
            kit_fail(check,
                     "interpolated in the middle of a step it is off by %.3g, at most %.3g was expected of the dense "
                     "order %d",
                     inside, allowed, check->integrator->dense_order);
    }
}

void kit_try_method_steps(KitCheck *check)
{
    Run run;
    const int steps = 2 * least_steps(check->integrator);
    gboolean going = begin(check, &run, &kit_oscillator, 1e-7);
    for (int i = 1; going && run.state.t < DURATION && i < MOST_STEPS && !kit_decided(check); i++) {
        const double from = run.state.t, limit = is_adaptive(check) || i >= steps ? DURATION : DURATION * i / steps;
        double q[SIZE], v[SIZE];
        memcpy(q, run.q, sizeof q);
        memcpy(v, run.v, sizeof v);
        going = advance(check, &run, limit);
        if (!going) break;
        if (!(run.state.t > from && run.state.t <= limit) || (!is_adaptive(check) && run.state.t != limit))
            kit_fail(check, "a step from %.17g s with the limit %.17g s ends at %.17g s", from, limit, run.state.t);
        const double made = run.state.t - from;
        if (!(fabs(run.report.step - made) <= 1e-9 * made))
            kit_fail(check, "a step from %.17g s to %.17g s reports a step of %.17g s", from, run.state.t,
                     run.report.step);
        if (!isfinite(kit_motion_error(run.motion, run.state.t, run.q, run.v)))
            kit_fail(check, "the state is not finite after the step to %g s", run.state.t);
        if (!kit_decided(check)) look_inside(check, &run, from, q, v);
    }
    end(&run);
}

/* Two runs, step by step, are the same bits. */
void kit_try_method_same_bits(KitCheck *check)
{
    Run one, other;
    const int steps = 2 * least_steps(check->integrator);
    gboolean going = begin(check, &one, &kit_oscillator, 1e-7);
    going = begin(check, &other, &kit_oscillator, 1e-7) && going;
    for (int i = 1; going && one.state.t < DURATION && i < MOST_STEPS; i++) {
        const double limit = is_adaptive(check) || i >= steps ? DURATION : DURATION * i / steps;
        going = advance(check, &one, limit) && advance(check, &other, limit);
        if (memcmp(one.q, other.q, sizeof one.q) == 0 && memcmp(one.v, other.v, sizeof one.v) == 0 &&
            one.state.t == other.state.t)
            continue;
        kit_fail(check, "two steppers side by side differ after the step to %g s", one.state.t);
        break;
    }
    end(&one);
    end(&other);
}

void kit_try_method_quiet(KitCheck *check)
{
    Run run;
    const char *first = NULL; // solvers of others set themselves up when they are first used
    const int steps = 2 * least_steps(check->integrator);
    if (!kit_watch_calls(check->objects)) kit_skip(check, "its calls cannot be watched here");
    gboolean going = begin(check, &run, &kit_oscillator, 1e-7);
    for (int i = 1; going && run.state.t < DURATION && i < MOST_STEPS && !kit_decided(check); i++) {
        kit_listen();
        going = advance(check, &run, is_adaptive(check) || i >= steps ? DURATION : DURATION * i / steps);
        const char *name = kit_heard();
        if (name != NULL && i > 1) kit_fail(check, "step number %d calls %s; create is the place for it", i, name);
        if (name != NULL) first = name;
    }
    end(&run);
    if (first != NULL) kit_tell(check, "the first step calls %s; later ones do not", first);
}

void kit_try_method_speed(KitCheck *check)
{
    const int steps = 20000;
    const gint64 start = g_get_monotonic_time();
    error_with(check, &kit_oscillator, steps, 1e-7);
    const double elapsed = (double)(g_get_monotonic_time() - start);
    if (is_adaptive(check))
        kit_tell(check, "%.3g us for %g s of an oscillator", elapsed, DURATION);
    else
        kit_tell(check, "%.3g ns a step of %d coordinates", elapsed * 1e3 / steps, SIZE);
}

void kit_try_method_declaration(KitCheck *check)
{
    const TinkerIntegrator *method = check->integrator;
    kit_look_at_id(check, "its", method->id, '-');
    if (method->summary == NULL || method->summary[0] == '\0') kit_fail(check, "it has no summary");
    if (method->source == NULL || method->source[0] == '\0')
        kit_fail(check, "it does not say where the method comes from");
    if (method->order < 1) kit_fail(check, "its order is %d, at least 1 was expected", method->order);
    if (method->dense_order < 0) kit_fail(check, "its dense order is %d, at least 0 was expected", method->dense_order);
    if (method->evaluations_per_step < 0)
        kit_fail(check, "it needs %d evaluations a step, at least 0 was expected", method->evaluations_per_step);
    if (isnan(method->imaginary_limit) || isnan(method->real_limit))
        kit_fail(check, "a limit of stability is no number");
    if (method->flags & TINKER_INTEGRATOR_EXPLICIT && method->flags & TINKER_INTEGRATOR_IMPLICIT)
        kit_fail(check, "it says that it is explicit and that it is implicit");
}
