/* The classical Runge-Kutta method of order 4 on y = (q, v).
 *
 * Because dq/dt = v holds exactly, the velocity stages can be put into the positions: with a1..a4 the accelerations,
 *
 *     (q2, v2) = (q + h/2 v,             v + h/2 a1)
 *     (q3, v3) = (q + h/2 v + h^2/4 a1,  v + h/2 a2)
 *     (q4, v4) = (q + h v + h^2/2 a2,    v + h a3)
 *     q1 = q + h v + h^2/6 (a1 + a2 + a3),  v1 = v + h/6 (a1 + 2 a2 + 2 a3 + a4)
 *
 * which is the textbook's method term by term, but keeps no velocity stages and reads fewer arrays.
 */
#include <glib.h>

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/stepping.h"
#include "numerics/sharing/sharing.h"

typedef struct Stepper {
    const TinkerSystem *system;
    TinkerHermite dense; /* its `from` holds the start, a1 and the first power */
    double *q, *v;       /* the stage */
    double *a2, *a3, *a4;
    double *power2, *power3, *power4;
    double memory[];
} Stepper;

/* The arrays of a loop over coordinates, which is shared among threads where it is long. */
typedef struct {
    double h, haa, ha;
    const double *q, *v, *a1, *a2, *a3, *a4;
    double *to_q, *to_v, *kept_q, *kept_v;
} Loop;

static void first_stage(void *data, int32_t first, int32_t end)
{
    const Loop *loop = data;
    const double *restrict q = loop->q, *restrict v = loop->v, *restrict a1 = loop->a1;
    double *restrict q2 = loop->to_q, *restrict v2 = loop->to_v;
    double *restrict q0 = loop->kept_q, *restrict v0 = loop->kept_v;
    double half = 0.5 * loop->h;
    for (int32_t i = first; i < end; i++) {
        q0[i] = q[i];
        v0[i] = v[i];
        q2[i] = q[i] + half * v[i];
        v2[i] = v[i] + half * a1[i];
    }
}

/* (q + h v + haa a1, v + ha a2): the stages 3 and 4, where a1 and a2 stand for the accelerations of two stages in turn.
 */
static void later_stage(void *data, int32_t first, int32_t end)
{
    const Loop *loop = data;
    const double *restrict q = loop->q, *restrict v = loop->v, *restrict b = loop->a1, *restrict a = loop->a2;
    double *restrict qs = loop->to_q, *restrict vs = loop->to_v;
    double hv = loop->h, haa = loop->haa, ha = loop->ha;
    for (int32_t i = first; i < end; i++) {
        qs[i] = q[i] + (hv * v[i] + haa * b[i]);
        vs[i] = v[i] + ha * a[i];
    }
}

static void advance(void *data, int32_t first, int32_t end)
{
    const Loop *loop = data;
    const double *restrict a1 = loop->a1, *restrict a2 = loop->a2, *restrict a3 = loop->a3, *restrict a4 = loop->a4;
    double *restrict q = loop->to_q, *restrict v = loop->to_v;
    double h = loop->h, sixth = h / 6.0, square = h * h / 6.0;
    for (int32_t i = first; i < end; i++) {
        double middle = a2[i] + a3[i];
        q[i] += h * v[i] + square * (a1[i] + middle);
        v[i] += sixth * (a1[i] + 2.0 * middle + a4[i]);
    }
}

/* The state at the end of the step, in place of the one at its start. */
static void advance_all(const Stepper *stepper, double h, double *q, double *v, double *books)
{
    const TinkerSystem *system = stepper->system;
    Loop loop = {.h = h,
                 .a1 = stepper->dense.from.a,
                 .a2 = stepper->a2,
                 .a3 = stepper->a3,
                 .a4 = stepper->a4,
                 .to_q = q,
                 .to_v = v};
    tinker_share_range(system->size, advance, &loop);
    for (int32_t i = 0; i < system->books; i++)
        books[i] +=
            h / 6.0 *
            (stepper->dense.from.power[i] + 2.0 * (stepper->power2[i] + stepper->power3[i]) + stepper->power4[i]);
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    size_t n = (size_t)system->size, m = (size_t)system->books;
    size_t doubles = tinker_hermite_doubles(system->size, system->books) + 5 * n + 3 * m;
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    double *next = stepper->memory;
    stepper->system = system;
    tinker_hermite_init(&stepper->dense, system, &next);
    stepper->q = tinker_take(&next, n);
    stepper->v = tinker_take(&next, n);
    stepper->a2 = tinker_take(&next, n);
    stepper->a3 = tinker_take(&next, n);
    stepper->a4 = tinker_take(&next, n);
    stepper->power2 = tinker_take(&next, m);
    stepper->power3 = tinker_take(&next, m);
    stepper->power4 = tinker_take(&next, m);
    return stepper;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    tinker_hermite_forget(&stepper->dense);
}

static TinkerStatus find_stages(Stepper *stepper, const TinkerState *state, double h, double limit)
{
    const TinkerSystem *system = stepper->system;
    TinkerHermiteEnd *from = &stepper->dense.from;
    double *q = stepper->q, *v = stepper->v, middle = state->t + 0.5 * h;
    int32_t n = system->size;
    int books = system->books > 0;
    TinkerStatus status =
        system->acceleration(system->context, state->t, state->q, state->v, from->a, books ? from->power : NULL);
    if (status != TINKER_OK) return status;
    Loop loop = {.h = h,
                 .q = state->q,
                 .v = state->v,
                 .a1 = from->a,
                 .to_q = q,
                 .to_v = v,
                 .kept_q = from->q,
                 .kept_v = from->v};
    tinker_share_range(n, first_stage, &loop);
    status = system->acceleration(system->context, middle, q, v, stepper->a2, books ? stepper->power2 : NULL);
    if (status != TINKER_OK) return status;
    loop.h = loop.ha = 0.5 * h, loop.haa = 0.25 * h * h, loop.a2 = stepper->a2;
    tinker_share_range(n, later_stage, &loop);
    status = system->acceleration(system->context, middle, q, v, stepper->a3, books ? stepper->power3 : NULL);
    if (status != TINKER_OK) return status;
    loop.h = loop.ha = h, loop.haa = 0.5 * h * h, loop.a1 = stepper->a2, loop.a2 = stepper->a3;
    tinker_share_range(n, later_stage, &loop);
    return system->acceleration(system->context, limit, q, v, stepper->a4, books ? stepper->power4 : NULL);
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    TinkerHermite *dense = &stepper->dense;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;

    tinker_hermite_forget(dense);
    status = find_stages(stepper, state, report->step, limit);
    if (status != TINKER_OK) return tinker_fixed_step_fail(system, report);
    dense->from.t = state->t;
    tinker_copy(system->books, state->books, dense->from.books);
    dense->from.values_known = dense->from.slopes_known = 1;

    advance_all(stepper, report->step, state->q, state->v, state->books);
    state->t = limit;
    if (tinker_is_constrained(system)) {
        int32_t moved = 0;
        status = system->project(system->context, limit, state->q, state->v, &moved);
        if (status != TINKER_OK) {
            tinker_hermite_restore(dense, state);
            tinker_hermite_forget(dense);
            return tinker_fixed_step_fail(system, report);
        }
    }
    dense->to.t = limit;
    return TINKER_OK;
}

/* The end of the step is not kept but worked out once more from the stages when somebody asks. */
static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    TinkerHermiteEnd *from = &stepper->dense.from, *to = &stepper->dense.to;
    if (from->values_known && !to->values_known) {
        tinker_copy(stepper->system->size, from->q, to->q);
        tinker_copy(stepper->system->size, from->v, to->v);
        tinker_copy(stepper->system->books, from->books, to->books);
        advance_all(stepper, to->t - from->t, to->q, to->v, to->books);
        to->values_known = 1;
    }
    return tinker_hermite_interpolate(&stepper->dense, t, q, v, books);
}

/* R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24: |R(iy)| = 1 at y = 2 sqrt(2), |R(-x)| = 1 at the root of x^3 - 4x^2 + 12x
 * = 24. */
const TinkerIntegrator tinker_integrator_rk4 = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT,
    .id = "rk4",
    .title = "Classical Runge-Kutta, order 4",
    .summary = "The fixed-step default: four evaluations a step, accurate where the step resolves the fastest motion.",
    .source = "W. Kutta, Zeitschrift fuer Mathematik und Physik 46 (1901) 435-453",
    .order = 4,
    .dense_order = 3,
    .evaluations_per_step = 4,
    .imaginary_limit = 2.8284271247461903,
    .real_limit = 2.785293563405282,
    .create = create,
    .destroy = g_free,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
