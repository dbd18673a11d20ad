/* The exact integrator: every part of a linear system is stepped by its own propagator.
 *
 * The parts' state in the modes is carried from step to step for as long as the host leaves the coordinates as
 * they were given; otherwise it is made anew from them, with the place as the new reference, so that only the
 * motion since is rounded. Step lengths that differ by rounding of t share a propagator; what they differ by is
 * carried along as `lag`.
 */
#include "numerics/exact/exact.h"

#include <float.h>
#include <string.h>

#include "numerics/exact/exact-private.h"
#include "numerics/integrate/stepping.h"

#define MOST_TINY_STEPS 100 /* in a row */

typedef struct {
    const TinkerSystem *system;
    TinkerLinearParts *parts;
    GPtrArray *each; /* of TinkerExactPart * */
    GPtrArray *memory;
    TinkerSignal *signals;
    const TinkerExactSlot **slots; /* of each part, for the present step */
    double *q, *v, *books;         /* what the last step gave */
    double *books_from;            /* and what it began with */
    double t, t_from;
    double tolerance;
    gboolean entered, carried, stepped;
    int32_t tiny; /* steps in a row */
} Stepper;

static void destroy(void *data)
{
    Stepper *stepper = data;
    if (!stepper) return;
    g_ptr_array_unref(stepper->each);
    g_ptr_array_unref(stepper->memory);
    tinker_linear_parts_free(stepper->parts);
    g_free(stepper);
}

static void free_part(gpointer part)
{
    tinker_exact_part_free(part);
}

static gboolean enter(Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    if (system->linear->signal_count > 0 && system->signals(system->context, stepper->signals) != TINKER_OK)
        return FALSE;
    for (guint k = 0; k < stepper->each->len; k++)
        if (!tinker_exact_part_enter(stepper->each->pdata[k], stepper->signals)) return FALSE;
    return TRUE;
}

static gboolean build(Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    gsize n = (gsize)system->size, m = (gsize)system->books;
    stepper->parts = tinker_linear_parts_new(system->linear);
    for (int32_t k = 0; k < stepper->parts->count; k++) {
        TinkerExactPart *part = tinker_exact_part_new(system, stepper->parts, k);
        if (!part) return FALSE;
        g_ptr_array_add(stepper->each, part);
    }
    double *doubles = tinker_exact_allot(stepper->memory, 2 * n + 2 * m, sizeof(double));
    stepper->signals = tinker_exact_allot(stepper->memory, (gsize)system->linear->signal_count, sizeof(TinkerSignal));
    stepper->slots = tinker_exact_allot(stepper->memory, stepper->each->len, sizeof(TinkerExactSlot *));
    if (!doubles || !stepper->signals || !stepper->slots) return FALSE;
    stepper->q = tinker_take(&doubles, n);
    stepper->v = tinker_take(&doubles, n);
    stepper->books = tinker_take(&doubles, m);
    stepper->books_from = tinker_take(&doubles, m);
    /* What the signals need is allotted here where the host can already say what they are, else with the first
     * step. */
    stepper->entered = enter(stepper);
    return TRUE;
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    if (!TINKER_HAS(TinkerSystem, system, signals) || !system->linear) return NULL;
    Stepper *stepper = g_new0(Stepper, 1);
    stepper->system = system;
    stepper->each = g_ptr_array_new_with_free_func(free_part);
    stepper->memory = g_ptr_array_new_with_free_func(g_free);
    if (build(stepper)) return stepper;
    destroy(stepper);
    return NULL;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    stepper->entered = enter(stepper);
    stepper->carried = stepper->stepped = FALSE;
    stepper->tiny = 0;
}

static gboolean is_finite(int32_t count, const double *values)
{
    double sum = 0.0;
    for (int32_t i = 0; i < count; i++)
        sum += values[i] * 0.0;
    return sum == 0.0;
}

static gboolean is_carried(const Stepper *stepper, const TinkerState *state)
{
    gsize bytes = (gsize)stepper->system->size * sizeof(double);
    return stepper->carried && state->t == stepper->t && memcmp(state->q, stepper->q, bytes) == 0 &&
           memcmp(state->v, stepper->v, bytes) == 0;
}

/* Of a state that was changed, or gone back to: at the end of the last step or at its start it lags as it did, since
 * whoever changed it knew it so; anywhere else it is what it says. */
static double lag_at(const Stepper *stepper, const TinkerExactPart *part, double t)
{
    if (t == stepper->t) return part->lag;
    return t == stepper->t_from ? part->lag_from : 0.0;
}

/* Brings the parts to the state, and turns the edges that the last step ended on. */
static void bring_to_state(Stepper *stepper, const TinkerState *state)
{
    gboolean carried = is_carried(stepper, state);
    for (guint k = 0; k < stepper->each->len; k++) {
        TinkerExactPart *part = stepper->each->pdata[k];
        if (!carried) {
            part->lag = lag_at(stepper, part, state->t);
            tinker_exact_part_start(part, state->q, state->v, stepper->signals, state->t);
            continue;
        }
        gboolean turned = FALSE;
        for (int32_t e = 0; e < part->edge_count; e++) {
            if (part->edges[e].meets) part->edges[e].met = TRUE;
            part->edges[e].meets = FALSE;
            if (!part->edges[e].due) continue;
            part->edges[e].sign = -part->edges[e].sign;
            part->edges[e].due = FALSE;
            turned = TRUE;
        }
        if (turned) tinker_exact_part_set_constant_forces(part);
    }
    /* From here on the parts are in this state, whatever becomes of the step. */
    tinker_copy(stepper->system->size, state->q, stepper->q);
    tinker_copy(stepper->system->size, state->v, stepper->v);
    stepper->t = state->t;
    stepper->carried = TRUE;
    stepper->stepped = FALSE;
}

static void forget_passings(TinkerExactPart *part)
{
    for (int32_t e = 0; e < part->edge_count; e++)
        part->edges[e].due = part->edges[e].meets = FALSE;
    part->landed = FALSE;
}

/* The end of the step: the limit, or where the first edge passes through d = 0, and the length before that is
 * rounded. */
static double find_end(Stepper *stepper, double limit, double *length)
{
    double t = stepper->t, whole = limit - t, h = whole;
    for (guint k = 0; k < stepper->each->len; k++) {
        TinkerExactPart *part = stepper->each->pdata[k];
        if (part->watched == 0) continue;
        tinker_exact_part_values(part, stepper->signals, t, part->values);
        double end = tinker_exact_part_passing(part, stepper->signals, t, h);
        if (fabs(end) >= fabs(h)) continue;
        for (guint earlier = 0; earlier < k; earlier++)
            forget_passings(stepper->each->pdata[earlier]);
        h = end;
    }
    *length = h;
    if (h == whole) return limit;
    double end = t + h;
    return end == t ? nextafter(t, limit) : end;
}

/* Finds every part's propagator before any part moves. */
static gboolean find_slots(Stepper *stepper, double h)
{
    for (guint k = 0; k < stepper->each->len; k++) {
        TinkerExactPart *part = stepper->each->pdata[k];
        double length = h - part->lag;
        /* A length of 0 marks an empty propagator. */
        stepper->slots[k] =
            tinker_exact_slot(part, length == 0.0 ? DBL_MIN : length, stepper->tolerance, FALSE, part->booked);
        if (!stepper->slots[k]) return FALSE;
    }
    return TRUE;
}

/* Takes every part from `from` to `z`, and its books along. A part that ends on a passing ends in the very state
 * that the search found there, so that rounding cannot put it back on the side that it came from. */
static void advance(Stepper *stepper, double t, double end, double h, double *books)
{
    for (guint k = 0; k < stepper->each->len; k++) {
        TinkerExactPart *part = stepper->each->pdata[k];
        const TinkerExactSlot *slot = stepper->slots[k];
        part->lag_from = part->lag;
        part->length = slot->h;
        part->lag += (part->landed ? h : slot->h) - (end - t);
        memcpy(part->from, part->z, 2 * (gsize)part->n * sizeof *part->z);
        tinker_exact_part_values(part, stepper->signals, t, part->values);
        tinker_exact_part_values(part, stepper->signals, end, part->ahead);
        tinker_exact_part_drive(part, part->values);
        tinker_exact_part_advance(part, slot, part->from, part->z);
        if (part->landed) memcpy(part->z, part->scratch + 2 * part->n, 2 * (gsize)part->n * sizeof *part->z);
        tinker_exact_part_write(part, part->z, stepper->q, stepper->v);
        if (part->booked) tinker_exact_part_book(part, slot, part->from, part->z, books);
    }
}

static TinkerStatus fail(Stepper *stepper, TinkerStepReport *report, const char *why)
{
    stepper->carried = FALSE;
    report->failure = why;
    return TINKER_FAILED;
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    if (!stepper->entered && !(stepper->entered = enter(stepper)))
        return fail(stepper, report, tinker_failure_of(system, "the system's signals are not known, or memory is out"));
    if (!is_finite(system->size, state->q) || !is_finite(system->size, state->v))
        return fail(stepper, report, "the state that the step begins with is not a number");
    bring_to_state(stepper, state);
    double t = state->t, h, end = find_end(stepper, limit, &h);
    stepper->tolerance = 2.0 * DBL_EPSILON * fmax(fabs(t), fabs(end));
    if (fabs(end - t) > 8.0 * DBL_EPSILON * fmax(fabs(t), fabs(limit - t)) || end == limit)
        stepper->tiny = 0;
    else if (++stepper->tiny > MOST_TINY_STEPS)
        return fail(stepper, report,
                    "an edge with a tension of its own has drawn its ends together, and no formula "
                    "holds across that");
    if (!find_slots(stepper, end - t))
        return fail(stepper, report, "the step is too long for the system's rates; take a shorter one");
    tinker_copy(system->books, state->books, stepper->books_from);
    tinker_copy(system->books, state->books, stepper->books);
    advance(stepper, t, end, h, stepper->books);
    if (!is_finite(system->size, stepper->q) || !is_finite(system->size, stepper->v) ||
        !is_finite(system->books, stepper->books))
        return fail(stepper, report, "the motion grows beyond all numbers within the step");
    stepper->t_from = t;
    stepper->t = end;
    stepper->stepped = TRUE;
    report->step = end - t;
    tinker_copy(system->size, stepper->q, state->q);
    tinker_copy(system->size, stepper->v, state->v);
    tinker_copy(system->books, stepper->books, state->books);
    state->t = end;
    return TINKER_OK;
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    if (!stepper->stepped) return TINKER_FAILED;
    if (t == stepper->t) {
        tinker_copy(system->size, stepper->q, q);
        tinker_copy(system->size, stepper->v, v);
        if (books) tinker_copy(system->books, stepper->books, books);
        return TINKER_OK;
    }
    if (books) tinker_copy(system->books, stepper->books_from, books);
    for (guint k = 0; k < stepper->each->len; k++) {
        TinkerExactPart *part = stepper->each->pdata[k];
        double h = t - stepper->t_from - part->lag_from;
        const double *z =
            tinker_exact_part_inside(part, stepper->signals, stepper->t_from, h, stepper->tolerance, books);
        if (!z) return TINKER_FAILED;
        tinker_exact_part_write(part, z, q, v);
    }
    return TINKER_OK;
}

const TinkerIntegrator tinker_integrator_exact = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_LINEAR,
    .id = "exact",
    .title = "Exact solution of a linear system",
    .summary = "Steps of any length, exact to rounding, where the system is linear.",
    .source =
        "N. J. Higham, Functions of Matrices, SIAM 2008, ch. 10; J. Demmel, P. Koev, Numer. Math. 98 (2004) 99-104",
    .order = 0,
    .dense_order = 0,
    .evaluations_per_step = 0,
    .imaginary_limit = -1.0,
    .real_limit = -1.0,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
