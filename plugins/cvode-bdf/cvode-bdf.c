/* The backward differentiation formulas of variable order and step, by CVODES of SUNDIALS, on y = (q, v):
 *
 *     dq/dt = v,   dv/dt = a(t, q, v),   d(books)/dt = power(t, q, v)
 *
 * The books are pure quadratures over the steps that the state makes (books.c). With rods, a contains their forces, and
 * every solution of the formula is projected onto them before its error is judged (E. Eich, SIAM Journal on Numerical
 * Analysis 30 (1993) 1467-1482), so that history and state agree.
 */
#include "stepper-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <tinker/declare.h>

#define SHARE           0.1 /* of the tolerance that one step may spend: errors add up over a run */
#define LEAST_TOLERANCE 4e-15

static double *place(const Stepper *stepper)
{
    return N_VGetArrayPointer(stepper->y);
}

/* What CVODE is answered: 1 asks for a smaller step. */
static int answer(TinkerStatus status)
{
    return status == TINKER_OK ? 0 : status == TINKER_RETRY_SMALLER ? 1 : -1;
}

/* CVODE calls these ------------------------------------------------------------------------------------------------ */

static int derivative(realtype t, N_Vector y, N_Vector slope, void *data)
{
    const Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    int32_t n = system->size;
    const double *q = N_VGetArrayPointer(y);
    double *rate = N_VGetArrayPointer(slope), *a = rate + n;
    if (n == 0) {
        rate[0] = 0.0;
        return 0;
    }
    TinkerStatus status = system->acceleration(system->context, t, q, q + n, a, NULL);
    if (status != TINKER_OK) return answer(status);
    memcpy(rate, q + n, (size_t)n * sizeof *rate);
    for (int32_t i = 0; i < n; i++)
        if (!isfinite(a[i])) return 1;
    return 0;
}

/* correction = (projected y) - y; the error is projected onto the directions that the rods leave free. */
static int project(realtype t, N_Vector y, N_Vector correction, realtype tolerance, N_Vector error, void *data)
{
    const Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    sunindextype unknowns = stepper_unknowns(system);
    const double *from = N_VGetArrayPointer(y);
    double *q = stepper->work, *v = q + system->size, *change = N_VGetArrayPointer(correction);
    int32_t moved = 0;
    memcpy(q, from, (size_t)unknowns * sizeof *q);
    TinkerStatus status = system->project(system->context, t, q, v, &moved);
    if (status != TINKER_OK) return answer(status);
    for (sunindextype i = 0; i < unknowns; i++)
        change[i] = q[i] - from[i];
    if (error == NULL) return 0;
    double *error_q = N_VGetArrayPointer(error), *error_v = error_q + system->size;
    status = system->project_velocity(system->context, t, q, error_q, 1);
    if (status == TINKER_OK) status = system->project_velocity(system->context, t, q, error_v, 1);
    return answer(status);
}

/* Failures are told by the step's report, not on standard error. */
static void keep_quiet(int code, const char *module, const char *function, char *message, void *data) {}

/* Memory ----------------------------------------------------------------------------------------------------------- */

static void destroy(void *data)
{
    Stepper *stepper = data;
    if (stepper == NULL) return;
    if (stepper->cvode != NULL) CVodeFree(&stepper->cvode);
    stepper_newton_destroy(stepper);
    stepper_books_destroy(stepper);
    if (stepper->y != NULL) N_VDestroy(stepper->y);
    if (stepper->weights != NULL) N_VDestroy(stepper->weights);
    if (stepper->context != NULL) SUNContext_Free(&stepper->context);
    free(stepper->work);
    free(stepper->from_misses);
    free(stepper->to_misses);
    free(stepper);
}

/* 0 where memory is short. */
static int allot(Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    stepper->work = calloc((size_t)stepper_unknowns(system), sizeof *stepper->work);
    stepper->from_misses = calloc((size_t)stepper_unknowns(system), sizeof *stepper->from_misses);
    stepper->to_misses = calloc((size_t)stepper_unknowns(system), sizeof *stepper->to_misses);
    if (stepper->from_misses == NULL || stepper->to_misses == NULL) return 0;
    if (stepper->work == NULL || SUNContext_Create(NULL, &stepper->context) != 0) return 0;
    stepper->y = N_VNew_Serial(stepper_unknowns(system), stepper->context);
    stepper->cvode = CVodeCreate(CV_BDF, stepper->context);
    if (stepper->y == NULL || stepper->cvode == NULL) return 0;
    N_VConst(0.0, stepper->y);
    stepper->y->ops->nvwrmsnorm = stepper_norm; /* and of every copy that CVODE makes */
    stepper->weights = N_VClone(stepper->y);
    return stepper->weights != NULL && stepper_books_create(stepper);
}

static int set_up(Stepper *stepper)
{
    void *cvode = stepper->cvode;
    int constrained = (stepper->system->flags & TINKER_SYSTEM_CONSTRAINED) != 0;
    return CVodeSetErrHandlerFn(cvode, keep_quiet, NULL) == CV_SUCCESS &&
           CVodeInit(cvode, derivative, 0.0, stepper->y) == CV_SUCCESS &&
           CVodeSetUserData(cvode, stepper) == CV_SUCCESS && CVodeWFtolerances(cvode, stepper_weights) == CV_SUCCESS &&
           CVodeSetStabLimDet(cvode, SUNTRUE) == CV_SUCCESS && stepper_newton_create(stepper) &&
           (!constrained || CVodeSetProjFn(cvode, project) == CV_SUCCESS);
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    Stepper *stepper = calloc(1, sizeof *stepper);
    if (stepper == NULL) return NULL;
    stepper->system = system;
    stepper->tolerance = fmax(SHARE * options->tolerance, LEAST_TOLERANCE);
    stepper->first_step = options->first_step > 0.0 ? options->first_step : 0.0;
    stepper->fresh = 1;
    if (allot(stepper) && set_up(stepper)) return stepper;
    destroy(stepper);
    return NULL;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static void restart(void *data)
{
    Stepper *stepper = data;
    stepper->fresh = 1;
    stepper->done = 0;
}

static TinkerStatus fail(Stepper *stepper, TinkerStepReport *report, const char *failure)
{
    restart(stepper);
    report->failure = failure;
    return TINKER_FAILED;
}

/* The system is at fault, and may say why. */
static TinkerStatus fail_system(Stepper *stepper, TinkerStepReport *report)
{
    const TinkerSystem *system = stepper->system;
    const char *reason = system->failure != NULL ? system->failure(system->context) : NULL;
    return fail(stepper, report, reason != NULL ? reason : "the system could not be evaluated");
}

static TinkerStatus fail_cvode(Stepper *stepper, TinkerStepReport *report, int flag)
{
    switch (flag) {
    case CV_RHSFUNC_FAIL:
    case CV_FIRST_RHSFUNC_ERR:
    case CV_REPTD_RHSFUNC_ERR:
    case CV_UNREC_RHSFUNC_ERR:
    case CV_PROJFUNC_FAIL:
    case CV_REPTD_PROJFUNC_ERR:
        return fail_system(stepper, report);
    case CV_TOO_MUCH_ACC:
        return fail(stepper, report,
                    "the tolerance is smaller than the rounding of the positions; choose a larger one");
    case CV_ERR_FAILURE:
    case CV_TOO_CLOSE:
        return fail(stepper, report,
                    "the step size was driven to nothing: the motion breaks down here, or the tolerance is out of "
                    "reach");
    case CV_CONV_FAILURE:
    case CV_NLS_FAIL:
    case CV_NLS_SETUP_FAIL:
        return fail(stepper, report,
                    "Newton's iteration does not converge for any step: forces jump here, or another method is needed");
    case CV_LSETUP_FAIL:
    case CV_LSOLVE_FAIL:
        return fail(stepper, report,
                    "Newton's matrix cannot be factored: the derivatives of the forces are not finite");
    default:
        return fail(stepper, report, "CVODE could not go on");
    }
}

static void take_state(Stepper *stepper, const TinkerState *state)
{
    size_t n = (size_t)stepper->system->size;
    if (n > 0) {
        memcpy(place(stepper), state->q, n * sizeof(double));
        memcpy(place(stepper) + n, state->v, n * sizeof(double));
    }
}

/* CVODE forgets its history and begins, with order 1, at the host's state. */
static TinkerStatus begin(Stepper *stepper, const TinkerState *state, double limit)
{
    const TinkerSystem *system = stepper->system;
    TinkerStatus status = TINKER_OK;
    take_state(stepper, state);
    if (system->size > 0 || system->books > 0)
        status = system->acceleration(system->context, state->t, state->q, state->v, stepper->work,
                                      system->books > 0 ? stepper->power_to : NULL);
    if (status != TINKER_OK) return status;
    stepper_scales_start(stepper, state, limit, stepper->work);
    stepper_order_restart(stepper);
    if (CVodeReInit(stepper->cvode, state->t, stepper->y) != CV_SUCCESS) return TINKER_FAILED;
    CVodeSetInitStep(stepper->cvode, stepper->first_step);
    stepper->fresh = 0;
    return TINKER_OK;
}

/* Trials since CVODE's last start that were thrown away: by the error test, and for want of a solution. */
static long rejections(const Stepper *stepper)
{
    long errors = 0, solves = 0;
    CVodeGetNumErrTestFails(stepper->cvode, &errors);
    CVodeGetNumStepSolveFails(stepper->cvode, &solves);
    return errors + solves;
}

/* The error of the step, as CVODE has judged it. */
static double error_of_step(Stepper *stepper)
{
    N_Vector errors = stepper->y, weights = stepper->weights;
    if (CVodeGetEstLocalErrors(stepper->cvode, errors) != CV_SUCCESS ||
        CVodeGetErrWeights(stepper->cvode, weights) != CV_SUCCESS)
        return 0.0;
    return fmin(stepper_norm(errors, weights), 1.0);
}

/* Notes what the polynomial lacks at the end of a step. */
static TinkerStatus note_misses(Stepper *stepper, double t, const double *q, const double *v, double *misses)
{
    const int32_t n = stepper->system->size;
    if (CVodeGetDky(stepper->cvode, t, 0, stepper->weights) != CV_SUCCESS) return TINKER_FAILED;
    const double *found = N_VGetArrayPointer(stepper->weights);
    for (int32_t i = 0; i < n; i++) {
        misses[i] = q[i] - found[i];
        misses[n + i] = v[i] - found[n + i];
    }
    return TINKER_OK;
}

/* Brings the books to the new state, which is in y. */
static TinkerStatus keep_books(Stepper *stepper, TinkerState *state, double t)
{
    const TinkerSystem *system = stepper->system;
    const double *q = place(stepper);
    if (system->books == 0) return TINKER_OK;
    stepper_books_begin(stepper, state);
    TinkerStatus status =
        system->acceleration(system->context, t, q, q + system->size, stepper->work, stepper->power_to);
    if (status != TINKER_OK) return status;
    stepper_books_look(stepper, state, t, q + system->size, stepper->work);
    return stepper_books_integrate(stepper, state->t, t, stepper->power_to, state->books);
}

/* Hands the new state to the host, on the rods to the last digit: at a limit it was interpolated over a rounding of t.
 * *done is 0, and the state as it was, where the books ask for a shorter step. */
static TinkerStatus commit(Stepper *stepper, TinkerState *state, double t, int *done)
{
    const TinkerSystem *system = stepper->system;
    size_t n = (size_t)system->size;
    double *q = place(stepper);
    int32_t moved = 0;
    TinkerStatus status = TINKER_OK;
    if (system->flags & TINKER_SYSTEM_CONSTRAINED) status = system->project(system->context, t, q, q + n, &moved);
    if (status == TINKER_OK) status = keep_books(stepper, state, t);
    *done = status == TINKER_OK && stepper_books_accept(stepper, t - state->t);
    if (status == TINKER_OK && !*done) {
        memcpy(state->books, stepper->books_from, (size_t)system->books * sizeof(double));
        return TINKER_OK;
    }
    if (status == TINKER_OK) status = note_misses(stepper, state->t, state->q, state->v, stepper->from_misses);
    if (status == TINKER_OK) status = note_misses(stepper, t, q, q + n, stepper->to_misses);
    if (status != TINKER_OK) return status;
    stepper->to = t;
    if (n > 0) {
        memcpy(state->q, q, n * sizeof *q);
        memcpy(state->v, q + n, n * sizeof *q);
    }
    state->t = t;
    return TINKER_OK;
}

/* One internal step of CVODE, begun anew where it has to be; answers its flag. */
static int advance(Stepper *stepper, const TinkerState *state, double limit, double *t, TinkerStepReport *report)
{
    if (stepper->fresh && begin(stepper, state, limit) != TINKER_OK) return CV_RHSFUNC_FAIL;
    long before = rejections(stepper);
    int flag = CVodeSetStopTime(stepper->cvode, limit);
    if (flag == CV_SUCCESS) flag = CVode(stepper->cvode, limit, stepper->y, t, CV_ONE_STEP);
    report->rejected += (int32_t)(rejections(stepper) - before);
    return flag;
}

/* The step failed for what CVODE remembers, its errors or its matrix, rather than for the system. */
static int history_is_worthless(int flag)
{
    return flag == CV_ERR_FAILURE || flag == CV_CONV_FAILURE;
}

/* One trial, which CVODE accepts; answers its flag. */
static int make_trial(Stepper *stepper, const TinkerState *state, double limit, double *t, TinkerStepReport *report)
{
    const int had_history = !stepper->fresh;
    const int flag = advance(stepper, state, limit, t, report);
    if (!had_history || !history_is_worthless(flag)) return flag;
    stepper->fresh = 1;
    return advance(stepper, state, limit, t, report);
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    report->rejected = 0;
    report->t_from = state->t;
    report->failure = NULL;
    if (!(limit > state->t) || !isfinite(limit))
        return fail(stepper, report, "an adaptive step needs a finite limit after the present time");
    stepper->done = 0;
    stepper->from = state->t;
    while (!stepper->done) {
        double t = state->t;
        const int flag = make_trial(stepper, state, limit, &t, report);
        if (flag < 0) return fail_cvode(stepper, report, flag);
        if (!(t > state->t)) return fail(stepper, report, "the step became shorter than the rounding of t");
        if (commit(stepper, state, t, &stepper->done) != TINKER_OK) return fail_system(stepper, report);
        if (!stepper->done) report->rejected++;
        if (!stepper->done) stepper->fresh = 1;
    }
    report->step = state->t - report->t_from;
    report->error = error_of_step(stepper);
    stepper->fresh = stepper_order_watch(stepper);
    return TINKER_OK;
}

/* The books at a time within the last step. */
static TinkerStatus interpolate_books(Stepper *stepper, double t, double *books)
{
    const TinkerSystem *system = stepper->system;
    const double *q = place(stepper);
    double *power = stepper->power_within;
    TinkerStatus status = system->acceleration(system->context, t, q, q + system->size, stepper->work, power);
    return status == TINKER_OK ? stepper_books_integrate(stepper, stepper->from, t, power, books) : status;
}

/* CVODE's polynomial passes the states at the ends of a step by what Newton's iteration and projections leave. Added
 * between them by shares, this makes the motion one without jumps, in which contacts can be told. */
static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    size_t n = (size_t)system->size;
    if (!stepper->done || CVodeGetDky(stepper->cvode, t, 0, stepper->y) != CV_SUCCESS) return TINKER_FAILED;
    const double share = (t - stepper->from) / (stepper->to - stepper->from), *from = stepper->from_misses;
    for (size_t i = 0; i < n; i++) {
        q[i] = place(stepper)[i] + (1.0 - share) * from[i] + share * stepper->to_misses[i];
        v[i] = place(stepper)[n + i] + (1.0 - share) * from[n + i] + share * stepper->to_misses[n + i];
    }
    return books == NULL || system->books == 0 ? TINKER_OK : interpolate_books(stepper, t, books);
}

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_IMPLICIT | TINKER_INTEGRATOR_DISSIPATES,
    .id = "cvode-bdf",
    .title = "Backward differentiation formulas of CVODE",
    .summary = "Stiff scenes, and a check by somebody else's code: implicit, of variable order.",
    .source = "A. C. Hindmarsh et al., SUNDIALS, ACM Transactions on Mathematical Software 31 (2005) 363-396; D. J. "
              "Gardner et al., ibid. 48 (2022) 31",
    .order = 5,
    .dense_order = 5,
    .evaluations_per_step = 2,
    .imaginary_limit = -1.0,
    .real_limit = -1.0,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.tinker.cvode-bdf", "CVODE BDF", "0.1.0", "MIT", integrators)
