/* Adaptive explicit Runge-Kutta on y = (q, v).
 *
 * Because dq/dt = v holds exactly, the velocity stages are put into the positions once and for all: with A2 = A A,
 *
 *     q_s = q + c_s h v + h^2 sum_j A2_sj a_j,     v_s = v + h sum_j A_sj a_j
 *
 * which is the method term by term, needs only the accelerations to be kept, and reads each once for both sums.
 */
#include "numerics/integrate/explicit-rk-private.h"

#include <glib.h>
#include <glib/gi18n-lib.h>

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"
#include "numerics/solve/largest.h"

#define REJECTIONS_CAP 100
/* Of the length of whole steps: one so short is tried with fewer stages, ... */
#define BRIEF 0.01
/* ... and done with them where its error, beside the tolerance, is no more than this. */
#define BRIEF_ERROR 1e-3

/* --- one trial --- */

static TinkerStatus evaluate(RkStepper *stepper, int stage, double t, const double *q, const double *v)
{
    const TinkerSystem *system = stepper->system;
    const TinkerTableau *tableau = stepper->scheme->tableau;
    int weighted = stage >= tableau->stages || tableau->a[tableau->stages][stage] != 0.0;
    double *power = weighted && system->books > 0 ? stepper->power[stage] : NULL;
    return system->acceleration(system->context, t, q, v, stepper->a[stage], power);
}

/* Leaves the state of a stage of the step from (t0, q0, v0) in (q, v); of stage `stages`, the state at its end. */
static void place_stage(RkStepper *stepper, int stage, double h)
{
    RkOnto state = {stepper->q0, stepper->v0, stepper->scheme->tableau->c[stage] * h, stepper->q, stepper->v};
    rk_combine(stepper, &stepper->scheme->rows[stage], h, &state);
}

static TinkerStatus place_and_evaluate(RkStepper *stepper, int stage, double h)
{
    place_stage(stepper, stage, h);
    double t = fmin(stepper->t0 + stepper->scheme->tableau->c[stage] * h, stepper->t1);
    if (stepper->scheme->tableau->c[stage] == 1.0) t = stepper->t1;
    return evaluate(stepper, stage, t, stepper->q, stepper->v);
}

/* Stages 1 to the end; *error is not finite where the system asked for a smaller step. */
static TinkerStatus try_step(RkStepper *stepper, double h, double *error)
{
    const TinkerTableau *tableau = stepper->scheme->tableau;
    int last = tinker_tableau_ends_on_evaluation(tableau) ? tableau->stages : tableau->stages - 1;
    for (int stage = 1; stage <= last; stage++) {
        TinkerStatus status = place_and_evaluate(stepper, stage, h);
        if (status != TINKER_OK) return status;
    }
    if (last < tableau->stages) place_stage(stepper, tableau->stages, h);
    *error = rk_find_error(stepper, h);
    return TINKER_OK;
}

/* --- a step --- */

/* Keeps the start and finds its acceleration. */
static TinkerStatus begin(RkStepper *stepper, const TinkerState *state)
{
    const TinkerSystem *system = stepper->system;
    int end = stepper->scheme->tableau->stages;
    TinkerStatus status = TINKER_OK;
    if (stepper->done && stepper->end_is_next) {
        double *a = stepper->a[0], *power = stepper->power[0];
        stepper->a[0] = stepper->a[end];
        stepper->power[0] = stepper->power[end];
        stepper->a[end] = a;
        stepper->power[end] = power;
    } else {
        status = evaluate(stepper, 0, state->t, state->q, state->v);
    }
    stepper->done = stepper->end_known = stepper->extra_known = 0;
    tinker_copy(system->size, state->q, stepper->q0);
    tinker_copy(system->size, state->v, stepper->v0);
    tinker_copy(system->books, state->books, stepper->books0);
    stepper->t0 = state->t;
    return status;
}

/* Finds the first step where it is not known. Of what is at rest with no force on it nothing tells how long it will be
 * but how long all may last. */
static TinkerStatus find_first_step(RkStepper *stepper, const TinkerState *state, double limit)
{
    TinkerStepControl *control = &stepper->control;
    if (control->h > 0.0) return TINKER_OK;
    control->h = stepper->first_step;
    if (control->h > 0.0) return TINKER_OK;
    const int32_t n = stepper->system->size;
    if (control->usual_before == 0.0 && tinker_largest(n, state->v) == 0.0 && tinker_largest(n, stepper->a[0]) == 0.0)
        control->usual_before = TINKER_USUAL_AT_REST * (limit - state->t);
    return tinker_starting_step(stepper->system, stepper->scheme->tableau->order, control->tolerance, state, limit,
                                stepper->a[0], stepper->q, stepper->v, stepper->error_q, &control->h);
}

/* Makes the trial's end the state, projected. */
static TinkerStatus commit(RkStepper *stepper, TinkerState *state, double h)
{
    const TinkerSystem *system = stepper->system;
    int32_t moved = 0;
    TinkerStatus status = TINKER_OK;
    tinker_copy(system->size, stepper->q, state->q);
    tinker_copy(system->size, stepper->v, state->v);
    if (tinker_is_constrained(system))
        status = system->project(system->context, stepper->t1, state->q, state->v, &moved);
    if (status != TINKER_OK) {
        tinker_copy(system->size, stepper->q0, state->q);
        tinker_copy(system->size, stepper->v0, state->v);
        return status;
    }
    rk_sum_powers(stepper, stepper->scheme->tableau->stages,
                  stepper->scheme->tableau->a[stepper->scheme->tableau->stages], h, stepper->books0, state->books);
    state->t = stepper->t1;
    stepper->done = 1;
    stepper->end_known = tinker_tableau_ends_on_evaluation(stepper->scheme->tableau);
    stepper->end_is_next = stepper->end_known && !moved; /* not where dense output finds it: looking saves nothing */
    return TINKER_OK;
}

static TinkerStatus fail(RkStepper *stepper, TinkerStepReport *report, const char *failure)
{
    stepper->done = 0;
    report->failure = failure;
    return TINKER_FAILED;
}

/* The system is at fault, and may say why. */
static TinkerStatus fail_system(RkStepper *stepper, TinkerStepReport *report)
{
    return fail(stepper, report, tinker_failure_of(stepper->system, "the system could not be evaluated"));
}

static void make_rows(RkScheme *scheme)
{
    const TinkerTableau *tableau = scheme->tableau;
    for (int stage = 0; stage <= tableau->stages + tableau->extra_stages; stage++)
        scheme->rows[stage] = rk_make_row(tableau, tableau->a[stage]);
    scheme->error = rk_make_row(tableau, tableau->error);
    if (tableau->second_error) scheme->second_error = rk_make_row(tableau, tableau->second_error);
    if (tableau->dense_error) scheme->dense_error = rk_make_row(tableau, tableau->dense_error);
}

static void *allot(RkStepper *stepper)
{
    const TinkerTableau *tableau = stepper->scheme->tableau;
    size_t n = (size_t)stepper->system->size, m = (size_t)stepper->system->books;
    double *next = stepper->memory;
    stepper->q0 = tinker_take(&next, n);
    stepper->v0 = tinker_take(&next, n);
    stepper->q = tinker_take(&next, n);
    stepper->v = tinker_take(&next, n);
    stepper->error_q = tinker_take(&next, n);
    stepper->error_v = tinker_take(&next, n);
    stepper->books0 = tinker_take(&next, m);
    for (int stage = 0; stage <= tableau->stages + tableau->extra_stages; stage++) {
        stepper->a[stage] = tinker_take(&next, n);
        stepper->power[stage] = tinker_take(&next, m);
    }
    g_assert(stepper->brief.tableau == NULL || stepper->brief.tableau->stages <= tableau->stages);
    make_rows(&stepper->whole);
    if (stepper->brief.tableau != NULL) make_rows(&stepper->brief);
    return stepper;
}

void *tinker_explicit_rk_create(const TinkerTableau *tableau, const TinkerSystem *system,
                                const TinkerIntegratorOptions *options)
{
    size_t stages = (size_t)(tableau->stages + 1 + tableau->extra_stages);
    size_t doubles = (6 + stages) * (size_t)system->size + (1 + stages) * (size_t)system->books;
    RkStepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    stepper->system = system;
    stepper->whole.tableau = tableau;
    stepper->brief.tableau = tableau->brief;
    stepper->scheme = &stepper->whole;
    stepper->first_step = options->first_step > 0.0 ? options->first_step : 0.0;
    tinker_step_control_init(&stepper->control, &tableau->law, options->tolerance);
    return allot(stepper);
}

void tinker_explicit_rk_destroy(void *stepper)
{
    g_free(stepper);
}

void tinker_explicit_rk_restart(void *data)
{
    RkStepper *stepper = data;
    stepper->done = 0;
    tinker_step_control_forget(&stepper->control);
}

/* How long a step may be that is tried briefly, from the error of such a trial. A short one does not lower it. */
static void learn_brief(RkStepper *stepper, double h, double error)
{
    const TinkerStepLaw *law = &stepper->brief.tableau->law;
    double factor = law->greatest_factor;
    if (isnan(error)) factor = law->least_factor;
    if (error > 0.0) factor = fmin(factor, pow(error / BRIEF_ERROR, -law->exponent));
    if (!(factor > law->least_factor)) factor = law->least_factor;
    stepper->brief_h = factor < 1.0 ? factor * h : fmax(stepper->brief_h, factor * h);
}

/* A step far shorter than the method's own, in one trial, where the error of fewer stages is nothing beside the
 * tolerance. Else the step is not done. How long steps are is known from the last whole one, whatever has happened to
 * the motion since then: the error is judged as that of a part of one. */
static TinkerStatus try_briefly(RkStepper *stepper, TinkerState *state, double limit, TinkerStepReport *report)
{
    const double h = limit - state->t, usual = stepper->control.usual;
    if (stepper->brief.tableau == NULL || !(h <= stepper->brief_h)) return TINKER_OK;
    double error = INFINITY;
    stepper->scheme = &stepper->brief;
    stepper->t1 = limit;
    stepper->control.usual = fmax(usual, stepper->reach);
    TinkerStatus status = try_step(stepper, h, &error);
    stepper->control.usual = usual;
    learn_brief(stepper, h, error);
    if (status == TINKER_OK && error <= BRIEF_ERROR) status = commit(stepper, state, h);
    if (!stepper->done) stepper->scheme = &stepper->whole;
    report->step = h;
    report->error = error;
    return status;
}

TinkerStatus tinker_explicit_rk_step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    RkStepper *stepper = data;
    report->rejected = 0;
    report->t_from = state->t;
    report->failure = NULL;
    if (!(limit > state->t) || !isfinite(limit))
        return fail(stepper, report, N_("an adaptive step needs a finite limit after the present time"));
    if (begin(stepper, state) != TINKER_OK) return fail_system(stepper, report);
    stepper->scheme = &stepper->whole;
    TinkerStatus status = try_briefly(stepper, state, limit, report);
    if (stepper->done) return TINKER_OK;
    if (status != TINKER_FAILED) status = find_first_step(stepper, state, limit);
    if (status != TINKER_OK) return fail_system(stepper, report);
    for (; report->rejected <= REJECTIONS_CAP; report->rejected++) {
        int lands = 0;
        double error = INFINITY, h = tinker_step_control_trial(&stepper->control, state->t, limit, &lands);
        stepper->t1 = lands ? limit : state->t + h;
        h = stepper->t1 - state->t;
        status = try_step(stepper, h, &error);
        if (status == TINKER_OK && error <= 1.0) status = commit(stepper, state, h);
        if (status == TINKER_FAILED) return fail_system(stepper, report);
        if (stepper->done) {
            tinker_step_control_accept(&stepper->control, h, error, report->rejected > 0);
            stepper->reach = stepper->control.h;
            stepper->brief_h = fmax(stepper->brief_h, BRIEF * stepper->reach);
            report->step = h;
            report->error = error;
            return TINKER_OK;
        }
        double reject_as = status == TINKER_RETRY_SMALLER ? INFINITY : error;
        if (!tinker_step_control_reject(&stepper->control, state->t, h, reject_as)) break;
    }
    if (status != TINKER_OK) return fail_system(stepper, report);
    return fail(stepper, report,
                "the step size was driven to nothing: the motion breaks down here, or the tolerance is out of reach");
}

/* --- dense output --- */

static TinkerStatus find_dense_stages(RkStepper *stepper, double h)
{
    const TinkerTableau *tableau = stepper->scheme->tableau;
    int end = tableau->stages;
    if (!stepper->end_known) {
        TinkerStatus status = place_and_evaluate(stepper, end, h);
        if (status != TINKER_OK) return status;
        stepper->end_known = 1;
    }
    for (int stage = end + 1; !stepper->extra_known && stage <= end + tableau->extra_stages; stage++) {
        TinkerStatus status = place_and_evaluate(stepper, stage, h);
        if (status != TINKER_OK) return status;
    }
    stepper->extra_known = 1;
    return TINKER_OK;
}

TinkerStatus tinker_explicit_rk_interpolate(void *data, double t, double *q, double *v, double *books)
{
    RkStepper *stepper = data;
    const TinkerTableau *tableau = stepper->scheme->tableau;
    if (!stepper->done) return TINKER_FAILED;
    double h = stepper->t1 - stepper->t0, s = (t - stepper->t0) / h;
    TinkerStatus status = find_dense_stages(stepper, h);
    if (status != TINKER_OK) return status;

    double weights[TINKER_RK_STAGES_CAP];
    tinker_tableau_dense_weights(tableau, s, weights);
    RkRow row = rk_make_row(tableau, weights);
    rk_combine(stepper, &row, h, &(RkOnto){stepper->q0, stepper->v0, s * h, q, v});
    if (books) rk_sum_powers(stepper, tableau->stages + 1 + tableau->extra_stages, weights, h, stepper->books0, books);
    return TINKER_OK;
}
