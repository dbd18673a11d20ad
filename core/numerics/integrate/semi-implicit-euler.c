/* Semi-implicit (symplectic) Euler: v1 = v + h a(t, q, v), q1 = q + h v1. One evaluation a step, order 1; the energy of
 * an undamped oscillator swings by a part of order h omega but does not grow. */
#include <glib.h>

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/stepping.h"

typedef struct Stepper {
    const TinkerSystem *system;
    TinkerHermite dense;
    double memory[];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    size_t doubles = tinker_hermite_doubles(system->size, system->books);
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    double *next = stepper->memory;
    stepper->system = system;
    tinker_hermite_init(&stepper->dense, system, &next);
    return stepper;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    tinker_hermite_forget(&stepper->dense);
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    const TinkerSystem *system = stepper->system;
    TinkerHermiteEnd *from = &stepper->dense.from;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    double h = report->step;

    tinker_hermite_start(&stepper->dense, state);
    double *power = system->books > 0 ? from->power : NULL;
    status = system->acceleration(system->context, state->t, state->q, state->v, from->a, power);
    if (status != TINKER_OK) return tinker_fixed_step_fail(system, report);
    from->slopes_known = 1;

    for (int32_t i = 0; i < system->size; i++) {
        state->v[i] += h * from->a[i];
        state->q[i] += h * state->v[i];
    }
    for (int32_t i = 0; i < system->books; i++)
        state->books[i] += h * from->power[i];
    state->t = limit;

    if (tinker_is_constrained(system)) {
        int32_t moved = 0;
        status = system->project(system->context, limit, state->q, state->v, &moved);
        if (status != TINKER_OK) {
            tinker_hermite_restore(&stepper->dense, state);
            return tinker_fixed_step_fail(system, report);
        }
    }
    tinker_hermite_finish(&stepper->dense, state);
    return TINKER_OK;
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    return tinker_hermite_interpolate(&stepper->dense, t, q, v, books);
}

/* imaginary: trace 2 - (h omega)^2 of a map of determinant 1. real: v1 = (1 - h c / m) v. */
const TinkerIntegrator tinker_integrator_semi_implicit_euler = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | TINKER_INTEGRATOR_SYMPLECTIC,
    .id = "semi-implicit-euler",
    .title = "Semi-implicit Euler, order 1",
    .summary = "The cheapest picture: one evaluation a step, and undamped motion keeps its energy on average.",
    .source = "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., I.1.2, Springer 2006",
    .order = 1,
    .dense_order = 1,
    .evaluations_per_step = 1,
    .imaginary_limit = 2.0,
    .real_limit = 2.0,
    .create = create,
    .destroy = g_free,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
