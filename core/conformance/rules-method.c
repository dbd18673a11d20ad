/* Rules of integrators, tried on an oscillator whose motion is known: x'' = -w^2 x - c v, with w = 2 and c = 0.3. Its closed form is exp(-c t / 2) (A cos(d t) + B sin(d t)), d^2 = w^2 - c^2 / 4. */
#include <math.h>
#include <string.h>

#include "conformance/kit-private.h"
#include "conformance/quiet-private.h"

#define SIZE       2
#define OMEGA      2.0
#define DAMPING    0.3
#define DURATION   2.0
#define MOST_STEPS 2000000

static const double start_q[SIZE] = {1.0, -0.4}, start_v[SIZE] = {0.3, 0.9}, masses[SIZE] = {1, 1};

static TinkerStatus acceleration(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < SIZE; i++)
        a[i] = -OMEGA * OMEGA * q[i] - DAMPING * v[i];
    if (power != NULL) power[0] = -DAMPING * (v[0] * v[0] + v[1] * v[1]);
    return TINKER_OK;
}
static TinkerStatus project(void *context, double t, double *q, double *v, int32_t *moved)
{
    *moved = 0;
    return TINKER_OK;
}
static TinkerStatus constrain_step(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v)
{
    return TINKER_OK;
}
static TinkerStatus project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous)
{
    return TINKER_OK;
}
static TinkerStatus damping_product(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out)
{
    for (int i = 0; i < SIZE; i++)
        out[i] = -DAMPING * dv[i];
    return TINKER_OK;
}
static void scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = 1;
    *speed = OMEGA;
}
static const char *failure(void *context)
{
    return NULL;
}
static TinkerStatus jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                             double *damping)
{
    for (int i = 0; i < SIZE; i++) {
        stiffness[i] = OMEGA * OMEGA;
        damping[i] = DAMPING;
    }
    return TINKER_OK;
}
static TinkerStatus signals(void *context, TinkerSignal *list)
{
    return TINKER_OK;
}

static const int32_t row_starts[] = {0, 1, 2}, pattern_columns[] = {0, 1};
static const TinkerPattern pattern = {SIZE, SIZE, row_starts, pattern_columns};
static const TinkerLinearEdge edges[SIZE] = {{0, -1, OMEGA *OMEGA, 0, DAMPING, 0},
                                             {1, -1, OMEGA *OMEGA, 0, DAMPING, 0}};
static const double anchors[] = {0};
static const TinkerLinearSystem linear = {.struct_size = sizeof(TinkerLinearSystem),
                                          .size = SIZE,
                                          .edge_count = SIZE,
                                          .anchor_count = 1,
                                          .mass = masses,
                                          .edges = edges,
                                          .anchors = anchors,
                                          .damper_book = 0,
                                          .drag_book = -1,
                                          .support_book = -1};
static const TinkerSystem oscillator = {.struct_size = sizeof(TinkerSystem),
                                        .flags = TINKER_SYSTEM_VELOCITY_DEPENDENT,
                                        .size = SIZE,
                                        .books = 1,
                                        .mass = masses,
                                        .acceleration = acceleration,
                                        .applied = acceleration,
                                        .project = project,
                                        .constrain_step = constrain_step,
                                        .project_velocity = project_velocity,
                                        .damping_product = damping_product,
                                        .scales = scales,
                                        .failure = failure,
                                        .pattern = &pattern,
                                        .jacobian = jacobian,
                                        .linear = &linear,
                                        .signals = signals};

/* The largest error of a state, relative to the scales. */
static double error_of(double t, const double *q, const double *v)
{
    const double d = sqrt(OMEGA * OMEGA - DAMPING * DAMPING / 4), fade = exp(-DAMPING * t / 2);
    double worst = 0;
    for (int i = 0; i < SIZE; i++) {
        const double b = (start_v[i] + DAMPING * start_q[i] / 2) / d;
        const double x = fade * (start_q[i] * cos(d * t) + b * sin(d * t));
        const double speed = fade * d * (b * cos(d * t) - start_q[i] * sin(d * t)) - DAMPING / 2 * x;
        worst = fmax(worst, fmax(fabs(q[i] - x), fabs(v[i] - speed) / OMEGA));
        if (!isfinite(q[i]) || !isfinite(v[i])) return INFINITY;
    }
    return worst;
}

/* One run of the oscillator. */
typedef struct {
    const TinkerIntegrator *method;
    void *stepper;
    TinkerState state;
    double q[SIZE], v[SIZE], books[1];
    TinkerStepReport report;
} Run;

static gboolean begin(KitCheck *check, Run *run, double tolerance, double step)
{
    const TinkerIntegratorOptions options = {
        .struct_size = sizeof options, .tolerance = tolerance, .spectral_radius = 0.8};
    *run = (Run){.method = check->integrator, .report = {.struct_size = sizeof(TinkerStepReport)}};
    memcpy(run->q, start_q, sizeof run->q);
    memcpy(run->v, start_v, sizeof run->v);
    run->state = (TinkerState){0, run->q, run->v, run->books};
    kit_phase(check, "create");
    run->stepper = run->method->create(&oscillator, &options);
    if (run->stepper == NULL) kit_fail(check, "create answers NULL on a damped oscillator");
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
static double error_with(KitCheck *check, int steps, double tolerance)
{
    Run run;
    double error = NAN;
    gboolean going = begin(check, &run, tolerance, DURATION / steps);
    if (is_adaptive(check)) {
        for (int i = 0; going && run.state.t < DURATION && i < MOST_STEPS; i++)
            going = advance(check, &run, DURATION);
    } else {
        for (int i = 1; going && i <= steps; i++)
            going = advance(check, &run, i == steps ? DURATION : DURATION * i / steps);
    }
    if (going) error = error_of(run.state.t, run.q, run.v);
    end(&run);
    return error;
}

static int least_steps(const TinkerIntegrator *method)
{
    const double limit = method->imaginary_limit > 0 ? fmin(method->imaginary_limit, 1.0) : 1.0;
    return (int)ceil(DURATION * OMEGA / (0.5 * limit));
}

static void try_tolerances(KitCheck *check)
{
    const double coarse = error_with(check, 1, 1e-5), fine = error_with(check, 1, 1e-9);
    if (kit_decided(check)) return;
    if (!(fine <= 1e-5) || !(fine <= 0.1 * coarse || fine <= 1e-10))
        kit_fail(check, "its error is %.3g with a tolerance of 1e-5 and %.3g with 1e-9; it was to follow the tolerance",
                 coarse, fine);
    kit_tell(check, "error %.2g with a tolerance of 1e-5, %.2g with 1e-9", coarse, fine);
}

/* The slope over the finest halving whose errors are above rounding. */
static void try_steps(KitCheck *check)
{
    int steps = least_steps(check->integrator);
    double before = error_with(check, steps, 1e-9), slope = NAN;
    for (int halving = 0; halving < 8 && !kit_decided(check); halving++) {
        steps *= 2;
        const double error = error_with(check, steps, 1e-9);
        if (!(error > 1e-11)) break;
        slope = log2(before / error);
        before = error;
    }
    if (kit_decided(check)) return;
    if (isnan(slope) && before < 1e-9)
        kit_skip(check, "it is exact on an oscillator, to %.2g", before);
    else if (!(slope >= check->integrator->order - 0.35))
        kit_fail(check, "halving its step shows the order %.2f, %d is declared", slope, check->integrator->order);
    else
        kit_tell(check, "measured %.2f, declared %d", slope, check->integrator->order);
}

void kit_try_method_order(KitCheck *check)
{
    if (is_adaptive(check))
        try_tolerances(check);
    else
        try_steps(check);
}

/* Steps land and dense output fits ------------------------------------------------------------------------------------ */

static void look_inside(KitCheck *check, const Run *run, double from, const double *q_from, const double *v_from)
{
    double q[SIZE], v[SIZE];
    const double places[] = {from, run->state.t, (from + run->state.t) / 2};
    const double h = OMEGA * (run->state.t - from), at_end = error_of(run->state.t, run->q, run->v);
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
        const double inside = error_of(places[2], q, v);
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
    gboolean going = begin(check, &run, 1e-7, DURATION / steps);
    for (int i = 1; going && run.state.t < DURATION && i < MOST_STEPS && !kit_decided(check); i++) {
        const double from = run.state.t, limit = is_adaptive(check) || i >= steps ? DURATION : DURATION * i / steps;
        double q[SIZE], v[SIZE];
        memcpy(q, run.q, sizeof q);
        memcpy(v, run.v, sizeof v);
        going = advance(check, &run, limit);
        if (!going) break;
        if (!(run.state.t > from && run.state.t <= limit) || (!is_adaptive(check) && run.state.t != limit))
            kit_fail(check, "a step from %.17g s with the limit %.17g s ends at %.17g s", from, limit, run.state.t);
        if (!isfinite(error_of(run.state.t, run.q, run.v)))
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
    gboolean going = begin(check, &one, 1e-7, DURATION / steps);
    going = begin(check, &other, 1e-7, DURATION / steps) && going;
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
    gboolean going = begin(check, &run, 1e-7, DURATION / steps);
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
    error_with(check, steps, 1e-7);
    const double elapsed = (double)(g_get_monotonic_time() - start);
    if (is_adaptive(check))
        kit_tell(check, "%.3g us for %g s of an oscillator", elapsed, DURATION);
    else
        kit_tell(check, "%.3g ns a step of %d coordinates", elapsed * 1e3 / steps, SIZE);
}

void kit_try_method_declaration(KitCheck *check)
{
    const TinkerIntegrator *method = check->integrator;
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
