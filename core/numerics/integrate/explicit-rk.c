/* Adaptive explicit Runge-Kutta on y = (q, v).
 *
 * Because dq/dt = v holds exactly, the velocity stages are put into the positions once and for all: with A2 = A A,
 *
 *     q_s = q + c_s h v + h^2 sum_j A2_sj a_j,     v_s = v + h sum_j A_sj a_j
 *
 * which is the method term by term, needs only the accelerations to be kept, and reads each once for both sums.
 */
#include "numerics/integrate/explicit-rk.h"
#include "numerics/solve/largest.h"

#include <glib.h>
#include <glib/gi18n-lib.h>

#include "numerics/integrate/books-error.h"
#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"

#define REJECTIONS_CAP 100
#define LANES          4
#define FOURS          2 /* that are summed at once, in registers */

/* Numbers side by side. GCC 12 does not vectorise the sums by itself, as their inner loop is short; the operations and
 * their order are those of the plain loop. */
typedef double Pair __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(LANES * sizeof(double))));

/* A weighted sum of accelerations, one for q and one for v, without the terms that are 0. */
typedef struct Row {
    int count;
    int stage[TINKER_RK_STAGES_CAP];
    Pair weight[TINKER_RK_STAGES_CAP]; /* for q, times h^2; for v, times h */
} Row;

typedef struct Stepper {
    const TinkerSystem *system;
    const TinkerTableau *tableau;
    TinkerStepControl control;
    double first_step;
    Row rows[TINKER_RK_STAGES_CAP];
    Row error, second_error;
    double *q0, *v0, *books0; /* the start of the last step */
    double *q, *v;            /* a stage, the trial's end */
    double *error_q, *error_v;
    double *a[TINKER_RK_STAGES_CAP];
    double *power[TINKER_RK_STAGES_CAP];
    double t0, t1;
    int done;        /* there is a last step */
    int end_known;   /* a[stages] holds the acceleration at its end ... */
    int end_is_next; /* ... which the step found, and where the state is: the next step begins with it */
    int extra_known; /* so do those behind it */
    double memory[];
} Stepper;

/* --- weighted sums of accelerations --- */

static Row make_row(const TinkerTableau *tableau, const double *weights)
{
    Row row = {0};
    int stages = tableau->stages + 1 + tableau->extra_stages;
    for (int j = 0; j < stages; j++) {
        double q = 0.0;
        for (int k = j + 1; k < stages; k++) /* no stage is made of itself or later ones */
            q += weights[k] * tableau->a[k][j];
        if (fabs(q) < 1e-14) q = 0.0; /* a simplifying assumption of the method, up to rounding */
        if (q == 0.0 && weights[j] == 0.0) continue;
        row.stage[row.count] = j;
        row.weight[row.count++] = (Pair){q, weights[j]};
    }
    return row;
}

/* Where sums go: alone, or onto a state that drifts for a time. */
typedef struct Onto {
    const double *q, *v; /* NULL: alone */
    double drift;
    double *q_out, *v_out;
} Onto;

/* From `first` on `fours` times four entries: with h^2 sum_j wq_j a_j and h sum_j wv_j a_j,
 * q_out = q + (drift v + sum), v_out = v + sum. */
static inline __attribute__((always_inline)) void combine_fours(const Stepper *stepper, const Row *row, double h,
                                                                const Onto *onto, int32_t first, const int fours)
{
    Four q_sum[FOURS] = {{0.0}}, v_sum[FOURS] = {{0.0}};
    for (int j = 0; j < row->count; j++) {
        const double *each = stepper->a[row->stage[j]] + first, of_q = row->weight[j][0], of_v = row->weight[j][1];
        for (int k = 0; k < fours; k++) {
            Four term;
            memcpy(&term, each + LANES * k, sizeof term);
            q_sum[k] += of_q * term;
            v_sum[k] += of_v * term;
        }
    }
    for (int k = 0; k < fours; k++, first += LANES) {
        Four q = (h * h) * q_sum[k], v = h * v_sum[k];
        if (onto->q != NULL) {
            Four from_q, from_v;
            memcpy(&from_q, onto->q + first, sizeof from_q);
            memcpy(&from_v, onto->v + first, sizeof from_v);
            q = from_q + (onto->drift * from_v + q);
            v = from_v + v;
        }
        memcpy(onto->q_out + first, &q, sizeof q);
        memcpy(onto->v_out + first, &v, sizeof v);
    }
}

/* The same of one entry, with both sums side by side. */
static inline __attribute__((always_inline)) void combine_one(const Stepper *stepper, const Row *row, double h,
                                                              const Onto *onto, int32_t i)
{
    Pair sum = {0.0, 0.0};
    for (int j = 0; j < row->count; j++) {
        double term = stepper->a[row->stage[j]][i];
        sum += row->weight[j] * (Pair){term, term};
    }
    sum *= (Pair){h * h, h};
    if (onto->q != NULL) sum = (Pair){onto->q[i] + (onto->drift * onto->v[i] + sum[0]), onto->v[i] + sum[1]};
    onto->q_out[i] = sum[0];
    onto->v_out[i] = sum[1];
}

TINKER_VARIANTS static void combine(const Stepper *stepper, const Row *row, double h, const Onto *onto)
{
    int32_t n = stepper->system->size, i = 0;
    for (; i + FOURS * LANES <= n; i += FOURS * LANES)
        combine_fours(stepper, row, h, onto, i, FOURS);
    for (; i + LANES <= n; i += LANES)
        combine_fours(stepper, row, h, onto, i, 1);
    for (; i < n; i++)
        combine_one(stepper, row, h, onto, i);
}

static void sum_powers(const Stepper *stepper, int stages, const double *weights, double h, const double *from,
                       double *books)
{
    for (int32_t i = 0; i < stepper->system->books; i++) {
        double sum = 0.0;
        for (int j = 0; j < stages; j++)
            if (weights[j] != 0.0) sum += weights[j] * stepper->power[j][i];
        books[i] = from[i] + h * sum;
    }
}

/* --- one trial --- */

static TinkerStatus evaluate(Stepper *stepper, int stage, double t, const double *q, const double *v)
{
    const TinkerSystem *system = stepper->system;
    const TinkerTableau *tableau = stepper->tableau;
    int weighted = stage >= tableau->stages || tableau->a[tableau->stages][stage] != 0.0;
    double *power = weighted && system->books > 0 ? stepper->power[stage] : NULL;
    return system->acceleration(system->context, t, q, v, stepper->a[stage], power);
}

/* Leaves the state of a stage of the step from (t0, q0, v0) in (q, v); of stage `stages`, the state at its end. */
static void place_stage(Stepper *stepper, int stage, double h)
{
    Onto state = {stepper->q0, stepper->v0, stepper->tableau->c[stage] * h, stepper->q, stepper->v};
    combine(stepper, &stepper->rows[stage], h, &state);
}

static TinkerStatus place_and_evaluate(Stepper *stepper, int stage, double h)
{
    place_stage(stepper, stage, h);
    double t = fmin(stepper->t0 + stepper->tableau->c[stage] * h, stepper->t1);
    if (stepper->tableau->c[stage] == 1.0) t = stepper->t1;
    return evaluate(stepper, stage, t, stepper->q, stepper->v);
}

/* `tangent`: without what projection takes off the trial's end. */
static double measure(Stepper *stepper, const Row *row, double h, TinkerErrorScale scale, gboolean tangent)
{
    const TinkerSystem *system = stepper->system;
    int32_t n = system->size;
    combine(stepper, row, h, &(Onto){.q_out = stepper->error_q, .v_out = stepper->error_v});
    double *const parts[] = {stepper->error_q, stepper->error_v};
    for (int k = 0; k < 2 && tangent; k++)
        if (system->project_velocity(system->context, stepper->t1, stepper->q, parts[k], 1) != TINKER_OK)
            return INFINITY;
    double q = tinker_relative(tinker_largest(n, stepper->error_q), scale.q);
    double v = tinker_relative(tinker_largest(n, stepper->error_v), scale.v);
    return q > v || isnan(q) ? q : v;
}

static double measure_all(Stepper *stepper, double h, TinkerErrorScale scale, gboolean tangent)
{
    double error = measure(stepper, &stepper->error, h, scale, tangent);
    if (!stepper->tableau->second_error) return error;
    return tinker_tableau_join_errors(error, measure(stepper, &stepper->second_error, h, scale, tangent));
}

/* The error of the trial whose end lies in (q, v), relative to the tolerance.
 *
 * Near a singular place of a mechanism (links in one line) rows nearly depend on each other: they determine some
 * accelerations by a small difference alone, in which rounding grows as 1 / distance, so that shorter steps only meet
 * more of it. It lies across the motion that the rows allow, and projection takes it off but for its square. So an
 * error that is far too large is measured again along the motion; where that leaves next to nothing, this and the
 * square count. What is at rest, such as a long chain that hangs, has no motion to measure it along: rounding that is
 * projected off there moves weights, and the energy tells. Books are not projected: where there are any, the error that
 * lies across tells of theirs. */
static double find_error(Stepper *stepper, double h)
{
    int32_t n = stepper->system->size;
    if (!isfinite(tinker_largest(n, stepper->q)) || !isfinite(tinker_largest(n, stepper->v))) return INFINITY;
    TinkerErrorScale scale = tinker_error_scale(stepper->system, &stepper->control, h, stepper->q0, stepper->v0,
                                                stepper->q, stepper->v, stepper->a[0]);
    double error = measure_all(stepper, h, scale, FALSE);
    if (!(error > TINKER_FAR_OFF) || !isfinite(error)) return error;
    if (!tinker_is_constrained(stepper->system) || stepper->system->books > 0) return error;
    const double way = h * tinker_largest(n, stepper->v0);
    if (!(tinker_largest(n, stepper->error_q) < TINKER_UNMOVED * way)) return error;
    double along = measure_all(stepper, h, scale, TRUE);
    if (!(along < TINKER_ERROR_ALONG * error)) return error;
    return fmax(along, fmin(TINKER_SQUARE_SHARE * stepper->control.tolerance * error * error, TINKER_MISPLACED));
}

/* Where velocities hardly change, the error of the motion tells nothing of the books, and they count themselves. */
static double find_error_of_books(Stepper *stepper, double h, double error)
{
    if (!(error <= 1.0) || stepper->system->books == 0) return error;
    const TinkerBooksTrial trial = {.tableau = stepper->tableau,
                                    .a = stepper->a,
                                    .power = stepper->power,
                                    .h = h,
                                    .books0 = stepper->books0,
                                    .q = stepper->q,
                                    .v = stepper->v,
                                    .tolerance = stepper->control.tolerance};
    return fmax(error, tinker_books_error(stepper->system, &trial));
}

/* Stages 1 to the end; *error is not finite where the system asked for a smaller step. */
static TinkerStatus try_step(Stepper *stepper, double h, double *error)
{
    const TinkerTableau *tableau = stepper->tableau;
    int last = tinker_tableau_ends_on_evaluation(tableau) ? tableau->stages : tableau->stages - 1;
    for (int stage = 1; stage <= last; stage++) {
        TinkerStatus status = place_and_evaluate(stepper, stage, h);
        if (status != TINKER_OK) return status;
    }
    if (last < tableau->stages) place_stage(stepper, tableau->stages, h);
    *error = find_error_of_books(stepper, h, find_error(stepper, h));
    return TINKER_OK;
}

/* --- a step --- */

/* Keeps the start and finds its acceleration, and the first step where it is not known. */
static TinkerStatus begin(Stepper *stepper, const TinkerState *state, double limit)
{
    const TinkerSystem *system = stepper->system;
    int end = stepper->tableau->stages;
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
    if (status != TINKER_OK || stepper->control.h > 0.0) return status;
    stepper->control.h = stepper->first_step;
    if (stepper->first_step > 0.0) return TINKER_OK;
    return tinker_starting_step(system, stepper->tableau->order, stepper->control.tolerance, state, limit,
                                stepper->a[0], stepper->q, stepper->v, stepper->error_q, &stepper->control.h);
}

/* Makes the trial's end the state, projected. */
static TinkerStatus commit(Stepper *stepper, TinkerState *state, double h)
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
    sum_powers(stepper, stepper->tableau->stages, stepper->tableau->a[stepper->tableau->stages], h, stepper->books0,
               state->books);
    state->t = stepper->t1;
    stepper->done = 1;
    stepper->end_known = tinker_tableau_ends_on_evaluation(stepper->tableau);
    stepper->end_is_next = stepper->end_known && !moved; /* not where dense output finds it: looking saves nothing */
    return TINKER_OK;
}

static TinkerStatus fail(Stepper *stepper, TinkerStepReport *report, const char *failure)
{
    stepper->done = 0;
    report->failure = failure;
    return TINKER_FAILED;
}

/* The system is at fault, and may say why. */
static TinkerStatus fail_system(Stepper *stepper, TinkerStepReport *report)
{
    return fail(stepper, report, tinker_failure_of(stepper->system, "the system could not be evaluated"));
}

static void *allot(Stepper *stepper)
{
    const TinkerTableau *tableau = stepper->tableau;
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
        stepper->rows[stage] = make_row(tableau, tableau->a[stage]);
    }
    stepper->error = make_row(tableau, tableau->error);
    if (tableau->second_error) stepper->second_error = make_row(tableau, tableau->second_error);
    return stepper;
}

void *tinker_explicit_rk_create(const TinkerTableau *tableau, const TinkerSystem *system,
                                const TinkerIntegratorOptions *options)
{
    size_t stages = (size_t)(tableau->stages + 1 + tableau->extra_stages);
    size_t doubles = (6 + stages) * (size_t)system->size + (1 + stages) * (size_t)system->books;
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    stepper->system = system;
    stepper->tableau = tableau;
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
    Stepper *stepper = data;
    stepper->done = 0;
    tinker_step_control_forget(&stepper->control);
}

TinkerStatus tinker_explicit_rk_step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    report->rejected = 0;
    report->t_from = state->t;
    report->failure = NULL;
    if (!(limit > state->t) || !isfinite(limit))
        return fail(stepper, report, N_("an adaptive step needs a finite limit after the present time"));
    if (begin(stepper, state, limit) != TINKER_OK) return fail_system(stepper, report);

    TinkerStatus status = TINKER_OK;
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

static TinkerStatus find_dense_stages(Stepper *stepper, double h)
{
    const TinkerTableau *tableau = stepper->tableau;
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
    Stepper *stepper = data;
    const TinkerTableau *tableau = stepper->tableau;
    if (!stepper->done) return TINKER_FAILED;
    double h = stepper->t1 - stepper->t0, s = (t - stepper->t0) / h;
    TinkerStatus status = find_dense_stages(stepper, h);
    if (status != TINKER_OK) return status;

    double weights[TINKER_RK_STAGES_CAP];
    tinker_tableau_dense_weights(tableau, s, weights);
    Row row = make_row(tableau, weights);
    combine(stepper, &row, h, &(Onto){stepper->q0, stepper->v0, s * h, q, v});
    if (books) sum_powers(stepper, tableau->stages + 1 + tableau->extra_stages, weights, h, stepper->books0, books);
    return TINKER_OK;
}
