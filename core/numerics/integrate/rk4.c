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
    double h;            /* of the step that is made, and ... */
    double *to_q, *to_v; /* ... the state that it begins at, which becomes that at its end */
    double memory[];
} Stepper;

/* A copy within a loop is to stay there: as a call of the C library it would take longer than the loop of few
 * coordinates, and one pass more of many. Clang knows no such thing of one function. */
#ifdef __clang__
#define KEEP_COPIES
#else
#define KEEP_COPIES __attribute__((optimize("no-tree-loop-distribute-patterns")))
#endif

/* The loops over coordinates, which are shared among threads where they are long. Their arrays are parameters: of
 * pointers that are read from memory the compiler does not believe that no two of them meet, and would look first,
 * which costs more than the loop of few coordinates. */
static inline __attribute__((always_inline)) void begin_stage(int32_t first, int32_t end, double half,
                                                              const double *restrict q, const double *restrict v,
                                                              const double *restrict a, double *restrict qs,
                                                              double *restrict vs, double *restrict q0,
                                                              double *restrict v0)
{
    for (int32_t i = first; i < end; i++) {
        q0[i] = q[i];
        v0[i] = v[i];
        qs[i] = q[i] + half * v[i];
        vs[i] = v[i] + half * a[i];
    }
}

KEEP_COPIES static void second_stage(void *data, int32_t first, int32_t end)
{
    const Stepper *self = data;
    const TinkerHermiteEnd *from = &self->dense.from;
    begin_stage(first, end, 0.5 * self->h, self->to_q, self->to_v, from->a, self->q, self->v, from->q, from->v);
}

static inline void go_on(int32_t first, int32_t end, double hv, double haa, double ha, const double *restrict q,
                         const double *restrict v, const double *restrict b, const double *restrict a,
                         double *restrict qs, double *restrict vs)
{
    for (int32_t i = first; i < end; i++) {
        qs[i] = q[i] + (hv * v[i] + haa * b[i]);
        vs[i] = v[i] + ha * a[i];
    }
}

static void third_stage(void *data, int32_t first, int32_t end)
{
    const Stepper *self = data;
    const double h = self->h;
    go_on(first, end, 0.5 * h, 0.25 * h * h, 0.5 * h, self->to_q, self->to_v, self->dense.from.a, self->a2, self->q,
          self->v);
}

static void fourth_stage(void *data, int32_t first, int32_t end)
{
    const Stepper *self = data;
    const double h = self->h;
    go_on(first, end, h, 0.5 * h * h, h, self->to_q, self->to_v, self->a2, self->a3, self->q, self->v);
}

static inline void sum_stages(int32_t first, int32_t end, double h, const double *restrict a1,
                              const double *restrict a2, const double *restrict a3, const double *restrict a4,
                              double *restrict q, double *restrict v)
{
    double sixth = h / 6.0, square = h * h / 6.0;
    for (int32_t i = first; i < end; i++) {
        double middle = a2[i] + a3[i];
        q[i] += h * v[i] + square * (a1[i] + middle);
        v[i] += sixth * (a1[i] + 2.0 * middle + a4[i]);
    }
}

static void advance(void *data, int32_t first, int32_t end)
{
    const Stepper *self = data;
    sum_stages(first, end, self->h, self->dense.from.a, self->a2, self->a3, self->a4, self->to_q, self->to_v);
}

static inline void sum_powers(int32_t count, double sixth, const double *restrict p1, const double *restrict p2,
                              const double *restrict p3, const double *restrict p4, double *restrict books)
{
    for (int32_t i = 0; i < count; i++)
        books[i] += sixth * (p1[i] + 2.0 * (p2[i] + p3[i]) + p4[i]);
}

/* The state at the end of a step, in place of the one at its start. */
static void advance_all(Stepper *stepper, double h, double *q, double *v, double *books)
{
    const TinkerSystem *system = stepper->system;
    stepper->h = h;
    stepper->to_q = q;
    stepper->to_v = v;
    tinker_share_range(system->size, advance, stepper);
    sum_powers(system->books, h / 6.0, stepper->dense.from.power, stepper->power2, stepper->power3, stepper->power4,
               books);
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
    stepper->h = h;
    stepper->to_q = state->q;
    stepper->to_v = state->v;
    tinker_share_range(n, second_stage, stepper);
    status = system->acceleration(system->context, middle, q, v, stepper->a2, books ? stepper->power2 : NULL);
    if (status != TINKER_OK) return status;
    tinker_share_range(n, third_stage, stepper);
    status = system->acceleration(system->context, middle, q, v, stepper->a3, books ? stepper->power3 : NULL);
    if (status != TINKER_OK) return status;
    tinker_share_range(n, fourth_stage, stepper);
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
